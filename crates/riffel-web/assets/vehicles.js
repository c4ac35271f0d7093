// The vehicles of a traffic: none, and the wheel of the case runs on the line, or several with shares, speeds and loads of their own.

import { element, worded } from './elements.js';
import { NumberField, UNITS } from './number-field.js';
import { currentLanguage, number, t, translate } from './words.js';

/** Most vehicles of one traffic, and letters of a name. */
const MOST = 12;
const LONGEST_NAME = 60;
/** How far the sum of the shares may be from one, as the program has it. */
const TOLERANCE = 2e-3;
/** Name of a value, its word, its unit, what the program takes, and whether a vehicle may do without. */
const FIELDS = [
  ['share', 'vehicle_share', 'percent', 1e-6, 1, false], ['from_km_per_h', 'speed_from', 'speed', 0.1, 700, false], ['to_km_per_h', 'speed_to', 'speed', 0.1, 700, false],
  ['wheel_load_n', 'vehicle_load', 'force', 1, 2e6, true], ['tractive_ratio', 'vehicle_traction', 'ratio', 1e-6, 0.999999, true],
];

const sumsToOne = (vehicles) => Math.abs(vehicles.reduce((sum, { share }) => sum + share, 0) - 1) <= TOLERANCE;
const areNamed = (vehicles) => vehicles.every(({ name }) => name) && new Set(vehicles.map(({ name }) => name)).size === vehicles.length;

/** A vehicle as a link has it, its values in one order: two that are the same are the same text. */
const ordered = (vehicle) => Object.fromEntries(['name', ...FIELDS.map(([name]) => name)].filter((name) => vehicle[name] !== undefined).map((name) => [name, vehicle[name]]));

/** The vehicles of a link: none where it has none, null where they make no traffic. */
export function readVehicles(given) {
  if (given === undefined) return [];
  if (!Array.isArray(given) || given.length > MOST) return null;
  const vehicles = given.map((one) => ordered({ ...one, name: String(one?.name ?? '').trim().slice(0, LONGEST_NAME) }));
  const isGood = (one) => FIELDS.every(([name, , , low, high, optional]) => (optional && one[name] === undefined) || (one[name] >= low && one[name] <= high)) && one.from_km_per_h <= one.to_km_per_h;
  return vehicles.every(isGood) && areNamed(vehicles) && (!vehicles.length || sumsToOne(vehicles)) ? vehicles : null;
}

/** Mean wheel load by shares, with that of the case where a vehicle says none [N]. */
export function meanLoad(vehicles, ofTheCase) {
  if (!vehicles?.length) return ofTheCase;
  const total = vehicles.reduce((sum, { share }) => sum + share, 0);
  return vehicles.reduce((sum, { share, wheel_load_n: load }) => sum + share * (load ?? ofTheCase), 0) / total;
}

export class Vehicles {
  /** `onChange` takes vehicles that make a traffic, `onTrouble` is told that something of them does not, or does again; `speeds` gives those of a first vehicle. */
  constructor({ onChange, onTrouble, speeds }) {
    Object.assign(this, { onChange, onTrouble, speeds, shown: [], rows: [] });
    this.list = element('div', { id: 'vehicles' });
    this.fault = element('p', { className: 'fault', id: 'vehicles-fault', hidden: true });
    this.add = worded('button', 'add_vehicle', { type: 'button', className: 'plain small', id: 'add-vehicle' });
    this.add.addEventListener('click', () => this.#add());
    this.place = element('div', { className: 'vehicles' }, this.list, this.fault, this.add);
  }

  /** Show the vehicles of a traffic. What is typed and not accepted stays as long as the traffic does. */
  show(vehicles) {
    if (JSON.stringify(vehicles) !== JSON.stringify(this.shown)) this.#build(vehicles);
    this.shown = structuredClone(vehicles);
    this.rows.forEach((row) => this.#refresh(row));
    this.add.disabled = this.rows.length >= MOST;
    translate(this.place);
    if (!this.fault.hidden) this.#checkShares();
  }

  get troubles() {
    const fields = this.rows.flatMap(({ name, nameFault, fields: own }) => [
      ...(nameFault.hidden ? [] : [{ label: t('vehicle_name'), input: name }]),
      ...own.filter((field) => field.isWrong).map((field) => ({ label: field.label(), input: field.input })),
    ]);
    return this.fault.hidden ? fields : [...fields, { label: t('vehicle_share'), input: this.rows[0].fields[0].input }];
  }

  #build(vehicles) {
    this.rows = vehicles.map((vehicle, k) => this.#row(structuredClone(vehicle), k));
    this.list.replaceChildren(...this.rows.map(({ group }) => group));
    this.fault.hidden = true;
  }

  #row(vehicle, k) {
    const name = element('input', { type: 'text', id: `vehicle-${k}-name`, maxLength: LONGEST_NAME, autocomplete: 'off', spellcheck: false });
    const nameFault = element('p', { className: 'fault', id: `vehicle-${k}-name-fault`, hidden: true });
    name.setAttribute('aria-describedby', nameFault.id);
    const drop = element('button', { type: 'button', className: 'plain small', textContent: '✕' });
    drop.addEventListener('click', () => this.#remove(row));
    const fields = FIELDS.map(([key, word, units, low, high, optional]) => new NumberField({
      id: `vehicle-${k}-${key.replace(/_.*/, '')}`, word, units: UNITS[units], low, high, label: () => `${vehicle.name}, ${t(word)}`, onTrouble: this.onTrouble,
      accept: (value) => this.#accept(row, key, value, optional),
    }));
    const group = element('div', { className: 'subgroup', role: 'group' },
      element('div', { className: 'row' }, worded('label', 'vehicle_name', { htmlFor: name.id }), name, drop, nameFault), ...fields.map((field) => field.row));
    const row = { vehicle, name, nameFault, drop, fields, group };
    name.addEventListener('change', () => this.#rename(row));
    return row;
  }

  #refresh({ vehicle, name, nameFault, drop, fields, group }) {
    if (nameFault.hidden) name.value = vehicle.name;
    group.setAttribute('aria-label', vehicle.name);
    drop.setAttribute('aria-label', `${t('drop')}: ${vehicle.name}`);
    fields.forEach((field, k) => field.show(vehicle[FIELDS[k][0]] ?? null, FIELDS[k][5] ? t('as_the_case') : ''));
  }

  #rename({ vehicle, name, nameFault }) {
    const text = name.value.trim();
    const others = this.rows.filter((row) => row.vehicle !== vehicle).map((row) => row.vehicle.name);
    const refusal = !text ? t('vehicle_needs_name') : others.includes(text) ? t('vehicle_twice', text) : '';
    Object.assign(nameFault, { hidden: !refusal, textContent: refusal, lang: currentLanguage() });
    name.setAttribute('aria-invalid', String(Boolean(refusal)));
    if (refusal) return this.onTrouble();
    vehicle.name = text;
    this.#settle();
  }

  #accept(row, key, value, optional) {
    const next = { ...row.vehicle, [key]: value };
    if (value === undefined && !optional) return t('vehicle_needs', t(FIELDS.find(([name]) => name === key)[1]));
    if (next.from_km_per_h > next.to_km_per_h) return t('must_rise');
    if (value === undefined) delete row.vehicle[key];
    else row.vehicle[key] = value;
    this.#settle();
    return '';
  }

  /** Hand on what is written, if all of it makes a traffic. */
  #settle() {
    this.#checkShares();
    this.rows.forEach((row) => this.#refresh(row));
    this.onTrouble();
    if (this.troubles.length) return;
    this.shown = this.rows.map(({ vehicle }) => ordered(vehicle));
    this.onChange(structuredClone(this.shown));
  }

  #checkShares() {
    const vehicles = this.rows.map(({ vehicle }) => vehicle);
    const sum = vehicles.reduce((total, { share }) => total + share, 0);
    this.fault.hidden = !vehicles.length || sumsToOne(vehicles);
    if (!this.fault.hidden) Object.assign(this.fault, { textContent: t('shares_sum', number(100 * sum, 4)), lang: currentLanguage() });
  }

  /** One more, which takes half of the passages of the last, or all if it is the first. */
  #add() {
    const vehicles = this.rows.map(({ vehicle }) => structuredClone(vehicle));
    const names = vehicles.map(({ name }) => name);
    let count = 1;
    while (names.includes(t('vehicle_n', count))) count++;
    const last = vehicles.at(-1);
    if (last) last.share /= 2;
    vehicles.push({ ...(last ?? { share: 1, ...this.speeds() }), name: t('vehicle_n', count) });
    this.#replace(vehicles);
    this.rows.at(-1).name.focus();
    this.rows.at(-1).name.select();
  }

  /** One less; the others keep their proportions. */
  #remove(row) {
    const vehicles = this.rows.filter((other) => other !== row).map(({ vehicle }) => vehicle);
    const sum = vehicles.reduce((total, { share }) => total + share, 0);
    this.#replace(vehicles.map((vehicle) => ({ ...vehicle, share: vehicle.share / sum })));
    this.add.focus();
  }

  #replace(vehicles) {
    this.#build(vehicles);
    this.#settle();
    this.add.disabled = this.rows.length >= MOST;
    translate(this.place);
  }
}
