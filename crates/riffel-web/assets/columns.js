// The columns of a table of many: which is the position, and which are heights of a rail.

import { element, worded } from './elements.js';
import { NumberField, UNITS as UNITS_OF_FIELDS } from './number-field.js';
import { t, translate } from './words.js';

/** Begin of a file that is looked at [bytes]. */
const BEGIN = 16_384;
const DELIMITERS = [['tab', '\t'], ['semicolon', ';'], ['comma', ',']];
/** Columns that are offered. */
const MOST = 24;
const UNITS = ['um', 'mm', 'm', 'cm', 'nm', 'in', 'mil', 'ft'];
const POSITIONS = ['m', 'km', 'mm', 'cm', 'ft', 'in', 'yd', 'mi'];
/** Steps between samples that are taken [mm]. */
const [SHORTEST_STEP, LONGEST_STEP] = [0.001, 1000];

const isNumber = (cell) => /^[+-]?(\d+([.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?$/.test(cell.trim());
const cellsOf = (line, mark) => (mark === ' ' ? line.trim().split(/\s+/) : line.split(mark)).map((cell) => cell.trim().replace(/^"(.*)"$/, '$1'));

/** The text of a file, as the program takes it: UTF-16 by its mark, else UTF-8 and, where it is none, Windows-1252. The end may be within a letter. */
export function decoded(bytes) {
  const mark = { '255 254': 'utf-16le', '254 255': 'utf-16be' }[bytes.subarray(0, 2).join(' ')];
  if (mark) return new TextDecoder(mark).decode(bytes, { stream: true });
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes, { stream: true });
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}

/** Layout of a file from its first lines: delimiter, lines of the head, names and first numbers of the columns. Null where there is no table of numbers. */
export async function layoutOf(file) {
  const text = decoded(new Uint8Array(await file.slice(0, BEGIN).arrayBuffer()));
  const lines = text.replace(/^\uFEFF/, '').split(/\r?\n/).slice(0, -1);
  const alone = oneColumn(lines);
  if (alone) return alone;
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

/** Heights alone, one in each line. What stands before a comma and rises from line to line is a position and no part of them. */
function oneColumn(lines) {
  const first = lines.findIndex(isNumber);
  const rest = lines.slice(first).filter((line) => line.trim());
  if (first < 0 || !rest.every(isNumber)) return null;
  const before = rest.map((line) => Number(line.split(',')[0]));
  if (rest.every((line) => line.includes(',')) && before.every((value, k) => k === 0 || value > before[k - 1])) return null;
  return { delimiter: 'tab', decimal: rest.some((line) => line.includes(',')) ? 'comma' : 'point', headerLines: first, names: [lines[first - 1]?.trim() ?? ''], examples: rest.slice(0, 3).map((line) => [line.trim()]) };
}

/** The unit that a name ends in: left_um, height [mm]. */
const unitIn = (name, units, otherwise) => {
  const [, found] = /[\s_([]\s*(µm|μm|um|mm|cm|nm|km|mil|mi|m|in|ft|yd)\s*[\])]?$/i.exec(name) ?? [];
  const unit = found?.toLowerCase().replace(/[µμ]/, 'u');
  return units.includes(unit) ? unit : otherwise;
};
const POSITION_NAME = /^(km|chainage|position|station|distance|x|s|weg|ort|kilomet)/i;
const HEIGHT_NAME = /(left|right|low|high|inner|outer|rail|height|level|links|rechts|innen|außen|hoch|höhe|profil)/i;

export class Columns {
  /** `onChoose` takes a reader profile, as `riffel roughness --format` does. */
  constructor({ onChoose }) {
    Object.assign(this, { onChoose, layout: null });
    this.table = element('table', { className: 'comparison', id: 'columns-table' });
    this.spacing = 0.001;
    this.step = new NumberField({
      id: 'columns-spacing', word: 'columns_spacing', units: UNITS_OF_FIELDS.millimetres, low: 1e-3 * SHORTEST_STEP, high: 1e-3 * LONGEST_STEP, onTrouble: () => {},
      accept: (value = 0.001) => {
        this.spacing = value;
        this.step.show(value);
        return '';
      },
    });
    this.step.show(this.spacing);
    const use = worded('button', 'columns_use', { type: 'button', className: 'plain', id: 'columns-use' });
    use.addEventListener('click', () => this.#choose());
    this.fault = element('p', { className: 'fault', hidden: true });
    this.place = element('details', { className: 'columns', id: 'columns', hidden: true }, worded('summary', 'columns'), worded('p', 'columns_help', { className: 'fine' }),
      element('div', { className: 'sideways' }, this.table), element('div', { className: 'settings' }, this.step.row, use), this.fault);
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
    const position = names.length > 1 ? Math.max(names.findIndex((name) => POSITION_NAME.test(name)), 0) : -1;
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
        this.step.row.hidden = this.rows?.some((row) => row.kind.value === 'position');
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
    const wrong = positions.length > 1 ? 'columns_one_position' : !heights.length ? 'columns_no_height' : null;
    // A step that is refused says so itself.
    if (!positions.length && this.step.isWrong) return;
    this.fault.hidden = !wrong;
    if (wrong) {
      this.fault.textContent = t(wrong);
      return;
    }
    this.onChoose({
      delimiter, decimal, header_lines: headerLines, ...(positions.length ? { position: { ...positions[0], name: '' } } : { spacing: `${this.spacing} m` }), rails: heights,
    });
  }

  reword() {
    this.step.show(this.spacing);
    translate(this.place);
  }
}
