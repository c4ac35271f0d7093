// Numbers as people write them: with the separators of their language, and never taken for another.

import { element } from './elements.js';
import { decimalMark } from './wording.js';
import { currentLanguage, t, written } from './words.js';

/** Signs that only ever part thousands, in any language; a plain space does where three digits follow. */
const NUMBER = /^([+\-−]?)((?:[\d.,'’_\u00a0\u2009\u202f]|(?<=\d) (?=\d{3}(?!\d)))*\d[.,]?)([eE][+\-−]?\d+)?\s*(.*)$/s;
const GROUPED = /^\d{1,3}(?:[^\d.,]\d{3})+(?:[.,]\d*)?$/;
const proper = (text, mark) => text.split(mark).every((group, k) => (k ? group.length === 3 : group.length >= 1 && group.length <= 3) && /^\d+$/.test(group));

const RAISED = '⁰¹²³⁴⁵⁶⁷⁸⁹';
/** Powers of ten as the page and papers write them, 2.5·10⁻⁹ or 2.5 x 10^-9, as the exponent of a program. */
const withExponent = (text) => text.replace(/(\d)\s*[·×x*]\s*10(?:\^([+\-−]?\d+)|([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+))/, (_, digit, plain, raised) =>
  `${digit}e${plain ?? raised.replace('⁻', '-').replace('⁺', '').replace(/[^-]/g, (sign) => RAISED.indexOf(sign))}`);

/**
 * Read a number with what follows it. The answer holds `number`, as a program writes it, and `rest`; `odd` where
 * it was not written as a program would. One that can be read two ways has `choices` in place of the number, as has a sum of
 * money with three digits behind its only mark. Null where no number begins.
 */
export function readNumber(text, language = currentLanguage(), isMoney = false) {
  const [, sign, body, exponent = '', rest] = NUMBER.exec(withExponent(text.trim())) ?? [];
  if (body === undefined || !Number.isFinite(Number(`1${exponent.replace('−', '-')}`))) return null;
  const whole = (digits) => `${sign.replace('−', '-').replace('+', '')}${digits.replace(/\.$/, '')}${exponent.replace('−', '-')}`;
  const read = (digits, odd) => ({ number: whole(digits), rest, odd });
  const spaced = /[^\d.,]/.test(body);
  if (spaced && !GROUPED.test(body)) return null;
  const digits = body.replace(/[^\d.,]/g, '');
  const marks = digits.replace(/\d/g, '');
  if (!marks) return read(digits, spaced);
  const last = marks.at(-1);
  const other = last === ',' ? '.' : ',';
  if (spaced) return marks.length > 1 ? null : read(digits.replace(',', '.'), true);
  if (marks.includes(other)) {
    // 1,234.5: the last is that of the decimals.
    const [before, after] = digits.split(last);
    return marks.indexOf(last) === marks.length - 1 && proper(before, other) ? read(`${before.replaceAll(other, '')}.${after}`, true) : null;
  }
  if (marks.length > 1) return proper(digits, last) ? read(digits.replaceAll(last, ''), true) : null;
  const [before, after] = digits.split(last);
  const decimal = `${before || '0'}.${after}`;
  const threefold = after.length === 3 && /^[1-9]\d*$/.test(before);
  if (last === decimalMark(language) && !(isMoney && threefold)) return read(decimal, threefold);
  return threefold ? { choices: [whole(before + after), whole(String(Number(decimal)))], rest } : read(decimal, true);
}

/** Ask at a place which of two numbers was meant; `take` is told. */
export function askWhich(place, text, { choices, rest }, unit, take) {
  const buttons = choices.map((choice) => {
    const button = element('button', { type: 'button', className: 'plain small', textContent: [written(choice), rest || unit].filter(Boolean).join(' ') });
    button.addEventListener('click', () => take(choice));
    return button;
  });
  place.lang = currentLanguage();
  place.replaceChildren(t('two_ways', text), ' ', ...buttons);
  place.hidden = false;
}
