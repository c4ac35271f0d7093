// The decision over a calibration: what grinding and remedies cost, which pays, and what it is worth to measure once more.

import { element, fillTable, row, svgElement, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords } from './messages.js';
import { set } from './keys.js';
import { readNumber } from './numbers.js';
import { nameOfValue } from './priors.js';
import { remember, remembered } from './remembered.js';
import { Fault, askOnce, json } from './server.js';
import { number, range, sentence, t, translate, written } from './words.js';

const [WIDTH, HEIGHT] = [240, 18];
/** Under which costs stay over a reload. */
const KEPT = 'riffel-decision-costs';
/** Costs of a plan: name, its unit behind a currency, what stands there before. */
const COSTS = [['grinding', '', ''], ['possession', '', ''], ['over_limit', '', ''], ['from_limit', 'dB', '-6'], ['discount_rate', '%', '3'], ['horizon', 'a', '20']];
/** What an action may cost. */
const OF_ACTION = [['investment', ''], ['life', 'a'], ['upkeep', '']];

/** What a field holds as a plan has it, in a unit; undefined where nothing is written. */
function amount({ value }, unit) {
  const read = readNumber(value);
  return value.trim() ? `${read && !read.choices ? read.number : value.trim()} ${unit}` : undefined;
}

/** Changes as a file of changes has them. */
function inTables(changes) {
  const keys = {};
  for (const { key, value } of changes) set(keys, key, value);
  return keys;
}

export class Decision {
  /** `spoken` puts a sentence of the program into words of the page. */
  constructor({ state, traffic, complain, save, spoken }) {
    Object.assign(this, { state, traffic, complain, spoken, answer: null, remedies: [], measurements: [], taken: {} });
    this.currency = element('input', { type: 'text', value: 'EUR', size: 4, maxLength: 8, id: 'currency' });
    this.currency.addEventListener('change', () => this.#rows());
    this.costs = new Map(COSTS.map(([name, , value]) => [name, this.#field(name, value, `cost_${name}`)]));
    this.every = this.#field('every', '', 'grind_every');
    this.actions = element('table', { className: 'comparison', id: 'actions' });
    this.rank = worded('button', 'rank_now', { type: 'button', className: 'plain', id: 'rank' });
    this.rank.addEventListener('click', () => this.#ask());
    const setting = (input, word, unit) => element('label', { className: 'setting' }, worded('span', word, { className: 'unit' }), input, unit);
    const settings = [setting(this.currency, 'currency', ''), ...COSTS.map(([name, unit]) => setting(this.costs.get(name), `cost_${name}`, unit)), setting(this.every, 'grind_every', worded('span', 'months_word'))];
    this.asked = element('article', { className: 'panel wide', id: 'decision-asked', hidden: true }, element('header', {}, worded('h2', 'what_to_do'), worded('span', 'what_to_do_help', { className: 'aside' })),
      element('div', { className: 'settings' }, ...settings), element('div', { className: 'sideways' }, this.actions), element('div', { className: 'settings' }, this.rank));
    this.take(remembered(KEPT) ?? {});
    this.asked.addEventListener('change', () => remember(KEPT, this.costsGiven));
    this.verdict = element('ul', { className: 'sentences', id: 'decision-words' });
    this.ranking = element('table', { className: 'comparison', id: 'ranking' });
    this.worth = element('ul', { className: 'sentences', id: 'worth' });
    const head = element('header', {}, worded('h2', 'ranked'), worded('span', 'ranked_help', { className: 'aside' }));
    offer(head, () => this.answer && { name: 'decision', table: this.ranking }, save, ['csv']);
    this.told = element('article', { className: 'panel wide', id: 'decision', hidden: true }, head, this.verdict, element('div', { className: 'sideways' }, this.ranking), this.worth);
    const keep = worded('button', 'save_decision', { type: 'button', className: 'plain', id: 'save-decision' });
    keep.addEventListener('click', () => [['plan.toml', this.answer.plan], ...this.answer.files].forEach(([name, text]) => save(new Blob([text], { type: 'application/toml' }), name)));
    this.told.append(element('div', { className: 'settings' }, keep));
    this.panels = [this.asked, this.told];
  }

  #field(name, value, word) {
    const input = element('input', { type: 'text', inputMode: 'decimal', id: `cost-${name}`, className: 'figure', size: 6, autocomplete: 'off', value: written(value) });
    input.dataset.tLabel = word;
    return input;
  }

  /** Chains were drawn: with levels of dates they say what remedies do. `example` has costs to begin with. */
  async offer({ data, is_conclusive: isConclusive, parameters }, plan, example) {
    this.answer = null;
    this.told.hidden = true;
    this.asked.hidden = !isConclusive || !data.some(({ measured }) => measured === 'level_rise_db');
    if (this.asked.hidden) return;
    // Nothing is ranked before there are remedies with their costs.
    this.rank.disabled = true;
    try {
      const { remedies } = await json(await askOnce('/api/remedies', { case: { keys: this.state.accepted }, traffic: this.traffic.givenFile }));
      this.remedies = remedies.map(({ id, name, changes }) => ({ id, name, changes }));
    } catch (fault) {
      if (!(fault instanceof Fault)) throw fault;
      this.complain(fault, { what: `${t('what_to_do')}: ` });
    }
    this.names = parameters.map(({ name }) => name);
    this.measurements = plan.data;
    if (example) this.costs.get('grinding').value = example.grinding;
    this.given = Object.fromEntries((example?.upkeep ?? []).map(([key, upkeep]) => [key, upkeep]));
    this.price = example?.price ?? '';
    this.#rows();
    this.rank.disabled = false;
  }

  /** What was written into the fields, by their ids. */
  get costsGiven() {
    return { ...this.taken, ...Object.fromEntries([...this.asked.querySelectorAll('input')].map(({ id, value }) => [id, value])) };
  }

  /** Costs of a project, for the fields that there are and those that come with remedies. */
  take(costs) {
    this.taken = costs;
    remember(KEPT, costs);
    for (const input of this.asked.querySelectorAll('input')) input.value = costs[input.id] ?? input.value;
  }

  /** A row for each remedy and for each kind of data that may be measured once more. */
  #rows() {
    const { value: currency } = this.currency;
    const { costsGiven: given } = this;
    const cell = (id, word, unit, label, value = '') => {
      const input = element('input', { type: 'text', inputMode: 'decimal', id, className: 'figure', size: 7, autocomplete: 'off', value: given[id] ?? value, ariaLabel: `${label}: ${t(word)}` });
      return element('td', {}, element('label', { className: 'choice' }, input, element('span', { className: 'unit', textContent: unit || currency })));
    };
    const head = (first, ...words) => element('tr', {}, ...[first, ...words].map((word) => worded('th', word, { scope: 'col' })));
    const rows = this.remedies.map(({ id, name, changes }) => row(inWords(name), OF_ACTION.map(([key, unit]) => cell(`action-${id}-${key}`, `action_${key}`, unit, inWords(name), key === 'upkeep' ? this.given[changes[0].key] : ''))));
    const more = this.measurements.map(({ name, kind }, k) => row(`${t(kind)} (${name})`, [cell(`price-${k}`, 'price', '', name, kind === 'dated-levels' ? this.price : '')]));
    this.actions.replaceChildren(element('tbody', {}, head('remedy', ...OF_ACTION.map(([key]) => `action_${key}`)), ...rows, head('measure_once_more', 'price'), ...more));
    translate(this.asked);
  }

  /** The tables of a plan: what has a cost is an action. */
  get question() {
    const currency = this.currency.value.trim();
    const of = (id, unit) => amount(document.getElementById(id), unit || currency);
    const cost = Object.fromEntries(COSTS.map(([name, unit]) => [name, amount(this.costs.get(name), unit || currency)]).filter(([, value]) => value));
    const action = this.remedies.map(({ id, name, changes }) => {
      const written = Object.fromEntries(OF_ACTION.map(([key, unit]) => [key, of(`action-${id}-${key}`, unit)]).filter(([, value]) => value));
      return Object.keys(written).length ? { name, title: inWords(name), changes: inTables(changes), ...written } : null;
    }).filter(Boolean);
    const every = amount(this.every, 'months');
    if (every) action.push({ title: t('every_months', this.every.value.trim()), grind_every: every });
    const measurement = this.measurements.map(({ name, kind }, k) => ({ title: name, kind, name, price: of(`price-${k}`) })).filter(({ price }) => price);
    return { cost, action, measurement };
  }

  /** Whether there are chains that tell what remedies do. */
  get isOffered() {
    return !this.asked.hidden;
  }

  /** How likely each of some remedies lengthens the grinding interval, and makes it the longest, by its id: where only grinding costs, that is the cheapest. */
  async likelihood(remedies) {
    const action = remedies.map(({ id, changes }) => ({ title: id, changes: inTables(changes) }));
    const { actions } = await json(await askOnce('/api/calibration/decision', { cost: { grinding: '1 EUR' }, action }));
    return new Map(actions.map(({ title, probability_longer: helps, probability_cheapest: best }) => [title, { helps, best }]));
  }

  /** The name of what would be measured once more. */
  #measured(title) {
    const { kind } = this.measurements.find(({ name }) => name === title);
    return `${t(kind)} (${title})`;
  }

  async #ask() {
    this.rank.disabled = true;
    const { question } = this;
    this.titles = question.action.map(({ name, grind_every: every }) => () => (every ? t('every_months', every.split(' ')[0]) : inWords(name)));
    const action = question.action.map(({ name: _, ...one }) => one);
    try {
      this.#show(await json(await askOnce('/api/calibration/decision', { ...question, action })));
    } catch (fault) {
      this.complain(fault, { what: `${t('rank_now')}: ` });
    } finally {
      this.rank.disabled = false;
    }
  }

  #show(answer) {
    this.answer = answer;
    this.told.hidden = false;
    const { actions, currency, sentences, remarks, measurements, evppi_per_year: values } = answer;
    const item = (english) => {
      const { textContent, lang } = this.spoken(english);
      return element('li', { textContent: sentence(textContent), lang });
    };
    this.verdict.replaceChildren(...[...sentences, ...remarks].map(item));
    const ends = [Math.min(...actions.map(({ cost_per_year: cost }) => cost[0])), Math.max(...actions.map(({ cost_per_year: cost, mean_cost_per_year: mean }) => Math.max(cost[4], mean)))];
    const percent = (share) => `${number(100 * share, 2)} %`;
    const rowOf = (action) => row(action === actions[0] ? t('as_it_is') : this.titles[actions.indexOf(action) - 1](), [band(action, ends),
      number(action.mean_cost_per_year), range([action.cost_per_year[0], action.cost_per_year[4]]), percent(action.probability_cheapest), action === actions[0] ? '' : percent(action.probability_longer)]);
    const heads = [['ranked_action'], ['ranked_picture'], ['ranked_mean', currency], ['ranked_band', currency], ['ranked_cheapest'], ['ranked_helps']];
    fillTable(this.ranking, heads.map(([word, value]) => t(word, value)), [...actions].sort((a, b) => a.rank - b.rank).map(rowOf));
    const worth = (name, one) => element('li', { textContent: t(one.price == null ? 'worth_known' : 'worth_measured', { name, worth: number(one.per_year), price: number(one.price ?? 0), net: number(one.net ?? 0), currency }) });
    const known = values.filter(({ per_year: worth }) => worth >= 0.5).slice(0, 3);
    this.worth.replaceChildren(...measurements.map((one) => worth(this.#measured(one.title), one)), ...known.map((one) => worth(nameOfValue(one.title), one)));
  }

  reword() {
    if (!this.asked.hidden) this.#rows();
    if (this.answer) this.#show(this.answer);
  }
}

/** Costs of a year: 90 % of the draws as a line, half of them as a bar, the mean as a mark. */
function band({ cost_per_year: [low, quarter, , half, high], mean_cost_per_year: mean }, [from, to]) {
  const x = (value) => 4 + ((WIDTH - 8) * (value - from)) / (to - from || 1);
  const rect = (name, a, b, height) => svgElement('rect', { class: name, x: x(a), y: (HEIGHT - height) / 2, width: Math.max(x(b) - x(a), 1), height });
  return svgElement('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'cost', 'aria-hidden': true }, rect('most', low, high, 2), rect('half', quarter, half, 8), rect('mean', mean, mean, HEIGHT));
}
