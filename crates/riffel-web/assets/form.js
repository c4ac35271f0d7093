// The form of a case, made from its JSON schema: a section for each table, a row for each key.

import { get, set, short, shownUnit, si, split } from './keys.js';
import { nameOf, number, t, written as worded } from './words.js';

/** A file cannot come over the page, and the page has one wheel that creeps along one rail. */
const NOT_HERE = [
  'track.measurement', 'wheelset', 'train', 'opposite_contact', 'contact.contact_angle', 'contact.lateral_offset', 'rail.torsion_constant',
  'rail.polar_second_moment', 'rail.warping_constant', 'rail.head_height', 'rail.foot_depth', 'rail.foot_width',
];

/** Ranges of the sliders in SI, and whether they are logarithmic. */
const SLIDERS = {
  'contact.friction': [0.05, 0.7, 0.005], 'contact.tractive_ratio': [0.02, 0.98, 0.005],
  'contact.normal_load': [10e3, 150e3, 500], 'wheel.inertia': [2, 300, 'log'], 'track.pad.stiffness': [10e6, 3e9, 'log'],
};
const LOG_STEPS = 400;
/** Two keys of which a case gives one. */
const ONE_OF = [['contact.tractive_ratio', 'contact.creepage']];
/** A model needs supports: the preset that stands in until others are chosen. */
const FIRST_PRESET = { 'one-layer': 'slab-direct', 'one-layer-periodic': 'slab-direct', 'two-layer': 'br-stiff', 'two-layer-periodic': 'br-stiff' };

const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};
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

export class Form {
  constructor({ place, handles, vocabulary, onChange, speed }) {
    Object.assign(this, { place, handles, onChange, speed, schema: vocabulary.schema, presets: vocabulary.presets, fields: new Map(), sliders: new Map() });
    this.#build();
  }

  // Making it ----------------------------------------------------------------------------------------

  #build() {
    const general = this.#section('general', true);
    this.place.append(general);
    for (const [key, node] of Object.entries(this.schema.properties)) {
      if (NOT_HERE.includes(key)) continue;
      const resolved = resolve(this.schema, node);
      if (resolved.properties) {
        const section = this.#section(key, ['track', 'contact'].includes(key));
        this.#rows(section.lastChild, key, resolved);
        this.place.append(section);
      } else {
        general.lastChild.append(this.#row(key, resolved));
      }
    }
    for (const key of Object.keys(SLIDERS)) this.#slider(key);
  }

  #section(key, open) {
    const heading = element('summary', {}, element('span', {}));
    heading.firstChild.dataset.name = key;
    return element('details', { open, className: 'group' }, heading, element('div', { className: 'rows' }));
  }

  #rows(place, parent, node) {
    for (const [name, child] of Object.entries(node.properties)) {
      const key = `${parent}.${name}`;
      if (NOT_HERE.includes(key)) continue;
      const resolved = resolve(this.schema, child);
      if (resolved.properties) {
        const heading = element('h4', {});
        heading.dataset.name = key;
        const group = element('div', { className: 'subgroup', role: 'group' }, heading);
        heading.id = `${idOf(key)}-heading`;
        group.setAttribute('aria-labelledby', heading.id);
        this.#rows(group, key, resolved);
        place.append(group);
      } else {
        place.append(this.#row(key, resolved));
      }
    }
  }

  #row(key, node) {
    const id = idOf(key);
    const label = element('label', { htmlFor: id, title: `${node.description ?? ''}\n${key}`.trim() });
    label.dataset.name = key;
    const unit = element('span', { className: 'unit', id: `${id}-unit` });
    const fault = element('p', { className: 'fault', lang: 'en', id: `${id}-fault`, hidden: true });
    const presets = this.presets.filter((preset) => preset.key === key);
    const choices = node.oneOf?.map((choice) => [choice.const, choice.description]) ?? node.enum?.map((name) => [name, '']);
    let input;
    if (presets.length) input = this.#menu(presets.map((preset) => [preset.name, preset.title]), true);
    else if (choices) input = this.#menu(choices.filter(([name]) => name !== 'measured'), node.default === undefined && key !== 'track.model');
    else {
      input = element('input', { type: 'text', autocomplete: 'off', spellcheck: false });
      if (node.unit !== undefined || node.type?.includes?.('integer')) {
        input.inputMode = 'decimal';
        input.className = 'figure';
      }
    }
    input.id = id;
    input.setAttribute('aria-describedby', `${unit.id} ${fault.id}`);
    const field = { key, node, input, unit, fault, presets, shown: shownUnit(key, node.unit) };
    input.addEventListener('change', () => this.#read(field));
    const row = element('div', { className: 'row' }, label, input, presets.length ? this.#sources(field) : unit, fault);
    this.fields.set(key, field);
    return row;
  }

  #menu(choices, empty) {
    const menu = element('select', {});
    if (empty) menu.append(element('option', { value: '', textContent: '—' }));
    for (const [name, title] of choices) menu.append(element('option', { value: name, textContent: name, title: title ?? '' }));
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
      bubble.replaceChildren(element('strong', { textContent: preset?.title ?? t('none'), lang: preset ? 'en' : '' }));
      for (const value of preset?.values ?? []) {
        bubble.append(element('p', {}, element('b', { textContent: `${nameOf(value.key)} = ${value.value}` }), ` ${t(value.badge)}. `, element('span', { textContent: value.source, lang: 'en' })));
      }
      const { left, bottom } = button.getBoundingClientRect();
      bubble.style.left = `${Math.max(8, Math.min(left, innerWidth - 372))}px`;
      bubble.style.top = `${Math.min(bottom + 6, innerHeight - 220)}px`;
    };
    bubble.addEventListener('beforetoggle', show);
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
      this.#change(key, unit ? `${value} ${unit}` : Number(value));
    });
    this.handles.append(element('div', { className: 'handle' }, label, output, input, note));
    this.sliders.set(key, slider);
  }

  // Showing a case -----------------------------------------------------------------------------------

  /** Show the keys that are written and, pale, what presets and defaults give for the others. */
  show(keys, complete) {
    this.keys = keys;
    if (complete) this.complete = complete;
    for (const field of this.fields.values()) this.#showField(field);
    for (const [key, slider] of this.sliders) this.#showSlider(key, slider);
  }

  #showField({ key, node, input, unit, shown }) {
    const written = get(this.keys, key);
    const whole = this.complete && get(this.complete, key);
    if (input.tagName === 'SELECT') {
      const name = written ?? '';
      // A name that no menu holds stays visible: the error beside it speaks of it.
      if (name && ![...input.options].some((option) => option.value === name)) input.append(element('option', { value: name, textContent: name }));
      input.value = name || (input.options[0].value === '' ? '' : (whole ?? node.default ?? ''));
      if (input.options[0].value === '' && !this.presets.some((preset) => preset.key === key)) {
        input.options[0].textContent = whole && !written ? `(${whole})` : '—';
      }
      return;
    }
    const quantity = node.unit !== undefined;
    if (!quantity) {
      if (document.activeElement !== input || written !== undefined) input.value = written ?? '';
      input.placeholder = whole ?? '';
      return;
    }
    const parts = written === undefined ? null : split(written, node.unit);
    input.value = written === undefined ? '' : worded(parts?.text ?? written);
    unit.textContent = parts?.unit ?? shown[0];
    const inherited = whole === undefined || whole === null ? null : Number.parseFloat(whole) / shown[1];
    input.placeholder = written === undefined && inherited !== null ? worded(short(inherited)) : '';
    if (input.placeholder) input.title = t('from_preset');
    else input.removeAttribute('title');
  }

  #showSlider(key, { input, output, note, place }) {
    const [unit, factor] = this.fields.get(key).shown;
    // What was written last goes before what the program last answered: it may be a step behind.
    const written = get(this.keys, key);
    const parts = written === undefined ? null : split(written, '');
    const own = parts && (parts.unit === unit ? parts.number * factor : parts.unit === '' ? parts.number : undefined);
    const value = own ?? (this.complete && si(this.complete, key));
    const model = this.complete?.track?.model ?? '';
    const off =
      (key === 'track.pad.stiffness' && (model === 'free-beam' || !(this.complete && si(this.complete, key))) && t('no_pads')) ||
      (key === 'wheel.inertia' && this.complete && this.complete.wheel.rotation !== 'inertia' && t('no_turning')) || '';
    input.disabled = Boolean(off);
    note.textContent = off;
    if (value === undefined || value === null) {
      output.textContent = '–';
      return;
    }
    if (document.activeElement !== input || Math.abs(place(value) - input.value) > Number(input.step)) input.value = place(value);
    output.textContent = `${number(value / factor, 3)}${unit ? ` ${unit}` : ''}`;
    input.setAttribute('aria-valuetext', output.textContent);
  }

  // Changing it --------------------------------------------------------------------------------------

  #read({ key, node, input, unit }) {
    const text = input.value.trim();
    if (text === '') return this.#change(key, undefined);
    if (input.tagName === 'SELECT' || (node.unit === undefined && !node.type?.includes?.('integer'))) return this.#change(key, text);
    const plain = /^[+-]?[\d.,]+([eE][+-]?\d+)?$/.test(text) ? text.replace(',', '.') : null;
    if (node.unit === undefined) return this.#change(key, plain === null ? text : Number(plain));
    if (plain === null) return this.#change(key, text.replace(/^([+-]?\d+),(\d+)/, '$1.$2'));
    this.#change(key, unit.textContent ? `${plain} ${unit.textContent}` : Number(plain));
  }

  #change(key, value) {
    set(this.keys, key, value);
    const other = ONE_OF.find((pair) => pair.includes(key))?.find((other) => other !== key);
    if (other && value !== undefined) set(this.keys, other, undefined);
    // A preset is chosen for its values: they go before those that were written.
    const preset = this.presets.find((preset) => preset.key === key && preset.name === value);
    for (const { key: given } of preset?.values ?? []) set(this.keys, given, undefined);
    if (key === 'track.preset') for (const part of ['pad', 'sleeper', 'ballast']) set(this.keys, `track.${part}`, undefined);
    const track = this.keys.track ?? {};
    if (key === 'track.model' && FIRST_PRESET[value] && !track.preset && !track.pad) set(this.keys, 'track.preset', FIRST_PRESET[value]);
    this.onChange(this.keys);
  }

  // Errors -------------------------------------------------------------------------------------------

  /** Show a fault at its field, or at the table that it stands in; true if there is a place for it. */
  refuse(fault, show = false) {
    this.clear();
    let key = fault.key ?? '';
    while (key && !this.fields.has(key)) {
      const inside = [...this.fields.keys()].find((other) => other.startsWith(`${key}.`));
      key = inside ?? (key.includes('.') ? key.slice(0, key.lastIndexOf('.')) : '');
    }
    const field = this.fields.get(key);
    if (!field) return false;
    field.fault.textContent = fault.help ? `${fault.message} (${fault.help})` : fault.message;
    field.fault.hidden = false;
    field.input.setAttribute('aria-invalid', 'true');
    field.input.closest('details').open = true;
    field.input.closest('.row').classList.add('wrong');
    if (show) field.input.closest('.row').scrollIntoView({ block: 'center' });
    return true;
  }

  clear() {
    for (const { input, fault } of this.fields.values()) {
      if (fault.hidden) continue;
      fault.hidden = true;
      input.removeAttribute('aria-invalid');
      input.closest('.row').classList.remove('wrong');
    }
  }
}
