// What a calibration says: in words, each value before and after the data, and the data beside what the model says of them.

import { letterSize, theme } from './colors.js';
import { axis, decades, draw, layout, palette } from './curves.js';
import { element, svgElement, worded } from './elements.js';
import { offer } from './figures.js';
import { said } from './messages.js';
import { shownUnit } from './keys.js';
import { nameOfValue, unitInWords, withNames } from './priors.js';
import { number, passages, power, range, sentence, t, translate } from './words.js';

const [WIDTH, HEIGHT] = [220, 64];
/** What is measured: word of its axis, factor to the unit there, what it is over, whether its axis is logarithmic. */
const MEASURED = {
  receptance_m_per_n: ['receptance_axis', 1e9, 'frequency', true], receptance_phase_rad: ['phase_axis', 180 / Math.PI, 'frequency', false], decay_rate_db_per_m: ['decay_axis', 1, 'frequency', true],
  level_rise_db: ['rise_axis', 1, 'wavelength', false], axle_box_level_db: ['axle_box_axis', 1, 'wavelength', false], pass_by_level_db: ['pass_by_axis', 1, 'passages', false],
  wave_growth_np: ['wave_growth_axis', 20 / Math.LN10, 'wavelength', false], wave_drift_rad: ['wave_drift_axis', 180 / Math.PI, 'wavelength', false], wear_m_per_100_mgt: ['wear_axis', 1e3, 'mass', false],
};
const TICKS = [10, 20, 30, 50, 70, 100, 200, 300, 500, 700, 1000, 2000, 5000];

/** A number of any size. */
const figure = (value) => (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6) || value === 0 ? number(value) : power(value, 3);

function path(x, y, { from, to }, top) {
  const at = (k) => `${((WIDTH * (x[k] - from)) / (to - from)).toFixed(1)} ${(HEIGHT - (HEIGHT * Math.min(y[k], top)) / top).toFixed(1)}`;
  return x.length ? `M${at(0).split(' ')[0]} ${HEIGHT}${x.map((_, k) => `L${at(k)}`).join('')}L${at(x.length - 1).split(' ')[0]} ${HEIGHT}Z` : '';
}

function densities({ x, after, x_before: xBefore, before, ...ends }) {
  const top = 1.05 * Math.max(...after, ...before);
  const paths = [['before', path(xBefore, before, ends, top)], ['after', path(x, after, ends, top)]];
  return svgElement('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, 'aria-hidden': true }, ...paths.map(([name, d]) => svgElement('path', { class: name, d })));
}

export class CalibrationAnswer {
  constructor({ save, unitOf }) {
    Object.assign(this, { unitOf, answer: null });
    const panel = (word, id, className, ...children) => element('article', { className: `panel ${className}`, id, hidden: true }, element('header', {}, worded('h2', word)), ...children);
    this.verdict = element('p', { className: 'why', id: 'calibration-conclusion' });
    this.words = element('ul', { className: 'sentences', id: 'calibration-words' });
    this.ways = element('div', { className: 'settings' });
    this.multiples = element('div', { className: 'multiples', id: 'marginals' });
    this.plots = element('div', { className: 'plots', id: 'predicted' });
    this.panels = [
      panel('data_tell', 'calibration-verdict', 'wide', this.verdict, this.words, this.ways), panel('before_after', 'marginals-panel', 'wide', worded('p', 'before_after_help', { className: 'fine' }), this.multiples),
      panel('predicted', 'predicted-panel', 'wide', worded('p', 'predicted_help', { className: 'fine' }), this.plots),
    ];
    offer(this.panels[1].querySelector('header'), () => this.answer && { name: 'calibration', rows: this.#rows() }, save, ['csv']);
  }

  /** A sentence of the program, with the names of the page. */
  spoken(english) {
    const { text, language } = said(english);
    const names = this.answer.parameters.map(({ name }) => name);
    return { textContent: withNames(text, names), lang: language };
  }

  show(answer) {
    this.answer = answer;
    for (const one of this.panels) one.hidden = !answer;
    if (!answer) return;
    const { conclusion, doubts, together, untold, far_from_others: far, remarks, is_conclusive: isConclusive, sampler } = answer;
    Object.assign(this.verdict, this.spoken(conclusion));
    this.verdict.textContent = sentence(this.verdict.textContent);
    const item = (english, className) => element('li', { ...this.spoken(english), className });
    const drawn = element('li', { textContent: t('drawn', { ...sampler, rhat: number(Math.max(...answer.parameters.map(({ rhat }) => rhat)), 4) }) });
    // Where chains disagree nothing is concluded.
    const more = isConclusive ? [...together, ...untold, ...far, ...remarks] : [...doubts, ...far, ...remarks];
    this.words.replaceChildren(drawn, ...more.map((one) => item(one, isConclusive ? '' : 'bad')));
    this.multiples.replaceChildren(...answer.parameters.map((one) => this.#multiple(one)));
    this.panels.forEach((one) => translate(one));
    this.#drawData();
  }

  /** Unit of a value on the page, and its factor to SI. */
  unit({ key, unit }) {
    if (unit === 'm/s') return shownUnit('', 'm/s');
    return key ? shownUnit(key, this.unitOf(key) ?? unit) : [unitInWords(unit), 1];
  }

  #multiple(one) {
    const [unit, size] = this.unit(one);
    const shown = (value) => figure(value / size);
    const [low, , middle, , high] = one.quantiles;
    const [from, , , , to] = one.prior_quantiles;
    const line = (text, className) => element('span', { textContent: text, className });
    return element('figure', {}, densities(one.densities), element('figcaption', {}, element('strong', { textContent: nameOfValue(one.name) }),
      ...(this.answer.is_conclusive ? [line(`${shown(middle)} (${range([low, high], shown)}) ${unit}`.trim(), 'after')] : []), line(t('was_before', `${range([from, to], shown)} ${unit}`.trim()), 'before'),
      line(t('told_share', { share: number(100 * Math.max(one.contraction, 0), 2), rhat: number(one.rhat, 4), draws: number(Math.min(one.ess_bulk, one.ess_tail), 3) }), 'fine')));
  }

  #rows() {
    const shares = ['q05', 'q25', 'q50', 'q75', 'q95'];
    const head = ['parameter', 'unit', ...shares, ...shares.map((share) => `prior_${share}`), 'rhat', 'ess_bulk', 'ess_tail', 'contraction'];
    return [head, ...this.answer.parameters.map((one) => [one.name, one.unit, ...one.quantiles, ...one.prior_quantiles, one.rhat, one.ess_bulk, one.ess_tail, one.contraction])];
  }

  /** A plot for each quantity that was measured, with a colour for each position or date. */
  #drawData() {
    const kinds = [...new Set(this.answer.data.map(({ measured }) => measured))];
    while (this.plots.childElementCount > kinds.length) this.plots.lastChild.remove();
    while (this.plots.childElementCount < kinds.length) this.plots.append(element('div', { className: 'curve' }));
    kinds.forEach((kind, k) => this.#drawKind(this.plots.children[k], kind, this.answer.data.filter(({ measured }) => measured === kind)));
  }

  #drawKind(place, kind, groups) {
    const [word, factor, over, isLog] = MEASURED[kind];
    const [isWavelength, isTime, isMass] = ['wavelength', 'passages', 'mass'].map((it) => it === over);
    const colors = palette().slice(1);
    const scaled = (values) => values.map((value) => value * factor);
    const traces = groups.flatMap(({ at, of, observed, quantiles }, k) => {
      const order = at.map((_, n) => n).sort((a, b) => at[a] - at[b]);
      const x = order.map((n) => (isWavelength ? 1e3 : isTime ? 1e-6 : 1) * at[n]);
      const y = (column) => scaled(order.map((n) => quantiles[n][column]));
      const color = colors[k % colors.length];
      const name = of === null ? t('measured') : isWavelength ? `${passages(of)} ${t('passages_word')}` : `${number(of)} m`;
      const line = (column, more) => ({ type: 'scatter', mode: 'lines', x, y: y(column), name: `${name}, ${[5, 50, 95][column]} %`, line: { color, width: column === 1 ? 1.4 : 0 }, showlegend: false, hoverinfo: 'skip', ...more });
      return [line(0), line(2, { fill: 'tonexty', fillcolor: `${color}33` }), line(1),
        { type: 'scatter', mode: 'markers', x, y: scaled(order.map((n) => observed[n])), name, marker: { color, size: 6, line: { color: theme().sheet, width: 1 } }, hovertemplate: '%{x:.4~g} · %{y:.3~g}<extra></extra>' }];
    });
    const all = traces.flatMap(({ x }) => x);
    const range = [Math.log10(0.94 * Math.min(...all)), Math.log10(1.06 * Math.max(...all))];
    draw(place, traces, layout({
      xaxis: isMass ? axis('MGT', {}) : isTime ? axis(`10⁶ ${t('passages_word')}`, {}) : axis(isWavelength ? `${t('wavelength')} λ [mm]` : `${t('frequency')} f [Hz]`, { type: 'log', tickvals: TICKS, range: isWavelength ? range.reverse() : range }),
      yaxis: axis(t(word), isLog ? decades(traces.flatMap(({ y }) => y)) : {}), showlegend: groups.length > 1, margin: { l: 4 * letterSize(), r: 10, t: 2.2 * letterSize(), b: 3 * letterSize() },
    }));
  }
}
