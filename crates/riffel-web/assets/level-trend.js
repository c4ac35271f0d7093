// What has become of a rail between its records: levels of a wavelength by date, and the wear coefficient that explains them.

import { element } from './elements.js';
import { inWords } from './messages.js';
import { currentLanguage, passages, t } from './words.js';

/** Decibels with a digit after the point and, where it is a change, with their sign. */
const tenths = (value, sign = '') => `${sign && value >= 0 ? '+' : ''}${value.toLocaleString(currentLanguage(), { minimumFractionDigits: 1, maximumFractionDigits: 1 }).replace('-', '−')}`;

/** "2025-05-01 12.1 dB, 2026-05-01 17.3 dB: +5.2 dB, +5.2 ± 0.8 dB a year"; the sentence of the program where the rail was ground. */
export function trendWords({ records, levels_db: levels, ground_before: ground, slope_db: slope, slope_scatter_db: scatter, per, sentence }) {
  if (ground) return inWords(sentence);
  const points = records.map((record, k) => `${record} ${tenths(levels[k])} dB`).join(', ');
  return t('course', { points, change: tenths(levels.at(-1) - levels[0], '+'), slope: tenths(slope, '+'), scatter: tenths(scatter), isYear: per === 'year' });
}

/**
 * What a forecast says of its fit as items of a list: what it was fitted to and what came of it, or why there is none. `item` makes one of a sentence of the
 * program, `take` puts the coefficient into the case.
 */
export function fitItems({ wear_fit: fit, fit_fault: fault }, { item, take }) {
  if (fault) return [item(fault.message)];
  if (!fit) return [];
  const items = [element('li', { textContent: t('fit_between', passages(fit.passages_between)), lang: currentLanguage() })];
  fit.sentences.forEach((sentence, k) => {
    const one = item(sentence);
    if (k === 0 && fit.verdict === 'fitted') {
      const use = element('button', { type: 'button', className: 'plain small', textContent: t('use_coefficient') });
      use.addEventListener('click', () => take(fit.coefficient_kg_per_j));
      one.append(' ', use);
    }
    items.push(one);
  });
  return items;
}
