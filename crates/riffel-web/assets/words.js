// Words of the page, and numbers as engineers write them.

import { CODES, isMessage, marked, worded } from './wording.js';

/** Names that several groups have. */
const GENERAL = new Set(['preset', 'model', 'section', 'beam', 'density', 'loss_factor', 'area', 'grid', 'rotation', 'response', 'hertz', 'mass_per_length']);

let language = [localStorage.getItem('riffel-language'), navigator.language?.slice(0, 2)].find((name) => CODES.includes(name)) ?? 'en';

export const currentLanguage = () => language;

export function chooseLanguage(name) {
  if (!CODES.includes(name)) return;
  language = name;
  localStorage.setItem('riffel-language', name);
  translate();
}

const idOf = (key) => `web-${key.replace(/[^a-z0-9]+/gi, '-')}`;

/** Words of the page, filled with values by their names or with one; what is no key of them stays as it is. */
export function t(key, values) {
  const id = idOf(key);
  return isMessage(id) ? worded(id, values, language) : key;
}

/** The words of a list, which bars part. */
export const wordsOf = (key) => t(key).split(' | ');

/** The key that names a key of the case: its own, or that of its last part. */
const nameKey = (key) => [key, key.split('.').at(-1)].map((one) => `name-${one}`).find((one) => isMessage(idOf(one)));

/** Name of a key of the case. */
export function nameOf(key) {
  const name = nameKey(key);
  return name ? t(name) : key.split('.').at(-1).replaceAll('_', ' ');
}

/** A key as a sentence names it: with its group where the name alone would not tell, as in "Wavelengths, points". */
export function labelOf(key) {
  const parts = key.split('.');
  const alone = isMessage(idOf(`name-${key}`)) && !GENERAL.has(parts.at(-1));
  return alone || parts.length < 2 ? nameOf(key) : `${nameOf(parts.slice(0, -1).join('.'))}, ${nameOf(key)}`;
}

/** Put the words of the present language into the page: data-t for text, data-t-label for labels. */
export function translate(root = document) {
  document.documentElement.lang = language;
  for (const element of root.querySelectorAll('[data-t]')) element.textContent = t(element.dataset.t);
  for (const element of root.querySelectorAll('[data-t-label]')) element.setAttribute('aria-label', t(element.dataset.tLabel));
  for (const element of root.querySelectorAll('[data-t-title]')) element.title = t(element.dataset.tTitle);
  for (const element of root.querySelectorAll('[data-name]')) element.textContent = nameOf(element.dataset.name);
}

/** A number with so many significant digits, in the manner of the language. */
export function number(value, digits = 3) {
  if (!Number.isFinite(value)) return '–';
  const size = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value)));
  if (size >= 6 || size < -4) return power(value);
  const decimals = Math.max(0, digits - 1 - size);
  const rounded = Number(value.toPrecision(Math.max(digits, size + 1))) || 0;
  return rounded.toLocaleString(language, { maximumFractionDigits: Math.min(12, decimals), useGrouping: Math.abs(rounded) >= 1e4 }).replace('-', '−');
}

/** A range by its ends as they are written, one where both are written alike. */
export function range([low, high], shown = (value) => number(value)) {
  const [from, to] = [shown(low), shown(high)];
  return from === to ? from : `${from}–${to}`;
}

/** Units of speed with their size in m/s. */
export const SPEED_UNITS = { 'km/h': 1 / 3.6, 'm/s': 1, mph: 0.44704 };
let speedUnit = 'km/h';
export function chooseSpeedUnit(name) {
  if (!(name in SPEED_UNITS)) return;
  speedUnit = name;
  localStorage.setItem('riffel-speed', name);
}
chooseSpeedUnit(localStorage.getItem('riffel-speed'));

/** Unit of speeds and its size in m/s. */
export const unitOfSpeed = () => [speedUnit, SPEED_UNITS[speedUnit]];

/** A speed [m/s] in that unit. */
export const speed = (value) => `${number(value / SPEED_UNITS[speedUnit])} ${speedUnit}`;

/** A piece of what the program says, which has km/h, with its speeds in that unit. */
export function inUnits({ text, speeds_m_per_s: speeds }) {
  return speeds && speedUnit !== 'km/h' ? `${range([speeds[0], speeds.at(-1)], (value) => number(value / SPEED_UNITS[speedUnit]))} ${speedUnit}` : text;
}

export const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}.`;

/** A number as it stands in a case, with the comma of the language. */
export const written = (text) => marked(text, language);

const RAISED = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };

/** A number with a power of ten. */
export function power(value, digits = 2) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
  const raised = [...String(Number(exponent))].map((c) => RAISED[c]).join('');
  return `${Number(mantissa).toLocaleString(language, { minimumFractionDigits: digits - 1 }).replace('-', '−')}·10${raised}`;
}

/** Size of a file. */
export const fileSize = (bytes) => (bytes < 1000 ? `${bytes} B` : bytes < 100_000 ? `${number(bytes / 1e3)} kB` : `${number(bytes / 1e6)} MB`);

/** A count of passages in words: 4.6 million. */
export function passages(count) {
  if (!Number.isFinite(count)) return '–';
  const [unit, word] = [[1e9, 'billion'], [1e6, 'million']].find(([unit]) => count >= unit) ?? [1];
  const shown = number(Number((count / unit).toPrecision(2)), 2);
  return word ? t(word, shown) : shown;
}
