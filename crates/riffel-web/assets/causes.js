// Cards of causes: a small picture of the mechanism, what speaks for it and against it, and what would settle it.

import { element, svgElement, worded } from './elements.js';

const SUPPORTS = [20, 60, 100];
const boxes = (y, width, height) => SUPPORTS.map((x) => `<rect x="${x - width / 2}" y="${y}" width="${width}" height="${height}"/>`).join('');
const line = (d, name = '') => `<path class="${name}" d="${d}"/>`;
/** An arrow up and one down. */
const shakes = (x, y) => line(`M${x} ${y - 8}v16m-3-3 3 3 3-3m-6-10 3-3 3 3`, 'moves');
const WHEEL = '<circle cx="60" cy="17" r="13"/>';
const STRAIGHT = 'M4 32h112';

/** Wheel, rail, pads, sleepers and ballast from the side; those that `move` are marked. */
function side(moves, marks, { rail = STRAIGHT, wheel = WHEEL } = {}) {
  const layers = [['wheel', wheel], ['rail', line(rail)], ['pad', boxes(34, 8, 3)], ['sleeper', boxes(38, 20, 7)], ['ballast', line('M4 50h112', 'dotted')]];
  return layers.map(([name, inner]) => `<g class="${moves.includes(name) ? 'moves' : ''}">${inner}</g>`).join('') + marks;
}
const discs = (axle, marks) => `${line(axle)}<ellipse cx="26" cy="29" rx="6" ry="18"/><ellipse cx="94" cy="29" rx="6" ry="18"/>${marks}`;
const spectrum = (way) => line('M6 6v44h108') + line(`M10 ${29 - 6 * way}C40 ${29 - 6 * way} 50 ${29 + 20 * way} 60 ${29 + 20 * way}S80 ${29 - 6 * way} 112 ${29 - 6 * way}`, 'moves');
const [PEAK, DIP] = [spectrum(-1), spectrum(1)];

/** A picture for each mechanism, by its name in the answers. */
const PICTURES = {
  'growth ridge': line('M6 40c8 0 8-12 16-12s8 12 16 12 8-12 16-12', 'moves') + line('M60 30c6-22 34-22 42-4m-8 0 8 0 1-8M102 40c-6 18-32 16-40 2m8-1-8 1-2 8'),
  'P2 resonance': side(['wheel'], shakes(86, 16)),
  'full-track resonance': side(['rail', 'pad', 'sleeper'], shakes(80, 20)),
  'sleeper antiresonance': side(['sleeper'], shakes(80, 46)),
  'rail on pad': side(['rail'], shakes(86, 24)),
  'pinned-pinned, vertical': side(['rail'], '', { rail: 'M4 26q8-2 16 6t40 0 40 0q8-2 16 2' }),
  'pinned-pinned, lateral': boxes(6, 12, 44) + line('M4 22q8-2 16 6t40 0 40 0q8-2 16 2', 'moves'),
  'wheelset torsion': discs('M26 29h68', line('M16 14c-8 10-8 20 0 30m-5-1 5 1 1-6M104 44c8-10 8-20 0-30m5 1-5-1-1 6', 'moves')),
  'wheelset bending': discs('M26 29h68', line('M26 29Q60 4 94 29', 'moves')),
  'grinding mark': side(['rail'], '', { wheel: '', rail: `M4 32${'l7-4 7 4'.repeat(8)}` }),
  'sleeper passing': side(['sleeper'], line('M84 17h22m-5-4 5 4-5 4')),
  'wheel circumference': side(['wheel'], '', { wheel: '<polygon points="60,3 68,7 73,14 72,22 66,29 58,30 50,26 47,18 48,10 54,5"/>' }),
  'peak of the measured receptance': PEAK, 'peak of the given receptance': PEAK, 'dip of the measured receptance': DIP, 'dip of the given receptance': DIP,
};

function picture(mechanism) {
  const svg = svgElement('svg', { viewBox: '0 0 120 56', 'aria-hidden': true });
  svg.innerHTML = PICTURES[mechanism] ?? '<text x="60" y="40" text-anchor="middle">?</text>';
  return svg;
}

/** The card of a mechanism. `head` stands beside the picture; `reasons` are for and against; what would settle it is one element. */
export function card(mechanism, head, [reasonsFor, reasonsAgainst], measurement) {
  const list = (word, reasons, name) => (reasons.length ? [element('dt', { className: name }, worded('span', word)), ...reasons.map((reason) => element('dd', {}, reason))] : []);
  const lines = element('dl', {}, ...list('speaks_for', reasonsFor, 'good'), ...list('speaks_against', reasonsAgainst, 'bad'), ...list('would_settle', [measurement], ''));
  return element('section', { className: 'card' }, picture(mechanism), element('div', { className: 'head' }, ...head), lines);
}
