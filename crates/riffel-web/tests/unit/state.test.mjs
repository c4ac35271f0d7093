// What is open: keys of a case, links, variants, steps back and forth, and projects.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gunzipSync, gzipSync } from 'node:zlib';
import { inLanguage } from './page.mjs';
import { get, inUnit, pack, set, short, shownUnit, si, split, unpack } from '../../assets/keys.js';
import { read as readList, written as writtenList } from '../../assets/lists.js';
import { inWords, read, written } from '../../assets/project.js';
import { remember, remembered } from '../../assets/remembered.js';
import { readCosts } from '../../assets/remedies.js';
import { held, underWay } from '../../assets/sent-files.js';
import { Steps } from '../../assets/steps.js';
import { MOST_VARIANTS, ownName, readVariants } from '../../assets/variants.js';
import { chooseSpeedUnit } from '../../assets/words.js';

test('a key is read, set and removed with the tables that it leaves empty', () => {
  const keys = { title: 'a', contact: { friction: 0.4, creepage: { lateral: 1 } } };
  assert.equal(get(keys, 'contact.creepage.lateral'), 1);
  assert.equal(get(keys, 'wheel.mass'), undefined);
  set(keys, 'wheel.mass', '350 kg');
  set(keys, 'contact.creepage.lateral', undefined);
  assert.deepEqual(keys, { title: 'a', contact: { friction: 0.4 }, wheel: { mass: '350 kg' } });
  set(keys, 'wheel.mass', undefined);
  set(keys, 'track.pad.stiffness', undefined);
  assert.deepEqual(keys, { title: 'a', contact: { friction: 0.4 } });
  // A table takes the place of a number.
  set(keys, 'contact.friction.left', 0.3);
  assert.deepEqual(keys.contact, { friction: { left: 0.3 } });
  set(keys, 'title', undefined);
  assert.deepEqual(Object.keys(keys), ['contact']);
});

test('quantities are taken apart and written in the unit of their field', () => {
  assert.deepEqual(split('50 kN', 'N'), { number: 50, unit: 'kN', text: '50' });
  assert.deepEqual(split(5e4, 'N'), { number: 5e4, unit: 'N', text: '50000' });
  assert.deepEqual(split(' -1.5e-3 kg m2 ', ''), { number: -0.0015, unit: 'kg m²', text: '-1.5e-3' });
  assert.deepEqual(split('7850', 'kg/m3'), { number: 7850, unit: 'kg/m³', text: '7850' });
  assert.equal(split('many', 'N'), null);
  assert.equal(short(0.1 + 0.2), '0.3');
  assert.equal(short(123456.7), '123460');
  assert.deepEqual(shownUnit('contact.normal_load', 'N'), ['kN', 1e3]);
  assert.deepEqual(shownUnit('track.support_spacing', 'm'), ['m', 1]);
  assert.deepEqual(shownUnit('wheel.inertia', 'kg m2'), ['kg m²', 1]);
  assert.deepEqual(shownUnit('contact.friction', ''), ['', 1]);
  assert.equal(inUnit('contact.normal_load', 52345.678, 'N'), '52.346 kN');
  assert.equal(inUnit('contact.friction', 0.4, ''), 0.4);
  assert.equal(si({ contact: { normal_load: '50000 N' } }, 'contact.normal_load'), 5e4);
  assert.equal(si({}, 'contact.normal_load'), undefined);
  for (const [unit, size] of [['km/h', 1 / 3.6], ['m/s', 1], ['mph', 0.44704]]) {
    chooseSpeedUnit(unit);
    assert.deepEqual(shownUnit('map.speed.max', 'm/s'), [unit, size]);
  }
  chooseSpeedUnit('km/h');
});

test('a link holds what is open, and a damaged one is told from a whole one', () => {
  const state = { case: { title: 'Straßenbahn: 60R2 µ', contact: { friction: 0.4 } }, point: [0.055, 30] };
  const link = pack(state);
  assert.match(link, /^[\w-]+\.[0-9a-z]+$/);
  assert.deepEqual(unpack(link), state);
  // A sum of before: none.
  assert.deepEqual(unpack(link.split('.')[0]), state);
  assert.deepEqual(unpack('e30'), {});
  for (const damage of [link.slice(0, -40), `${link.slice(0, 20)}!${link.slice(21)}`, `${link.slice(0, 20)}${link[20] === 'A' ? 'B' : 'A'}${link.slice(21)}`, `${link}0`]) assert.throws(() => unpack(damage), damage);
  for (const nonsense of ['nonsense', 'e3', 'A'.repeat(50_000)]) assert.throws(() => unpack(nonsense));
  // The sum is FNV-1a of what stands before it: of "e30", the packed empty object.
  assert.equal(pack({}), `e30.${[...'e30'].reduce((hash, letter) => Number((BigInt(hash ^ letter.charCodeAt(0)) * 0x01000193n) & 0xffffffffn), 0x811c9dc5).toString(36)}`);
});

test('no two variants have one name', () => {
  const others = [{ name: 'A' }, { name: 'dry' }, { name: 'dry (2)' }];
  assert.equal(ownName(' wet ', others), 'wet');
  assert.equal(ownName('', others), 'B');
  assert.equal(ownName('dry', others), 'dry (3)');
  assert.equal(ownName('x'.repeat(50), []).length, 40);
  assert.equal(ownName('', [...'ABCDEF'].map((name) => ({ name }))), 'A (2)');
});

test('the variants of a link are read, those of before too', () => {
  const keys = { contact: { friction: 0.6 } };
  assert.deepEqual(readVariants({ kept: keys }), [{ name: 'A', case: keys }]);
  assert.deepEqual(readVariants({}), []);
  assert.deepEqual(readVariants({ variants: [{ name: 'dry rail', case: keys }, { name: 'dry rail', case: keys }, { case: keys }, { name: 'x', case: 3 }, null, { name: 'y', case: [] }] }).map(({ name }) => name), ['dry rail', 'dry rail (2)', 'A']);
  assert.equal(readVariants({ variants: Array(9).fill({ case: keys }) }).length, MOST_VARIANTS);
});

test('steps go back and forth, a drag is one, and a reload finds them', () => {
  sessionStorage.clear();
  const told = [];
  const steps = new Steps((ways) => told.push(ways));
  steps.begin({ friction: 0.4 });
  assert.deepEqual(told.at(-1), { undo: false, redo: false });
  assert.equal(steps.record({ friction: 0.3 }), true);
  assert.equal(steps.record({ friction: 0.3 }), false);
  assert.equal(steps.record({ friction: 0.5 }, 'slide'), true);
  assert.equal(steps.record({ friction: 0.6 }, 'slide'), false);
  assert.deepEqual(steps.undo(), { friction: 0.3 });
  assert.deepEqual(told.at(-1), { undo: true, redo: true });
  assert.deepEqual(steps.undo(), { friction: 0.4 });
  assert.equal(steps.undo(), undefined);
  assert.deepEqual(steps.redo(), { friction: 0.3 });
  assert.deepEqual(steps.redo(), { friction: 0.6 });
  assert.equal(steps.redo(), undefined);
  // After the end of a gesture, as after a step back, the next is another.
  steps.record({ friction: 0.1 }, 'slide');
  steps.settle();
  assert.equal(steps.record({ friction: 0.2 }, 'slide'), true);
  assert.equal(steps.record({ friction: 0.7 }, 'other'), true);
  assert.deepEqual(steps.undo(), { friction: 0.2 });
  assert.equal(steps.record({ friction: 0.8 }, 'other'), true);
  assert.equal(steps.redo(), undefined);
  steps.amend({ friction: 0.8, map: 1 });
  const again = new Steps(() => {});
  again.begin({ friction: 0.8, map: 1 });
  assert.deepEqual(again.undo(), { friction: 0.2 });
  // What was kept of another case is over.
  const other = new Steps(() => {});
  other.begin({ friction: 0.9 });
  assert.equal(other.undo(), undefined);
});

test('a hundred steps are kept, and each is a copy', () => {
  const steps = new Steps(() => {});
  const state = { friction: 0 };
  steps.begin(state);
  for (let k = 1; k <= 150; k++) {
    state.friction = k;
    steps.record(state);
  }
  let back = 0;
  while (steps.undo()) back++;
  assert.equal(back, 100);
  assert.equal(steps.present.friction, 50);
});

test('what a browser does not keep is gone after a reload, without a word', () => {
  remember('riffel-test', { a: 1 });
  assert.deepEqual(remembered('riffel-test'), { a: 1 });
  remember('riffel-test', null);
  assert.equal(remembered('riffel-test'), null);
  const { setItem } = sessionStorage;
  sessionStorage.setItem = () => { throw new Error('full'); };
  remember('riffel-test', 1);
  sessionStorage.setItem = setItem;
  assert.equal(remembered('riffel-test'), null);
  sessionStorage.setItem('riffel-test', '{');
  assert.equal(remembered('riffel-test'), null);
});

test('lists of a case are written and read', () => {
  assert.equal(writtenList(['0 m', '2.5 m']), '0 m, 2.5 m');
  const discs = [{ name: 'left', mass: '350 kg', at: { x: 1 } }, { mass: 2 }];
  assert.equal(writtenList(discs), '{ name = "left", mass = "350 kg", at = { x = 1 } },\n{ mass = 2 }');
  assert.deepEqual(readList(writtenList(discs)), discs);
  assert.deepEqual(readList('0 m, 2,5 m; 3'), ['0 m', '2,5 m', 3]);
  assert.deepEqual(readList(' , ;'), []);
  assert.equal(readList('{ mass = }'), '{ mass = }');
});

test('costs of remedies are those that the program takes', () => {
  assert.deepEqual(readCosts({ a: 0.01, b: 1e9, c: 0, d: 2e9, e: 'many' }), { a: 0.01, b: 1e9 });
  assert.deepEqual(readCosts(undefined), {});
});

test('of files that are sent a reload has those that the program holds', () => {
  const [sent, underway] = [{ name: 'a.csv', size: 3, date: '', upload: 7, spectra: {} }, { name: 'b.csv', size: 4, date: '' }];
  assert.deepEqual(held([sent, underway]), [{ name: 'a.csv', size: 3, date: '', upload: 7 }]);
  assert.match(underWay(0.456), /45\.6 %$/);
});

// Projects -----------------------------------------------------------------------------------------------

globalThis.FileReader = class {
  readAsDataURL(blob) {
    blob.bytes().then((bytes) => {
      this.result = `data:;base64,${Buffer.from(bytes).toString('base64')}`;
      this.onload();
    }, this.onerror);
  }
};

const file = (text, name = 'all.riffel') => new File([text], name);
const letters = (one) => gunzipSync(Buffer.from(one.gzip_base64, 'base64')).toString();
const CASE = { title: 'My line', contact: { friction: 0.4 } };
const VARIANT = { name: 'dry', case: { contact: { friction: 0.6 } } };
const TRAFFIC = { from_km_per_h: 60, to_km_per_h: 100, passages_per_day: 4000, months: 12 };
const OPEN = { case: CASE, variants: [VARIANT], traffic: TRAFFIC, costs: { 'softer-pads': 10000 } };
const FORMAT = { delimiter: 'semicolon', rails: [{ column: 2, unit: 'mm' }] };
const RECORD = { name: 'new.csv', file: file('x,y\n1,2\n', 'new.csv'), format: FORMAT, table: { name: 'line.csv', text: '12;weld' }, earlier: { date: '2026-05-01', files: [{ name: 'old.csv', file: file('old', 'old.csv'), date: '2025-05-01' }] } };
const PLAN = { data: [{ name: 'hammer.csv', file: file('h', 'hammer.csv') }], priors: { 'track.pad.stiffness': { prior: { median: '280 MN/m' } } }, draws: '3000', costs: { 'cost-grinding': '250' } };

test('a project holds all that is open and gives it back', async () => {
  const { text, holds, left } = await written({ ...OPEN, record: RECORD, plan: PLAN });
  assert.equal(left, '');
  assert.match(holds, /the record new\.csv with 1 earlier, the plan of a calibration with 1 table/);
  assert.match(holds, /^“My line”, /);
  assert.match(holds, /what remedies cost/);
  const project = JSON.parse(text);
  assert.deepEqual([project.format, project.version], ['riffel-project', 1]);
  assert.equal(letters(project.record), 'x,y\n1,2\n');
  assert.equal(letters(project.record.earlier[0]), 'old');
  assert.equal(project.record.earlier[0].date, '2025-05-01');
  assert.equal(project.record.date, '2026-05-01');
  assert.equal(letters(project.plan.data[0]), 'h');
  const again = await read(file(text));
  assert.deepEqual(again.case, CASE);
  assert.deepEqual(again.variants, [VARIANT]);
  assert.deepEqual(again.traffic, TRAFFIC);
  assert.deepEqual(again.costs, OPEN.costs);
  assert.deepEqual([again.record.file.name, await again.record.file.text(), again.record.file.type], ['new.csv', 'x,y\n1,2\n', 'text/csv']);
  assert.deepEqual([again.record.format, again.record.table], [FORMAT, RECORD.table]);
  assert.deepEqual([again.record.earlier.date, again.record.earlier.files[0].date, await again.record.earlier.files[0].file.text()], ['2026-05-01', '2025-05-01', 'old']);
  assert.deepEqual([again.plan.priors, again.plan.draws, again.plan.costs], [PLAN.priors, PLAN.draws, PLAN.costs]);
  assert.equal(await again.plan.data[0].text(), 'h');
});

test('a project of a case alone has no record and no plan', async () => {
  const { text, holds } = await written({ case: CASE, variants: [], traffic: null, costs: {}, record: null, plan: null });
  assert.deepEqual(Object.keys(JSON.parse(text)), ['format', 'version', 'case', 'variants', 'traffic', 'costs']);
  assert.doesNotMatch(holds, /record|calibration|cost/);
  const again = await read(file(text));
  assert.equal(again.record, undefined);
  assert.equal(again.plan, undefined);
  assert.equal(again.traffic, null);
});

test('what neither the page nor the program has any more is left out and named', async () => {
  const { fetch } = globalThis;
  const asked = [];
  globalThis.fetch = async (path, { body }) => {
    asked.push([path, JSON.parse(body)]);
    return JSON.parse(body).upload === 1 ? new Response('kept by the program') : new Response(JSON.stringify({ message: 'the file is no longer here' }), { status: 410 });
  };
  try {
    const { text, left } = await written({ ...OPEN, record: { ...RECORD, file: { name: 'new.csv' }, kept: 9 }, plan: { ...PLAN, data: [{ name: 'hammer.csv', file: undefined, kept: 1 }] } });
    assert.equal(left, 'new.csv');
    assert.equal(JSON.parse(text).record, undefined);
    assert.equal(letters(JSON.parse(text).plan.data[0]), 'kept by the program');
    assert.deepEqual(asked.map(([path]) => path), ['/api/upload/kept', '/api/upload/kept']);
  } finally {
    globalThis.fetch = fetch;
  }
});

test('what is no project is refused in a sentence', async () => {
  const { text } = await written({ ...OPEN, record: RECORD, plan: PLAN });
  const project = JSON.parse(text);
  const with_ = (more) => JSON.stringify({ ...project, ...more });
  const large = gzipSync(Buffer.alloc(257 << 20)).toString('base64');
  for (const [given, english, german] of [
    [text.slice(0, text.length / 2), 'damaged', 'beschädigt'], [with_({ version: 9 }), 'version 9', 'Version 9'], ['{"a": 1}', 'no project', 'kein Projekt'], ['null', 'no project', 'kein Projekt'], [with_({ case: [] }), 'damaged', 'beschädigt'],
    [with_({ record: { ...project.record, gzip_base64: project.record.gzip_base64.slice(0, 20) } }), 'damaged', 'beschädigt'],
    [with_({ plan: { ...project.plan, data: [{ name: 'a.csv', gzip_base64: 'AAAA' }] } }), 'damaged', 'beschädigt'],
    [with_({ record: { ...project.record, gzip_base64: large } }), 'more than 256 MiB', 'mehr als 256 MiB'],
  ]) {
    await assert.rejects(() => read(file(given)), (words) => typeof words === 'string' && words.includes(english) && words.includes('all.riffel'), english);
    const words = await inLanguageWhile('de', () => read(file(given)).catch((refusal) => refusal));
    assert.match(words, new RegExp(german));
  }
});

async function inLanguageWhile(name, act) {
  const { chooseLanguage } = await import('../../assets/words.js');
  chooseLanguage(name);
  try {
    return await act();
  } finally {
    chooseLanguage('en');
  }
}

test('a project of before without costs or variants is read, and what is none of them is left out', async () => {
  const again = await read(file(JSON.stringify({ format: 'riffel-project', version: 1, case: CASE, traffic: { from_km_per_h: 90, to_km_per_h: 30 }, plan: { data: [], priors: 3, costs: null }, record: { name: 'a.txt', gzip_base64: gzipSync('x').toString('base64') } })));
  assert.deepEqual([again.variants, again.traffic, again.costs], [[], null, {}]);
  assert.deepEqual([again.plan.priors, again.plan.costs], [{}, {}]);
  assert.deepEqual([again.record.format, again.record.table, again.record.earlier, again.record.file.type], [null, null, null, 'text/plain']);
});

test('what a link holds is told in words', () => {
  const words = inLanguage('de', () => inWords({ case: CASE, variants: [], traffic: null }));
  assert.match(words, /keinen eigenen Verkehr/);
  assert.doesNotMatch(words, /Messung/);
  assert.match(inLanguage('de', () => inWords({ case: CASE, variants: [], traffic: TRAFFIC, record: { file: { name: 'messung.csv' } } })), /die Messung messung\.csv/);
});
