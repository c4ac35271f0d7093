// What the page that is one file does not hold, in place of `measure.js`, `calibrate.js` and `bogie.js`: a sentence that says where it is.

import { element } from './elements.js';
import { currentLanguage } from './words.js';

const ELSEWHERE = {
  en: 'This page is one file. Measured rails, calibration, bogies in a curve, reports, and maps as PNG, SVG and HTML are on the page that riffel serve opens.',
  de: 'Diese Seite ist eine Datei. Gemessene Schienen, Kalibrierung, Drehgestelle im Bogen, Berichte und Karten als PNG, SVG und HTML hat die Seite, die riffel serve öffnet.',
};

for (const part of ['tab-measure', 'tab-calibrate', 'tab-curve', 'view-measure', 'view-calibrate', 'view-curve']) document.getElementById(part).remove();
for (const kind of ['png', 'svg', 'html', 'report']) document.querySelector(`[data-take=${kind}]`).remove();

export function startMeasure({ listen, banner }) {
  const said = element('p', { className: 'fine', id: 'elsewhere' });
  const say = () => (said.textContent = ELSEWHERE[currentLanguage()]);
  say();
  // Last also where the page is one column.
  said.style.order = '99';
  document.querySelector('main').append(said);
  listen((what) => what === 'words' && say());
  return { saveReport: async () => false, take: () => banner.notice(ELSEWHERE[currentLanguage()]), bringBack: () => banner.notice(ELSEWHERE[currentLanguage()]) };
}

export function startBogie() {}

export function startCalibrate({ banner }) {
  const elsewhere = () => banner.notice(ELSEWHERE[currentLanguage()]);
  return { likelihood: () => null, plan: null, take: elsewhere, bringBack: elsewhere };
}
