// The traffic: what turns passages into months and gross tonnes. Until one is given, a default stands in and says so.

import { element, worded } from './elements.js';
import { short } from './keys.js';
import { askWhich, readNumber } from './numbers.js';
import { SPEED_UNITS, currentLanguage, number, passages, t, unitOfSpeed, written } from './words.js';

export const DEFAULT = { from_km_per_h: 60, to_km_per_h: 100, passages_per_day: 6000, months: 12 };
/** What the program takes: lowest and highest value. */
const FIELDS = [
  ['passages_per_day', 'traffic-daily', 'passages_daily', '1/d', 0.01, 1e6], ['from_km_per_h', 'traffic-from', 'speed_from', 'km/h', 0.1, 700],
  ['to_km_per_h', 'traffic-to', 'speed_to', 'km/h', 0.1, 700], ['months', 'traffic-months', 'months_ahead', '', 0.1, 1200],
];
/** Units of speed that are taken, in km/h. */
const SPEEDS = { ...Object.fromEntries(Object.entries(SPEED_UNITS).map(([unit, size]) => [unit, 3.6 * size])), kph: 1, 'mi/h': 3.6 * SPEED_UNITS.mph };
const DAYS_OF_MONTH = 365.25 / 12;
const GRAVITY = 9.80665;
/** A number as it may be typed again: without separators of thousands. */
const plain = (value) => written(short(value));

/** A traffic as a link holds it, if it is one. */
export function readTraffic(given) {
  const whole = { ...DEFAULT, ...given };
  const good = FIELDS.every(([name, , , , low, high]) => whole[name] >= low && whole[name] <= high) && whole.from_km_per_h <= whole.to_km_per_h;
  return given && typeof given === 'object' && good ? Object.fromEntries(Object.keys(DEFAULT).map((name) => [name, whole[name]])) : null;
}

export class Traffic {
  /** `onChange` is told of a traffic that is accepted, `onTrouble` that a field is not, or is again. */
  constructor(place, { onChange, onTrouble }) {
    Object.assign(this, { place, onChange, onTrouble, given: null, fields: [] });
    const summary = element('summary', {}, worded('span', 'traffic'), (this.short = element('small', { className: 'aside' })));
    const rows = element('div', { className: 'rows' });
    for (const [name, id, word, unit, low, high] of FIELDS) {
      const input = element('input', { type: 'text', inputMode: 'decimal', id, className: 'figure', autocomplete: 'off', spellcheck: false });
      const fault = element('p', { className: 'fault', id: `${id}-fault`, hidden: true });
      input.setAttribute('aria-describedby', fault.id);
      const beside = element('span', { className: 'unit' });
      const field = { name, word, input, fault, beside, low, high, isSpeed: unit === 'km/h', unit };
      input.addEventListener('change', () => this.#read(field));
      rows.append(element('div', { className: 'row' }, worded('label', word, { htmlFor: id }), input, beside, fault));
      this.fields.push(field);
    }
    rows.append((this.note = worded('p', 'traffic_is_default', { className: 'echo' })));
    place.append(element('details', { className: 'group', id: 'traffic-group' }, summary, rows));
  }

  get values() {
    return this.given ?? DEFAULT;
  }

  /** Show a traffic; null is the default. */
  show(given) {
    this.given = given;
    for (const field of this.fields) {
      if (field.isSpeed) [field.unit] = unitOfSpeed();
      field.beside.textContent = field.unit;
      if (!field.fault.hidden) continue;
      field.input.value = given ? plain(given[field.name] / this.#size(field)) : '';
      field.input.placeholder = plain(DEFAULT[field.name] / this.#size(field));
    }
    this.short.textContent = t(given ? 'traffic_given' : 'traffic_default', number(this.values.passages_per_day, 4));
    this.note.hidden = Boolean(given);
  }

  /** Size of the unit beside a field in that of the traffic. */
  #size({ isSpeed, unit }) {
    return isSpeed ? SPEEDS[unit] : 1;
  }

  #read(field) {
    this.#right(field);
    const text = field.input.value.trim();
    const accept = (value) => {
      this.#right(field);
      const next = { ...this.values, [field.name]: value ?? DEFAULT[field.name] };
      if (next.from_km_per_h > next.to_km_per_h) return this.#wrong(field, t('must_rise'));
      this.show(FIELDS.every(([name]) => next[name] === DEFAULT[name]) && value === undefined ? null : next);
      this.onTrouble();
      this.onChange(this.given);
    };
    if (text === '') return accept(undefined);
    const read = readNumber(text);
    const factor = read && (read.rest === '' || read.rest === field.unit ? this.#size(field) : field.isSpeed ? SPEEDS[read.rest] : undefined);
    if (factor === undefined || factor === null) return this.#wrong(field, t('no_number', text));
    const bounded = (digits) => {
      const value = Number(digits) * factor;
      if (value >= field.low && value <= field.high) return accept(value);
      this.#wrong(field, t('must_lie', { label: t(field.word), value: text, low: plain(field.low / this.#size(field)), high: `${plain(field.high / this.#size(field))} ${field.unit}`.trim() }));
    };
    if (!read.choices) return bounded(read.number);
    askWhich(field.fault, text, read, field.unit, bounded);
    this.#wrong(field);
  }

  #wrong({ input, fault }, sentence) {
    if (sentence) Object.assign(fault, { textContent: sentence, lang: currentLanguage() });
    fault.hidden = false;
    input.setAttribute('aria-invalid', 'true');
    input.closest('.row').classList.add('wrong');
    this.onTrouble();
  }

  #right({ input, fault }) {
    if (fault.hidden) return;
    fault.hidden = true;
    input.removeAttribute('aria-invalid');
    input.closest('.row').classList.remove('wrong');
    this.onTrouble();
  }

  get troubles() {
    return this.fields.filter(({ fault }) => !fault.hidden).map(({ word, input }) => ({ label: t(word), input }));
  }

  /** Time and gross tonnes of a count of axle passages, for a load of each of the two wheels of an axle [N]. */
  span(count, wheelLoad) {
    const days = count / this.values.passages_per_day;
    const tonnes = (count * 2 * wheelLoad) / GRAVITY / 1000;
    return { days, months: days / DAYS_OF_MONTH, megatonnes: tonnes / 1e6 };
  }

  /** The same in words: time, mass and all in one, "5.6 million passages (31 months or 57 MGT with the default traffic)". */
  words(count, wheelLoad) {
    const { days, months, megatonnes } = this.span(count, wheelLoad);
    const time = months < 1 ? t('time_days', number(days, 2)) : months < 36 ? t('time_months', number(months, 2)) : t('time_years', number(months / 12, 2));
    const mass = t('gross_tonnes', number(megatonnes, 2));
    return { time, mass, whole: `${passages(count)} ${t('passages_word')} (${t('growth_time', { time, mass, isDefault: !this.given })})` };
  }
}
