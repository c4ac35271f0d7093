// A measured rail along the line: the moving RMS of each band with its limit, what lies there, what to grind, the verdict by section, and the way to a part.

import { letterSize, theme } from './colors.js';
import { decoded } from './columns.js';
import { axis, draw, layout, palette, refit } from './curves.js';
import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { said } from './messages.js';
import { Line, json } from './server.js';
import { currentLanguage, wordsOf, number, range, t, translate } from './words.js';

/** Blocks along the line that are drawn at most, and the shortest one [m]. */
const BLOCKS = 400;
const SHORTEST_BLOCK = 1;
/** Length of rail that a click takes: that of a block, and no less than this [m]. */
const STRETCH = 10;

const millimetres = (ends) => `${range(ends, (end) => number(1e3 * end, 4))} mm`;

/** A place on the line with as many digits as a metre takes, or a part of one where there is room; what is left of a zero is one. */
const metres = (place, position = Math.round(1e3 * place) / 1e3 || 0) => number(position, Math.max(3, Math.ceil(Math.log10(Math.abs(position) + 1)) + 1));
export const span = ({ from_m: from, to_m: to }) => range([from, to], metres);

export class Along {
  /** `question` gives the name of the record and how it is laid out; `onPart` takes the part of the line that was chosen, null for all of it. */
  constructor({ question, onPart, complain, inLabels, save }) {
    Object.assign(this, { question, onPart, complain, inLabels, held: null, answer: null, part: null, table: null });
    this.line = new Line('/api/ask/along', json);
    this.plot = element('div', { className: 'curve tall', id: 'along' });
    const head = element('header', {}, worded('h2', 'along'));
    this.shown = element('strong', { id: 'part' });
    this.whole = worded('button', 'whole_record', { type: 'button', className: 'plain small', id: 'whole-record' });
    this.whole.addEventListener('click', () => this.#choose(null));
    this.inView = worded('button', 'part_in_view', { type: 'button', className: 'plain small', id: 'part-in-view', hidden: true });
    this.inView.addEventListener('click', () => this.#choose(this.zoomed));
    this.input = element('input', { type: 'file', id: 'line-table', className: 'away', accept: '.csv,.txt,.tsv,text/plain,text/csv' });
    this.input.addEventListener('change', () => {
      if (this.input.files[0]) this.#takeTable(this.input.files[0]);
      this.input.value = '';
    });
    this.drop = element('button', { type: 'button', className: 'plain small', hidden: true, id: 'line-table-drop' });
    this.drop.addEventListener('click', () => this.#takeTable(null));
    const parts = element('div', { className: 'buttons' }, element('span', {}, worded('span', 'shown_below'), ' ', this.shown), this.whole, this.inView);
    const layer = element('div', { className: 'buttons' }, this.input, worded('label', 'line_table', { htmlFor: 'line-table', className: 'plain small' }), this.drop, worded('span', 'line_table_hint', { className: 'fine' }));
    this.panel = element('article', { className: 'panel wide', hidden: true, id: 'along-panel' }, head, parts, this.plot, element('p', { className: 'fine' }, worded('span', 'rms_axis'), '; ', worded('span', 'along_hint')), layer);
    offer(head, () => ({ name: 'along', plot: this.plot }), save);
    const tabled = (id, word, name) => {
      const table = element('table', { className: 'comparison', id });
      const header = element('header', {}, worded('h2', word));
      const panel = element('article', { className: 'panel wide', hidden: true, id: `${id}-panel` }, header, element('div', { className: 'sideways scroll' }, table));
      offer(header, () => ({ name, table }), save, ['csv']);
      return { table, panel };
    };
    this.verdicts = tabled('section-verdicts', 'by_section', 'section-verdicts');
    this.grind = tabled('sections', 'to_grind', 'sections');
    this.total = element('p', { className: 'fine' });
    this.grind.panel.append(this.total);
    this.panels = [this.panel, this.verdicts.panel, this.grind.panel];
  }

  /** Show what belongs to a record of some length [m] as it is held, with the part that is chosen; null hides all. */
  show(held, part, length) {
    const same = held && this.held === held && this.answer;
    Object.assign(this, { held, part, length });
    if (same) this.#show();
    else {
      this.answer = null;
      for (const panel of this.panels) panel.hidden = true;
      if (held) this.#ask();
    }
  }

  #ask(refuse = () => {}) {
    const { held, table } = this;
    const block = Math.max(SHORTEST_BLOCK, this.length / BLOCKS);
    this.line.ask({ ...this.question(), block, ...(table && { along: table }) }, (answer) => {
      // Meanwhile another record may have come.
      if (this.held !== held) return;
      this.answer = answer;
      this.#show();
    }, (fault) => {
      if (fault.status !== 410) this.complain(fault, { what: `${t('along')}: ` });
      refuse();
    });
  }

  /** A table of what lies along the line takes the place of the one before, unless it is refused; null removes it. */
  async #takeTable(file) {
    const before = this.table;
    this.table = file && { name: file.name, text: decoded(new Uint8Array(await file.arrayBuffer())) };
    this.#ask(() => (this.table = before));
  }

  #choose(part) {
    this.part = part && { from_m: part.from_m, to_m: part.to_m };
    this.#show();
    this.onPart(this.part);
  }

  /** A part about a place, or from one to another, that is long enough for a spectrum and lies within the record. */
  #around(from, to) {
    const { rails } = this.answer;
    const [begin, end] = [Math.min(...rails.map((rail) => rail.from_m[0])), Math.max(...rails.map((rail) => rail.to_m.at(-1)))];
    const length = Math.max(STRETCH, to - from, rails[0].to_m[0] - rails[0].from_m[0]);
    const first = Math.max(begin, Math.min((from + to - length) / 2, end - length));
    return { from_m: first, to_m: Math.min(end, first + length) };
  }

  reword() {
    for (const panel of this.panels) translate(panel);
    this.#show();
  }

  #show() {
    const { answer, part, table } = this;
    if (!answer) return;
    this.shown.textContent = part ? `${span(part)} m` : t('whole_record');
    this.whole.hidden = !part;
    this.drop.hidden = !table;
    this.drop.textContent = `✕ ${table?.name ?? ''}`;
    this.drop.setAttribute('aria-label', `${t('drop')}: ${table?.name ?? ''}`);
    const { grind, sections } = answer.roughness;
    this.panel.hidden = false;
    this.verdicts.panel.hidden = !sections?.length;
    this.grind.panel.hidden = !grind;
    this.#verdicts(sections ?? []);
    if (grind) this.#sections(grind);
    this.#draw();
  }

  async #draw() {
    const { rails, bands_m, roughness } = this.answer;
    const { warm, soft } = theme();
    const kilometres = Math.max(...rails.flatMap((rail) => [rail.from_m[0], rail.to_m.at(-1)].map(Math.abs))) >= 2000;
    const [unit, size] = kilometres ? ['km', 1000] : ['m', 1];
    const along = (position) => position / size;
    const [axes, traces, colors] = [{}, [], palette()];
    // Bands that this record does not resolve are left out.
    const bands = bands_m.map((band, k) => ({ band, courses: rails.map((rail) => rail.moving_rms_max_m[k]), limit: this.#limit(band) })).filter(({ courses }) => courses.flat().some((value) => value !== null));
    const there = this.#there();
    const strip = there.length ? (0.9 * there.length) / (0.9 * there.length + 4.5 * bands.length) : 0;
    const gap = 0.05;
    const height = (1 - strip - gap * bands.length) / bands.length;
    bands.forEach(({ band, courses, limit }, k) => {
      const yaxis = `y${k ? k + 1 : ''}`;
      const top = 1 - strip - gap - k * (height + gap);
      const most = Math.max(1e6 * (limit ?? 0) * 1.1, ...courses.flat().map((value) => 1e6 * value));
      axes[`yaxis${k ? k + 1 : ''}`] = axis(millimetres(band), { domain: [Math.max(0, top - height), top], range: [0, 1.08 * most], nticks: 4, fixedrange: true });
      courses.forEach((course, r) => {
        // Each block from its begin to its end.
        const x = rails[r].from_m.flatMap((from, n) => [along(from), along(rails[r].to_m[n])]);
        const y = course.flatMap((value) => (value === null ? [null, null] : [1e6 * value, 1e6 * value]));
        const rail = rails.length > 1 ? `${t('rail_named', rails[r].name)}, ` : '';
        traces.push({ type: 'scatter', mode: 'lines', x, y, yaxis, name: `${rail}${millimetres(band)}`, line: { color: colors[r ? 3 + (r % 4) : 1], width: 1.4 }, hovertemplate: `%{x:.5~g} ${unit} · %{y:.3~g} µm<extra>${rail}${millimetres(band)}</extra>` });
      });
      const ends = [Math.min(...rails.map((rail) => rail.from_m[0])), Math.max(...rails.map((rail) => rail.to_m.at(-1)))].map(along);
      if (limit) traces.push({ type: 'scatter', mode: 'lines', x: ends, y: [1e6 * limit, 1e6 * limit], yaxis, name: `${t('limit')} ${millimetres(band)}`, line: { color: warm, width: 1.4, dash: 'dash' }, hovertemplate: `${number(1e6 * limit)} µm<extra>${t('limit')}</extra>` });
    });
    if (there.length) {
      const n = bands.length + 1;
      axes[`yaxis${n}`] = axis('', { domain: [1 - strip, 1], range: [there.length - 0.5, -0.5], tickvals: there.map((_, k) => k), ticktext: there.map(({ words }) => words), fixedrange: true, showgrid: false });
      there.forEach(({ words, places, color }, k) => traces.push({
        type: 'scatter', mode: 'lines+markers', yaxis: `y${n}`, name: words, x: places.flatMap(({ from_m, to_m }) => [along(from_m), along(to_m), null]), y: places.flatMap(() => [k, k, null]),
        text: places.flatMap(({ name }) => [name, name, '']), line: { color, width: 6 }, marker: { color, size: 7, symbol: 'line-ns', line: { color, width: 2 } }, hovertemplate: `%{text} %{x:.5~g} ${unit}<extra>${words.replaceAll('<', '&lt;')}</extra>`,
      }));
    }
    const ground = (roughness.grind?.sections ?? []).map(({ from_m, to_m }) => ({ type: 'rect', xref: 'x', yref: 'paper', x0: along(from_m), x1: along(to_m), y0: 0, y1: 1 - strip, fillcolor: warm, opacity: 0.13, line: { width: 0 }, layer: 'below' }));
    const chosen = this.part ? [{ type: 'rect', xref: 'x', yref: 'paper', x0: along(this.part.from_m), x1: along(this.part.to_m), y0: 0, y1: 1, line: { color: soft, width: 1.6 } }] : [];
    const rem = `${Math.max(17, 9 * bands.length) + 1.8 * there.length}rem`;
    const isOther = this.plot.style.height !== rem;
    this.plot.style.height = rem;
    await draw(this.plot, traces, layout({
      xaxis: axis(`${t('position')} [${unit}]`, { anchor: `y${bands.length > 1 ? bands.length : ''}` }), ...axes, shapes: [...ground, ...chosen],
      // A click counts wherever it is, not on a line alone; a part that is looked at stays while anything else is drawn anew.
      hovermode: 'x', hoverdistance: -1, uirevision: String(this.held.turn),
      margin: { l: 5 * letterSize(), r: 10, t: 0.6 * letterSize(), b: 3 * letterSize() },
    }));
    if (isOther) refit(this.panel);
    this.size = size;
    if (this.listening || !this.plot.on) return;
    this.listening = true;
    this.plot.on('plotly_click', ({ points }) => this.#choose(this.#around(points[0].x * this.size, points[0].x * this.size)));
    this.plot.on('plotly_relayout', (change) => {
      const [from, to] = [change['xaxis.range[0]'], change['xaxis.range[1]']];
      if (from === undefined && !change['xaxis.autorange']) return;
      this.zoomed = from === undefined ? null : this.#around(from * this.size, to * this.size);
      this.inView.hidden = !this.zoomed;
    });
  }

  /** What lies along the line, a row for each kind; first what the record itself shows. */
  #there() {
    const { along = [], rails = [] } = this.answer.roughness;
    const colors = palette();
    const shown = rails.flatMap(({ name, defects = [] }) => defects.map((defect) => ({ ...defect, name: `${t('rail_named', name)}, ${t(`shows_${defect.kind}`)}` })));
    const kinds = [...new Set(along.map(({ kind }) => kind))];
    const rows = kinds.map((kind, k) => ({ words: kind, places: along.filter((place) => place.kind === kind), color: colors[[3, 4, 5, 1][k % 4]] }));
    return [...(shown.length ? [{ words: t('record_shows'), places: shown, color: theme().warm }] : []), ...rows];
  }

  #limit([from, to]) {
    const close = (one, other) => Math.abs(one - other) < 1e-6;
    return this.answer.roughness.bands.find((one) => close(one.from_m, from) && close(one.to_m, to))?.limit_rms_m ?? null;
  }

  /** A table whose rows are ways to parts of the line; `rows` gives the part of a row, its rail and its other cells. */
  #tabled({ table }, columns, rows) {
    const body = rows.map(({ part, rail, cells }) => {
      const go = element('button', { type: 'button', className: 'plain small', textContent: span(part) });
      const chosen = this.part && Math.abs(this.part.from_m - part.from_m) < 1e-6 && Math.abs(this.part.to_m - part.to_m) < 1e-6;
      const way = row(rail ? t('rail_name', rail) : '–', [go, ...cells]);
      way.className = 'way';
      if (chosen) way.setAttribute('aria-current', 'true');
      way.addEventListener('click', () => this.#choose(this.#around(part.from_m, part.to_m)));
      return way;
    });
    table.hidden = !rows.length;
    fillTable(table, columns, body);
  }

  #verdicts(sections) {
    const none = (value, words) => (value == null ? '–' : words());
    this.#tabled(this.verdicts, wordsOf('verdict_columns'), sections.map((section) => {
      const { excess_db: excess, share_over_limit: share, rms_over_limit: ratio } = section;
      const { text, language } = said(section.sentence, this.inLabels);
      const words = [text, ...(section.along ?? []).map(({ kind, name }) => `${kind} ${name}`.trim())].join('; ');
      return {
        part: section, rail: section.rail,
        cells: [
          none(excess, () => `${excess > 0 ? '+' : ''}${number(Math.round(10 * excess) / 10)} dB, ${number(1e3 * section.wavelength_m)} mm`),
          none(share, () => (share ? `${number(100 * share, 2)} %, ${number(ratio, 2)}×` : '0 %')), number(section.grind_m, 3),
          element('td', { className: `said ${section.within ? 'good' : 'bad'}`, textContent: words, lang: language }),
        ],
      };
    }));
  }

  #sections(grind) {
    this.#tabled(this.grind, wordsOf('section_columns'), grind.sections.map((section) => ({
      part: section, rail: section.rail, cells: [number(section.to_m - section.from_m, 3), millimetres([section.band_from_m, section.band_to_m]), number(section.rms_over_limit, 3)],
    })));
    this.total.textContent = grind.sections.length ? t('grind_total', { metres: number(grind.total_m, 3), share: number(100 * grind.share_of_length, 3) }) : t('nothing_to_grind');
    this.total.lang = currentLanguage();
  }
}
