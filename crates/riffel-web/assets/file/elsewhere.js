// What the page that is one file does not hold, in place of `measure.js`, `calibrate.js` and `bogie.js`: a sentence that says where it is.

import { element } from './elements.js';
import { t } from './words.js';

for (const part of ['tab-measure', 'tab-calibrate', 'tab-curve', 'view-measure', 'view-calibrate', 'view-curve']) document.getElementById(part).remove();
for (const kind of ['png', 'svg', 'html', 'report']) document.querySelector(`[data-take=${kind}]`).remove();

export function startMeasure({ listen, banner }) {
  const said = element('p', { className: 'fine', id: 'elsewhere' });
  const say = () => (said.textContent = t('elsewhere'));
  say();
  // Last also where the page is one column.
  said.style.order = '99';
  document.querySelector('main').append(said);
  listen((what) => what === 'words' && say());
  return { saveReport: async () => false, take: () => banner.notice(t('elsewhere')), bringBack: () => banner.notice(t('elsewhere')) };
}

export function startBogie() {}

export function startCalibrate({ banner }) {
  const elsewhere = () => banner.notice(t('elsewhere'));
  return { likelihood: () => null, plan: null, take: elsewhere, bringBack: elsewhere };
}
