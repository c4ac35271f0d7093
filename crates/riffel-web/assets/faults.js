// What the program refuses, in the labels of the form and the unit of the field.

import { said } from './messages.js';
import { get, set, short } from './keys.js';
import { Fault, askOnce } from './server.js';
import { currentLanguage, inUnits, labelOf, nameOf, t, written } from './words.js';

/** An option of the program; the page has none. */
const OPTION = /--[a-z]+(-[a-z]+)*/;

/** Keys of the case by their labels, options as plain words, quantities in the unit of a field. */
export const inLabels = (form, field) => (piece) => {
  const { text, key, si, unit } = piece;
  if (key === undefined) return si !== undefined && unit === field?.node?.unit ? `${written(short(si / field.shown[1]))} ${field.shown[0]}` : inUnits(piece);
  if (OPTION.test(key)) return nameOf(key.slice(2).replaceAll('-', '_'));
  return [...form.fields.keys()].some((own) => own === key || own.startsWith(`${key}.`)) ? labelOf(key) : text;
};

/** The sentence of a fault and what would be right. */
export function wording({ status, key, message, help }, form) {
  if (status === 0) return { text: t('gone'), language: currentLanguage() };
  const shown = inLabels(form, form.fields.get(key));
  const sentence = said(message, shown);
  if (!help) return sentence;
  // What the program would have one write on its command line helps nobody here.
  const advice = OPTION.test(help) ? { text: t('page_reads'), language: currentLanguage() } : said(help, shown);
  return { text: `${sentence.text} (${advice.text})`, language: advice.language === 'en' ? 'en' : sentence.language };
}

/** No form has more fields that are wrong at once. */
const MOST = 12;

/** The program names the first fault of a case: the others, found by mending one after the other with what went before. */
export async function furtherFaults(keys, first, accepted) {
  const [mended, found] = [structuredClone(keys), [first]];
  while (found.length < MOST && found.at(-1).key) {
    const { key } = found.at(-1);
    set(mended, key, get(accepted ?? {}, key));
    try {
      await askOnce('/api/case', { case: { keys: mended } });
      break;
    } catch (fault) {
      if (!(fault instanceof Fault) || fault.status !== 422 || found.some((other) => other.key === fault.key)) break;
      found.push(fault);
    }
  }
  return found;
}
