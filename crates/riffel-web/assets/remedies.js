// What helps: remedies ranked by what they do to growth under the traffic, each to be kept as a variant.

import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { inUnit, set, shownUnit } from './keys.js';
import { labelOf, number, sentence, t, told, translate } from './words.js';

export class Remedies {
  /** `onKeep` takes the name and the keys of a variant, `onTraffic` leads to the speeds of the traffic. */
  constructor({ state, unitOf, save, onKeep, onTraffic }) {
    Object.assign(this, { state, unitOf, onKeep, onTraffic, answer: null });
    this.table = element('table', { className: 'comparison', id: 'remedies' });
    this.rest = element('ul', { className: 'fine' });
    const header = element('header', {}, worded('h2', 'what_helps'), worded('span', 'each_alone', { className: 'aside' }));
    offer(header, () => ({ name: 'remedies', table: this.table }), save, ['csv']);
    this.panel = element('article', { className: 'panel remedies-panel of-remedies', id: 'remedies-panel' }, header, (this.hint = worded('p', 'remedies_come', { className: 'why' })), element('div', { className: 'sideways' }, this.table), this.rest);
  }

  /** Show an answer; null is that nothing is known yet. */
  show(answer) {
    this.answer = answer;
    const rows = answer?.remedies.map((one) => this.#row(one)) ?? [];
    this.hint.hidden = rows.length > 0;
    this.hint.dataset.t = answer ? 'nothing_grows' : 'remedies_come';
    const head = element('thead', {}, element('tr', {}, ...['remedy', 'growth_changes', 'doubles_in', ''].map((word) => (word ? worded('th', word, { scope: 'col' }) : element('td')))));
    this.table.replaceChildren(...(rows.length ? [head, element('tbody', {}, ...rows)] : []));
    const left = answer?.left_out.map(({ title, reason }) => `${sentence(`${t('left_out')}: ${told(title)}`)} ${sentence(told(reason))}`) ?? [];
    this.rest.replaceChildren(...[...(answer?.notes.map((note) => sentence(told(note))) ?? []), ...left].map((textContent) => element('li', { textContent })));
    translate(this.panel);
  }

  #row(remedy) {
    const change = 100 * remedy.change_of_fastest_growth;
    const bar = element('i', { className: change < 0 ? 'less' : 'more' });
    bar.style.width = `${Math.min(Math.abs(change), 100) / 2}%`;
    const changes = remedy.changes.map(({ key, value }) => this.#inUnit(key, value));
    const name = element('th', { scope: 'row' }, told(remedy.name), element('small', { textContent: changes.map(({ text }) => text).join(', ') }));
    const ofTraffic = remedy.changes[0].key.startsWith('speed.');
    const keep = worded('button', ofTraffic ? 'set_traffic' : 'keep_remedy', { type: 'button', className: 'plain small' });
    keep.addEventListener('click', () => {
      if (ofTraffic) return this.onTraffic();
      const keys = structuredClone(this.state.keys);
      for (const { key, given } of changes) set(keys, key, given);
      return this.onKeep(told(remedy.name), keys);
    });
    const signed = `${change > 0 ? '+' : ''}${number(Math.round(change))} %`;
    return element('tr', {}, name, element('td', { className: 'effect' }, bar, element('span', { textContent: signed })), element('td', { textContent: told(remedy.doubles_in) }), element('td', {}, keep));
  }

  /** A key with its value [SI] as the form has it. */
  #inUnit(key, value) {
    const [unit, size] = shownUnit(key, this.unitOf(key));
    const shown = key === 'speed.standard_deviation' ? `± ${number(3.6 * value)} km/h` : `${key === 'speed.factor' ? '×' : labelOf(key)} ${number(value / size)} ${unit}`.trim();
    return { key, text: shown, given: inUnit(key, value, this.unitOf(key)) };
  }
}
