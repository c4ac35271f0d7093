// The uncertain values of a calibration: each with its usual prior, which may be changed, or left out.

import { element, fillTable, worded } from './elements.js';
import { readNumber } from './numbers.js';
import { remember, remembered } from './remembered.js';
import { labelOf, t, translate, written } from './words.js';

/** The two numbers of each distribution. */
const NUMBERS = { lognormal: ['median', 'factor'], normal: ['mean', 'standard_deviation'], uniform: ['min', 'max'], triangular: ['min', 'max'] };
/** Values that are no keys of a case, with their words. */
const OWN = { preload_stiffening: 'preload_stiffening', 'vehicle.speed.mean': 'speed_mean', 'vehicle.speed.standard_deviation': 'speed_deviation', 'vehicle.traction_share': 'traction_share', 'vehicle.tractive_ratio': 'vehicle_traction', 'vehicle.wheel_mass': 'vehicle_wheel_mass' };

/** The name of an uncertain value on the page. */
export function nameOfValue(name) {
  const missed = /^(.*)\.discrepancy$/.exec(name);
  if (missed) return t('missed_of', missed[1]);
  const [, key, vehicle] = /^(.*?)( \(.*\))?$/.exec(name);
  return `${OWN[key] ? t(OWN[key]) : labelOf(key)}${vehicle ?? ''}`;
}

/** The unit of what a model misses of growth is words. */
export const unitInWords = (text) => text.replace('dB per 1e6 passages', t('passages_unit'));

/** Words of the program with the names of values as the page has them. */
export const withNames = (text, names) => [...names].sort((a, b) => b.length - a.length).reduce((words, name) => words.replaceAll(name, nameOfValue(name)), unitInWords(text));

/** Where a reload finds what was changed. */
const KEPT = 'riffel-priors';

export class Priors {
  /** `onChange` is told that priors are others, or that a value is left out. */
  constructor({ onChange }) {
    Object.assign(this, { onChange, changes: remembered(KEPT) ?? {}, usual: [] });
    this.table = element('table', { className: 'comparison', id: 'priors' });
    this.place = element('div', { className: 'sideways', tabIndex: 0, role: 'group' }, this.table);
    this.place.dataset.tLabel = 'uncertain';
  }

  /** Show the values of a plan, of which `usual` is that without changes. */
  show({ usual, parameters }) {
    this.usual = usual;
    this.data = new Map(parameters.map(({ name, data }) => [name, data]));
    fillTable(this.table, ['uncertain', 'prior', '', 'told_from'].map((word) => word && t(word)), usual.map((one) => this.#row(one)));
    translate(this.place);
  }

  /** Take changes in the place of those before. */
  take(changes) {
    this.changes = changes;
    remember(KEPT, changes);
  }

  #change(name, more) {
    const change = { ...this.changes[name], ...more };
    if (!change.left_out) delete change.left_out;
    if (!Object.keys(change.prior ?? {}).length) delete change.prior;
    const { [name]: _, ...others } = this.changes;
    this.take(Object.keys(change).length ? { ...others, [name]: change } : others);
    this.onChange();
  }

  #row({ name, distribution, prior }) {
    const change = this.changes[name] ?? {};
    const label = nameOfValue(name);
    const taken = element('input', { type: 'checkbox', checked: !change.left_out });
    taken.addEventListener('change', () => this.#change(name, { left_out: !taken.checked }));
    const fields = NUMBERS[distribution].map((key) => {
      const input = element('input', { type: 'text', className: 'figure', autocomplete: 'off', spellcheck: false, size: 10, disabled: change.left_out, value: written(change.prior?.[key] ?? prior[key]), ariaLabel: `${label}: ${t(`prior_${key}`)}` });
      input.addEventListener('change', () => {
        const own = { ...change.prior, [key]: valueOf(input.value) };
        if (own[key] === undefined || own[key] === prior[key]) delete own[key];
        this.#change(name, { prior: own });
      });
      return element('label', { className: 'choice' }, worded('span', `prior_${key}`, { className: 'unit' }), input);
    });
    const data = this.data.get(name) ?? [];
    return element('tr', { className: change.left_out ? 'left-out' : '' }, element('th', { scope: 'row' }, element('label', {}, taken, ` ${label}`)), ...fields.map((field) => element('td', {}, field)), element('td', { textContent: change.left_out ? t('value_of_case') : data.join(', ') }));
  }
}

/** What is typed as a plan has it: a number, or a text with its unit; undefined from an empty field. */
function valueOf(text) {
  if (!text.trim()) return undefined;
  const read = readNumber(text);
  if (!read || read.choices) return text.trim();
  return read.rest ? `${read.number} ${read.rest}` : Number(read.number);
}
