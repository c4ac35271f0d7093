// A measured rail along the line: the moving RMS of each band with its limit, what to grind, and the spectrum at a place.

import { letterSize, theme } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { Line, json } from './server.js';
import { number, t, translate } from './words.js';

/** Blocks along the line that are drawn at most, and the shortest one [m]. */
const BLOCKS = 400;
const SHORTEST_BLOCK = 1;
/** Length of rail whose spectrum is shown at a click: that of a block, and no less than this [m]. */
const STRETCH = 10;

const millimetres = ([from, to]) => `${number(1e3 * from, 4)}–${number(1e3 * to, 4)} mm`;

/** A place on the line with as many digits as a metre takes, or a part of one where there is room; what is left of a zero is one. */
export const metres = (place, position = Math.round(1e3 * place) / 1e3 || 0) => number(position, Math.max(3, Math.ceil(Math.log10(Math.abs(position) + 1)) + 1));

export class Along {
  /** `question` gives the name of the record and how it is laid out. */
  constructor({ question, complain, save }) {
    Object.assign(this, { question, complain, courses: null, roughness: null, at: null, there: null });
    this.line = new Line('/api/along', json);
    this.places = new Line('/api/along/spectrum', json);
    this.rail = element('select', { id: 'along-rail' });
    this.rail.dataset.tLabel = 'rail';
    this.rail.addEventListener('change', () => this.#draw());
    this.plot = element('div', { className: 'curve tall', id: 'along' });
    const head = element('header', {}, worded('h2', 'along'), this.rail, worded('span', 'along_hint', { className: 'aside' }));
    this.panel = element('article', { className: 'panel wide', hidden: true, id: 'along-panel' }, head, this.plot, worded('p', 'rms_axis', { className: 'fine' }));
    offer(head, () => ({ name: 'along', plot: this.plot }), save);
    this.spectrum = element('div', { className: 'curve tall', id: 'place-spectrum' });
    this.title = element('h2', {});
    const placeHead = element('header', {}, this.title);
    this.placePanel = element('article', { className: 'panel half', hidden: true, id: 'place-panel' }, placeHead, this.spectrum);
    offer(placeHead, () => ({ name: 'place-spectrum', plot: this.spectrum }), save);
    this.table = element('table', { className: 'comparison', id: 'sections' });
    this.total = element('p', { className: 'fine' });
    this.grindPanel = element('article', { className: 'panel half', hidden: true, id: 'grind-panel' }, element('header', {}, worded('h2', 'to_grind')), element('div', { className: 'sideways' }, this.table), this.total);
    const grindHead = this.grindPanel.querySelector('header');
    offer(grindHead, () => ({ name: 'sections', table: this.table }), save, ['csv']);
    this.panels = [this.panel, this.placePanel, this.grindPanel];
  }

  /** Show what belongs to an answer on the rail; null hides all. */
  show(roughness, limits) {
    const same = roughness && this.roughness === roughness;
    Object.assign(this, { roughness, limits });
    // A table of levels has no line.
    const hasLine = Boolean(roughness?.rails?.length || (roughness?.length_m && roughness.grind));
    this.grindPanel.hidden = !(hasLine && roughness.grind);
    if (!hasLine) {
      this.panel.hidden = this.placePanel.hidden = true;
      this.courses = this.there = null;
      return;
    }
    this.#sections();
    if (same) return this.#draw();
    this.there = null;
    this.placePanel.hidden = true;
    this.block = Math.max(SHORTEST_BLOCK, roughness.length_m / BLOCKS);
    this.line.ask({ ...this.question(), block_m: this.block }, (courses) => {
      // Meanwhile another record may have come.
      if (this.roughness !== roughness) return;
      this.courses = courses;
      const chosen = this.rail.value;
      const names = courses.rails.map(({ name }) => name);
      this.rail.replaceChildren(...names.map((name) => element('option', { value: name, textContent: t('rail_named', name) })));
      this.rail.value = names.includes(chosen) ? chosen : names[0];
      this.rail.hidden = names.length < 2;
      this.panel.hidden = false;
      this.#draw();
    }, (fault) => fault.status !== 410 && this.complain(fault, { what: `${t('along')}: ` }));
  }

  reword() {
    for (const panel of this.panels) translate(panel);
    for (const option of this.rail.options) option.textContent = t('rail_named', option.value);
  }

  async #draw() {
    const { courses, roughness } = this;
    if (!courses || this.panel.hidden) return;
    const rail = courses.rails.find(({ name }) => name === this.rail.value) ?? courses.rails[0];
    const colors = palette();
    const { warm, soft } = theme();
    // Bands that no limit holds are left out, as are those that this record does not resolve.
    const bands = courses.bands_m.map((band, k) => ({ band, course: rail.moving_rms_max_m[k], limit: this.#limit(rail.name, band) })).filter(({ course }) => course.some((value) => value !== null));
    const kilometres = Math.max(...rail.to_m.map(Math.abs)) >= 2000;
    const along = (position) => (kilometres ? position / 1000 : position);
    // Each block from its begin to its end.
    const x = rail.from_m.flatMap((from, k) => [along(from), along(rail.to_m[k])]);
    const axes = {};
    const traces = [];
    const shapes = [];
    const gap = 0.05;
    const height = (1 - gap * (bands.length - 1)) / bands.length;
    bands.forEach(({ band, course, limit }, k) => {
      const y = course.flatMap((value) => (value === null ? [null, null] : [1e6 * value, 1e6 * value]));
      const suffix = k ? String(k + 1) : '';
      const top = 1 - k * (height + gap);
      const most = Math.max(...y.filter((value) => value !== null), limit ? 1.1e6 * limit : 0);
      axes[`yaxis${suffix}`] = axis(millimetres(band), { domain: [Math.max(0, top - height), top], range: [0, 1.08 * most], nticks: 4 });
      traces.push({ type: 'scatter', mode: 'lines', x, y, yaxis: `y${suffix}`, name: millimetres(band), line: { color: colors[1], width: 1.4 }, hovertemplate: `%{x:.5~g} ${kilometres ? 'km' : 'm'} · %{y:.3~g} µm<extra>${millimetres(band)}</extra>` });
      if (limit) {
        traces.push({ type: 'scatter', mode: 'lines', x: [x[0], x.at(-1)], y: [1e6 * limit, 1e6 * limit], yaxis: `y${suffix}`, name: `${t('limit')} ${millimetres(band)}`, line: { color: warm, width: 1.4, dash: 'dash' }, hovertemplate: `${number(1e6 * limit)} µm<extra>${t('limit')}</extra>` });
      }
    });
    for (const section of roughness.grind?.sections ?? []) {
      if (section.rail === rail.name) shapes.push({ type: 'rect', xref: 'x', yref: 'paper', x0: along(section.from_m), x1: along(section.to_m), y0: 0, y1: 1, fillcolor: warm, opacity: 0.13, line: { width: 0 }, layer: 'below' });
    }
    if (this.at !== null && this.there) shapes.push({ type: 'line', xref: 'x', yref: 'paper', x0: along(this.at), x1: along(this.at), y0: 0, y1: 1, line: { color: soft, width: 1.2 } });
    this.plot.style.height = `${Math.max(17, 9 * bands.length)}rem`;
    await draw(this.plot, traces, layout({
      xaxis: axis(`${t('position')} [${kilometres ? 'km' : 'm'}]`, { anchor: `y${bands.length > 1 ? bands.length : ''}` }), ...axes, shapes,
      // A click counts wherever it is, not on a line alone.
      hovermode: 'x', hoverdistance: -1,
      margin: { l: 5 * letterSize(), r: 10, t: 0.6 * letterSize(), b: 3 * letterSize() },
    }));
    if (this.listening) return;
    this.listening = true;
    this.plot.on?.('plotly_click', ({ points }) => this.#place(points[0].x * (Math.max(...this.courses.rails[0].to_m.map(Math.abs)) >= 2000 ? 1000 : 1)));
  }

  #limit(rail, [from, to]) {
    const close = (one, other) => Math.abs(one - other) < 1e-6;
    const band = this.roughness.bands.find((one) => (one.rail === rail || !rail) && close(one.from_m, from) && close(one.to_m, to));
    return band?.limit_rms_m ?? null;
  }

  /** Ask for the spectrum of a stretch about a place [m]. */
  #place(position) {
    const { courses } = this;
    const half = Math.max(STRETCH, this.block) / 2;
    const [begin, end] = [Math.min(...courses.rails.map((rail) => rail.from_m[0])), Math.max(...courses.rails.map((rail) => rail.to_m.at(-1)))];
    // A whole stretch at the ends of the record, too.
    const from = Math.max(begin, Math.min(position - half, end - 2 * half));
    const to = Math.min(end, from + 2 * half);
    this.places.ask({ ...this.question(), from_m: from, to_m: to }, (there) => {
      if (this.courses !== courses) return;
      Object.assign(this, { at: position, there: { ...there, from, to } });
      this.#draw();
      this.drawPlace();
    }, (fault) => this.complain(fault, { what: `${metres(from)}–${metres(to)} m: ` }));
  }

  async drawPlace() {
    const { there, roughness, limits } = this;
    this.placePanel.hidden = !there;
    if (!there) return;
    this.title.textContent = t('spectrum_at', `${metres(there.from)}–${metres(there.to)} m`);
    const colors = palette();
    const curve = (levels, name, color, more = {}) => ({
      type: 'scatter', mode: 'lines', x: levels.map(([wavelength]) => 1e3 * wavelength), y: levels.map(([, level]) => level), name, line: { color, width: 1.8, ...more },
      hovertemplate: `%{x:.3~g} mm · %{y:.1f} dB<extra>${name.replaceAll('<', '&lt;')}</extra>`,
    });
    const levels = (list) => list.map(({ wavelength_m: wavelength, level_db: level }) => [wavelength, level]);
    const rails = (document_) => (document_.rails?.length ? document_.rails : [{ name: '', spectrum: document_.spectrum }]);
    const named = ({ name }) => t('rail_named', name);
    const traces = [
      ...rails(there).map((rail, k) => curve(levels(rail.spectrum), `${named(rail)}, ${t('here')}`, colors[k ? 3 : 0])),
      ...rails(roughness).map((rail, k) => curve(levels(rail.spectrum), `${named(rail)}, ${t('whole_record')}`, colors[k ? 3 : 0], { width: 1, dash: 'dot' })),
      ...limits.map((limit, k) => curve(limit.wavelength_m_and_level_db, limit.edition, colors[2 + k], { width: 1.4, dash: 'dash' })),
    ];
    const all = traces.flatMap(({ x }) => x);
    await draw(this.spectrum, traces, layout({
      xaxis: axis(`${t('wavelength')} λ [mm]`, { type: 'log', tickvals: [2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000], range: [Math.log10(Math.max(...all)), Math.log10(Math.min(...all))] }),
      yaxis: axis(t('level_axis')), showlegend: true, margin: { l: 4 * letterSize(), r: 10, t: 3.4 * letterSize(), b: 3 * letterSize() },
    }));
  }

  #sections() {
    const { grind } = this.roughness;
    if (!grind) return;
    const head = element('thead', {}, element('tr', {}, ...t('section_columns').map((textContent) => element('th', { scope: 'col', textContent }))));
    const rows = grind.sections.map((section) => {
      const go = element('button', { type: 'button', className: 'plain small', textContent: `${metres(section.from_m)}–${metres(section.to_m)}` });
      go.addEventListener('click', () => {
        if (section.rail) this.rail.value = section.rail;
        this.#place((section.from_m + section.to_m) / 2);
      });
      const cells = [number(section.to_m - section.from_m, 3), millimetres([section.band_from_m, section.band_to_m]), number(section.rms_over_limit, 3)];
      return element('tr', {}, element('th', { scope: 'row', textContent: section.rail ? t('rail_name', section.rail) : '–' }), element('td', {}, go), ...cells.map((textContent) => element('td', { textContent })));
    });
    this.table.hidden = !rows.length;
    this.table.replaceChildren(head, element('tbody', {}, ...rows));
    this.total.textContent = rows.length ? t('grind_total', { metres: number(grind.total_m, 3), share: number(100 * grind.share_of_length, 3) }) : t('nothing_to_grind');
  }
}
