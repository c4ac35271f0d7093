// What the program refuses, in the labels of the form and the unit of the field.

import { said } from './german.js';
import { get, set, short } from './keys.js';
import { Fault, askOnce } from './server.js';
import { currentLanguage, labelOf, t } from './words.js';

const PREFIXES = { n: 1e-9, µ: 1e-6, u: 1e-6, m: 1e-3, c: 1e-2, k: 1e3, M: 1e6, G: 1e9 };
const plain = (unit) => unit.replace(/[⁰¹²³⁴]/g, (power) => '⁰¹²³⁴'.indexOf(power));

/** Factor to SI of a unit that the program writes for a quantity in `si`. */
function factorOf(unit, si, [shown, factor]) {
  const [own, base] = [plain(unit), plain(si)];
  if (own === plain(shown)) return factor;
  if (own === base) return 1;
  if (own === 'deg' && base === 'rad') return Math.PI / 180;
  return own.slice(1) === base ? PREFIXES[own[0]] : undefined;
}

/** Bounds such as "1 N" in the unit of the field; what was typed stands in quotation marks and stays. */
function inUnitOf(text, field) {
  if (!field?.node?.unit) return text;
  const [shown, factor] = field.shown;
  const unquoted = text.split('"');
  for (let k = 0; k < unquoted.length; k += 2) {
    unquoted[k] = unquoted[k].replace(/(-?\d(?:[\d.,]*\d)?(?:e-?\d+)?) ([A-Za-zµ][\w²³⁴/·]*(?: (?:s|m|m2|s\/m|s\/rad)(?![\w]))?)/g, (all, value, unit) => {
      const own = factorOf(unit, field.node.unit, field.shown);
      const words = () => short((Number(value.replace(',', '.')) * own) / factor);
      return own === undefined ? all : `${currentLanguage() === 'de' ? words().replace('.', ',') : words()} ${shown}`;
    });
  }
  return unquoted.join('"');
}

/** Keys of the case by their labels. */
const named = (text, fields) => text
  .replace(/`([a-z_]+(?:\.[a-z_]+)*)`/g, (all, key) => (fields.has(key) || isTable(fields, key) ? labelOf(key) : all))
  .replace(/(?<![\w"./])[a-z_]+(?:\.[a-z_]+)+(?![\w.])/g, (key) => (fields.has(key) || isTable(fields, key) ? labelOf(key) : key));
const isTable = (fields, key) => [...fields.keys()].some((other) => other.startsWith(`${key}.`));

/** Options of the program, of which the page has none, as plain words. */
const OPTION = /--([a-z]+(?:-[a-z]+)*)/g;
const plainOptions = (text) => text.replace(OPTION, (_, name) => name.replaceAll('-', ' '));

/** Words of the program in the labels of the form. */
export const inLabels = (text, form) => plainOptions(named(text, form.fields));

/** The sentence of a fault and what would be right. */
export function wording(fault, form) {
  if (fault.status === 0) return { text: t('gone'), language: currentLanguage() };
  let { language } = said(fault.message);
  const words = (text) => {
    const { text: spoken, language: own } = said(text);
    if (own === 'en') language = own;
    return inLabels(inUnitOf(spoken, form.fields.get(fault.key)), form);
  };
  // What the program would have one write on its command line helps nobody here.
  const help = fault.help && fault.help.search(OPTION) < 0 ? words(fault.help) : fault.help && t('page_reads');
  const text = [words(fault.message), help && `(${help})`].filter(Boolean).join(' ');
  return { text, language };
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
