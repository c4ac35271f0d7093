// What helps: remedies ranked by what they do to growth under the traffic, or by the months that they gain for their cost, each to be kept as a variant.

import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { inSentences, inWords } from './messages.js';
import { inUnit, set, shownUnit } from './keys.js';
import { NumberField, UNITS } from './number-field.js';
import { remember, remembered } from './remembered.js';
import { labelOf, number, sentence, speed, t, translate } from './words.js';

/** Where a reload finds what remedies cost. */
const KEPT = 'riffel-costs';
/** Least and most that a remedy may cost. */
const [LEAST, MOST] = [0.01, 1e9];

/** The costs of a project, by the ids of remedies; what is no cost is left out. */
export const readCosts = (costs) => Object.fromEntries(Object.entries(costs ?? {}).filter(([, cost]) => cost >= LEAST && cost <= MOST));

export class Remedies {
  /**
   * `onKeep` takes the name and the keys of a variant, `onTraffic` leads to the speeds of the traffic, `onCosts` is told that costs are others; `likelihood`
   * promises by the ids of remedies how likely each helps, null without a calibration of the case; `unexplained` gives what is said where the model does not
   * explain a measured rail, of which it ranks nothing.
   */
  constructor({ state, unitOf, save, onKeep, onTraffic, onCosts, onFault, likelihood, unexplained }) {
    Object.assign(this, { state, unitOf, onKeep, onTraffic, onCosts, onFault, likelihood, unexplained, answer: null, likely: null, costs: remembered(KEPT) ?? {}, fields: new Map() });
    this.table = element('table', { className: 'comparison', id: 'remedies' });
    this.rest = element('ul', { className: 'fine' });
    const header = element('header', {}, worded('h2', 'what_helps'), worded('span', 'each_alone', { className: 'aside' }));
    offer(header, () => ({ name: 'remedies', table: this.table }), save, ['csv']);
    this.panel = element('article', { className: 'panel remedies-panel of-remedies', id: 'remedies-panel' }, header, (this.hint = worded('p', 'remedies_come', { className: 'why' })), element('div', { className: 'sideways' }, this.table), this.rest);
  }

  /** Show an answer; null is that nothing is known yet. */
  show(answer) {
    if (answer !== this.answer) this.likely = null;
    this.answer = answer;
    const typing = document.activeElement;
    const doubts = this.unexplained();
    const rows = doubts.length ? [] : (answer?.remedies.map((one) => this.#row(one)) ?? []);
    this.hint.hidden = rows.length > 0;
    this.hint.dataset.t = answer ? 'nothing_grows' : 'remedies_come';
    const heads = ['remedy', 'growth_changes', 'doubles_in', 'ground_after', 'remedy_cost', ...(this.likely ? ['likely_helps', 'likely_best'] : []), ''];
    if (rows.length) fillTable(this.table, heads.map((word) => word && t(word)), rows);
    else this.table.replaceChildren();
    // A field that has moved with its row is still the one that is written in.
    if (this.table.contains(typing)) typing.focus();
    const left = answer?.left_out.map(({ title, reason }) => `${sentence(`${t('left_out')}: ${inWords(title)}`)} ${sentence(inWords(reason))}`) ?? [];
    this.rest.hidden = doubts.length > 0;
    this.rest.replaceChildren(...[...(answer?.notes.map((note) => sentence(inWords(note))) ?? []), ...left].map((textContent) => element('li', { textContent })));
    translate(this.panel);
    if (doubts.length) this.hint.textContent = inSentences(doubts);
    for (const [id, field] of this.fields) field.show(this.costs[id] ?? null);
  }

  /** The costs of a project in the place of those that are written. */
  take(costs) {
    this.costs = costs;
    remember(KEPT, costs);
    this.onCosts();
  }

  /** Ask how likely each helps, where a calibration of the case can tell. */
  async askLikelihood() {
    const { answer } = this;
    try {
      const likely = answer && (await this.likelihood(answer.remedies));
      if (answer !== this.answer || likely === this.likely) return;
      this.likely = likely;
      this.show(answer);
    } catch (fault) {
      this.onFault(fault);
    }
  }

  /** The field of what a remedy costs, which stays as long as the page. */
  #cost({ id, name }) {
    if (!this.fields.has(id)) {
      const accept = (value) => {
        if (value === undefined) delete this.costs[id];
        else this.costs[id] = value;
        remember(KEPT, this.costs);
        this.onCosts();
        return '';
      };
      this.fields.set(id, new NumberField({ id: `cost-of-${id}`, word: 'remedy_cost', units: UNITS.money, low: LEAST, high: MOST, accept, onTrouble: () => {} }));
    }
    const { input, fault, echo } = this.fields.get(id);
    input.setAttribute('aria-label', `${inWords(name)}: ${t('remedy_cost')}`);
    return [input, fault, echo];
  }

  #row(remedy) {
    const change = 100 * remedy.change_of_fastest_growth;
    const bar = element('i', { className: change < 0 ? 'less' : 'more' });
    bar.style.width = `${Math.min(Math.abs(change), 100) / 2}%`;
    const changes = remedy.changes.map(({ key, value }) => this.#inUnit(key, value));
    const name = element('th', { scope: 'row' }, inWords(remedy.name), element('small', { textContent: changes.map(({ text }) => text).join(', ') }));
    const ofTraffic = remedy.changes[0].key.startsWith('speed.');
    const keep = worded('button', ofTraffic ? 'set_traffic' : 'keep_remedy', { type: 'button', className: 'plain small' });
    keep.addEventListener('click', () => {
      if (ofTraffic) return this.onTraffic();
      const keys = structuredClone(this.state.keys);
      for (const { key, given } of changes) set(keys, key, given);
      return this.onKeep(inWords(remedy.name), keys);
    });
    const signed = `${change > 0 ? '+' : ''}${number(Math.round(change))} %`;
    const { months_gained: gained, months_per_cost: worth } = remedy;
    const ground = element('td', { textContent: remedy.ground_after ? inWords(remedy.ground_after) : '–' }, ...(gained === null ? [] : [element('small', { textContent: t('months_gained', { months: `${gained > 0 ? '+' : ''}${number(gained, 2)}`, worth: worth && number(1000 * worth, 2) }) })]));
    const likely = this.likely ? ['helps', 'best'].map((what) => `${number(100 * (this.likely.get(remedy.id)?.[what] ?? NaN), 2)} %`) : [];
    return row(name, [element('td', { className: 'effect' }, bar, element('span', { textContent: signed })), inWords(remedy.doubles_in), ground, element('td', {}, ...this.#cost(remedy)), ...likely, keep]);
  }

  /** A key with its value [SI] as the form has it. */
  #inUnit(key, value) {
    const [unit, size] = shownUnit(key, this.unitOf(key));
    const ofSpeeds = { 'speed.standard_deviation': () => `± ${speed(value)}`, 'speed.standard_deviation_factor': () => `± × ${number(value)}`, 'speed.factor': () => `× ${number(value)}` };
    const shown = ofSpeeds[key]?.() ?? `${labelOf(key)} ${number(value / size)} ${unit}`.trim();
    return { key, text: shown, given: inUnit(key, value, this.unitOf(key)) };
  }
}
