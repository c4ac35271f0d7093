// The columns of a table of many: which is the position, and which are heights of a rail.

import { element, worded } from './elements.js';
import { t, translate } from './words.js';

/** Begin of a file that is looked at [bytes]. */
const BEGIN = 16_384;
const DELIMITERS = [['tab', '\t'], ['semicolon', ';'], ['comma', ',']];
/** Columns that are offered. */
const MOST = 24;
const UNITS = ['um', 'mm', 'm'];
const POSITIONS = ['m', 'km', 'mm'];

const isNumber = (cell) => /^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?$/.test(cell.trim());
const cellsOf = (line, mark) => (mark === ' ' ? line.trim().split(/\s+/) : line.split(mark)).map((cell) => cell.trim().replace(/^"(.*)"$/, '$1'));

/** Layout of a file from its first lines: delimiter, lines of the head, names and first numbers of the columns. Null where there is no table of numbers. */
export async function layoutOf(file) {
  const text = await file.slice(0, BEGIN).text();
  const lines = text.replace(/^\uFEFF/, '').split(/\r?\n/).slice(0, -1);
  for (const [delimiter, mark] of [...DELIMITERS, ['space', ' ']]) {
    const rows = lines.map((line) => cellsOf(line, mark));
    const first = rows.findIndex((cells) => cells.length > 1 && cells.filter(isNumber).length > 1);
    if (first < 0) continue;
    const numbers = rows.slice(first).filter((cells) => cells.length === rows[first].length).slice(0, 3);
    const decimal = numbers.flat().some((cell) => /\d,\d/.test(cell)) && mark !== ',' ? 'comma' : 'point';
    const head = rows[first - 1];
    const names = rows[first].map((_, k) => (head?.length === rows[first].length ? head[k] : ''));
    return { delimiter, decimal, headerLines: first, names: names.slice(0, MOST), examples: numbers.map((cells) => cells.slice(0, MOST)) };
  }
  return null;
}

/** The unit that a name ends in: left_um, height [mm]. */
const unitIn = (name, units, otherwise) => {
  const [, found] = /[\s_([]\s*(µm|um|mm|km|m)\s*[\])]?$/i.exec(name) ?? [];
  const unit = found?.toLowerCase().replace('µ', 'u');
  return units.includes(unit) ? unit : otherwise;
};
const POSITION_NAME = /^(km|chainage|position|station|distance|x|s|weg|ort|kilomet)/i;
const HEIGHT_NAME = /(left|right|low|high|inner|outer|rail|height|level|links|rechts|innen|außen|hoch|höhe|profil)/i;

export class Columns {
  /** `onChoose` takes a reader profile, as `riffel roughness --format` does. */
  constructor({ onChoose }) {
    Object.assign(this, { onChoose, layout: null });
    this.table = element('table', { className: 'comparison', id: 'columns-table' });
    this.spacing = element('input', { type: 'text', id: 'columns-spacing', value: '1', inputMode: 'decimal', size: 6 });
    const use = worded('button', 'columns_use', { type: 'button', className: 'plain', id: 'columns-use' });
    use.addEventListener('click', () => this.#choose());
    this.fault = element('p', { className: 'fault', hidden: true });
    this.step = element('label', { className: 'choice' }, worded('span', 'columns_spacing'), this.spacing, ' mm');
    this.place = element('details', { className: 'columns', id: 'columns', hidden: true }, worded('summary', 'columns'), worded('p', 'columns_help', { className: 'fine' }),
      element('div', { className: 'sideways' }, this.table), element('div', { className: 'buttons' }, this.step, use), this.fault);
  }

  /** Offer the columns of a file, as they were `chosen` for it before; one that is not at hand any more, or is no table, has none. */
  async offer(file, chosen) {
    this.layout = file instanceof Blob ? await layoutOf(file) : null;
    this.place.hidden = !this.layout;
    this.place.open = false;
    if (this.layout) this.#show(chosen);
  }

  /** The program could not read it as it stands. */
  open() {
    if (this.layout) this.place.open = true;
  }

  #show(chosen) {
    const { names, examples } = this.layout;
    const position = Math.max(names.findIndex((name) => POSITION_NAME.test(name)), 0);
    const kinds = ['none', 'position', 'height'];
    const likely = (k) => (k === position ? 'position' : HEIGHT_NAME.test(names[k]) || names.length <= 3 ? 'height' : 'none');
    this.rows = names.map((name, k) => {
      const label = name || t('column_n', k + 1);
      const kind = element('select', { ariaLabel: `${label}: ${t('column_is')}` }, ...kinds.map((value) => worded('option', `column_${value}`, { value })));
      const unit = element('select', { ariaLabel: `${label}: ${t('column_unit')}` });
      const units = () => {
        const list = kind.value === 'position' ? POSITIONS : UNITS;
        unit.replaceChildren(...list.map((value) => element('option', { value, textContent: value.replace('um', 'µm') })));
        unit.value = unitIn(name, list, /^km/i.test(name) && kind.value === 'position' ? 'km' : list[0]);
        unit.hidden = kind.value === 'none';
        this.step.hidden = this.rows?.some((row) => row.kind.value === 'position');
      };
      kind.value = likely(k);
      kind.addEventListener('change', units);
      return { name: label, kind, unit, units };
    });
    this.rows.forEach(({ kind, unit, units }, k) => {
      const [position, height] = [chosen?.position, chosen?.rails.find(({ column }) => column === k + 1)];
      const own = position?.column === k + 1 ? position : height;
      if (chosen) kind.value = !own ? 'none' : own === position ? 'position' : 'height';
      units();
      if (own) unit.value = own.unit;
    });
    const cells = (k) => examples.map((row) => element('td', { textContent: row[k] ?? '' }));
    this.table.replaceChildren(element('tbody', {}, ...this.rows.map(({ name, kind, unit }, k) =>
      element('tr', {}, element('th', { scope: 'row', textContent: name }), element('td', {}, kind), element('td', {}, unit), ...cells(k)))));
    this.fault.hidden = true;
    translate(this.place);
  }

  #choose() {
    const { delimiter, decimal, headerLines } = this.layout;
    const of = (wanted) => this.rows.flatMap(({ name, kind, unit }, k) => (kind.value === wanted ? [{ column: k + 1, unit: unit.value, name }] : []));
    const [positions, heights] = [of('position'), of('height')];
    const spacing = Number(this.spacing.value.replace(',', '.'));
    const wrong = positions.length > 1 ? 'columns_one_position' : !heights.length ? 'columns_no_height' : !positions.length && !(spacing > 0) ? 'columns_no_spacing' : null;
    this.fault.hidden = !wrong;
    if (wrong) {
      this.fault.textContent = t(wrong);
      return;
    }
    this.onChoose({
      delimiter, decimal, header_lines: headerLines, ...(positions.length ? { position: { ...positions[0], name: '' } } : { spacing: `${spacing} mm` }), rails: heights,
    });
  }

  reword() {
    translate(this.place);
  }
}
