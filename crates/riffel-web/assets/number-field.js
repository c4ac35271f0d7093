// A field of a number with its unit: read as people write it, and refused in its place.

import { element, worded } from './elements.js';
import { short } from './keys.js';
import { askWhich, readNumber } from './numbers.js';
import { SPEED_UNITS, currentLanguage, number, t, unitOfSpeed, written } from './words.js';

/** Units of speed that are taken, in km/h. */
const SPEEDS = { ...Object.fromEntries(Object.entries(SPEED_UNITS).map(([unit, size]) => [unit, 3.6 * size])), kph: 1, 'mi/h': 3.6 * SPEED_UNITS.mph };
/** Units of length that are taken [m]: the micrometre with either of its two letters. */
const LENGTHS = { m: 1, mm: 1e-3, µm: 1e-6, 'μm': 1e-6, um: 1e-6, cm: 1e-2, km: 1e3, in: 0.0254, ft: 0.3048 };
/** Unit beside a field and sizes of the units that it takes, in that of its value. A pound-force is 0.45359237 kg under standard gravity. */
export const UNITS = {
  speed: () => ({ unit: unitOfSpeed()[0], sizes: SPEEDS }),
  force: () => ({ unit: 'kN', sizes: { kN: 1e3, N: 1, MN: 1e6, lbf: 4.4482216152605, kip: 4448.2216152605 } }),
  percent: () => ({ unit: '%', sizes: { '%': 0.01 } }),
  ratio: () => ({ unit: '', sizes: { '': 1, '%': 0.01 } }),
  none: () => ({ unit: '', sizes: { '': 1 } }),
  money: () => ({ unit: '', sizes: { '': 1 }, isMoney: true }),
  length: () => ({ unit: 'm', sizes: LENGTHS }),
  millimetres: () => ({ unit: 'mm', sizes: LENGTHS }),
  micrometres: () => ({ unit: 'µm', sizes: LENGTHS }),
  mass: () => ({ unit: 't', sizes: { t: 1e3, kg: 1, lb: 0.45359237, lbs: 0.45359237 } }),
  stiffness: () => ({ unit: 'MN/m', sizes: { 'MN/m': 1e6, 'kN/mm': 1e6, 'kN/m': 1e3, 'N/mm': 1e3, 'N/m': 1 } }),
  daily: () => ({ unit: '1/d', sizes: { '1/d': 1 } }),
};

/** A value so many times what it was before may be a slip of the hand. */
export const FAR = 100;

/** A number as it may be typed again: without separators of thousands. */
const plain = (value) => written(short(value));

export class NumberField {
  /**
   * `units` is one of UNITS, `label` gives the name by which messages call the field. `accept` takes a value between `low` and `high`, or undefined from an empty
   * field, and answers with a sentence if it refuses it. `onTrouble` is told that the field is refused, or is again accepted.
   */
  constructor({ id, word, units, low, high, label = () => t(word), accept, onTrouble }) {
    Object.assign(this, { units, low, high, label, accept, onTrouble });
    this.input = element('input', { type: 'text', inputMode: 'decimal', id, className: 'figure', autocomplete: 'off', spellcheck: false });
    this.fault = element('p', { className: 'fault', id: `${id}-fault`, hidden: true });
    this.echo = element('p', { className: 'echo', id: `${id}-echo`, hidden: true });
    this.input.setAttribute('aria-describedby', `${this.fault.id} ${this.echo.id}`);
    this.beside = element('span', { className: 'unit' });
    this.row = element('div', { className: 'row' }, worded('label', word, { htmlFor: id }), this.input, this.beside, this.fault, this.echo);
    this.input.addEventListener('change', () => this.#read());
  }

  /** Show a value, null for an empty field, and what stands in for none: a value or words. What is typed stays for its value, and what is refused. */
  show(value, otherwise) {
    this.unit = this.units().unit;
    this.beside.textContent = this.unit;
    if (this.isWrong) return;
    const { typed } = this;
    if (typed && (typed.value !== value || typed.unit !== this.unit || typed.language !== currentLanguage())) this.typed = null;
    this.input.value = this.typed?.text ?? (value === null ? '' : plain(value / this.#size));
    this.input.placeholder = typeof otherwise === 'number' ? plain(otherwise / this.#size) : (otherwise ?? '');
    this.value = value ?? (typeof otherwise === 'number' ? otherwise : undefined);
    this.#tell();
  }

  /** What was read, where it was not written in the unit of the field or is far from what it was. */
  #tell() {
    const { value, before, isOdd } = this.typed ?? {};
    const inUnit = (value) => `${number(value / this.#size, 4)} ${this.unit}`.trim();
    const times = Math.abs(value / before);
    const far = times >= FAR || times <= 1 / FAR;
    this.echo.hidden = !isOdd && !far;
    if (this.echo.hidden) return;
    Object.assign(this.echo, { textContent: far ? t('far_off', { now: inUnit(value), before: inUnit(before) }) : t('read_as', inUnit(value)), lang: currentLanguage() });
    this.echo.classList.toggle('far', far);
  }

  get isWrong() {
    return !this.fault.hidden;
  }

  /** Size of the unit beside the field. */
  get #size() {
    return this.units().sizes[this.unit];
  }

  #read() {
    this.right();
    const text = this.input.value.trim();
    const accept = (value, isOdd) => {
      this.right();
      // A number that was asked for is shown as it was chosen.
      this.typed = value === undefined || isOdd === undefined ? null : { text: this.input.value, value, isOdd, before: this.value, unit: this.unit, language: currentLanguage() };
      const refusal = this.accept(value);
      if (refusal) this.wrong(refusal);
    };
    this.typed = null;
    this.echo.hidden = true;
    if (text === '') return accept(undefined);
    const { sizes, isMoney } = this.units();
    const read = readNumber(text, currentLanguage(), isMoney);
    if (!read) return this.wrong(t('no_number', text));
    const factor = read.rest === '' ? this.#size : sizes[read.rest];
    const units = Object.keys(sizes).filter(Boolean).join(', ');
    if (factor === undefined) return this.wrong(units ? t('no_unit', { text, units }) : t('no_number', text));
    const bounded = (digits, isOdd) => {
      const value = Number(digits) * factor;
      if (value >= this.low && value <= this.high) return accept(value, isOdd);
      this.wrong(t('must_lie', { label: this.label(), value: text, low: plain(this.low / this.#size), high: `${plain(this.high / this.#size)} ${this.unit}`.trim() }));
    };
    if (!read.choices) return bounded(read.number, Boolean(read.odd) || (read.rest !== '' && read.rest !== this.unit));
    askWhich(this.fault, text, read, this.unit, (choice) => bounded(choice));
    this.wrong();
  }

  /** Say what is wrong, or that something is. */
  wrong(sentence) {
    if (sentence) Object.assign(this.fault, { textContent: sentence, lang: currentLanguage() });
    this.fault.hidden = false;
    this.input.setAttribute('aria-invalid', 'true');
    this.row.classList.add('wrong');
    this.onTrouble();
  }

  right() {
    if (!this.isWrong) return;
    this.fault.hidden = true;
    this.input.removeAttribute('aria-invalid');
    this.row.classList.remove('wrong');
    this.onTrouble();
  }
}
