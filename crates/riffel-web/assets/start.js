// The first visit: a line, a vehicle, rail and pads, from which a case is made that one can go on with.

import { element, worded } from './elements.js';
import { inWords } from './messages.js';
import { t, translate } from './words.js';

/** Rails with what they lie on: section, preset of the track and its model. */
const TRACKS = [
  ['60E1', 'ballasted-stiff-pads', 'two-layer-periodic'], ['60E1', 'ballasted-soft-pads', 'two-layer-periodic'], ['60E1', 'railfe-ballasted', 'two-layer-periodic'],
  ['BS113A', 'br-stiff', 'two-layer-periodic'], ['CN60', 'china-ballasted', 'two-layer-periodic'], ['54E1', 'slab-direct', 'one-layer-periodic'],
  ['60E1', 'continuous-support', 'one-layer'],
];
/** Choice of the vehicle that a line has by itself. */
const OWN = '';

export class Start {
  /** `open` takes the keys of a case, `done` is told when somebody goes on with it. */
  constructor({ vocabulary, open, done }) {
    Object.assign(this, { vocabulary, open });
    const menu = (id, word, choices) => {
      const select = element('select', { id }, ...choices);
      select.addEventListener('change', () => this.#choose(select === this.line));
      return [select, element('label', { htmlFor: id }, worded('span', word), select)];
    };
    const presets = (key) => vocabulary.presets.filter((preset) => preset.key === key);
    const said = (value, title, before = '') => {
      const option = element('option', { value });
      option.say = () => (option.textContent = before + inWords(title));
      return option;
    };
    const titles = new Map(presets('track.preset').map(({ name, title }) => [name, title]));
    const labels = [];
    [this.line, labels[0]] = menu('start-line', 'start_line', vocabulary.lines.map(({ name }) => worded('option', `line_${name}`, { value: name })));
    [this.vehicle, labels[1]] = menu('start-vehicle', 'start_vehicle', [worded('option', 'start_own', { value: OWN }), ...presets('vehicle').map(({ name, title }) => said(name, title))]);
    [this.track, labels[2]] = menu('start-track', 'start_track', TRACKS.map(([section, preset], k) => said(k, titles.get(preset), `${section} · `)));
    const go = worded('button', 'start_go', { type: 'button', className: 'plain', id: 'start-go' });
    go.addEventListener('click', () => {
      this.panel.hidden = true;
      done();
    });
    this.panel = element('article', { className: 'panel start', id: 'start', hidden: true }, element('header', {}, worded('h2', 'start')), element('div', { className: 'choices' }, ...labels), element('p', { className: 'fine' }, worded('span', 'start_help'), ' ', go));
    this.#follow();
    this.reword();
  }

  /** The case of a first visit. */
  get first() {
    return structuredClone(this.vocabulary.lines[0].case);
  }

  show() {
    this.panel.hidden = false;
    this.line.focus();
  }

  reword() {
    translate(this.panel);
    for (const option of this.panel.querySelectorAll('option')) option.say?.();
  }

  get #case() {
    return this.vocabulary.lines.find(({ name }) => name === this.line.value).case;
  }

  /** Another line comes with its own vehicle and track. */
  #follow() {
    const { vehicle = OWN, rail, track } = this.#case;
    this.vehicle.value = vehicle;
    this.vehicle.options[0].hidden = vehicle !== OWN;
    this.track.value = TRACKS.findIndex(([section, preset]) => section === rail.section && preset === track.preset);
  }

  #choose(isLine) {
    if (isLine) this.#follow();
    const keys = structuredClone(this.#case);
    if (this.vehicle.value !== OWN && this.vehicle.value !== keys.vehicle) {
      keys.vehicle = this.vehicle.value;
      // Its wheel and its load are those of the vehicle.
      delete keys.wheel;
      delete keys.contact.normal_load;
    }
    const [section, preset, model] = TRACKS[this.track.value];
    if (section !== keys.rail.section || preset !== keys.track.preset) {
      keys.rail.section = section;
      keys.track = { model, preset, ...(model.endsWith('periodic') && { position: '0 m' }) };
      keys.title = `${t(`line_${this.line.value}`)}, ${section}, ${preset}`;
    }
    this.open(keys);
  }
}
