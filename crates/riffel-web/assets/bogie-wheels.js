// Growth of the case under each wheel of the bogie in its curve, and the way of its mean state into the case.

import { element, svgElement, worded } from './elements.js';
import { offer } from './figures.js';
import { caseTitle, inWords } from './messages.js';
import { inUnit, set } from './keys.js';
import { Line, json } from './server.js';
import { number, power, range, t, translate } from './words.js';

/** Width and height of a picture, in its own units, and where its zero lies. */
const [WIDTH, HEIGHT, ZERO] = [200, 70, 50];

export class BogieWheels {
  constructor({ state, traffic, unitOf, inLabels, replace, save }) {
    Object.assign(this, { state, traffic, unitOf, inLabels, replace, line: new Line('/api/curve/wheels', json), answer: null });
    this.of = element('span', { className: 'aside' });
    this.words = element('p', { className: 'why' });
    this.multiples = element('div', { className: 'multiples', id: 'growth-of-wheels' });
    const header = element('header', {}, worded('h2', 'growth_of_wheels'), this.of);
    offer(header, () => this.answer && { name: 'growth-of-wheels', rows: this.#rows() }, save, ['csv']);
    this.panel = element('article', { className: 'panel wide', id: 'wheels-panel' }, header, this.words, this.multiples);
  }

  /** Ask for the case at hand in a curve; null is one in which the bogie does not stand. */
  ask(curve) {
    const keys = this.state.accepted;
    if (!curve || !keys) return this.#show(null, curve, keys);
    this.panel.classList.add('stale');
    return this.line.ask({ ...curve, case: { keys } }, (answer) => this.#show(answer, curve, keys), (fault) => this.#show({ fault, wheels: [] }, curve, keys));
  }

  /** Ask again, where the case has changed. */
  caseChanged() {
    if (this.keys !== this.state.accepted) this.ask(this.curve);
  }

  /** What is shown is no longer, or again, that of the fields. */
  settle(isOld) {
    this.panel.classList.toggle('stale', isOld || !this.line.idle);
  }

  #show(answer, curve, keys) {
    Object.assign(this, { answer, curve, keys });
    this.panel.classList.remove('stale');
    this.reword();
  }

  /** One for each wheel: of one on two points the contact that carries more. */
  get #wheels() {
    return this.answer.wheels.filter((wheel) => wheel.share_of_second_contact <= 0.5);
  }

  #rows() {
    const wheels = this.#wheels.filter((wheel) => wheel.growth_rate_per_passage);
    return [['wavelength_m', ...wheels.map(({ wheelset, rail }) => `wheelset_${wheelset}_${rail}_rail`)],
      ...this.answer.wavelength_m.map((wavelength, k) => [wavelength, ...wheels.map((wheel) => wheel.growth_rate_per_passage[k])])];
  }

  reword() {
    translate(this.panel);
    const { answer } = this;
    this.panel.hidden = !answer;
    if (!answer) return;
    this.of.textContent = caseTitle(this.keys);
    this.words.textContent = answer.fault ? inWords(answer.fault.message, this.inLabels) : t('growth_of_wheels_help', answer.wavelength_m.at(0) && range([answer.wavelength_m[0], answer.wavelength_m.at(-1)], (one) => number(1e3 * one)));
    const most = Math.max(...this.#wheels.map((wheel) => wheel.highest?.growth_rate_per_passage ?? 0), 1e-12);
    this.multiples.replaceChildren(...this.#wheels.map((wheel) => this.#figure(wheel, most)));
  }

  #figure(wheel, most) {
    const name = t('wheel_of', wheel);
    const caption = element('figcaption', {}, element('b', { textContent: name }));
    const figure = element('figure', {}, caption);
    if (!wheel.keys) {
      caption.append(element('span', { textContent: inWords(wheel.not_in_loop, this.inLabels) }));
      return figure;
    }
    const { highest } = wheel;
    caption.append(element('span', {
      textContent: highest ? t('wheel_grows', { wavelength: number(1e3 * highest.wavelength_m), frequency: number(highest.frequency_hz), rate: power(highest.growth_rate_per_passage), doubling: this.traffic.doubling(highest.doubling_passages), isEdge: highest.at_edge }) : t('nothing_grows'),
    }));
    const use = worded('button', 'use_state', { type: 'button', className: 'plain small', textContent: t('use_state') });
    use.addEventListener('click', () => {
      const keys = structuredClone(this.state.keys);
      for (const key of this.answer.give_way) set(keys, key, undefined);
      for (const [key, value] of Object.entries(wheel.keys)) set(keys, key, typeof value === 'number' ? inUnit(key, value, this.unitOf(key)) : value);
      this.replace({ case: keys, point: null, tab: 'explore' }, t('state_used', name));
    });
    figure.prepend(this.#picture(wheel.growth_rate_per_passage, most, name));
    figure.append(use);
    return figure;
  }

  /** Growth over wavelength in the scale of all wheels; decay is cut off. */
  #picture(rates, most, label) {
    const wavelengths = this.answer.wavelength_m;
    const across = (wavelength) => (WIDTH * (wavelength - wavelengths[0])) / (wavelengths.at(-1) - wavelengths[0]);
    const points = rates.map((rate, k) => `${across(wavelengths[k]).toFixed(1)} ${Math.min(HEIGHT, ZERO - (ZERO * rate) / most).toFixed(1)}`);
    const path = svgElement('path', { d: `M0 ${ZERO} L${points.join(' L')} L${WIDTH} ${ZERO} Z`, class: 'after' });
    return svgElement('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': label }, path);
  }
}
