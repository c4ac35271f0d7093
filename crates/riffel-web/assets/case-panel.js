// A panel that follows the case: asked for when its view is shown, pale as long as what it shows is of another question.

import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { caseTitle, inWords, said } from './messages.js';
import { Line, json } from './server.js';
import { sentence, t, translate } from './words.js';

/**
 * `more` is what a question has beside the case, null while there is none, and `at` says it in words; `fill` shows an answer in `plot` and in `below`; `rows` are the
 * table to take away.
 */
export function startCasePanel({ state, listen, inLabels, save }, { view, path, word, more = () => ({}), at = () => '', below = [], fill, rows }) {
  const line = new Line(path, json);
  const of = element('span', { className: 'aside' });
  const words = element('p', { className: 'why', id: `${word}-words` });
  const plot = element('div', { className: 'curve tall', id: word });
  const notes = element('ul', { className: 'fine' });
  const header = element('header', {}, worded('h2', word), of);
  const panel = element('article', { className: 'panel wide', id: `${word}-panel` }, header, words, plot, ...below, notes);
  /** What is shown: the question as text, its keys, and what came of it. */
  let shown = null;
  offer(header, () => shown?.answer && { name: word, plot, rows: rows(shown.answer) }, save);
  document.getElementById(`view-${view}`).append(panel);

  /** The question that is under way. */
  let asked = '';
  line.onCancel = () => (asked = '');

  /** The question now, as text; an empty one while there is none. */
  const now = () => {
    const own = state.accepted && more();
    return own ? JSON.stringify({ case: { keys: state.accepted }, ...own }) : '';
  };
  const pale = () => panel.classList.toggle('stale', Boolean(shown) && shown.question !== now());

  function ask() {
    pale();
    const question = now();
    if (state.view !== view || !question || [asked, shown?.question].includes(question)) return;
    asked = question;
    const keys = state.accepted;
    const take = (answer, fault) => {
      shown = { question, keys, answer, fault };
      if (asked === question) asked = '';
      pale();
      show();
    };
    line.ask(question, (answer) => take(answer, null), (fault) => take(null, fault));
  }

  function show() {
    if (!shown) return;
    const { question, keys, answer, fault } = shown;
    of.textContent = [caseTitle(keys), at(JSON.parse(question))].filter(Boolean).join(', ');
    words.textContent = fault ? said(fault.message, inLabels).text : answer.sentences.map((note) => sentence(inWords(note))).join(' ');
    notes.replaceChildren(...(answer?.notes ?? []).map((note) => element('li', { textContent: inWords(note) })));
    for (const one of [plot, ...below]) one.hidden = !answer;
    if (answer) fill(answer, plot);
    translate(panel);
  }

  listen((what) => {
    if (what === 'words') show();
    else if (what !== 'variants') ask();
  });
}
