// A project in one file: the case with its variants and traffic, and the measured rail with its earlier records, columns and what lies along the line.

import { readTraffic } from './traffic.js';
import { readVariants } from './variants.js';
import { caseTitle, t } from './words.js';

/** How the name of a project ends, and how it says what it is. */
export const PROJECT = '.riffel';
const FORMAT = 'riffel-project';
const VERSION = 1;

const isTable = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** The bytes of a file, packed and as letters. */
async function packed(file) {
  const zipped = await new Response(file.stream().pipeThrough(new CompressionStream('gzip'))).blob();
  const reader = new FileReader();
  await new Promise((done, fail) => Object.assign(reader, { onload: done, onerror: () => fail(reader.error) }).readAsDataURL(zipped));
  return { name: file.name, gzip_base64: reader.result.split(',')[1] };
}

/** The file of before; what is damaged throws. */
async function unpacked({ name, gzip_base64: letters }) {
  const bytes = Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0));
  const blob = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).blob();
  return new File([blob], String(name), { type: /\.csv$/i.test(name) ? 'text/csv' : 'text/plain' });
}

/** What a project, or a link, holds in words. */
export function inWords({ case: keys, variants, traffic, record }) {
  return t('project_holds', { title: caseTitle(keys), variants: variants.length, traffic: Boolean(traffic), record: record?.name ?? record?.file.name, earlier: record?.earlier?.files.length ?? 0 });
}

/** The text of a project. A record that a reload left to the program alone is no file any more, and is left out: `left` names it. */
export async function written({ case: keys, variants, traffic, record }) {
  const files = record ? [record.file, ...(record.earlier?.files ?? []).map(({ file }) => file)] : [];
  const isWhole = files.every((file) => file instanceof File);
  const held = isWhole ? record : null;
  const rail = held && {
    ...(await packed(held.file)), format: held.format, table: held.table, date: held.earlier?.date ?? '',
    earlier: await Promise.all((held.earlier?.files ?? []).map(async ({ file, date }) => ({ ...(await packed(file)), date }))),
  };
  const text = JSON.stringify({ format: FORMAT, version: VERSION, case: keys, variants, traffic, ...(rail && { record: rail }) });
  return { text, holds: inWords({ case: keys, variants, traffic, record: held }), left: isWhole ? null : record.file.name };
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
  const { case: keys, record } = project;
  if (!isTable(keys)) throw t('project_broken', file.name);
  const given = { case: keys, variants: readVariants(project), traffic: readTraffic(project.traffic) };
  if (!record) return given;
  try {
    const files = await Promise.all((record.earlier ?? []).map(async (one) => ({ file: await unpacked(one), date: String(one.date ?? '') })));
    const earlier = files.length ? { date: String(record.date ?? ''), files } : null;
    return { ...given, record: { file: await unpacked(record), format: record.format ?? null, table: record.table ?? null, earlier } };
  } catch {
    throw t('project_broken', file.name);
  }
}
