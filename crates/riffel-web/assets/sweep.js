// A sweep: growth over wavelength under the traffic for six values of one quantity, or at six speeds, everything else as in the case at hand.

import { letterSize, orderedColor, theme } from './colors.js';
import { axis, draw, growthRange, growthUnit, layout } from './curves.js';
import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords } from './messages.js';
import { set, si } from './keys.js';
import { Line, json } from './server.js';
import { wordsOf, number, power, speed as inUnit, t, translate } from './words.js';

/** Curves of a sweep. */
const COUNT = 6;
/** Keys of which a case gives one. */
const IN_PLACE_OF = { 'contact.tractive_ratio': 'contact.creepage' };

/** What is swept: the key with its values and how they are written; speeds have no key, and the growth of each is that of trains of one speed. */
const SWEEPS = {
  pads: { key: 'track.pad.stiffness', values: [50, 80, 125, 200, 320, 500], written: (value) => `${value} MN/m`, shown: (value) => `${number(value)} MN/m` },
  friction: { key: 'contact.friction', values: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], written: (value) => value, shown: (value) => `μ = ${number(value, 2)}` },
  tractive: { key: 'contact.tractive_ratio', values: [0.15, 0.3, 0.45, 0.6, 0.75, 0.9], written: (value) => value, shown: (value) => `τ = ${number(value, 2)}` },
  speeds: { shown: inUnit },
};

/** Growth over wavelength of several, each with its name, colour and width, in one power of ten. */
export async function drawCurves(place, lines) {
  const unit = growthUnit(lines.flatMap((one) => one.growth_rate_per_passage));
  const traces = lines.map(({ wavelength_m: wavelength, growth_rate_per_passage: rate, name, color, width }) => ({
    // plotly.js would read marks in a name.
    type: 'scatter', mode: 'lines', name: name.replaceAll('<', '&lt;'), x: wavelength.map((value) => 1e3 * value), y: rate.map((value) => value / unit), line: { color, width },
    hovertemplate: `%{x:.3~g} mm · %{y:.3~g}<extra>${name.replaceAll('<', '&lt;')}</extra>`,
  }));
  const zero = { type: 'line', xref: 'paper', yref: 'y', x0: 0, x1: 1, y0: 0, y1: 0, line: { color: theme().soft, width: 1 } };
  await draw(place, traces, layout({
    xaxis: axis(`${t('wavelength')} λ [mm]`), yaxis: axis(`${t('rate')} [${power(unit, 1).replace('1·', '')}]`, growthRange(traces.flatMap(({ y }) => y))), shapes: [zero], showlegend: true,
    margin: { l: 4 * letterSize(), r: 10, t: 2.4 * letterSize(), b: 3 * letterSize() },
  }));
}

/** What grows fastest under the traffic, as the headline has it; null where nothing grows. */
const underTraffic = ({ fastest, cause, doubles_in: time }) => fastest && {
  rate: fastest.growth_rate_per_passage, wavelength: fastest.wavelength_m, frequency: cause?.frequency_hz, doubling: inWords(time), isEdge: fastest.at_edge,
};

export class Sweep {
  /** `onKeep` takes the variants of a sweep. */
  constructor({ state, traffic, complain, save, onKeep }) {
    Object.assign(this, { state, traffic, complain, onKeep, kind: null, answer: null, line: new Line('/api/line', json), atSpeeds: new Line('/api/growth', json), turn: 0 });
    this.buttons = Object.keys(SWEEPS).map((kind) => {
      const button = worded('button', `sweep_${kind}`, { type: 'button', className: 'plain', id: `sweep-${kind}`, ariaPressed: 'false' });
      button.addEventListener('click', () => this.choose(kind === this.kind ? null : kind));
      return button;
    });
    this.keep = worded('button', 'sweep_keep', { type: 'button', className: 'plain', id: 'sweep-keep', hidden: true });
    this.keep.addEventListener('click', () => onKeep(this.answer.steps.map(({ name, keys }) => ({ name, case: structuredClone(keys) }))));
    this.note = element('p', { className: 'fine' });
    this.plot = element('div', { className: 'curve tall', id: 'sweep-curves', hidden: true });
    this.table = element('table', { className: 'comparison', id: 'sweep-table', hidden: true });
    this.aside = element('span', { className: 'aside' });
    const header = element('header', {}, worded('h2', 'sweep'), this.aside);
    offer(header, () => (this.answer ? { name: `sweep-${this.kind}`, plot: this.plot } : null), save);
    this.panel = element('article', { className: 'panel wide', id: 'sweep' }, header,
      element('div', { className: 'buttons wrap' }, ...this.buttons, this.keep), this.note, this.plot, element('div', { className: 'sideways' }, this.table));
    this.show();
  }

  choose(kind) {
    this.kind = kind;
    this.answer = this.asked = null;
    for (const button of this.buttons) button.setAttribute('aria-pressed', String(button.id === `sweep-${kind}`));
    this.show();
    this.caseChanged();
  }

  /** The cases of the sweep, with names and, where these are swept, speeds. */
  #steps() {
    const { key, values, written, shown } = SWEEPS[this.kind];
    const { keys, map } = this.state;
    const range = map.speed;
    const places = values ?? Array.from({ length: COUNT }, (_, k) => range.min + ((range.max - range.min) * (k + 1)) / COUNT);
    return places.map((value) => {
      const own = structuredClone(keys);
      if (key) {
        set(own, key, written(value));
        if (IN_PLACE_OF[key]) set(own, IN_PLACE_OF[key], undefined);
      }
      return { name: shown(value), keys: own, ...(!key && { speed: value }) };
    });
  }

  /** Ask anew, if a sweep is chosen. */
  caseChanged() {
    const { state, kind } = this;
    if (!kind || state.view !== 'compare' || !state.map) return;
    const complete = state.head?.complete;
    const noPads = kind === 'pads' && complete && (complete.track?.model === 'free-beam' || !si(complete, 'track.pad.stiffness'));
    this.noPads = noPads;
    const steps = this.#steps();
    const { traffic } = this;
    const asked = JSON.stringify([steps, noPads, traffic.given]);
    if (asked === this.asked) return;
    this.asked = asked;
    const turn = ++this.turn;
    if (noPads) {
      this.answer = null;
      return this.show();
    }
    const answers = [];
    const take = (more) => {
      // Another sweep may have been chosen, or the case changed.
      if (turn !== this.turn) return;
      answers.push(...more);
      this.answer = { answers, steps };
      this.show();
      if (kind !== 'speeds' && answers.length < steps.length) next();
    };
    const refuse = (fault) => {
      this.asked = null;
      if (!fault.key) this.complain(fault, { until: 'case' });
    };
    // One after the other: growth under the traffic takes its time, and each is shown as it comes.
    const next = () => this.line.ask({ for: 'sweep', case: { keys: steps[answers.length].keys }, traffic: traffic.givenFile }, (answer) => take([answer]), refuse);
    if (kind !== 'speeds') return next();
    const curves = steps.map(({ name, keys, speed }) => ({ name, case: { keys }, speed_m_per_s: speed }));
    return this.atSpeeds.ask({ for: 'sweep', curves, case: { keys: structuredClone(state.keys) } }, take, refuse);
  }

  show() {
    const { answer, kind } = this;
    this.plot.hidden = this.table.hidden = !answer;
    this.note.hidden = Boolean(answer) || (kind && !this.noPads);
    this.note.textContent = t(kind ? 'no_pads' : 'sweep_comes');
    const done = answer?.answers.length;
    this.keep.hidden = done !== COUNT || kind === 'speeds';
    this.aside.textContent = !answer || kind === 'speeds' ? '' : [t('sweep_of_traffic'), done < COUNT && t('so_many_of', { done, of: COUNT })].filter(Boolean).join(', ');
    if (!answer) return;
    const { dark } = theme();
    const name = (k) => SWEEPS[kind].values ? answer.steps[k].name : inUnit(answer.steps[k].speed);
    const curveOf = ({ curve, ...one }) => (curve ? { wavelength_m: curve.map(([wavelength]) => wavelength), growth_rate_per_passage: curve.map(([, rate]) => rate) } : one);
    drawCurves(this.plot, answer.answers.map((one, k) => ({ ...curveOf(one), name: name(k), width: 1.8, color: orderedColor(k / (COUNT - 1), dark) })));
    const highest = kind === 'speeds' ? (one) => this.#atSpeed(one) : underTraffic;
    fillTable(this.table, ['', ...wordsOf('sweep_columns')], answer.answers.map((one, k) => {
      const high = highest(one);
      return row(name(k), high
        ? [power(high.rate, 3), `${number(1e3 * high.wavelength)} mm${high.isEdge ? `, ${t('at_edge')}` : ''}`, high.frequency ? `${number(high.frequency)} Hz` : '–', high.doubling]
        : [t('nothing_grows_here'), '–', '–', '–']);
    }));
  }

  /** What grows fastest at one speed; null where nothing grows. */
  #atSpeed({ lines, wavelength_m: wavelengths }) {
    const high = lines.filter(({ growth_rate_per_passage: rate }) => rate > 0).reduce((best, one) => (best && best.growth_rate_per_passage >= one.growth_rate_per_passage ? best : one), null);
    return high && {
      rate: high.growth_rate_per_passage, wavelength: high.wavelength_m, frequency: high.frequency_hz, doubling: this.traffic.doubling(Math.LN2 / high.growth_rate_per_passage),
      // There growth may go on rising: the window hides the crest.
      isEdge: [wavelengths[0], wavelengths.at(-1)].includes(high.wavelength_m),
    };
  }

  reword() {
    translate(this.panel);
    if (this.answer) this.answer.steps = this.#steps();
    this.show();
  }
}
