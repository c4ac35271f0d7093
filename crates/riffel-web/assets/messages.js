// What the program says, in the language and the units of the page.

import { pieces, languageOf } from './wording.js';
import { currentLanguage, inUnits, sentence, t } from './words.js';

/** A message of the program in words, and the language they are in; `shown` gives the words of a key or a quantity. */
export function said(message, shown = inUnits) {
  const language = currentLanguage();
  const text = pieces(message, language).map((piece) => (piece.text === undefined ? piece : shown(piece))).join('');
  // With the minus that the numbers of the page have.
  return { text: text.replace(/(?<=^|[\s(=])-(?=\d)/g, '−'), language: languageOf(message, language) };
}

/** The text alone. */
export const inWords = (message, shown) => said(message, shown).text;

/** Several as a text of sentences. */
export const inSentences = (list) => list.map((one) => sentence(inWords(one))).join(' ');

/** Messages, each of them once and without some others. */
export function once(list, others = []) {
  const known = new Set(others.map((one) => JSON.stringify(one)));
  return list.filter((one) => {
    const count = known.size;
    return known.add(JSON.stringify(one)).size > count;
  });
}

let titles = [];

/** The titles of the lines that come with the page, which are said in its language. */
export const knowTitles = (all) => { titles = all; };

/** The title of a case: of a line that comes with the page in its language, of others as it is written. */
export const titled = (title) => inWords(titles.find(({ english }) => english === title) ?? title);

/** The title of a case by its keys, in quotation marks. */
export const caseTitle = (keys) => (keys.title ? t('quoted', titled(String(keys.title))) : t('untitled'));
