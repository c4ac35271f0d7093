// The headline: what grows fastest under the traffic and in what time, what it follows, and what helps most.

import { Calm } from './calm.js';
import { card } from './causes.js';
import { drawCurves } from './sweep.js';
import { palette } from './curves.js';
import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { inSentences, inWords, said } from './messages.js';
import { Remedies } from './remedies.js';
import { Line, json } from './server.js';
import { sentence, t, translate } from './words.js';

/** The headline is asked for when the map has stood still for so long [ms]: it takes as long as five maps, and would hold up the next ones under a slider. */
const REST = 150;
/** Remedies are asked for when nothing has changed for so long after it [ms]: they take as long as eight headlines. */
const CALM = 400;

/** The wavelength that grows fastest, at the speed at which the wheel of the case makes it grow most; null where none grows. */
const placeOf = ({ fastest, cause, speeds_m_per_s: speeds }) => fastest && { wavelength: fastest.wavelength_m, speed: cause?.speed_m_per_s ?? (speeds[0] + speeds[1]) / 2, isEdge: fastest.at_edge };

export class Outlook {
  /** `question` is the case with its traffic; `onHeadline` is told where on the map the fastest growth lies, `onWhy` that somebody asks for it, `announce` what a screen reader is told; `stale` and `fresh` take what waits. */
  constructor(view, { state, question, onHeadline, onWhy, announce, onFault, onCancel, stale, fresh, save, ...ways }) {
    Object.assign(this, { view, state, question, onHeadline, announce, onFault, stale, fresh, line: new Line('/api/line', json), ranking: new Line('/api/remedies', json), answer: null });
    this.rest = new Calm(REST, () => this.#ask());
    this.calm = new Calm(CALM, () => this.#rank());
    this.line.onCancel = this.ranking.onCancel = onCancel;
    this.remedies = new Remedies({ state, save, onFault, onCosts: () => this.#rank(), ...ways });
    this.large = element('strong', { id: 'doubling' });
    this.until = element('small', {});
    this.verdict = element('p', { className: 'verdict', id: 'verdict' });
    const why = worded('button', 'show_why', { type: 'button', className: 'plain small', id: 'show-why' });
    why.addEventListener('click', () => {
      onWhy();
      // The evidence beside the place on the map.
      this.panel.scrollIntoView({ block: 'nearest' });
      this.panel.focus({ preventScroll: true });
    });
    const helps = worded('button', 'show_helps', { type: 'button', className: 'plain small', id: 'show-helps' });
    helps.addEventListener('click', () => this.remedies.panel.scrollIntoView({ block: 'center' }));
    const buttons = element('div', { className: 'buttons' }, why, helps);
    this.why = why;
    this.headline = element('article', { className: 'panel wide headline of-line', id: 'headline' }, worded('h2', 'headline', { className: 'away' }), element('p', { className: 'large' }, this.large, this.until), element('div', {}, this.verdict, buttons));
    this.cause = element('div', { id: 'cause' });
    this.curve = element('div', { className: 'curve', id: 'traffic-curve' });
    const header = element('header', {}, worded('h2', 'why_there'));
    offer(header, () => (this.answer ? { name: 'growth-under-traffic', plot: this.curve } : null), save);
    this.panel = element('article', { className: 'panel of-line', id: 'cause-panel', tabIndex: -1 }, header, this.cause, worded('h3', 'traffic_curve'), this.curve);
    view.prepend(this.headline);
    view.querySelector('.loop-panel').after(this.panel, this.remedies.panel);
  }

  /** Ask anew, once the map stands still; both answers of before pale. */
  ask() {
    this.stale('line');
    this.stale('remedies');
    this.calm.stop();
    this.rest.begin();
  }

  /** Whether a question waits until nothing changes. */
  get isWaiting() {
    return this.rest.isWaiting || this.calm.isWaiting;
  }

  #ask() {
    const show = (answer) => {
      this.#show(answer);
      if (this.rest.isWaiting || this.line.pending || !this.state.current) return;
      this.fresh('line');
      this.onHeadline(placeOf(answer));
    };
    this.line.ask(this.question(), (answer) => {
      show(answer);
      this.calm.begin();
    }, (fault) => show({ fault }));
  }

  #rank() {
    if (!this.state.current) return;
    this.ranking.ask({ ...this.question(), costs: this.remedies.costs }, (answer) => {
      if (this.isWaiting || this.ranking.pending) return;
      this.remedies.show(answer);
      this.remedies.askLikelihood();
      this.fresh('remedies');
      this.#tell();
    }, (fault) => this.onFault(fault));
  }

  #show(answer) {
    this.answer = answer;
    this.remedies.answer = null;
    this.#tell();
    this.announce(this.verdict.textContent);
  }

  #tell() {
    const { answer } = this;
    if (!answer) return;
    const { fastest, doubles_in: time, cause, card: evidence, unstable_frequency_hz: oscillates } = answer;
    const helps = this.remedies.answer?.helps_most;
    const doubts = this.remedies.unexplained();
    this.verdict.textContent = inSentences(answer.fault ? [answer.fault.message] : [...doubts, ...answer.notes, ...(helps && !doubts.length ? [helps] : [])]);
    const isTooFast = fastest?.faster_than_known;
    this.large.textContent = time ? (isTooFast || oscillates ? sentence(inWords(time)) : `In ${inWords(time)}`) : t(answer.fault ? 'not_known' : 'nothing_grows_here');
    this.until.textContent = oscillates ? '' : isTooFast ? t('order_holds') : fastest ? t('until_doubled', fastest.doubling_passages_banded !== null) : '';
    this.why.hidden = !cause;
    this.cause.replaceChildren(evidence ? this.#card(cause, evidence) : element('p', { className: 'why', textContent: t(answer.fault ? 'not_known' : 'no_cause') }));
    translate(this.panel);
    this.draw();
  }

  #card(cause, { title, evidence_for: own, evidence_against: others }) {
    const items = (notes) => notes.map((note) => sentence(inWords(note)));
    const { text, language } = said(cause.measurement);
    return card(cause.mechanism, [element('h3', { textContent: inWords(title) })], [items(own), items(others)], element('span', { textContent: text, lang: language }));
  }

  draw() {
    const curve = this.answer?.curve;
    if (!curve || this.view.hidden) return;
    drawCurves(this.curve, [{ name: t('traffic'), color: palette()[1], width: 2, wavelength_m: curve.map(([wavelength]) => wavelength), growth_rate_per_passage: curve.map(([, rate]) => rate) }]);
  }

  reword() {
    for (const one of [this.headline, this.panel]) translate(one);
    if (this.remedies.answer) this.remedies.show(this.remedies.answer);
    this.#tell();
  }
}
