// The form of a case, made from its JSON schema: a section for each table, a row for each key.

import { element, put } from './elements.js';
import { wording } from './faults.js';
import { get, set, short, shownUnit, si, split } from './keys.js';
import * as lists from './lists.js';
import { FAR } from './number-field.js';
import { askWhich, readNumber } from './numbers.js';
import { inWords, said } from './messages.js';
import { labelOf, nameOf, number, t, written as worded } from './words.js';

/** A file cannot come over the page. */
const NOT_HERE = ['track.measurement', 'wheelset.file'];
/** Choices that need one. */
const OF_FILES = ['measured', 'modal'];
/** Keys of the wheel that a wheelset replaces. */
const OF_A_WHEEL = ['wheel.mass', 'wheel.inertia', 'wheel.rotation'];

/** Ranges of the sliders in SI, and whether they are logarithmic. */
const SLIDERS = {
  'contact.friction': [0.05, 0.7, 0.005], 'contact.tractive_ratio': [0.02, 0.98, 0.005],
  'contact.normal_load': [10e3, 150e3, 500], 'wheel.inertia': [2, 300, 'log'], 'track.pad.stiffness': [10e6, 3e9, 'log'],
};
const LOG_STEPS = 400;
/** Where a reload finds whether all keys are shown. */
const ALL_KEYS = 'riffel-all-keys';
/** Two keys of which a case gives one. */
const ONE_OF = [['contact.tractive_ratio', 'contact.creepage'], ['wear.coefficient', 'wear.measured']];
/** A model needs supports: the preset that stands in until others are chosen. */
const FIRST_PRESET = { 'one-layer': 'slab-direct', 'one-layer-periodic': 'slab-direct', 'two-layer': 'br-stiff', 'two-layer-periodic': 'br-stiff' };

const idOf = (key) => `key-${key.replaceAll('.', '-')}`;

/** What a schema says of a key, references and null left aside. */
function resolve(schema, node) {
  if (node.$ref) {
    const { $ref, ...rest } = node;
    return resolve(schema, { ...schema.$defs[$ref.split('/').at(-1)], ...rest });
  }
  const choice = node.anyOf?.find((choice) => choice.type !== 'null');
  if (choice) {
    const { anyOf: _, ...rest } = node;
    return { ...resolve(schema, choice), ...rest };
  }
  return node;
}

/** The table that may stand in the place of a number; undefined where there is none. */
function tableOf(schema, node) {
  const tables = (node.anyOf ?? []).map((choice) => tableOf(schema, choice));
  return tables.find(Boolean) ?? (node.$ref && schema.$defs[node.$ref.split('/').at(-1)].properties ? resolve(schema, node) : undefined);
}

/** What a field shows of a value: not the table in its place. */
const bare = (value) => (value === null || Array.isArray(value) || typeof value !== 'object' ? value : undefined);

/** What a key is, in the language of the page: shown beside the pointer, and in a menu before the name of a choice. */
function hint(place, lines = place.hint) {
  Object.assign(place, { hint: lines, title: lines.map((line) => inWords(line).replaceAll('\n', ' ')).filter(Boolean).join('\n') });
  place.dataset.hint = '';
  if (place.tagName !== 'OPTION') return;
  const [first] = place.title.split(/[.:;](?= |$)/);
  place.textContent = first ? `${first} · ${place.value}` : place.value;
}

/** Words of the program as an element, in the language they are in: a citation stays as it is. */
function spoken(name, words) {
  const { text, language } = said(words);
  return element(name, { textContent: text, lang: language });
}

export class Form {
  /** `onChange` is told the gesture that goes on, `onAsk` that a field asks what was meant, or no longer does. */
  constructor({ place, handles, vocabulary, onChange, onAsk }) {
    Object.assign(this, { place, handles, onChange, onAsk, schema: vocabulary.schema, presets: vocabulary.presets, fields: new Map(), sliders: new Map() });
    this.#build();
  }

  // Making it ----------------------------------------------------------------------------------------

  #build() {
    const general = this.#section('general');
    this.place.append(general);
    for (const [key, node] of Object.entries(this.schema.properties)) {
      if (NOT_HERE.includes(key)) continue;
      const resolved = resolve(this.schema, node);
      if (resolved.properties) {
        const section = this.#section(key);
        this.#rows(section.lastChild, key, resolved);
        this.place.append(section);
      } else {
        general.lastChild.append(this.#row(key, resolved));
      }
    }
    for (const key of Object.keys(SLIDERS)) this.#slider(key);
    this.all = element('button', { type: 'button', className: 'plain small', id: 'all-keys', ariaPressed: 'false', hidden: true });
    const show = (is) => {
      this.place.classList.toggle('all-keys', is);
      this.all.setAttribute('aria-pressed', String(is));
      this.#tellIdle();
    };
    this.all.addEventListener('click', () => {
      const is = !this.place.classList.contains('all-keys');
      show(is);
      localStorage.setItem(ALL_KEYS, is);
    });
    show(localStorage.getItem(ALL_KEYS) === 'true');
    this.place.append(this.all);
  }

  #section(key) {
    const heading = element('summary', {}, element('span', {}));
    heading.firstChild.dataset.name = key;
    return element('details', { className: 'group' }, heading, element('div', { className: 'rows' }));
  }

  #rows(place, parent, node) {
    for (const [name, child] of Object.entries(node.properties)) {
      const key = `${parent}.${name}`;
      if (NOT_HERE.includes(key)) continue;
      const resolved = resolve(this.schema, child);
      const table = resolved.properties ? resolved : tableOf(this.schema, child);
      if (!resolved.properties) place.append(this.#row(key, resolved));
      if (!table) continue;
      const heading = element('h4', {});
      heading.dataset.name = resolved.properties ? key : `${key}/table`;
      const group = element('div', { className: 'subgroup', role: 'group' }, heading);
      heading.id = `${idOf(key)}-heading`;
      group.setAttribute('aria-labelledby', heading.id);
      this.#rows(group, key, table);
      place.append(group);
    }
  }

  #row(key, node) {
    const id = idOf(key);
    const label = element('label', { htmlFor: id });
    hint(label, [node.description, key]);
    label.dataset.name = key;
    const unit = element('span', { className: 'unit', id: `${id}-unit` });
    const fault = element('p', { className: 'fault', lang: 'en', id: `${id}-fault`, hidden: true });
    const echo = element('p', { className: 'echo', id: `${id}-echo`, hidden: true });
    const presets = this.presets.filter((preset) => preset.key === key);
    const choices = node.oneOf?.map((choice) => [choice.const, choice.description]) ?? node.enum?.map((name) => [name, '']);
    let input;
    if (presets.length) input = this.#menu(presets.map((preset) => [preset.name, preset.title]), true);
    else if (choices) {
      // A table that a case may do without is left out with its last key.
      const optional = !this.schema.required.includes(key.split('.')[0]);
      input = this.#menu(choices.filter(([name]) => !OF_FILES.includes(name)), optional || (node.default === undefined && key !== 'track.model'));
    } else if (node.type?.includes?.('array')) {
      input = element('textarea', { rows: node.items.$ref ? 3 : 1, spellcheck: false });
    } else {
      input = element('input', { type: 'text', autocomplete: 'off', spellcheck: false });
      if (node.unit !== undefined || node.type?.includes?.('integer')) {
        input.inputMode = 'decimal';
        input.className = 'figure';
      }
    }
    input.id = id;
    input.setAttribute('aria-describedby', `${unit.id} ${fault.id} ${echo.id}`);
    // `typed` is what stands in the field by hand, with the value that it was read as; `asks` what waits for an answer;
    // while it is `writing`, no answer may replace its text.
    const field = { key, node, input, unit, fault, echo, presets, shown: shownUnit(key, node.unit), typed: null, asks: null, writing: false };
    unit.textContent = presets.length ? '' : field.shown[0];
    input.addEventListener('input', () => (field.writing = true));
    input.addEventListener('blur', () => (field.writing = false));
    input.addEventListener('change', () => {
      field.writing = false;
      this.#read(field);
    });
    const row = element('div', { className: 'row' }, label, input, presets.length ? this.#sources(field) : unit, fault, echo);
    this.fields.set(key, field);
    return row;
  }

  #menu(choices, empty) {
    const menu = element('select', {});
    if (empty) menu.append(element('option', { value: '', textContent: '—' }));
    for (const [name, title] of choices) {
      const option = element('option', { value: name });
      hint(option, [title]);
      menu.append(option);
    }
    return menu;
  }

  /** A button that shows where the values of a preset come from, on hover, by touch and by key. */
  #sources(field) {
    const bubble = element('div', { className: 'bubble', popover: 'auto', id: `${field.input.id}-sources` });
    const button = element('button', { type: 'button', className: 'info', textContent: 'i' });
    button.dataset.tLabel = 'sources';
    button.setAttribute('aria-label', t('sources'));
    button.popoverTargetElement = bubble;
    const show = () => {
      const preset = field.presets.find((preset) => preset.name === field.input.value);
      bubble.replaceChildren(preset ? spoken('strong', preset.title) : element('strong', { textContent: t('none') }));
      for (const value of preset?.values ?? []) {
        bubble.append(element('p', {}, element('b', { textContent: `${nameOf(value.key)} = ${worded(value.value)}` }), ` ${t(value.badge)}. `, spoken('span', value.source)));
      }
    };
    // Inside the window, wherever its button is.
    const place = () => {
      const { left, bottom } = button.getBoundingClientRect();
      bubble.style.left = `${Math.max(8, Math.min(left, innerWidth - bubble.offsetWidth - 8))}px`;
      bubble.style.top = `${Math.max(8, Math.min(bottom + 6, innerHeight - bubble.offsetHeight - 8))}px`;
    };
    bubble.addEventListener('beforetoggle', show);
    bubble.addEventListener('toggle', place);
    let hovering;
    button.addEventListener('pointerenter', (event) => {
      if (event.pointerType === 'mouse') hovering = setTimeout(() => bubble.showPopover(), 150);
    });
    button.addEventListener('pointerleave', (event) => {
      clearTimeout(hovering);
      if (event.pointerType === 'mouse' && !bubble.matches(':hover')) bubble.hidePopover();
    });
    bubble.addEventListener('pointerleave', () => bubble.hidePopover());
    return element('span', { className: 'unit' }, button, bubble);
  }

  #slider(key) {
    const [low, high, step] = SLIDERS[key];
    const logarithmic = step === 'log';
    const range = logarithmic ? { min: 0, max: LOG_STEPS, step: 1 } : { min: low, max: high, step };
    const input = element('input', { type: 'range', id: `slide-${idOf(key)}`, ...range });
    const label = element('label', { htmlFor: input.id });
    label.dataset.name = key.endsWith('stiffness') ? `${key}/slider` : key;
    const output = element('output', { htmlFor: input.id });
    const note = element('small', { className: 'note' });
    const slider = {
      input, output, note,
      value: () => (logarithmic ? low * (high / low) ** (input.value / LOG_STEPS) : Number(input.value)),
      place: (value) => (logarithmic ? Math.round((LOG_STEPS * Math.log(value / low)) / Math.log(high / low)) : value),
    };
    input.addEventListener('input', () => {
      const [unit, factor] = this.fields.get(key).shown;
      const value = short(Number((slider.value() / factor).toPrecision(3)));
      this.#change(key, unit ? `${value} ${unit}` : Number(value), `slide ${key}`);
    });
    const ticks = element('datalist', { id: `ticks-${idOf(key)}` });
    input.setAttribute('list', ticks.id);
    this.handles.append(element('div', { className: 'handle' }, label, output, input, ticks, note));
    slider.ticks = ticks;
    this.sliders.set(key, slider);
  }

  // Showing a case -----------------------------------------------------------------------------------

  /** Show the keys that are written and, pale, what presets and defaults give for the others. */
  show(keys, complete, current = Boolean(complete)) {
    this.keys = keys;
    if (complete) this.complete = complete;
    // Whether what the program answered is that of these keys.
    this.current = current;
    for (const field of this.fields.values()) this.#showField(field);
    for (const [key, slider] of this.sliders) this.#showSlider(key, slider);
  }

  /** Fold the keys that the models of the case do not use: those named, and all in tables named. One that is written stays. */
  fold(idle) {
    const folded = [...this.fields.values()].map(({ key }) => get(this.keys, key) === undefined && idle.some((name) => key === name || key.startsWith(`${name}.`)));
    // With most steps of a slider nothing changes here.
    if (folded.join() === this.folded?.join()) return;
    this.folded = folded;
    this.idle = folded.filter(Boolean).length;
    [...this.fields.values()].forEach(({ input }, k) => input.closest('.row').classList.toggle('idle', folded[k]));
    for (const group of this.place.querySelectorAll('.subgroup, .group:not(#changed)')) {
      group.classList.toggle('idle', ![...group.querySelectorAll('.row')].some((row) => !row.classList.contains('idle')));
    }
    this.#tellIdle();
  }

  #tellIdle() {
    this.all.hidden = !this.idle;
    this.all.textContent = t(this.place.classList.contains('all-keys') ? 'fold_keys' : 'all_keys', this.idle);
  }

  /** A tick at each slider where its value would be without what was changed [SI]. */
  tick(values) {
    for (const [key, { ticks, place }] of this.sliders) ticks.replaceChildren(...(values[key] > 0 ? [element('option', { value: place(values[key]) })] : []));
  }

  /** Give a key a value, or none; as by hand. */
  change(key, value) {
    this.fields.get(key).typed = null;
    this.#change(key, value);
  }

  #showField(field) {
    const { key, node, input, echo, shown } = field;
    if (field.writing) return;
    const written = bare(get(this.keys, key));
    const whole = this.complete && bare(get(this.complete, key));
    if (input.tagName === 'TEXTAREA') {
      input.value = Array.isArray(written) ? lists.written(written) : (written ?? '');
      put(input, { placeholder: whole ? lists.written(whole) : '' });
      return;
    }
    if (input.tagName === 'SELECT') {
      const name = written ?? '';
      // A name that no menu holds stays visible: the error beside it speaks of it.
      if (name && ![...input.options].some((option) => option.value === name)) input.append(element('option', { value: name, textContent: name }));
      input.value = name || (input.options[0].value === '' ? '' : (whole ?? node.default ?? ''));
      if (input.options[0].value === '' && !this.presets.some((preset) => preset.key === key)) {
        put(input.options[0], { textContent: whole && !written ? `(${whole})` : '—' });
      }
      return;
    }
    if (field.asks) return;
    if (field.typed && field.typed.value !== written) field.typed = null;
    echo.hidden = true;
    if (node.unit === undefined) {
      if (document.activeElement !== input || written !== undefined) input.value = field.typed?.text ?? written ?? '';
      put(input, { placeholder: String(whole ?? '') });
      return;
    }
    const parts = written === undefined ? null : split(written, node.unit);
    const plain = parts?.unit === shown[0];
    // The unit beside the field is that of a bare number: another one stands with its number, in the field.
    input.value = field.typed?.text ?? worded(written === undefined ? '' : plain ? parts.text : parts && typeof written === 'number' ? `${parts.text} ${parts.unit}` : written);
    // What is missing has no default that could stand in.
    const inherited = whole === undefined || whole === null || !field.fault.hidden ? null : Number.parseFloat(whole) / shown[1];
    put(input, { placeholder: written === undefined && inherited !== null ? String(worded(short(inherited))) : '' });
    if (input.placeholder) put(input, { title: t('from_preset') });
    else input.removeAttribute('title');
    this.#echo(field, parts && !plain);
  }

  /** What the program read, where it was not written in the unit of the field or is far from what it was. */
  #echo({ key, typed, echo, shown: [unit, factor] }, foreign) {
    const value = this.current && si(this.complete, key);
    if (value === undefined || value === null || !Number.isFinite(value)) return;
    const inUnit = (value) => `${number(value / factor, 4)}${unit ? ` ${unit}` : ''}`;
    const times = Math.abs(value / typed?.before);
    const far = times >= FAR || times <= 1 / FAR;
    if (!foreign && !typed?.odd && !far) return;
    echo.textContent = far ? t('far_off', { now: inUnit(value), before: inUnit(typed.before) }) : t('read_as', inUnit(value));
    echo.classList.toggle('far', far);
    echo.hidden = false;
  }

  #showSlider(key, { input, output, note, place }) {
    const [unit, factor] = this.fields.get(key).shown;
    // What was written last goes before what the program last answered: it may be a step behind.
    const written = bare(get(this.keys, key));
    const parts = written === undefined ? null : split(written, '');
    const own = parts && (parts.unit === unit ? parts.number * factor : parts.unit === '' ? parts.number : undefined);
    const value = own ?? (this.complete && si(this.complete, key));
    const model = this.complete?.track?.model ?? '';
    const off =
      (key === 'track.pad.stiffness' && (model === 'free-beam' || !(this.complete && si(this.complete, key))) && t('no_pads')) ||
      (key === 'wheel.inertia' && this.complete && this.complete.wheel.rotation !== 'inertia' && t('no_turning')) || '';
    input.disabled = Boolean(off);
    put(note, { textContent: off });
    if (value === undefined || value === null) {
      output.textContent = '–';
      return;
    }
    if (document.activeElement !== input || Math.abs(place(value) - input.value) > Number(input.step)) input.value = place(value);
    output.textContent = `${number(value / factor, 3)}${unit ? ` ${unit}` : ''}`;
    input.setAttribute('aria-valuetext', output.textContent);
  }

  // Changing it --------------------------------------------------------------------------------------

  #read(field) {
    const { key, node, input, shown } = field;
    this.#answered(field);
    const text = input.value.trim();
    if (text === '') return this.#change(key, undefined);
    if (input.tagName === 'TEXTAREA') return this.#change(key, lists.read(text));
    const count = node.type?.includes?.('integer');
    if (input.tagName === 'SELECT' || (node.unit === undefined && !count)) return this.#change(key, text);
    const read = readNumber(text);
    if (read?.choices) return this.#ask(field, text, read);
    const value = this.#value(read, text, count, shown[0]);
    field.typed = { text: input.value, value, odd: read?.odd, before: this.complete && si(this.complete, key) };
    this.#change(key, value);
  }

  /** A value as the case file has it; what is no number goes to the program as it is, which says so. */
  #value(read, text, count, unit) {
    if (!read) return text;
    if (count) return read.rest ? text : Number(read.number);
    if (read.rest) return `${read.number} ${read.rest}`;
    return unit ? `${read.number} ${unit}` : Number(read.number);
  }

  /** Nothing changes before the field has its answer. */
  #ask(field, text, read) {
    const count = field.node.type?.includes?.('integer');
    askWhich(field.fault, text, read, field.shown[0], (number) => {
      this.#answered(field);
      const value = this.#value({ number, rest: read.rest }, number, count, field.shown[0]);
      field.typed = null;
      this.#change(field.key, value);
      field.input.focus();
    });
    field.asks = text;
    this.#wrong(field);
    this.onAsk();
  }

  #answered(field) {
    if (!field.asks) return;
    field.asks = null;
    this.#right(field);
    this.onAsk();
  }

  #change(key, value, gesture = null) {
    const field = this.fields.get(key);
    if (gesture) this.#answered(field);
    set(this.keys, key, value);
    const within = (table) => key === table || key.startsWith(`${table}.`);
    const other = ONE_OF.find((pair) => pair.some(within))?.find((other) => !within(other));
    if (other && value !== undefined) set(this.keys, other, undefined);
    if (within('wheelset') && value !== undefined) for (const replaced of OF_A_WHEEL) set(this.keys, replaced, undefined);
    // A preset is chosen for its values: they go before those that were written.
    const preset = this.presets.find((preset) => preset.key === key && preset.name === value);
    for (const { key: given } of preset?.values ?? []) set(this.keys, given.replace(/\[.*/, ''), undefined);
    if (key === 'track.preset') for (const part of ['pad', 'sleeper', 'ballast']) set(this.keys, `track.${part}`, undefined);
    const track = this.keys.track ?? {};
    if (key === 'track.model' && FIRST_PRESET[value] && !track.preset && !track.pad) set(this.keys, 'track.preset', FIRST_PRESET[value]);
    this.onChange(gesture);
  }

  // Errors -------------------------------------------------------------------------------------------

  /** The field of a key, or one of the table that the key is or stands in. */
  #fieldOf(fault) {
    let key = (fault.key ?? '').replace(/\[.*/, '');
    while (key && !this.fields.has(key)) {
      const inside = [...this.fields.keys()].find((other) => other.startsWith(`${key}.`));
      key = inside ?? (key.includes('.') ? key.slice(0, key.lastIndexOf('.')) : '');
    }
    return this.fields.get(key);
  }

  /** Show faults at their fields; those that have none come back. */
  refuse(faults) {
    this.clear();
    return faults.filter((fault) => {
      const field = this.#fieldOf(fault);
      if (!field) return true;
      field.refused = fault;
      this.#tell(field);
      this.#wrong(field);
      return false;
    });
  }

  #tell(field) {
    const { text, language } = wording(field.refused, this);
    Object.assign(field.fault, { textContent: text, lang: language });
  }

  #wrong({ input, fault }) {
    fault.hidden = false;
    input.placeholder = '';
    input.setAttribute('aria-invalid', 'true');
    input.closest('.row').classList.add('wrong');
  }

  #right({ input, fault }) {
    fault.hidden = true;
    input.removeAttribute('aria-invalid');
    input.closest('.row').classList.remove('wrong');
  }

  /** The fields that are not accepted or ask, as the page lists them. */
  get troubles() {
    return [...this.fields.values()].filter(({ fault }) => !fault.hidden).map((field) => ({ label: labelOf(field.key), input: field.input }));
  }

  clear() {
    for (const field of this.fields.values()) if (!field.fault.hidden && !field.asks) this.#right(field);
  }

  /** Another case is open: what was typed into this one is over. */
  forget() {
    for (const field of this.fields.values()) {
      field.typed = null;
      field.writing = false;
      if (field.asks) this.#answered(field);
    }
  }

  /** Another unit of speeds: that of a bare number changes with it, and a value keeps the one it was written in. */
  reunit() {
    for (const field of this.fields.values()) {
      if (field.node.unit !== 'm/s') continue;
      field.shown = shownUnit(field.key, field.node.unit);
      field.unit.textContent = field.shown[0];
      // Another question than the one that was asked.
      this.#answered(field);
    }
  }

  /** Words of another language: what was typed is shown as the program has it. */
  reword() {
    this.#tellIdle();
    for (const field of this.fields.values()) {
      if (field.fault.hidden) field.typed = null;
      else if (!field.asks) this.#tell(field);
      for (const one of field.input.closest('.row').querySelectorAll('[data-hint]')) hint(one);
    }
  }
}
