// On top of the keys: a search, and those whose value is not that of a preset or default or of the case as it was opened, each with a way back.

import { Calm } from './calm.js';
import { element, lead, worded } from './elements.js';
import { get, si, split } from './keys.js';
import { Line, json } from './server.js';
import { labelOf, number, t, translate, written } from './words.js';

/** What presets and defaults would give is asked for when nothing has changed for so long [ms]. */
const CALM = 200;

export class Sidebar {
  constructor(place, { form, state }) {
    Object.assign(this, { form, state, opened: {}, without: {}, line: new Line('/api/own-values', json), calm: new Calm(CALM, () => this.#compare()) });
    this.search = element('input', { type: 'search', id: 'search-keys', autocomplete: 'off', spellcheck: false });
    this.search.addEventListener('input', () => this.#find());
    this.none = worded('p', 'no_key_found', { className: 'fine', hidden: true });
    this.count = element('small', { className: 'aside' });
    this.rows = element('div', { className: 'rows' });
    this.group = element('details', { className: 'group', id: 'changed', open: true, hidden: true }, element('summary', {}, worded('span', 'own_values'), this.count), this.rows);
    place.prepend(element('label', { className: 'search', htmlFor: 'search-keys' }, worded('span', 'search_key'), this.search), this.none, this.group);
  }

  /** Another case is open, to which one may go back. */
  begin(keys) {
    this.opened = structuredClone(keys);
    this.without = {};
  }

  /** The case at hand has been accepted. */
  show() {
    this.#list();
    this.calm.begin();
  }

  #compare() {
    this.line.ask({ case: { keys: this.state.accepted } }, (without) => {
      this.without = without;
      this.#list();
      const { form } = this;
      form.tick(Object.fromEntries([...form.sliders.keys()].map((key) => [key, this.#reference(key)])));
    });
  }

  /** The number [SI] that a slider would stand at by itself. */
  #reference(key) {
    const { accepted, head } = this.state;
    if (key in this.without) return Number.parseFloat(this.without[key]);
    const before = get(this.opened, key);
    if (before === undefined || get(accepted, key) === before) return si(head.complete, key);
    const { number: value, unit } = split(before, '') ?? {};
    const [name, size] = this.form.fields.get(key).shown;
    return unit === '' ? value : unit === name ? value * size : undefined;
  }

  #list() {
    const { keys } = this.state;
    const changed = [...this.form.fields.keys()].filter((key) => key in this.without || JSON.stringify(get(keys, key)) !== JSON.stringify(get(this.opened, key)));
    // A key goes where it is the same again, while the program is still asked.
    const own = changed.filter((key) => get(keys, key) !== undefined || get(this.opened, key) !== undefined);
    this.group.hidden = !own.length;
    this.count.textContent = number(own.length);
    this.rows.replaceChildren(...own.map((key) => this.#row(key)));
  }

  #row(key) {
    const { form, state, without, opened } = this;
    const shown = (value) => (value === undefined ? t('not_given') : typeof value === 'object' ? '…' : this.#inUnit(key, value));
    const back = key in without ? undefined : get(opened, key);
    const name = element('a', { href: `#${form.fields.get(key).input.id}`, textContent: labelOf(key) });
    name.addEventListener('click', (event) => (event.preventDefault(), lead(form.fields.get(key).input)));
    const button = element('button', { type: 'button', className: 'plain small', textContent: `↶ ${shown(key in without ? without[key] : back)}` });
    button.setAttribute('aria-label', `${t('back_to')} ${button.textContent.slice(2)}: ${labelOf(key)}`);
    button.addEventListener('click', () => form.change(key, back));
    return element('div', { className: 'row own' }, name, element('span', { className: 'figure', textContent: shown(get(state.keys, key)) }), button);
  }

  /** A value of the case, or of the program in SI, in the unit of the form where it is a number in SI. */
  #inUnit(key, value) {
    const { node, shown: [unit, size] } = this.form.fields.get(key);
    const parts = node.unit === undefined ? null : split(value, node.unit);
    if (!parts) return written(value);
    return parts.unit === split(0, node.unit).unit ? `${number(parts.number / size)} ${unit}`.trim() : `${written(parts.text)} ${parts.unit}`;
  }

  /** Only the keys whose name, dotted key or description has what is sought. */
  #find() {
    const sought = this.search.value.trim().toLowerCase();
    let found = 0;
    for (const { key, input } of this.form.fields.values()) {
      const row = input.closest('.row');
      const is = !sought || `${labelOf(key)} ${key} ${row.querySelector('label').title}`.toLowerCase().includes(sought);
      row.classList.toggle('not-sought', !is);
      found += is;
    }
    for (const group of this.form.place.querySelectorAll('.group:not(#changed), .subgroup')) {
      const has = Boolean(group.querySelector('.row:not(.not-sought)'));
      group.classList.toggle('not-sought', !has);
      if (group.tagName === 'DETAILS') group.open = Boolean(sought) && has;
    }
    this.form.place.classList.toggle('sought', Boolean(sought));
    this.none.hidden = found > 0;
  }

  reword() {
    translate(this.form.place);
    this.#list();
  }
}
