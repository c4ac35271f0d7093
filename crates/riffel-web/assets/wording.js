// Messages in the words of a language: their values filled into the wordings of the Fluent files.

import { LANGUAGES } from './wordings.js';

const own = (id, language) => LANGUAGES[language].wordings[id];

/** The codes of all languages. */
export const CODES = Object.keys(LANGUAGES);

/** What stands between the whole part of a number and the rest. */
export const decimalMark = (language) => LANGUAGES[language].decimal_mark;

/** Whether there is a message of an id. */
export const isMessage = (id) => id in LANGUAGES.en.wordings;

/** A number with the decimal mark of a language. */
export const marked = (text, language) => String(text).replace(/(?<=\d)\.(?=\d)/g, decimalMark(language));

/** The language in which a message is said: English where the other has no words for it. */
export function languageOf(said, language) {
  if (said?.capital !== undefined) return languageOf(said.capital, language);
  return said?.id !== undefined && own(said.id, language) !== undefined ? language : 'en';
}

const named = (values, name) => (Object(values) === values ? values[name] : values);

/** One of several wordings: by a number or its plural, by a text, or by `no` for what is not there. */
function chosen({ among, other }, value, language) {
  const name = value ? String(value) : 'no';
  const plural = typeof value === 'number' && new Intl.PluralRules(language).select(value);
  return among[name] ?? among[plural] ?? among[other];
}

const filled = (wording, values, language) => [wording].flat().flatMap((part) => {
  if (typeof part === 'string') return [part];
  if (part.key !== undefined) return [{ text: part.key, key: part.key }];
  if (part.choice !== undefined) return filled(chosen(part, named(values, part.choice), language), values, language);
  return parts(named(values, part.value), language);
});

/** The parts of a value or of a message. */
function parts(said, language) {
  if (said === null || said === undefined) return [];
  if (Array.isArray(said)) return said.flatMap((one, k) => [...(k ? [', '] : []), ...parts(one, language)]);
  if (typeof said !== 'object') return [String(said)];
  if (said.capital !== undefined) {
    const [first, ...rest] = parts(said.capital, language);
    return typeof first === 'string' && first ? [first[0].toUpperCase() + first.slice(1), ...rest] : [first, ...rest];
  }
  if (said.number !== undefined) return [marked(said.number, language)];
  if (said.text !== undefined) return [{ ...said, text: marked(said.text, language) }];
  if (said.key !== undefined) return [{ text: said.key, key: said.key }];
  const wording = own(said.id, language) ?? own(said.id, 'en') ?? said.english ?? said.id;
  return filled(wording, said.values, language);
}

/** The pieces of a message: words, and keys, quantities and speeds as objects, which a reader may show in another way. */
export function pieces(said, language) {
  const all = [];
  for (const part of parts(said, language)) {
    if (typeof part === 'string' && typeof all.at(-1) === 'string') all.push(all.pop() + part);
    else all.push(part);
  }
  // The quotation marks of code belong to the key between them.
  all.forEach((piece, k) => {
    if (piece.key === undefined || !all[k - 1]?.endsWith?.('`') || !all[k + 1]?.startsWith?.('`')) return;
    [all[k - 1], all[k], all[k + 1]] = [all[k - 1].slice(0, -1), { ...piece, text: `\`${piece.text}\`` }, all[k + 1].slice(1)];
  });
  return all;
}

/** A message of an id in words. */
export const worded = (id, values, language) => pieces({ id, values }, language).map((piece) => piece.text ?? piece).join('');
