// What is drawn and handed out, as text: SVG, tables, colours, places of names; and that all scripts fit together.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { SourceTextModule, SyntheticModule } from 'node:vm';
import { place } from './page.mjs';
import { css, differenceSteps, growthSteps, orderedColor } from '../../assets/colors.js';
import { csv, offer } from '../../assets/figures.js';
import { MapNames, frame, overlap } from '../../assets/map-names.js';
import { ticks } from '../../assets/map-view.js';
import { SvgContext } from '../../assets/svg-context.js';

const ASSETS = new URL('../../assets/', import.meta.url);

test('every script is strict, and what it imports is exported', async () => {
  const known = new Map();
  const module = (url) => {
    if (known.has(url)) return known.get(url);
    const made = url.endsWith('/wordings.js') ? new SyntheticModule(['LANGUAGES'], () => {}) : new SourceTextModule(readFileSync(new URL(url), 'utf8'), { identifier: url });
    known.set(url, made);
    return made;
  };
  const scripts = readdirSync(ASSETS).filter((name) => name.endsWith('.js'));
  for (const name of scripts) {
    const one = module(new URL(name, ASSETS).href);
    if (one.status === 'unlinked') await one.link((specifier, from) => module(new URL(specifier, from.identifier).href));
  }
  // Every one of them is part of the page.
  const imported = new Set([...known.values()].flatMap((one) => one.moduleRequests?.map(({ specifier }) => specifier.slice(2)) ?? []));
  assert.deepEqual(scripts.filter((name) => !imported.has(name)), ['main.js']);
});

test('what is drawn on a canvas is written as SVG', () => {
  const context = new SvgContext(300.004, 200, '#fff');
  context.setTransform();
  context.clearRect();
  Object.assign(context, { strokeStyle: '#123', fillStyle: 'url("a")', lineWidth: 1.256 });
  context.beginPath();
  context.moveTo(1.001, 2);
  context.lineTo(3, 4.567);
  context.closePath();
  context.stroke();
  context.setLineDash([4, 2]);
  context.strokeRect(10, 20, 30, 40);
  context.setLineDash([]);
  context.fillRect(0, 0, 5, 5);
  context.beginPath();
  context.arc(50, 60, 7);
  context.fill();
  const text = context.text();
  assert.ok(text.startsWith('<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200" viewBox="0 0 300 200"><rect width="300" height="200" fill="#fff"/>'));
  for (const part of [
    '<path d="M1 2L3 4.57z" fill="none" stroke="#123" stroke-width="1.26"/>', '<path d="M10 20h30v40h-30z" fill="none" stroke="#123" stroke-width="1.26" stroke-dasharray="4 2"/>', '<path d="M0 0h5v5h-5z" fill="url(&quot;a&quot;)"/>',
    '<path d="M43 60a7 7 0 1 0 14 0a7 7 0 1 0 -14 0z" fill="url(&quot;a&quot;)"/>',
  ]) assert.ok(text.includes(part), `${part} in ${text}`);
  // A path without a point is none.
  context.beginPath();
  context.stroke();
  assert.equal(context.text(), text);
  context.lineTo(7, 8);
  context.stroke();
  assert.ok(context.text().includes('d="M7 8"'));
});

test('groups of a drawing are closed as they were opened, and styles come back', () => {
  const context = new SvgContext(100, 100, 'none');
  Object.assign(context, { fillStyle: 'red', font: '600 12px "DejaVu Sans", serif', textAlign: 'center', textBaseline: 'middle' });
  context.save();
  Object.assign(context, { fillStyle: 'blue', font: '9px serif', textAlign: 'right' });
  context.rect(0, 0, 10, 10);
  context.clip();
  context.translate(5, 6.789);
  context.rotate(-Math.PI / 2);
  context.fillText('a < b & "c"', 1, 2);
  context.restore();
  context.fillText('537 Hz', 10, 20);
  const text = context.text();
  assert.match(text, /<clipPath id="(clip-\d+)"><path d="M0 0h10v10h-10z"\/><\/clipPath><g clip-path="url\(#\1\)"><g transform="translate\(5 6\.79\)"><g transform="rotate\(-90\)">/);
  assert.ok(text.includes('<text x="1" y="5.24" font-size="9" font-family="serif" text-anchor="end" fill="blue">a &lt; b &amp; &quot;c&quot;</text></g></g></g>'), text);
  assert.ok(text.includes('<text x="10" y="24.32" font-size="12" font-weight="600" font-family="&quot;DejaVu Sans&quot;, serif" text-anchor="middle" fill="red">537 Hz</text></svg>'), text);
  assert.equal(context.measureText('abc').width, 18);
  context.save();
  context.translate(1, 1);
  assert.ok(context.text().endsWith('</g></svg>'), 'what is open is closed');
  context.drawImage(place('canvas'), 1, 2, 30, 40);
  assert.ok(context.text().includes('<image x="1" y="2" width="30" height="40" preserveAspectRatio="none" href="data:image/png;base64,"/>'));
});

test('a table is written with quotation marks where a cell needs them', () => {
  assert.equal(csv([['a', 'b, c', 'say "d"'], [1.5, null, undefined], ['x\ny', true, 0]]), 'a,"b, c","say ""d"""\n1.5,,\n"x\ny",true,0\n');
});

/** The table that a figure hands out. */
async function tableOf(figure, kinds) {
  const header = place('header');
  let saved;
  const given = new Promise((done) => (saved = (blob, name) => done([blob, name])));
  offer(header, () => figure, saved, kinds);
  header.inside.find(({ dataset }) => dataset.figure === 'csv').click();
  const [blob, name] = await given;
  assert.equal(blob.type, 'text/csv');
  return [name, await blob.text()];
}

test('a figure hands out its numbers', async () => {
  const map = { wavelength: { min: 0.02, max: 0.08 }, speed: { min: 5, max: 60 }, columns: 3, rows: 2, values: Float32Array.of(1, -2, 0.1, 4, 5, 6e-9) };
  const rows = 'wavelength_m,speed_m_per_s,growth_rate_per_passage\n0.02,5,1\n0.05,5,-2\n0.08,5,0.1\n0.02,60,4\n0.05,60,5\n0.08,60,6e-9\n';
  assert.deepEqual(await tableOf({ name: 'map', map: { map, kind: 'growth' } }), ['map.csv', rows]);
  assert.match((await tableOf({ name: 'map', map: { map, kind: 'difference' } }))[1], /growth_rate_difference_per_passage/);
  const plot = {
    layout: { xaxis: { title: { text: 'wavelength λ [mm]' } }, yaxis: { title: { text: 'growth' } }, yaxis2: {} },
    data: [{ name: 'a &lt; b', x: [1, 2], y: [3, 4] }, { x: [5], y: [null], yaxis: 'y2' }, { name: 'empty', x: [], y: [] }, { name: 'none' }],
  };
  assert.deepEqual(await tableOf({ name: 'growth', plot }, ['csv']), ['growth.csv', 'curve,wavelength λ [mm],value,quantity\na < b,1,3,growth\na < b,2,4,growth\n,5,,yaxis2\n']);
  const table = { rows: [{ cells: [{ textContent: ' P₁ ' }, { textContent: '31.5 kN' }] }] };
  assert.deepEqual((await tableOf({ name: 'loop', table }))[1], 'P₁,31.5 kN\n');
  assert.equal((await tableOf({ name: 'own', table, rows: [[1]] }))[1], '1\n');
});

const lightness = ([red, green, blue]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
const rises = (values) => values.every((value, k) => k === 0 || value > values[k - 1]);

test('colours of growth tell weak from strong by their lightness', () => {
  const [light, dark] = [growthSteps(false), growthSteps(true)];
  assert.equal(light.length, 10);
  assert.ok(rises(light.map(lightness).reverse()));
  assert.deepEqual(dark, [...light].reverse());
  for (const steps of [light, differenceSteps(false).more, differenceSteps(true).less]) for (const color of steps) assert.ok(color.every((part) => Number.isInteger(part) && part >= 0 && part <= 255));
  // Blue: of weak growth hardly, of strong growth much.
  const [[red, , blue], strong] = [light[0], light.at(-1)];
  assert.ok(blue > red && strong[2] > 2 * strong[0]);
  for (const isDark of [false, true]) {
    const { more, less } = differenceSteps(isDark);
    const order = isDark ? [more, less] : [[...more].reverse(), [...less].reverse()];
    for (const steps of order) assert.ok(rises(steps.map(lightness)));
    assert.ok(more.at(-1)[0] > more.at(-1)[2] && less.at(-1)[2] > less.at(-1)[0]);
  }
  assert.equal(css([1, 2, 3]), 'rgb(1,2,3)');
  const family = (isDark) => [0, 0.25, 0.5, 0.75, 1].map((share) => lightness(orderedColor(share, isDark).match(/\d+/g).map(Number)));
  assert.ok(rises(family(false)) && rises(family(true).reverse()));
});

test('ticks are round numbers between two values, some of a wanted count', () => {
  const close = (found, expected) => assert.deepEqual(found.map((value) => Number(value.toPrecision(9))), expected);
  close(ticks(20, 80, 6), [20, 30, 40, 50, 60, 70, 80]);
  close(ticks(18, 216, 5), [50, 100, 150, 200]);
  close(ticks(0, 1, 5), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  close(ticks(-12, 13, 6), [-10, -5, 0, 5, 10]);
});

test('names of a map keep out of each other and of its marks', () => {
  const context = new SvgContext(400, 300, 'none');
  const within = { left: 10, top: 10, width: 380, height: 280 };
  const line = Array.from({ length: 50 }, (_, k) => ({ x: 20 + 7 * k, y: 280 - 5 * k }));
  const style = { font: '10px serif', color: '#000', ground: '#fff' };
  const names = new MapNames(context, within, 10, []);
  for (let k = 0; k < 6; k++) names.write(`${100 + k} Hz`, line, style);
  assert.equal(names.placed.length, 6);
  names.placed.forEach((one, k) => names.placed.slice(0, k).forEach((other) => assert.ok(!overlap(one, other))));
  for (const { left, right, top, bottom } of names.placed) assert.ok(left >= 12 && right <= 388 && top >= 12 && bottom <= 288);
  // The first is tried near the upper end of its line, beside it.
  assert.ok(names.placed[0].right < line[43].x && names.placed[0].bottom < line[43].y);
  const marked = new MapNames(context, within, 10, Array.from({ length: 40 }, (_, k) => ({ x: 250 + 3 * k, y: 60 })));
  marked.write('100 Hz', line, style);
  const [spot] = marked.placed;
  assert.ok(!(spot.top < 60 && spot.bottom > 60 && spot.right > 250));
  const into = new MapNames(context, within, 10, []);
  into.write('traffic', [{ x: 200, y: 150 }], { ...style, into: true });
  assert.deepEqual(into.placed[0], frame(context, 'traffic', 10, { x: 200, y: 150 }));
  // Without room there is no name.
  const small = new MapNames(context, { left: 0, top: 0, width: 20, height: 20 }, 10, []);
  small.write('a long name', [{ x: 10, y: 10 }], style);
  small.write('outside', [{ x: 100, y: 100 }], style);
  assert.equal(small.placed.length, 0);
  assert.equal(overlap({ left: 0, right: 1, top: 0, bottom: 1 }, { left: 1, right: 2, top: 0, bottom: 1 }), false);
});
