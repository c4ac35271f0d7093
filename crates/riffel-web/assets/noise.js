// Rolling noise: what a coach sounds like on the measured rail, what would make it quieter, and what becomes of it.

import { letterSize, theme } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords, said } from './messages.js';
import { askWhich, readNumber } from './numbers.js';
import { Line, json } from './server.js';
import { currentLanguage, wordsOf, number, speed, t, translate, written } from './words.js';

/** Where a reload finds the limit that was written, and the wheel that was chosen. */
const LIMIT = 'riffel-limit-dba';
const WHEEL = 'riffel-noise-wheel';
const [LOWEST, HIGHEST] = [0, 200];
/** What radiates, with the colour of its curve. */
const PARTS = [['rail', 1], ['sleepers', 3], ['wheel', 2], ['total', 0]];
/** What a wheel may be, with its word. */
const WHEELS = [['rigid', 'noise_rigid'], ['straight-web-920', 'noise_straight_web']];
/** Levels so far below the highest are not drawn [dB]. */
const DEPTH = 50;
/** Least height of the axis of the months ahead [dB]: less than that is not heard. */
const LEAST_SPAN = 2;

/** A level with one digit after the point. */
const decibels = (value) => (value === null ? '–' : (Math.round(10 * value) / 10 + 0).toLocaleString(currentLanguage(), { minimumFractionDigits: 1, maximumFractionDigits: 1 }).replace('-', '−'));

/** What a reload finds; null if there is nothing. */
function kept(name) {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

/** Keep a value over a reload; null is none. */
function keep(name, value) {
  try {
    if (value === null) localStorage.removeItem(name);
    else localStorage.setItem(name, value);
  } catch {
    // Then a reload asks for it again.
  }
}

function keptLimit() {
  const limit = Number(kept(LIMIT) ?? NaN);
  return limit >= LOWEST && limit <= HIGHEST ? limit : null;
}

export class Noise {
  /** `question` asks about the rail, `isCurrent` tells whether that is still what is shown. */
  constructor({ question, isCurrent, complain, banner, inLabels, save }) {
    Object.assign(this, { question, isCurrent, complain, inLabels, of: null, answer: null, limit: keptLimit() });
    this.line = new Line('/api/ask/noise', json);
    this.line.onCancel = () => banner.say(() => t('stopped'), { ways: [['again', () => this.#ask()]] });
    this.verdict = element('p', { className: 'why', id: 'noise-verdict' });
    this.wheel = element('select', { id: 'noise-wheel' }, ...WHEELS.map(([value, word]) => worded('option', word, { value })));
    const wheel = kept(WHEEL);
    if (WHEELS.some(([value]) => value === wheel)) this.wheel.value = wheel;
    this.wheel.addEventListener('change', () => {
      keep(WHEEL, this.wheel.value);
      this.#ask();
    });
    const wheelChoice = element('label', { className: 'choice' }, worded('span', 'noise_wheel_is'), this.wheel);
    this.parts = element('table', { className: 'comparison', id: 'noise-parts' });
    this.bands = element('div', { className: 'curve tall', id: 'noise-bands' });
    this.remarks = element('ul', { className: 'fine', id: 'noise-remarks' });
    const head = element('header', {}, worded('h2', 'noise'));
    this.panel = element('article', { className: 'panel half', hidden: true, id: 'noise-panel' }, head, wheelChoice, this.verdict, element('div', { className: 'sideways' }, this.parts), this.bands, this.remarks);
    offer(head, () => ({ name: 'noise', plot: this.bands }), save);
    this.save = head.querySelector('.take');

    this.measures = element('table', { className: 'comparison', id: 'noise-measures' });
    const measuresHead = element('header', {}, worded('h2', 'noise_helps'));
    offer(measuresHead, () => ({ name: 'noise-measures', table: this.measures }), save, ['csv']);
    this.input = element('input', { type: 'text', id: 'noise-limit', inputMode: 'decimal', size: 5, autocomplete: 'off' });
    this.input.addEventListener('change', () => this.#read());
    this.fault = element('p', { className: 'fault', id: 'noise-limit-fault', hidden: true });
    this.input.setAttribute('aria-describedby', this.fault.id);
    this.course = element('div', { className: 'curve', id: 'noise-course' });
    this.outlook = element('p', { className: 'why', id: 'noise-outlook' });
    const courseHead = element('header', {}, worded('h2', 'noise_ahead'));
    offer(courseHead, () => ({ name: 'noise-ahead', plot: this.course }), save);
    this.helpPanel = element('article', { className: 'panel half', hidden: true, id: 'noise-help-panel' }, measuresHead, element('div', { className: 'sideways' }, this.measures),
      courseHead, element('label', { className: 'choice' }, worded('span', 'noise_limit'), this.input, 'dB(A)'), this.fault, this.outlook, this.course);
    this.panels = [this.panel, this.helpPanel];
  }

  /** Show what belongs to a measurement; null hides all. */
  show(measurement) {
    const same = this.of === measurement;
    this.of = measurement;
    if (!measurement || measurement.is_silent) this.answer = null;
    this.#show();
    if (!same) this.#ask();
  }

  reword() {
    for (const panel of this.panels) translate(panel);
  }

  #ask() {
    if (!this.of || this.of.is_silent) return;
    this.#stale(true);
    const take = (answer) => {
      // The record may be gone meanwhile.
      if (!this.of) return;
      this.answer = answer;
      this.#stale(this.line.pending || !this.isCurrent());
      this.#show();
    };
    const wheel = this.wheel.value !== WHEELS[0][0] && { wheel_modes: this.wheel.value };
    this.line.ask({ ...this.question(), ...wheel, ...(this.limit !== null && { limit_dba: this.limit }) }, take, (fault) => {
      if (fault.status === 422) take({ fault });
      else if (fault.status !== 410) this.complain(fault, { what: `${t('noise')}: ` });
    });
  }

  #stale(is) {
    for (const panel of this.panels) panel.classList.toggle('stale', is);
  }

  /** The limit, as it is typed; nothing is none. */
  #read() {
    const text = this.input.value.trim();
    const accept = (value) => {
      this.#refuse('');
      this.limit = value;
      keep(LIMIT, value);
      this.#ask();
    };
    if (text === '') return accept(null);
    const read = readNumber(text);
    if (!read || !['', 'dB', 'dB(A)', 'dBA'].includes(read.rest)) return this.#refuse(t('no_number', text));
    const bounded = (digits) => {
      const value = Number(digits);
      if (value >= LOWEST && value <= HIGHEST) return accept(value);
      this.#refuse(t('must_lie', { label: t('noise_limit'), value: text, low: LOWEST, high: `${HIGHEST} dB(A)` }));
    };
    if (!read.choices) return bounded(read.number);
    this.#refuse(' ');
    askWhich(this.fault, text, read, 'dB(A)', bounded);
  }

  #refuse(sentence) {
    this.fault.hidden = !sentence;
    this.input.setAttribute('aria-invalid', String(Boolean(sentence)));
    Object.assign(this.fault, { textContent: sentence, lang: currentLanguage() });
  }

  #show() {
    const { answer } = this;
    const isSilent = Boolean(this.of?.is_silent);
    const fault = answer?.fault;
    this.panel.hidden = !answer && !isSilent;
    this.helpPanel.hidden = this.parts.hidden = this.bands.hidden = this.remarks.hidden = this.save.hidden = !answer || Boolean(fault);
    if (this.panel.hidden) return;
    if (isSilent || fault) {
      const { text, language } = isSilent ? { text: t('noise_silent'), language: currentLanguage() } : said(fault.message, this.inLabels);
      Object.assign(this.verdict, { textContent: text, lang: language });
      return;
    }
    Object.assign(this.verdict, {
      textContent: t('noise_verdict', { level: this.#level(answer.level.total_dba), speed: speed(answer.speed_m_per_s), wheelsets: number(answer.wheels), length: number(answer.train_length_m), distance: number(answer.distance_m), height: number(answer.height_m) }),
      lang: currentLanguage(),
    });
    fillTable(this.parts, ['', ...PARTS.map(([part]) => t(`noise_${part}`))], [row('dB(A)', PARTS.map(([part]) => decibels(answer.level[`${part}_dba`])))]);
    const measures = answer.measures.map(({ title, total_dba: after, saved_db: saved }) => row(inWords(title), [decibels(after), decibels(saved)]));
    fillTable(this.measures, wordsOf('noise_columns'), measures);
    this.remarks.replaceChildren(...answer.remarks.map((remark) => {
      const { text, language } = said(remark, this.inLabels);
      return element('li', { textContent: text, lang: language });
    }));
    if (this.fault.hidden) this.input.value = this.limit === null ? '' : written(this.limit);
    this.outlook.textContent = this.#ahead();
    this.#draw();
  }

  /** A level in dB(A), a lower bound where the bands end below 2 kHz. */
  #level(value) {
    const hertz = this.answer.lower_bound_up_to_hz;
    return t('noise_level', { level: decibels(value), hertz: hertz && number(hertz) });
  }

  /** The months ahead as sentences. */
  #ahead() {
    const { month, total_dba: levels, limit_dba: limit, months_to_limit: months, beyond_linear_range: cut } = this.answer.course;
    const sentences = [t('noise_becomes', { level: this.#level(levels.at(-1)), months: number(month.at(-1)) })];
    if (cut) sentences.push(t('noise_cut'));
    if (limit !== null) sentences.push(t(months === null ? 'noise_never' : months === 0 ? 'noise_now' : 'noise_then', { limit: written(limit), months: number(months) }));
    return sentences.join(' ');
  }

  async #draw() {
    const { level, frequency_hz: frequency, course } = this.answer;
    const colors = palette();
    const curve = (x, y, name, color, more) => ({
      type: 'scatter', mode: 'lines', x, y, name, line: { color, width: 1.6, ...more.line }, hovertemplate: `%{x:.4~g} ${more.unit} · %{y:.1f} dB<extra>${name}</extra>`,
    });
    // The total below its parts, which it hides where one makes it alone.
    const traces = [...PARTS].reverse().map(([part, color]) => curve(frequency, level[`${part}_db`], t(`noise_${part}`), colors[color], { unit: 'Hz', line: part === 'total' ? { width: 3.2 } : {} })).filter(({ y }) => y.some((value) => value !== null));
    const most = Math.max(...level.total_db);
    const margin = { l: 4 * letterSize(), r: 10, t: 2.2 * letterSize(), b: 3 * letterSize() };
    await draw(this.bands, traces, layout({
      xaxis: axis(`${t('frequency')} f [Hz]`, { type: 'log', tickvals: [125, 250, 500, 1000, 2000, 4000], range: [Math.log10(frequency[0]), Math.log10(frequency.at(-1))] }),
      yaxis: axis(t('noise_axis'), { range: [most - DEPTH, most + 4] }), showlegend: true, margin,
    }));
    const limit = course.limit_dba;
    const ahead = [
      curve(course.month, course.total_dba, t('noise_total'), colors[0], { unit: t('months_word') }),
      ...(limit === null ? [] : [curve([0, course.month.at(-1)], [limit, limit], t('limit'), theme().warm, { unit: t('months_word'), line: { dash: 'dash' } })]),
    ];
    const all = ahead.flatMap(({ y }) => y);
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const beyond = Math.max(LEAST_SPAN - (high - low), 0.1 * (high - low)) / 2;
    await draw(this.course, ahead, layout({ xaxis: axis(t('noise_months')), yaxis: axis(t('noise_level_axis'), { range: [low - beyond, high + beyond] }), showlegend: ahead.length > 1, margin }));
  }
}
