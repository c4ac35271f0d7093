// The bogie from above as it stands in its curve, travelling to the right: wheels coloured by wear, creep forces on the rail as arrows.

import { svgElement } from './elements.js';
import { number, t } from './words.js';

/** Breadth of the head of a rail [m], length and breadth of a wheel, length of the longest arrow. */
const HEAD = 0.07;
const WHEEL = [0.5, 0.13];
const ARROW = 0.55;
/** Most that angles [rad] and shifts [m] are drawn as. */
const SEEN = { angle: 0.22, shift: 0.12, bow: 0.35 };

/** `curve` is what the program tells of the equilibrium; `label` says it in words. */
export function drawBogie(place, curve, { radius, gauge, wheelbase, label }) {
  // To the middle of either rail; axle ends, frame and picture reach beyond it.
  const half = 0.5 * (gauge + HEAD);
  const [frame, end, edge] = [half + 0.3, half + 0.35, half + 1];
  const largest = (values) => Math.max(...values.map(Math.abs), 1e-12);
  const reach = 0.5 * wheelbase + 0.7;
  const factor = Math.min(
    30,
    SEEN.angle / largest(curve.wheelsets.map((one) => one.yaw_rad)),
    SEEN.shift / largest(curve.wheelsets.map((one) => one.lateral_shift_m)),
    (SEEN.bow * 2 * Math.abs(radius)) / reach ** 2,
  );
  // Rounded, so that it can be told.
  const step = 10 ** Math.floor(Math.log10(factor));
  const scale = Math.floor(factor / step) * step;
  const across = (x) => (scale * x * x) / (2 * radius);
  const svg = svgElement('svg', { viewBox: `${-reach} ${-edge} ${2 * reach} ${2 * edge}`, role: 'img', 'aria-label': label, class: 'bogie' });
  for (const side of [-half, half]) {
    const places = Array.from({ length: 41 }, (_, k) => -reach + (2 * reach * k) / 40);
    svg.append(svgElement('polyline', { points: places.map((x) => `${x.toFixed(3)},${(across(x) + side).toFixed(3)}`).join(' '), class: 'rail' }));
  }
  const wear = largest(curve.wheels.map((wheel) => wheel.t_gamma_n));
  const force = largest(curve.wheels.map((wheel) => Math.hypot(wheel.longitudinal_force_n, wheel.lateral_force_n)));
  const axles = curve.wheelsets.map((one, index) => {
    const x = [0.5, -0.5][index] * wheelbase;
    return { x, y: across(x) + scale * one.lateral_shift_m, yaw: scale * (one.yaw_rad + x / radius) };
  });
  if (axles.length === 2) {
    // The frame lies on the axles.
    const [front, rear] = axles;
    for (const side of [-1, 1]) {
      svg.append(svgElement('line', { x1: rear.x, y1: rear.y + side * frame, x2: front.x, y2: front.y + side * frame, class: 'frame' }));
    }
    svg.append(svgElement('line', { x1: 0, y1: 0.5 * (front.y + rear.y) - frame, x2: 0, y2: 0.5 * (front.y + rear.y) + frame, class: 'frame' }));
  }
  axles.forEach(({ x, y, yaw }, index) => {
    const turned = svgElement('g', { transform: `translate(${x} ${y}) rotate(${(yaw * 180) / Math.PI})` });
    turned.append(svgElement('line', { x1: 0, y1: -end, x2: 0, y2: end, class: 'axle' }));
    const wheels = curve.wheels.filter((wheel) => wheel.wheelset === index + 1);
    for (const wheel of wheels) {
      const side = wheel.rail === 'left' ? -half : half;
      const share = Math.max(wheel.t_gamma_n, 0) / wear;
      const rect = svgElement('rect', { x: -0.5 * WHEEL[0], y: side - 0.5 * WHEEL[1], width: WHEEL[0], height: WHEEL[1], rx: 0.03, class: 'wheel' });
      rect.style.fillOpacity = (0.08 + 0.92 * share).toFixed(3);
      turned.append(rect);
    }
    svg.append(turned);
    for (const wheel of wheels) {
      const side = wheel.rail === 'left' ? -half : half;
      // Where the yawed axle has this wheel.
      const at = [x - side * Math.sin(yaw), y + side * Math.cos(yaw)];
      const tip = [wheel.longitudinal_force_n, wheel.lateral_force_n].map((part) => (ARROW * part) / force);
      const length = Math.hypot(...tip);
      if (length < 0.02) continue;
      const angle = (Math.atan2(tip[1], tip[0]) * 180) / Math.PI;
      const arrow = svgElement('g', { transform: `translate(${at[0]} ${at[1]}) rotate(${angle})`, class: 'creep' });
      arrow.append(
        svgElement('line', { x1: 0, y1: 0, x2: Math.max(length - 0.1, 0), y2: 0 }),
        svgElement('path', { d: `M${length} 0 l-0.13 0.055 v-0.11 Z` }),
      );
      svg.append(arrow);
    }
  });
  // The way of travel.
  svg.append(svgElement('path', { d: `M${reach - 0.42} 0 h0.24 m-0.09 -0.07 l0.09 0.07 l-0.09 0.07`, class: 'travel' }));
  const words = document.createElement('p');
  words.className = 'why';
  words.textContent = t('bogie_drawn', { scale, force: number(1e-3 * force), wear: number(wear) });
  place.replaceChildren(svg, words);
}
