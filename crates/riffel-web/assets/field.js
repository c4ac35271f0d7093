// The field: what was predicted of sites whose corrugation is published, beside what was measured there.

import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords } from './messages.js';
import { askOnce, json } from './server.js';
import { number, range, sentence, t, translate } from './words.js';

export function startField({ state, listen, complain, save }) {
  const summary = element('p', { className: 'why', id: 'field-summary' });
  const table = element('table', { className: 'comparison', id: 'field' });
  const header = element('header', {}, worded('h2', 'field'));
  const panel = element('article', { className: 'panel wide', id: 'field-panel' }, header, summary, element('div', { className: 'sideways' }, table));
  offer(header, () => answer && { name: 'field', table }, save, ['csv']);
  document.getElementById('view-paper').append(panel);
  let answer = null;
  let asked = false;

  async function ask() {
    if (asked || state.view !== 'paper') return;
    asked = true;
    try {
      answer = await json(await askOnce('/api/field', {}));
      show();
    } catch (fault) {
      asked = false;
      complain(fault, { what: `${t('field')}: ` });
    }
  }

  /** A number, or two ends of which one may be open. */
  const measured = (value) => {
    if (!Array.isArray(value)) return number(value);
    const [low, high] = value;
    return low === null ? t('up_to', number(high)) : high === null ? t('from_on', number(low)) : range(value);
  };

  function rowOf({ site, what, unit, measured: found, predicted, inside, source }) {
    const band = predicted ? `${number(predicted.median)} (${range(predicted.band_80)})` : t('nothing_grows_here');
    const name = element('th', { scope: 'row', textContent: site, lang: 'en', title: source });
    return row(name, [`${inWords(what)}${inWords(unit) && `, ${inWords(unit)}`}`, band, measured(found), element('td', { textContent: t(inside ? 'inside' : 'outside'), className: inside ? 'good' : 'bad' })]);
  }

  function show() {
    if (!answer) return;
    summary.textContent = sentence(inWords(answer.summary));
    fillTable(table, ['site', 'measured_what', 'predicted_band', 'measured_there', ''].map((word) => word && t(word)), answer.outcomes.map(rowOf));
    translate(panel);
  }

  listen((what) => {
    if (what === 'words') show();
    else if (what === 'view') ask();
  });
}
