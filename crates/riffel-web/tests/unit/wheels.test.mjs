// Growth under the wheels of a bogie: what is asked, what stands beside each picture, and a wheel that becomes that of the case.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inLanguage, place } from './page.mjs';
import { BogieWheels } from '../../assets/bogie-wheels.js';
import { Traffic } from '../../assets/traffic.js';

const settled = () => new Promise((done) => setImmediate(done));

const WHEEL = { wheelset: 1, rail: 'low', share_of_second_contact: 0, growth_rate_per_passage: [1e-7, 2e-7] };
const ANSWER = {
  wavelength_m: [0.02, 0.08], give_way: ['contact.tractive_ratio'],
  wheels: [
    { ...WHEEL, keys: { 'contact.creepage.lateral': 0.0034567891 }, highest: { wavelength_m: 0.0631, frequency_hz: 198.1, growth_rate_per_passage: 2e-7, at_edge: false, doubling_passages: 6e6 } },
    { ...WHEEL, rail: 'high', keys: {}, highest: { wavelength_m: 0.08, frequency_hz: 156, growth_rate_per_passage: 2e-7, at_edge: true, doubling_passages: 1e5 } },
    { ...WHEEL, rail: 'high', share_of_second_contact: 0.6, keys: {}, highest: null },
    { ...WHEEL, wheelset: 2, growth_rate_per_passage: null, not_in_loop: { id: 'no-constant-force-in-time', values: {} } },
    { ...WHEEL, wheelset: 2, rail: 'high', growth_rate_per_passage: [-1e-7, -2e-7], keys: {}, highest: null },
  ],
};

/** The wheels of a page, with its questions, each of which is answered by hand. */
function wheels(context) {
  const open = [];
  context.mock.method(globalThis, 'fetch', (path, { body }) => new Promise((answer) => open.push({ path, asked: JSON.parse(body), answer: (given) => answer(new Response(JSON.stringify(given))) })));
  const traffic = new Traffic(place(), { onChange: () => {}, onTrouble: () => {} });
  traffic.show(null);
  traffic.setUsual({ speeds_m_per_s: [80 / 3.6, 140 / 3.6], passages_per_day: 6000, in_curve: false, fastest_doubling_days: 96 });
  const state = { accepted: { wheel: { mass: '350 kg' } }, keys: { contact: { tractive_ratio: 0.1, friction: 0.4 } } };
  const opened = [];
  const one = new BogieWheels({ state, traffic, inLabels: undefined, unitOf: () => '', replace: (next, words) => opened.push([next, words]), save: () => {} });
  return { one, open, state, opened, figures: () => one.multiples.children.map(({ textContent }) => textContent) };
}

test('each wheel says where growth is highest, whether at the edge of the window, and in what time it doubles', async (context) => {
  const { one, open, figures } = wheels(context);
  one.ask({ wheel: { name: 'S1002' } });
  open[0].answer(ANSWER);
  await settled();
  const [first, edge, out, calm, ...more] = figures();
  // Of a wheel on two points the contact that carries more.
  assert.equal(more.length, 0);
  assert.match(first, /^Wheelset 1, low rail.*2\.0·10⁻⁷ per passage at 63\.1 mm, 198 Hz; to double: 6 million passages, 33 months/);
  assert.match(edge, /^Wheelset 1, high rail.*80 mm, 156 Hz, at the edge of the window; to double: faster than any railway known/);
  assert.match(out, /^Wheelset 2, low rail.*no creepage keeps the force/);
  assert.match(calm, /^Wheelset 2, high rail.*nothing grows/);
  // All of it follows the language.
  inLanguage('de', () => one.reword());
  assert.match(figures()[1], /am Rand des Fensters/);
  assert.match(figures()[2], /hält kein Schlupf die Kraft/);
});

test('growth of the wheels is that of the case at hand', async (context) => {
  const { one, open, state, figures } = wheels(context);
  const curve = { set: { 'curve.radius': 180 } };
  one.ask(curve);
  assert.deepEqual([open[0].path, open[0].asked], ['/api/curve/wheels', { ...curve, case: { keys: { wheel: { mass: '350 kg' } } } }]);
  open[0].answer(ANSWER);
  await settled();
  assert.equal(figures().length, 4);
  one.caseChanged();
  assert.equal(open.length, 1);
  state.accepted = { wheel: { mass: '900 kg' } };
  one.caseChanged();
  assert.deepEqual(open[1].asked, { ...curve, case: { keys: { wheel: { mass: '900 kg' } } } });
  assert.ok(one.panel.classes.has('stale'));
  const [wheel] = ANSWER.wheels;
  open[1].answer({ ...ANSWER, wheels: [{ ...wheel, highest: { ...wheel.highest, wavelength_m: 0.0412 } }] });
  await settled();
  assert.match(figures().join(), /41\.2 mm/);
  assert.equal(one.panel.classes.has('stale'), false);
  // A bogie that does not stand has no wheels in the loop.
  one.ask(null);
  assert.deepEqual([open.length, one.panel.hidden], [2, true]);
});

test('a wheel becomes that of the case, with what it brings and without what gives way', async (context) => {
  const { one, open, state, opened } = wheels(context);
  one.ask({});
  open[0].answer(ANSWER);
  await settled();
  one.multiples.children[0].inside.find(({ tagName }) => tagName === 'BUTTON').click();
  const [[next, words]] = opened;
  assert.deepEqual(next.case.contact.friction, 0.4);
  assert.equal('tractive_ratio' in next.case.contact, false);
  assert.ok(Math.abs(next.case.contact.creepage.lateral / 0.0034567891 - 1) < 1e-4, 'five digits are written');
  assert.match(words, /Wheelset 1, low rail/);
  assert.equal(state.keys.contact.tractive_ratio, 0.1, 'undo finds what was there');
});
