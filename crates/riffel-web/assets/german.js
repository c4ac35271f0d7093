// What the program says, in the language of the page. Each of its answers has the German of its sentences beside them, and the
// pieces of those that name keys and quantities.

import { currentLanguage, inUnits, sentence } from './words.js';

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
  return { text: pieces ? pieces.map((piece) => (piece.text === undefined ? piece : shown(piece))).join('') : (german ?? english), language };
}

/** The text alone. */
export const inWords = (english, shown) => said(english, shown).text;

/** Several as a text of sentences. */
export const inSentences = (list) => list.map((one) => sentence(inWords(one))).join(' ');
