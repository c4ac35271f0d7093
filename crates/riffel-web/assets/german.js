// What the program says, in the language of the page. Each of its answers has the German of its sentences beside them, and the
// pieces of those that name keys and quantities.

import { currentLanguage, inUnits, sentence, t } from './words.js';

const known = new Map();
const inPieces = new Map();

/** An answer, whose German and pieces are kept. */
export function heard(answer) {
  for (const [english, german] of Object.entries(answer.german ?? {})) known.set(english, german);
  for (const [english, pieces] of Object.entries(answer.message_pieces ?? {})) inPieces.set(english, pieces);
  return answer;
}

/**
 * What the program said, in the language of the page where that is known, and that language; `shown` gives the words of a key or
 * a quantity.
 */
export function said(english, shown = inUnits) {
  const german = currentLanguage() === 'de' ? known.get(english.trim()) : undefined;
  const language = german === undefined ? 'en' : 'de';
  const pieces = inPieces.get(english.trim())?.[language];
  const text = pieces ? pieces.map((piece) => (piece.text === undefined ? piece : shown(piece))).join('') : (german ?? english);
  // With the minus that the numbers of the page have.
  return { text: text.replace(/(?<=^|[\s(=])-(?=\d)/g, '−'), language };
}

/** The text alone. */
export const inWords = (english, shown) => said(english, shown).text;

/** Several as a text of sentences. */
export const inSentences = (list) => list.map((one) => sentence(inWords(one))).join(' ');

/** The title of a case by its keys, in quotation marks; those of the lines that come with the page are in its language, others as they are written. */
export const caseTitle = (keys) => (keys.title ? t('quoted', inWords(String(keys.title))) : t('untitled'));
