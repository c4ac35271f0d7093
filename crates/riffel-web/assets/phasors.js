// The loop as arrows: which way each oscillation points, with the profile to the right. What points to the
// left of the upright line is in antiphase with the profile; where that is the dissipation, corrugation grows.

import { svgElement } from './elements.js';
import { number, speed, t } from './words.js';

const RADIUS = 100;

/** Name, colour, length of the arrow, value and unit of the table; a loop on all axes has a lateral force and no one angular velocity. */
const ARROWS = [
  ['profile', 'Δ', 'ink', 1, (s) => [s.amplitude_m, 0], 1e6, 'µm'],
  ['normal', 'P₁', 'phasor-p', 0.9, (s) => s.normal_force_n, 1e-3, 'kN'],
  ['tangential', 'Q₁', 'phasor-q', 0.78, (s) => s.tangential_force_n, 1, 'N'],
  ['lateral_force', 'Q_y', 'phasor-o', 0.66, (s) => s.lateral_force_n, 1, 'N'],
  ['angular', 'Ω₁', 'phasor-o', 0.66, (s) => s.angular_velocity_rad_per_s, 1e3, 'mrad/s'],
  ['dissipation', 'W₁', 'phasor-w', 1, (s) => s.dissipation_lag_w, 1, 'W'],
];

const modulus = ([re, im]) => Math.hypot(re, im);
const degrees = ([re, im]) => (Math.atan2(im, re) * 180) / Math.PI;

/** `inWords` says how long a count of passages is. */
export function drawPhasors(place, table, state, inWords) {
  const svg = svgElement('svg', { viewBox: '-132 -122 264 244', role: 'img', 'aria-label': words(state, inWords) });
  svg.append(
    svgElement('path', { d: `M0 ${-RADIUS - 12} A${RADIUS + 12} ${RADIUS + 12} 0 0 0 0 ${RADIUS + 12} Z`, class: 'half' }),
    svgElement('circle', { r: RADIUS, class: 'ring' }), svgElement('circle', { r: RADIUS / 2, class: 'ring faint' }),
    svgElement('line', { x1: -RADIUS - 12, x2: RADIUS + 12, y1: 0, y2: 0, class: 'ring' }),
    svgElement('line', { y1: -RADIUS - 12, y2: RADIUS + 12, x1: 0, x2: 0, class: 'ring' }),
    svgElement('text', { x: -RADIUS - 8, y: -RADIUS - 4, class: 'side', 'text-anchor': 'start' }, t('grows_here')),
    svgElement('text', { x: RADIUS + 8, y: -RADIUS - 4, class: 'side', 'text-anchor': 'end' }, t('decays_here')),
  );
  for (const degree of [30, 60, 120, 150, 210, 240, 300, 330]) {
    const [c, s] = [Math.cos((degree * Math.PI) / 180), Math.sin((degree * Math.PI) / 180)];
    svg.append(svgElement('line', { x1: 96 * c, y1: 96 * s, x2: 100 * c, y2: 100 * s, class: 'ring' }));
  }
  const taken = [];
  const arrows = ARROWS.filter(([, , , , value]) => value(state));
  for (const [name, symbol, color, length, value] of arrows) {
    const pair = value(state);
    if (!(modulus(pair) > 0)) continue;
    const angle = (-degrees(pair) * Math.PI) / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const reach = RADIUS * length;
    const arrow = svgElement('g', { class: `arrow ${name}` });
    arrow.style.color = `var(--${color})`;
    arrow.append(svgElement('line', { x1: 0, y1: 0, x2: (reach - 7) * c, y2: (reach - 7) * s }));
    arrow.append(svgElement('path', { d: 'M0 0 L-10 4 L-10 -4 Z', transform: `translate(${reach * c} ${reach * s}) rotate(${(angle * 180) / Math.PI})` }));
    // Names keep out of each other's way.
    let out = reach + 11;
    while (taken.some(([x, y]) => Math.hypot(x - out * c, y - out * s) < 15) && out > 24) out -= 13;
    taken.push([out * c, out * s]);
    const shift = out < reach ? 9 : 0;
    arrow.append(svgElement('text', { x: out * c - shift * s, y: out * s + shift * c + 4, 'text-anchor': 'middle' }, symbol));
    svg.append(arrow);
  }
  place.replaceChildren(svg);

  table.replaceChildren(...arrows.map(([name, , color, , value, factor, unit]) => {
    const pair = value(state);
    const row = document.createElement('tr');
    const cell = (tag, text) => Object.assign(document.createElement(tag), { textContent: text });
    const head = cell('th', t(name));
    head.scope = 'row';
    head.style.setProperty('--mark', `var(--${color})`);
    const size = modulus(pair) * factor;
    row.append(head, cell('td', `${number(size, 3)} ${unit}`), cell('td', size > 0 ? `${number(degrees(pair), 3)}°` : '–'));
    return row;
  }));
}

/** The same in words. */
export function words(state, inWords) {
  const force = Math.round(degrees(state.normal_force_n));
  const lag = Math.abs(Math.round(degrees(state.dissipation_lag_w)));
  const rate = state.growth_rate_per_passage;
  const count = inWords(Math.LN2 / Math.abs(rate), rate > 0);
  return t('sentence', {
    lambda: number(1e3 * state.wavelength_m, 3), speed: speed(state.speed_m_per_s), hertz: number(state.frequency_hz, 3),
    force: Math.abs(force) < 2 ? t('inphase') : force > 0 ? t('leads', force) : t('lags', -force),
    where: lag > 90 ? t('troughs', lag) : t('crests', lag),
    verdict: rate === 0 ? t('stays') : rate > 0 ? t('doubles', count) : t('halves', count),
  });
}
