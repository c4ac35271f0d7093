// A project in one file: the case with its variants and traffic, the measured rail with its earlier records, columns and what lies along the line, and the plan of
// a calibration, with what grinding and remedies cost.

import { caseTitle } from './messages.js';
import { Fault, askOnce } from './server.js';
import { readCosts } from './remedies.js';
import { readTraffic } from './traffic.js';
import { readVariants } from './variants.js';
import { t } from './words.js';

/** How the name of a project ends, and how it says what it is. */
export const PROJECT = '.riffel';
const FORMAT = 'riffel-project';
const VERSION = 1;

const isTable = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** The bytes of a file, packed and as letters. One that a reload left to the program alone is that which the program has kept. */
async function packed({ file, name, kept }) {
  const whole = file instanceof File ? file : await (await askOnce('/api/upload/kept', { upload: kept })).blob();
  const zipped = await new Response(whole.stream().pipeThrough(new CompressionStream('gzip'))).blob();
  const reader = new FileReader();
  await new Promise((done, fail) => Object.assign(reader, { onload: done, onerror: () => fail(reader.error) }).readAsDataURL(zipped));
  return { name, gzip_base64: reader.result.split(',')[1] };
}

/** Most that the files of a project hold together [bytes], the largest that the program gives back; a few letters of it can stand for any number. */
const LARGEST = 256 * 2 ** 20;

/** The file of before, from what is left of a room; what is damaged or has no room throws. */
async function unpacked({ name, gzip_base64: letters }, room) {
  const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
  const bounded = new TransformStream({
    transform(piece, controller) {
      room.left -= piece.length;
      if (room.left < 0) throw RangeError();
      controller.enqueue(piece);
    },
  });
  const blob = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')).pipeThrough(bounded)).blob();
  return new File([blob], String(name), { type: /\.csv$/i.test(name) ? 'text/csv' : 'text/plain' });
}

/** What a project, or a link, holds in words. */
export function inWords({ case: keys, variants, traffic, costs, record, plan }) {
  const name = record?.name ?? record?.file.name;
  return [
    caseTitle(keys),
    variants.length && t('holds_variants', variants.length),
    t(traffic ? 'holds_traffic' : 'holds_no_traffic'),
    Object.keys(costs ?? {}).length && t('left_costs'),
    name && t('holds_record', { record: name, earlier: record.earlier?.files.length ? String(record.earlier.files.length) : '' }),
    plan?.data.length && t('holds_tables', plan.data.length),
  ].filter(Boolean).join(', ');
}

const all = (files) => Promise.all(files.map(async (one) => ({ ...(await packed(one)), ...(one.date !== undefined && { date: one.date }) })));

const railOf = async (record) => ({ ...(await packed(record)), format: record.format, table: record.table, date: record.earlier?.date ?? '', earlier: await all(record.earlier?.files ?? []) });

const planOf = async ({ data, ...plan }) => ({ ...plan, data: await all(data) });

/** The text of a project. What neither the page nor the program has any more is left out: `left` names it. */
export async function written({ record, plan, ...open }) {
  const left = [];
  const whole = async (what, pack, names) => {
    try {
      return what && (await pack(what));
    } catch (fault) {
      if (!(fault instanceof Fault)) throw fault;
      left.push(...names(what));
      return null;
    }
  };
  const files = {
    record: await whole(record, railOf, ({ name }) => [name]),
    plan: await whole(plan, planOf, ({ data }) => data.map(({ name }) => name)),
  };
  const held = Object.fromEntries(Object.entries(files).filter(([, value]) => value));
  return { text: JSON.stringify({ format: FORMAT, version: VERSION, ...open, ...held }), holds: inWords({ ...open, record: files.record && record, plan: files.plan }), left: left.join(', ') };
}

/** What a file of a project holds, ready to be opened; throws a sentence where it is none. */
export async function read(file) {
  let project;
  try {
    project = JSON.parse(await file.text());
  } catch {
    throw t('project_broken', file.name);
  }
  if (project?.format !== FORMAT) throw t('project_other', file.name);
  if (!(project.version <= VERSION)) throw t('project_later', { name: file.name, version: project.version, own: VERSION });
  const { case: keys, record, plan } = project;
  if (!isTable(keys)) throw t('project_broken', file.name);
  const given = { case: keys, variants: readVariants(project), traffic: readTraffic(project.traffic), costs: readCosts(project.costs) };
  const room = { left: LARGEST };
  const opened = (one) => unpacked(one, room);
  try {
    if (plan) given.plan = { data: await Promise.all(plan.data.map(opened)), priors: isTable(plan.priors) ? plan.priors : {}, draws: plan.draws, costs: isTable(plan.costs) ? plan.costs : {} };
    if (!record) return given;
    const files = await Promise.all((record.earlier ?? []).map(async (one) => ({ file: await opened(one), date: String(one.date ?? '') })));
    const earlier = files.length ? { date: String(record.date ?? ''), files } : null;
    return { ...given, record: { file: await opened(record), format: record.format ?? null, table: record.table ?? null, earlier } };
  } catch {
    throw room.left < 0 ? t('project_large', { name: file.name, most: LARGEST / 2 ** 20 }) : t('project_broken', file.name);
  }
}
