// The traffic: what turns passages into months and gross tonnes. Until one is given, the usual one of the line stands in and says so.

import { element, worded } from './elements.js';
import { NumberField, UNITS } from './number-field.js';
import { Vehicles, meanLoad, readVehicles } from './vehicles.js';
import { number, passages, t } from './words.js';

/** Of the usual traffic, before the program has told that of the line. */
const USUAL = { from_km_per_h: 60, to_km_per_h: 100, passages_per_day: 6000, months: 12 };
/** What the program takes: lowest and highest value. */
const FIELDS = [
  ['passages_per_day', 'traffic-daily', 'passages_daily', 'daily', 0.01, 1e6], ['from_km_per_h', 'traffic-from', 'speed_from', 'speed', 0.1, 700],
  ['to_km_per_h', 'traffic-to', 'speed_to', 'speed', 0.1, 700], ['months', 'traffic-months', 'months_ahead', 'none', 0.1, 1200],
];
const DAYS_OF_MONTH = 365.2425 / 12;
const GRAVITY = 9.80665;

/** The vehicle of a traffic that names none, as a traffic file has it. */
const WHEEL_OF_THE_CASE = 'the wheel of the case';
/** Where the standard deviation reaches this share of the mean, no normal distribution stands for the speeds but so many, each in the middle of an equal part. */
const WIDEST_NORMAL = 0.25;
const SPEEDS = 16;

const ends = ({ from_km_per_h: from, to_km_per_h: to }) => [from / 3.6, to / 3.6];
const middle = (vehicle) => (ends(vehicle)[0] + ends(vehicle)[1]) / 2;

/** Speeds that lie evenly between two ends, as keys of a traffic file. */
function evenly([from, to]) {
  const [mean, deviation] = [(from + to) / 2, (to - from) / Math.sqrt(12)];
  if (deviation < WIDEST_NORMAL * mean) return { speed: { mean, ...(deviation > 0 && { standard_deviation: deviation }) } };
  return { speeds: Array.from({ length: SPEEDS }, (_, place) => ({ speed: from + ((to - from) * (place + 0.5)) / SPEEDS, share: 1 / SPEEDS })) };
}

/** A traffic with other vehicles, and the lowest and highest of their speeds. */
function withVehicles({ vehicles: _, ...traffic }, vehicles) {
  if (!vehicles.length) return traffic;
  const ends = (name) => vehicles.map((vehicle) => vehicle[name]);
  return { ...traffic, from_km_per_h: Math.min(...ends('from_km_per_h')), to_km_per_h: Math.max(...ends('to_km_per_h')), vehicles };
}

/** A traffic as a link holds it, if it is one. Those of before have no vehicles. */
export function readTraffic(given) {
  if (!given || typeof given !== 'object') return null;
  const vehicles = readVehicles(given.vehicles);
  const whole = { ...USUAL, ...given };
  const good = FIELDS.every(([name, , , , low, high]) => whole[name] >= low && whole[name] <= high) && whole.from_km_per_h <= whole.to_km_per_h;
  const own = Object.fromEntries(Object.keys(USUAL).map((name) => [name, whole[name]]));
  return good && vehicles ? withVehicles({ ...own, ...(given.all_wheels === true && { all_wheels: true }) }, vehicles) : null;
}

export class Traffic {
  /** `onChange` is told of a traffic that is accepted, `onTrouble` that a field is not, or is again. */
  constructor(place, { onChange, onTrouble }) {
    Object.assign(this, { place, onChange, onTrouble, given: null, usual: USUAL, fastest: 0 });
    const summary = element('summary', {}, worded('span', 'traffic'), (this.short = element('small', { className: 'aside' })));
    this.fields = FIELDS.map(([name, id, word, units, low, high]) => Object.assign(new NumberField({
      id, word, units: UNITS[units], low, high, onTrouble, accept: (value) => this.#accept(name, value),
    }), { name }));
    this.vehicles = new Vehicles({ onTrouble, onChange: (vehicles) => this.#take(withVehicles(this.values, vehicles)), speeds: () => ({ from_km_per_h: this.values.from_km_per_h, to_km_per_h: this.values.to_km_per_h }) });
    this.allWheels = element('input', { type: 'checkbox', id: 'traffic-all-wheels' });
    this.allWheels.addEventListener('change', () => this.#setAllWheels(this.allWheels.checked));
    this.inCurve = element('label', { className: 'row', hidden: true, htmlFor: 'traffic-all-wheels' }, this.allWheels, worded('span', 'all_wheels'));
    const rows = element('div', { className: 'rows' }, ...this.fields.map((field) => field.row), this.inCurve, this.vehicles.place, (this.note = worded('p', 'traffic_is_default', { className: 'echo' })));
    place.append(element('details', { className: 'group', id: 'traffic-group' }, summary, rows));
  }

  get values() {
    return this.given ?? this.usual;
  }

  /** The usual traffic of the line, as the program tells it; whether that changes the traffic. */
  setUsual({ speeds_m_per_s: speeds, passages_per_day, in_curve: inCurve, fastest_doubling_days: fastest }) {
    this.fastest = fastest;
    this.inCurve.hidden = !inCurve;
    const [from_km_per_h, to_km_per_h] = speeds.map((speed) => Number((3.6 * speed).toPrecision(6)));
    const usual = { ...USUAL, from_km_per_h, to_km_per_h, passages_per_day };
    if (JSON.stringify(usual) === JSON.stringify(this.usual)) return false;
    this.usual = usual;
    // What is being written stays.
    if (!this.place.contains(document.activeElement) && !this.troubles.length) this.show(this.given);
    return !this.given;
  }

  /** Show a traffic; null is the usual one. */
  show(given) {
    this.given = given;
    const vehicles = given?.vehicles ?? [];
    for (const field of this.fields) {
      field.show(given ? given[field.name] : null, this.usual[field.name]);
      // Vehicles have speeds of their own.
      if (field.name.endsWith('_km_per_h')) {
        field.row.hidden = vehicles.length > 0;
        if (field.row.hidden) field.right();
      }
    }
    this.vehicles.show(vehicles);
    this.allWheels.checked = Boolean(given?.all_wheels);
    this.short.textContent = t(given ? 'traffic_given' : 'traffic_default', number(this.values.passages_per_day, 4));
    this.note.hidden = Boolean(given);
  }

  #accept(name, value) {
    const next = { ...this.values, [name]: value ?? this.usual[name] };
    if (next.from_km_per_h > next.to_km_per_h) return t('must_rise');
    this.#take(value === undefined && this.#isUsual(next) ? null : next);
    return '';
  }

  #setAllWheels(is) {
    const { all_wheels: _, ...others } = this.values;
    const next = { ...others, ...(is && { all_wheels: true }) };
    this.#take(this.#isUsual(next) ? null : next);
  }

  #isUsual({ vehicles, all_wheels: allWheels, ...values }) {
    return !vehicles && !allWheels && FIELDS.every(([name]) => values[name] === this.usual[name]);
  }

  #take(next) {
    this.show(next);
    this.onTrouble();
    this.onChange(this.given);
  }

  get troubles() {
    return [...this.fields.filter((field) => field.isWrong).map((field) => ({ label: field.label(), input: field.input })), ...this.vehicles.troubles];
  }

  get #vehicles() {
    return this.values.vehicles ?? [{ name: WHEEL_OF_THE_CASE, share: 1, ...this.values }];
  }

  /** The keys of its traffic file. */
  get file() {
    // A case that has no curve any more has one wheel.
    const through = this.values.all_wheels && !this.inCurve.hidden && { curve: true };
    const vehicle = this.#vehicles.map(({ name, share, wheel_load_n: load, tractive_ratio: ratio, ...speeds }) => ({
      name, share, ...(load !== undefined && { wheel_load: load }), ...(ratio !== undefined && { tractive_ratio: ratio }), ...evenly(ends(speeds)), ...through,
    }));
    return { line: { passages_per_day: this.values.passages_per_day }, vehicle };
  }

  /** The same of a traffic that was given; null for the usual one of the line. */
  get givenFile() {
    return this.given && this.file;
  }

  /** Mean speed of the axle passages [m/s]. */
  get meanSpeed() {
    const shares = this.#vehicles.reduce((sum, { share }) => sum + share, 0);
    return this.#vehicles.reduce((sum, vehicle) => sum + vehicle.share * middle(vehicle), 0) / shares;
  }

  /** Speeds of the wheel of the case, as a question has them; none where the vehicles have their own. */
  get speed() {
    return this.values.vehicles ? [] : [ends(this.values).map((speed) => `${speed} m/s`).join('..')];
  }

  /** Time and gross tonnes of a count of axle passages, for a load of each of the two wheels of an axle where no vehicle says another [N]. */
  span(count, wheelLoad) {
    const days = count / this.values.passages_per_day;
    const tonnes = (count * 2 * meanLoad(this.values.vehicles, wheelLoad)) / GRAVITY / 1000;
    return { days, months: days / DAYS_OF_MONTH, megatonnes: tonnes / 1e6 };
  }

  /** The same in words: time, mass and all in one, "5.6 million passages (31 months or 57 MGT with the default traffic)"; no time where a doubling is faster than any railway known. */
  words(count, wheelLoad, grows = true) {
    const { days, months, megatonnes } = this.span(count, wheelLoad);
    const isTooFast = grows && days < this.fastest;
    const time = isTooFast ? t('faster_than_known') : months < 1 ? t('time_days', number(days, 2)) : months < 36 ? t('time_months', number(months, 2)) : t('time_years', number(months / 12, 2));
    const mass = t('gross_tonnes', number(megatonnes, 2));
    return { isTooFast, time, mass, whole: `${passages(count)} ${t('passages_word')} (${isTooFast ? time : t('growth_time', { time, mass, isDefault: !this.given })})` };
  }

  /** In what a wave doubles: "4.7 million passages, 26 months"; neither where that is faster than any railway known. */
  doubling(count) {
    const { isTooFast, time } = this.words(count, 0);
    return isTooFast ? time : `${passages(count)} ${t('passages_word')}, ${time}`;
  }
}
