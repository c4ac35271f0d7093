// A wheelset as it moves in one of its modes: axle, wheels and discs seen from the front and a little from the side.

import { svgElement } from './elements.js';

/** What is seen of a length along the rail: across and upward. */
const DEPTH = [0.42, 0.24];
/** How large the largest displacement is drawn [m]. */
const SEEN = 0.16;
/** Corners of a wheel. */
const CORNERS = 40;
/** Radius of a disc between the wheels over that of a wheel, breadth of wheels and discs [m]. */
const DISC = 0.62;
const BREADTH = { wheel: 0.13, disc: 0.06 };

/** A point along the rail, to the right and downward [m] on the sheet. */
const seen = ([x, y, z]) => [y + DEPTH[0] * x, z - DEPTH[1] * x];
const written = (points) => points.map((point) => seen(point).map((value) => value.toFixed(4)).join(',')).join(' ');

export class WheelsetDrawing {
  /** `wheelset` is what the program tells of it; `label` says it in words. */
  constructor(place, wheelset, label) {
    this.wheelset = wheelset;
    const { position_m: places, rolling_radius_m: radius } = wheelset;
    const [half, high] = [0.5 * (places.at(-1) - places[0]) + 0.35, 1.55 * radius];
    this.svg = svgElement('svg', { viewBox: `${-half} ${-high} ${2 * half} ${2 * high}`, role: 'img', 'aria-label': label, class: 'wheelset' });
    // Where nothing moves.
    this.svg.append(svgElement('line', { x1: places[0], y1: 0, x2: places.at(-1), y2: 0, class: 'rest' }));
    this.bodies = wheelset.discs.map((disc) => {
      const kind = disc.is_wheel ? 'wheel' : 'disc';
      const own = disc.is_wheel ? radius : disc.turns ? DISC * radius : 0.18;
      const body = { disc, radius: own, breadth: BREADTH[kind], back: svgElement('polygon', { class: kind }), face: svgElement('polygon', { class: `${kind} face` }), spoke: svgElement('polyline', { class: 'spoke' }) };
      return body;
    });
    // What is further left lies behind: a piece of the axle, what sits on its end, the next piece.
    this.bodies.sort((a, b) => a.disc.position_m - b.disc.position_m);
    const nearest = (y) => Math.round(((places.length - 1) * (y - places[0])) / (places.at(-1) - places[0]));
    const cuts = [0, ...this.bodies.map(({ disc }) => Math.min(places.length - 1, Math.max(0, nearest(disc.position_m)))), places.length - 1];
    this.pieces = cuts.slice(1).map((to, k) => ({ from: cuts[k], to, line: svgElement('polyline', { class: 'shaft' }) }));
    for (const { line } of this.pieces) line.style.strokeWidth = wheelset.axle_diameter_m || 0.1;
    this.svg.append(...this.bodies.flatMap(({ back, face, spoke, disc }, k) => [this.pieces[k].line, back, face, ...(disc.turns ? [spoke] : [])]), this.pieces.at(-1).line);
    place.replaceChildren(this.svg);
  }

  /** Draw a mode at a share of its amplitude, from -1 to 1. */
  draw(mode, share) {
    const { position_m: places, rolling_radius_m: radius } = this.wheelset;
    const scale = SEEN * share;
    const moved = places.map((y, k) => {
      const [x, along, z] = mode.displacement[k].map((part) => scale * part);
      return [x, y + along, z];
    });
    for (const { from, to, line } of this.pieces) line.setAttribute('points', written(moved.slice(from, to + 1)));
    const step = places[1] - places[0];
    for (const { disc, radius: own, breadth, back, face, spoke } of this.bodies) {
      const k = Math.min(places.length - 2, Math.max(1, Math.round((disc.position_m - places[0]) / step)));
      const [cx, cy, cz] = moved[k];
      // Slopes of the axle, by which the plane of the wheel leans.
      const [sx, sz] = [0, 2].map((axis) => (moved[k + 1][axis] - moved[k - 1][axis]) / (2 * step));
      const twist = disc.turns ? (scale * 2 * mode.twist[k]) / radius : 0;
      const at = (angle, r, side) => {
        const [x, z] = [r * Math.cos(angle), r * Math.sin(angle)];
        return [cx + x, cy + side - sx * x - sz * z, cz + z];
      };
      const circle = (side) => Array.from({ length: CORNERS }, (_, corner) => at((2 * Math.PI * corner) / CORNERS, own, side));
      back.setAttribute('points', written(circle(-0.5 * breadth)));
      face.setAttribute('points', written(circle(0.5 * breadth)));
      spoke.setAttribute('points', written([at(twist - Math.PI / 2, own, 0.5 * breadth), at(twist + Math.PI / 2, own, 0.5 * breadth)]));
    }
  }
}
