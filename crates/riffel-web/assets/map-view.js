// A growth map on a canvas: bands of colour, zero contour, ridge, rays of constant frequency and a cursor.
// plotly.js takes 40 to 130 ms to draw a map of 241 × 221 points as heatmap or contours; this takes a few.

import { css, differenceSteps, growthSteps, letterSize, theme } from './colors.js';
import { MapNames, overlap } from './map-names.js';
import { SvgContext } from './svg-context.js';
import { number, power, speed as inUnit, t, unitOfSpeed } from './words.js';

/** Margins around the map in letters, which grow with the screen; and the size of letters in the same measure. */
const MARGIN = { left: 4, right: 1.1, top: 0.8, bottom: 3.1 };
const LETTERS = 0.85;
/** Pixels coloured at most: beyond, the picture is stretched a little. */
const MOST_PIXELS = 1.6e6;
/** Strongest zoom, that of a step of the keys, and that of a pixel of the wheel. */
const MOST_ZOOM = 20;
const ZOOM_STEP = 1.5;
const ZOOM_PIXEL = 0.002;
/** Branches named by their frequency, the strongest among them. */
const NAMED_BRANCHES = 4;

/** Round numbers between two values, some of a wanted count. */
export function ticks(low, high, count) {
  const step = 10 ** Math.floor(Math.log10((high - low) / count));
  const factor = [1, 2, 5, 10].find((factor) => (high - low) / (step * factor) <= count) ?? 10;
  const size = step * factor;
  const values = [];
  for (let k = Math.ceil(low / size - 1e-9); k * size <= high * (1 + 1e-9); k++) values.push(k * size);
  return values;
}

export class MapView {
  /** `place` is an element of the page; `onPoint(point, pinned)` is told of the cursor, which follows the pointer until it is pinned, and `onLeave` that the pointer has gone. */
  constructor(place, { onPoint, onLeave, label, kind = 'growth' } = {}) {
    // An element of the page knows its map.
    place.view = this;
    Object.assign(this, { place, onPoint, onLeave, kind, map: null, point: null, marks: [], names: [], taken: [], held: null, window: null, band: null, hover: null, dragged: null });
    this.field = document.createElement('canvas');
    this.marksOver = document.createElement('canvas');
    this.marksOver.tabIndex = onPoint ? 0 : -1;
    this.marksOver.setAttribute('role', 'img');
    if (label) this.marksOver.setAttribute('aria-label', label);
    place.append(this.field, this.marksOver);
    this.pixels = document.createElement('canvas');
    new ResizeObserver(() => this.draw()).observe(place);
    if (onPoint) this.#listen();
  }

  /** Show a map: axes in SI and growth rates, one row of wavelengths for each speed. */
  show(map) {
    this.map = map;
    const inside = (axis) => this.window?.[axis].min >= map[axis].min && this.window?.[axis].max <= map[axis].max;
    if (this.window && !(inside('wavelength') && inside('speed'))) this.#zoomTo(null);
    else this.draw();
  }

  /** The part of the map that is shown. */
  get frame() {
    return this.window ?? this.map;
  }

  /** Show the whole map. */
  zoomOut() {
    this.#zoomTo(null);
  }

  #zoomTo(window) {
    this.window = window;
    this.onZoom?.(Boolean(window));
    this.draw();
  }

  /** Zoom about a point, which keeps its place. */
  #zoomBy(factor, point) {
    const window = {};
    for (const axis of ['wavelength', 'speed']) {
      const [whole, shown] = [this.map[axis], this.frame[axis]];
      const span = Math.max((whole.max - whole.min) / MOST_ZOOM, (shown.max - shown.min) / factor);
      if (span >= whole.max - whole.min) return this.#zoomTo(null);
      const share = (point[axis] - shown.min) / (shown.max - shown.min);
      const min = Math.min(whole.max - span, Math.max(whole.min, point[axis] - share * span));
      window[axis] = { min, max: min + span };
    }
    this.#zoomTo(window);
  }

  /** Move the window, if there is one, so that a point lies in it. */
  #bringIn(point) {
    if (!this.window) return;
    const window = structuredClone(this.window);
    for (const axis of ['wavelength', 'speed']) {
      const { min, max } = window[axis];
      const by = Math.min(0, point[axis] - min) + Math.max(0, point[axis] - max);
      window[axis] = { min: min + by, max: max + by };
    }
    if (JSON.stringify(window) !== JSON.stringify(this.window)) this.#zoomTo(window);
  }

  set label(words) {
    this.marksOver.setAttribute('aria-label', words);
  }

  /** Move the cursor to a wavelength [m] and speed [m/s]. */
  moveTo(point) {
    this.point = point;
    this.#bringIn(point);
    this.#drawOver();
  }

  /** Largest magnitude of the values: that of the map, or the one held. */
  get scale() {
    return this.held ?? this.map?.strongest ?? 0;
  }

  draw() {
    const { width, height } = this.place.getBoundingClientRect();
    if (!this.map || width < 80 || height < 80) return;
    const ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.field, this.marksOver]) {
      if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
        canvas.width = Math.round(width * ratio);
        canvas.height = Math.round(height * ratio);
      }
    }
    this.ratio = ratio;
    this.#measure(width, height);
    this.#drawField();
    this.#drawOver();
  }

  #measure(width, height) {
    const em = letterSize();
    this.font = LETTERS * em;
    this.box = {
      left: MARGIN.left * em, top: MARGIN.top * em,
      width: width - (MARGIN.left + MARGIN.right) * em, height: height - (MARGIN.top + MARGIN.bottom) * em,
    };
    this.colors = theme();
  }

  // Colours ------------------------------------------------------------------------------------------

  /** The map with its marks as SVG in the colours of the page, without the cursor. */
  svg() {
    const { width, height } = this.place.getBoundingClientRect();
    const context = new SvgContext(width, height, theme().sheet);
    this.#measure(width, height);
    this.#drawField(context);
    this.#drawMarks(context, [...this.names]);
    return context.text();
  }

  #drawField(context = this.field.getContext('2d')) {
    const { box, ratio, colors } = this;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.field.width, this.field.height);
    this.#colorPixels();
    context.imageSmoothingEnabled = true;
    context.drawImage(this.pixels, box.left, box.top, box.width, box.height);
    this.#drawAxes(context, colors);
    this.#drawRays(context, colors);
    this.#drawBranches(context, colors);
    this.#drawRidge(context, colors);
    this.#drawNames(context, colors);
  }

  /** Value between the points of the grid, band and colour, pixel by pixel. */
  #colorPixels() {
    const { box, ratio, map, colors } = this;
    const shrink = Math.min(1, Math.sqrt(MOST_PIXELS / (box.width * box.height * ratio * ratio)));
    const width = Math.max(2, Math.round(box.width * ratio * shrink));
    const height = Math.max(2, Math.round(box.height * ratio * shrink));
    Object.assign(this.pixels, { width, height });
    const context = this.pixels.getContext('2d');
    const image = context.createImageData(width, height);
    const out = new Uint32Array(image.data.buffer);
    const rgba = ([r, g, b]) => (255 << 24) | (b << 16) | (g << 8) | r;
    const grows = this.kind === 'growth' ? growthSteps(colors.dark) : differenceSteps(colors.dark).more;
    const falls = this.kind === 'growth' ? null : differenceSteps(colors.dark).less;
    const more = Uint32Array.from(grows, rgba);
    const less = falls && Uint32Array.from(falls, rgba);
    const none = rgba(colors.dark ? [30, 34, 39] : [255, 255, 255]);
    const edge = rgba(colors.dark ? [150, 160, 172] : [64, 70, 78]);
    const count = more.length;
    const perBand = this.scale > 0 ? count / this.scale : 0;
    const { columns, rows, values } = map;
    // Place in the grid of a share of what is shown.
    const along = (axis, share, points) => ((this.frame[axis].min + share * (this.frame[axis].max - this.frame[axis].min) - map[axis].min) / (map[axis].max - map[axis].min)) * (points - 1);
    // Places of the pixels in the grid, once for all rows.
    const left = new Uint16Array(width);
    const share = new Float32Array(width);
    for (let x = 0; x < width; x++) {
      const place = along('wavelength', (x + 0.5) / width, columns);
      left[x] = Math.min(columns - 2, Math.max(0, Math.floor(place)));
      share[x] = place - left[x];
    }
    const row = new Float32Array(columns);
    const above = new Uint8Array(width);
    for (let y = 0; y < height; y++) {
      const place = along('speed', 1 - (y + 0.5) / height, rows);
      const lower = Math.min(rows - 2, Math.max(0, Math.floor(place)));
      const part = place - lower;
      const from = lower * columns;
      for (let i = 0; i < columns; i++) row[i] = values[from + i] * (1 - part) + values[from + columns + i] * part;
      let before = 0;
      for (let x = 0; x < width; x++) {
        const i = left[x];
        const value = row[i] + (row[i + 1] - row[i]) * share[x];
        const sign = value > 0 ? 1 : 2;
        let color;
        if (value > 0) color = more[Math.min(count - 1, (value * perBand) | 0)];
        else if (less && value < 0) color = less[Math.min(count - 1, (-value * perBand) | 0)];
        else color = none;
        // Where the sign changes, from left to right or from the row above, runs the zero contour.
        if ((before && before !== sign) || (y && above[x] !== sign)) color = edge;
        before = sign;
        above[x] = sign;
        out[y * width + x] = color;
      }
    }
    context.putImageData(image, 0, 0);
  }

  // Lines --------------------------------------------------------------------------------------------

  x(wavelength) {
    const { min, max } = this.frame.wavelength;
    return this.box.left + (this.box.width * (wavelength - min)) / (max - min);
  }

  y(speed) {
    const { min, max } = this.frame.speed;
    return this.box.top + this.box.height * (1 - (speed - min) / (max - min));
  }

  #drawAxes(context, colors) {
    const { box, frame } = this;
    const [unit, size] = unitOfSpeed();
    context.font = `${this.font}px ${colors.font}`;
    context.lineWidth = 1;
    context.strokeStyle = colors.soft;
    context.strokeRect(box.left + 0.5, box.top + 0.5, box.width - 1, box.height - 1);
    context.fillStyle = colors.soft;
    context.textAlign = 'center';
    context.textBaseline = 'top';
    const bottom = box.top + box.height;
    for (const mm of ticks(1e3 * frame.wavelength.min, 1e3 * frame.wavelength.max, box.width / (6.4 * this.font))) {
      const x = Math.round(this.x(mm / 1e3)) + 0.5;
      line(context, x, bottom, x, bottom - 5);
      line(context, x, box.top, x, box.top + 5);
      context.fillText(number(mm, 4), x, bottom + 5);
    }
    context.textAlign = 'right';
    context.textBaseline = 'middle';
    for (const tick of ticks(frame.speed.min / size, frame.speed.max / size, box.height / (3.8 * this.font))) {
      const y = Math.round(this.y(tick * size)) + 0.5;
      line(context, box.left, y, box.left + 5, y);
      line(context, box.left + box.width, y, box.left + box.width - 5, y);
      context.fillText(number(tick, 4), box.left - 6, y);
    }
    context.fillStyle = colors.ink;
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    context.fillText(`${t('wavelength')} λ [mm]`, box.left + box.width / 2, bottom + (MARGIN.bottom - 0.3) * letterSize());
    context.save();
    context.translate(4, box.top + box.height / 2);
    context.rotate(-Math.PI / 2);
    context.textBaseline = 'top';
    context.fillText(`${t('speed')} V [${unit}]`, 0, 0);
    context.restore();
  }

  /** Clip to the map while drawing. */
  #within(context, draw) {
    const { box } = this;
    context.save();
    context.beginPath();
    context.rect(box.left, box.top, box.width, box.height);
    context.clip();
    draw();
    context.restore();
  }

  /** Rays of constant frequency but for one that would lie on that of the strongest branch. */
  #rays() {
    const best = this.map.bestFit;
    return (this.map.rays ?? []).filter((hertz) => !best || Math.abs(Math.log(hertz / best)) > 0.12);
  }

  #drawRays(context, colors) {
    const { map } = this;
    const best = map.bestFit;
    const ray = (hertz, style, width, dash) => {
      context.strokeStyle = style;
      context.lineWidth = width;
      context.setLineDash(dash);
      line(context, this.x(map.wavelength.min), this.y(hertz * map.wavelength.min), this.x(map.wavelength.max), this.y(hertz * map.wavelength.max));
      context.setLineDash([]);
    };
    this.#within(context, () => {
      for (const hertz of this.#rays()) ray(hertz, colors.dark ? 'rgba(190,200,210,.45)' : 'rgba(90,98,108,.5)', 1, []);
      if (best) ray(best, colors.warm, 2, [7, 5]);
    });
  }

  /** A line through each branch of growth. */
  #drawBranches(context, colors) {
    context.strokeStyle = colors.warm;
    context.lineWidth = 1.4;
    this.#within(context, () => {
      for (const branch of this.#branches()) {
        context.beginPath();
        for (const { x, y } of this.#crest(branch)) context.lineTo(x, y);
        context.stroke();
      }
    });
  }

  /** Branches that are more than a point. */
  #branches() {
    return (this.map.branches ?? []).filter(({ points }) => points.speed_m_per_s.length > 1);
  }

  /** The crest of a branch on the canvas. */
  #crest({ points }) {
    return points.wavelength_m.map((wavelength, k) => ({ x: this.x(wavelength), y: this.y(points.speed_m_per_s[k]) }));
  }

  /** A ray of constant frequency on the canvas, from its lower end. */
  #ray(hertz) {
    const { wavelength, speed } = this.map;
    const [begin, end] = [Math.max(wavelength.min, speed.min / hertz), Math.min(wavelength.max, speed.max / hertz)];
    if (end <= begin) return [];
    return Array.from({ length: 61 }, (_, k) => begin + (k / 60) * (end - begin)).map((at) => ({ x: this.x(at), y: this.y(hertz * at) }));
  }

  /** Names by frequency: that of the strongest branch first, then the weaker ones, then the rays. */
  #drawNames(context, colors) {
    const { map } = this;
    const ridge = (map.ridge?.wavelength_m ?? []).map((wavelength, k) => ({ x: this.x(wavelength), y: this.y(map.ridge.speed_m_per_s[k]) }));
    const branches = this.#branches();
    const marks = [...ridge, ...branches.flatMap((branch) => this.#crest(branch))];
    const names = new MapNames(context, this.box, this.font, marks);
    const ground = colors.dark ? 'rgba(27,31,36,.82)' : 'rgba(255,255,255,.85)';
    const words = (hertz) => `${number(hertz, 3)} Hz`;
    const strong = { font: `600 ${this.font}px ${colors.font}`, color: colors.warm, ground };
    if (map.bestFit) names.write(words(map.bestFit), this.#ray(map.bestFit), strong);
    for (const branch of branches.slice(1, NAMED_BRANCHES)) names.write(words(branch.frequency_hz), this.#crest(branch), strong);
    const weak = { font: `${this.font}px ${colors.font}`, color: colors.soft, ground, into: true };
    for (const hertz of this.#rays()) names.write(words(hertz), this.#ray(hertz), weak);
    this.names = names.placed;
  }

  #drawRidge(context, colors) {
    const ridge = this.map.ridge;
    if (!ridge) return;
    const step = Math.max(1, Math.round(ridge.speed_m_per_s.length / 55));
    const { wavelength, speed } = this.frame;
    const shown = (value, { min, max }) => value >= min && value <= max;
    for (let k = 0; k < ridge.speed_m_per_s.length; k += step) {
      // A mark outside the window is none at its edge.
      if (!shown(ridge.wavelength_m[k], wavelength) || !shown(ridge.speed_m_per_s[k], speed)) continue;
      const [x, y] = [this.x(ridge.wavelength_m[k]), this.y(ridge.speed_m_per_s[k])];
      context.beginPath();
      context.arc(x, y, 0.22 * this.font, 0, 2 * Math.PI);
      context.lineWidth = 0.8;
      if (ridge.at_edge[k]) {
        context.strokeStyle = colors.dark ? '#e8ecf0' : '#000';
        context.stroke();
      } else {
        context.fillStyle = colors.dark ? '#0d0f12' : '#000';
        context.strokeStyle = colors.dark ? '#e8ecf0' : '#fff';
        context.fill();
        context.stroke();
      }
    }
  }

  #drawOver() {
    if (!this.box || !this.map) return;
    const { ratio, colors } = this;
    const context = this.marksOver.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.marksOver.width, this.marksOver.height);
    this.taken = [...this.names];
    this.#drawMarks(context, this.taken);
    this.#drawCursor(context, colors);
    this.#drawDragged(context, colors);
    this.#drawReadout(context, colors);
  }

  /** What lies on the map beside the cursor; words keep out of the places that are taken. */
  #drawMarks(context, taken) {
    const { box, colors } = this;
    this.#within(context, () => {
      this.#drawBand(context, colors, taken);
      for (const { wavelength, label, isOfTraffic } of this.marks) {
        if (wavelength < this.frame.wavelength.min || wavelength > this.frame.wavelength.max) continue;
        const x = Math.round(this.x(wavelength)) + 0.5;
        context.strokeStyle = colors.warm;
        // Wider than the line of the cursor, which may stand on it.
        context.lineWidth = isOfTraffic ? 7 : 1.5;
        line(context, x, isOfTraffic ? this.y(this.band.to) : box.top, x, isOfTraffic ? this.y(this.band.from) : box.top + box.height);
        context.font = `600 ${this.font}px ${colors.font}`;
        // As high as there is room beside names and other marks; left of its line at the right edge.
        const width = context.measureText(label).width + 6;
        const left = x + 3 + width > box.left + box.width ? Math.max(box.left, x - 3 - width) : x + 3;
        const at = (top) => ({ words: label, left, right: left + width, top, bottom: top + 1.5 * this.font });
        let spot = at(box.top + 0.5 * this.font);
        while (taken.some((other) => overlap(spot, other))) spot = at(spot.top + 0.5 * this.font);
        taken.push(spot);
        context.fillStyle = colors.dark ? 'rgba(27,31,36,.82)' : 'rgba(255,255,255,.85)';
        context.fillRect(spot.left, spot.top, width, 1.5 * this.font);
        context.fillStyle = colors.warm;
        context.textAlign = 'left';
        context.textBaseline = 'middle';
        context.fillText(label, left + 3, spot.top + 0.75 * this.font + 0.5);
      }
    });
  }

  /** The speeds of the traffic: a line at each end, and its name. */
  #drawBand(context, colors, taken) {
    if (!this.band) return;
    const { box } = this;
    const ends = [this.y(this.band.from), this.y(this.band.to)].map((y) => Math.round(y) + 0.5);
    context.strokeStyle = context.fillStyle = colors.accent;
    context.lineWidth = 1;
    context.setLineDash([2, 4]);
    for (const y of ends) line(context, box.left, y, box.left + box.width, y);
    context.setLineDash([]);
    context.fillRect(box.left, ends[1], 4, ends[0] - ends[1]);
    context.font = `${this.font}px ${colors.font}`;
    const width = context.measureText(this.band.label).width + 6;
    // Along the left edge, as low as there is room beside the names of the map.
    const at = (bottom) => ({ words: this.band.label, left: box.left + 6, right: box.left + 6 + width, top: bottom - 1.5 * this.font, bottom });
    let spot = at(Math.min(ends[0], box.top + box.height) - 1);
    while (taken.some((other) => overlap(spot, other)) && spot.top > box.top) spot = at(spot.bottom - 0.5 * this.font);
    if (spot.top <= box.top || spot.top > ends[0]) return;
    taken.push(spot);
    context.fillStyle = colors.dark ? 'rgba(27,31,36,.82)' : 'rgba(255,255,255,.85)';
    context.fillRect(spot.left, spot.top, width, 1.5 * this.font);
    context.fillStyle = colors.accent;
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    context.fillText(this.band.label, spot.left + 3, spot.top + 0.75 * this.font + 0.5);
  }

  /** What the map says under the pointer. */
  get readout() {
    if (!this.hover) return [];
    const { wavelength, speed } = this.hover;
    const rate = valueAt(this.map, this.hover);
    const marks = this.marks.filter((mark) => Math.abs(this.x(mark.wavelength) - this.x(wavelength)) < 0.5 * this.font);
    return [`${number(1e3 * wavelength)} mm, ${inUnit(speed)}, ${number(speed / wavelength)} Hz`, `${power(rate, 3)} ${t('per_passage')}`, ...marks.map(({ label }) => label)];
  }

  #drawReadout(context, colors) {
    const lines = this.readout;
    if (!lines.length) return;
    const { box } = this;
    context.font = `${this.font}px ${colors.font}`;
    const width = Math.max(...lines.map((text) => context.measureText(text).width)) + 12;
    const height = (1.4 * lines.length + 0.5) * this.font;
    const [x, y] = [this.x(this.hover.wavelength), this.y(this.hover.speed)];
    // Beside the pointer, on the side where there is room.
    const left = x + 14 + width > box.left + box.width ? x - 14 - width : x + 14;
    const top = y - 14 - height < box.top ? y + 14 : y - 14 - height;
    context.fillStyle = colors.dark ? 'rgba(27,31,36,.92)' : 'rgba(255,255,255,.94)';
    context.strokeStyle = colors.soft;
    context.lineWidth = 1;
    context.fillRect(left, top, width, height);
    context.strokeRect(Math.round(left) + 0.5, Math.round(top) + 0.5, Math.round(width), Math.round(height));
    context.fillStyle = colors.ink;
    context.textAlign = 'left';
    context.textBaseline = 'top';
    lines.forEach((text, k) => context.fillText(text, left + 6, top + (0.4 + 1.4 * k) * this.font));
  }

  /** The frame that is drawn to zoom into it. */
  #drawDragged(context, colors) {
    if (!this.dragged) return;
    const [{ wavelength: l1, speed: v1 }, { wavelength: l2, speed: v2 }] = this.dragged;
    context.strokeStyle = colors.accent;
    context.lineWidth = 1.5;
    context.strokeRect(this.x(l1), this.y(v1), this.x(l2) - this.x(l1), this.y(v2) - this.y(v1));
  }

  #drawCursor(context, colors) {
    if (!this.point) return;
    const { box } = this;
    const [x, y] = [this.x(this.point.wavelength), this.y(this.point.speed)];
    if (x < box.left - 1 || x > box.left + box.width + 1 || y < box.top - 1 || y > box.top + box.height + 1) return;
    for (const [style, width] of [[colors.dark ? '#000' : '#fff', 4], [colors.ink, 1]]) {
      context.strokeStyle = style;
      context.lineWidth = width;
      context.globalAlpha = width > 1 ? 0.6 : 0.55;
      line(context, x, box.top, x, box.top + box.height);
      line(context, box.left, y, box.left + box.width, y);
      context.globalAlpha = 1;
      context.lineWidth = width > 1 ? 4.5 : 2;
      context.beginPath();
      context.arc(x, y, 7, 0, 2 * Math.PI);
      context.stroke();
    }
  }

  // The cursor ---------------------------------------------------------------------------------------

  /** Wavelength and speed under a place of the page. */
  #at(event) {
    const frame = this.marksOver.getBoundingClientRect();
    const { box, frame: shown } = this;
    const right = (event.clientX - frame.left - box.left) / box.width;
    const up = 1 - (event.clientY - frame.top - box.top) / box.height;
    if (right < -0.02 || right > 1.02 || up < -0.03 || up > 1.03) return null;
    const on = ({ min, max }, share) => min + (max - min) * Math.min(1, Math.max(0, share));
    return { wavelength: on(shown.wavelength, right), speed: on(shown.speed, up) };
  }

  #listen() {
    const over = this.marksOver;
    // Fingers or buttons that are down, by where they are on the map.
    const down = new Map();
    over.addEventListener('pointermove', (event) => {
      if (!this.map) return;
      const point = this.#at(event);
      this.hover = event.pointerType === 'mouse' ? point : null;
      if (down.size === 2 && down.has(event.pointerId)) {
        const apart = spread(down);
        down.set(event.pointerId, event);
        const [one, other] = [...down.values()].map((finger) => this.#at(finger));
        if (one && other) this.#zoomBy(spread(down) / apart, { wavelength: (one.wavelength + other.wavelength) / 2, speed: (one.speed + other.speed) / 2 });
        return;
      }
      if (this.dragged && point) this.dragged[1] = point;
      else if (point && (!this.point?.pinned || event.buttons)) return this.onPoint(point, Boolean(event.buttons));
      this.#drawOver();
    });
    over.addEventListener('pointerleave', () => {
      this.hover = null;
      this.#drawOver();
      this.onLeave();
    });
    over.addEventListener('pointerdown', (event) => {
      if (!this.map) return;
      const point = this.#at(event);
      if (!point) return;
      over.setPointerCapture(event.pointerId);
      down.set(event.pointerId, event);
      if (event.shiftKey) this.dragged = [point, point];
      else if (down.size === 1) this.onPoint(point, true);
    });
    for (const end of ['pointerup', 'pointercancel']) {
      over.addEventListener(end, (event) => {
        down.delete(event.pointerId);
        if (!this.dragged) return;
        const [one, other] = this.dragged;
        this.dragged = null;
        const range = (axis) => ({ min: Math.min(one[axis], other[axis]), max: Math.max(one[axis], other[axis]) });
        const large = (axis) => range(axis).max - range(axis).min >= (this.map[axis].max - this.map[axis].min) / MOST_ZOOM;
        if (end === 'pointerup' && large('wavelength') && large('speed')) this.#zoomTo({ wavelength: range('wavelength'), speed: range('speed') });
        else this.#drawOver();
      });
    }
    // The wheel scrolls the page where it cannot zoom: down on the whole map, and up on the way back to the head of the page.
    over.addEventListener('wheel', (event) => {
      const point = this.map && this.#at(event);
      if (!point || !(this.window || event.ctrlKey || (event.deltaY < 0 && scrollY === 0))) return;
      event.preventDefault();
      this.#zoomBy(Math.exp(-ZOOM_PIXEL * event.deltaY), point);
    }, { passive: false });
    over.addEventListener('dblclick', () => this.zoomOut());
    // Arrows step by a fortieth of the window, with Shift by a grid point; Home goes to the highest growth.
    over.addEventListener('keydown', (event) => {
      if (!this.map || !this.point) return;
      const { wavelength, speed, highest } = this.map;
      const share = event.shiftKey ? 1 / 240 : 1 / 40;
      const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      const span = (axis) => this.frame[axis].max - this.frame[axis].min;
      const keep = (value, { min, max }) => Math.min(max, Math.max(min, value));
      if (by) {
        this.onPoint({
          wavelength: keep(this.point.wavelength + by[0] * share * span('wavelength'), wavelength),
          speed: keep(this.point.speed + by[1] * share * span('speed'), speed),
        }, true);
      } else if (event.key === '+' || event.key === '-') {
        this.#zoomBy(event.key === '+' ? ZOOM_STEP : 1 / ZOOM_STEP, this.point);
      } else if (event.key === '0') {
        this.zoomOut();
      } else if (event.key === 'Home' && highest) {
        this.onPoint({ wavelength: highest.wavelength_m, speed: highest.speed_m_per_s }, true);
      } else return;
      event.preventDefault();
    });
  }
}

/** The colour bar of a map: steps, values, name. */
export function drawBar(place, view, title) {
  // The bar knows how it is drawn in another theme.
  place.redraw = () => drawBar(place, view, title);
  const colors = theme();
  const strongest = view.scale;
  const ends = (value) => (Math.abs(value) < 0.01 || Math.abs(value) >= 1e5 ? power(value) : number(value, 2));
  place.replaceChildren();
  const steps = document.createElement('div');
  steps.className = 'steps';
  const list = view.kind === 'growth'
    ? growthSteps(colors.dark)
    : [...differenceSteps(colors.dark).less.toReversed(), ...differenceSteps(colors.dark).more];
  const at = (k) => `${((100 * k) / list.length).toFixed(2)}%`;
  steps.style.background = `linear-gradient(to right, ${list.map((step, k) => `${css(step)} ${at(k)} ${at(k + 1)}`).join(', ')})`;
  const word = (text, className) => {
    const span = document.createElement('span');
    span.textContent = text;
    span.className = className;
    return span;
  };
  if (!(strongest > 0)) {
    place.append(word(view.kind === 'growth' ? t('nothing_grows') : t('no_difference'), 'name'));
    return;
  }
  place.append(word(title, 'name'), word(view.kind === 'growth' ? '0' : ends(-strongest), 'end'), steps, word(ends(strongest), 'end'));
}

/** Distance of two pointers [px]. */
function spread(down) {
  const [one, other] = [...down.values()];
  return Math.max(1, Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY));
}

function line(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

/** A framed answer as a map: growth rates and axes. */
export function toMap(head, values, offset = 0) {
  const { wavelength_m: wavelength, speed_m_per_s: speed } = head.window;
  const [columns, rows] = [wavelength.points, speed.points];
  const rate = head.growth_rate_per_dissipation;
  const growth = new Float32Array(columns * rows);
  let strongest = 0;
  for (let k = 0; k < growth.length; k++) {
    const value = values[offset + k] * rate;
    growth[k] = value;
    if (value > strongest) strongest = value;
  }
  return {
    wavelength, speed, columns, rows, strongest, values: growth, ridge: head.ridge, branches: head.branches, bestFit: head.best_fit_frequency_hz,
    rays: head.rays_hz, highest: head.highest, rate,
  };
}

/** The growth rate of a map between its points. */
export function valueAt(map, { wavelength, speed }) {
  const place = (value, { min, max }, points) => Math.min(points - 1.000001, Math.max(0, ((value - min) / (max - min)) * (points - 1)));
  const [x, y] = [place(wavelength, map.wavelength, map.columns), place(speed, map.speed, map.rows)];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const at = (i, j) => map.values[j * map.columns + i];
  const mix = (a, b, share) => a + (b - a) * share;
  return mix(mix(at(i, j), at(i + 1, j), x - i), mix(at(i, j + 1), at(i + 1, j + 1), x - i), y - j);
}
