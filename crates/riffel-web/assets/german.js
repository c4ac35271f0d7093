// What the program says, in German. Each of its answers has the German of its sentences beside them.

import { currentLanguage } from './words.js';

const known = new Map();

/** An answer, whose German is kept. */
export function heard(answer) {
  for (const [english, german] of Object.entries(answer.german ?? {})) known.set(english, german);
  return answer;
}

/** What the program said, in the language of the page where that is known, and that language. */
export function said(english) {
  const german = currentLanguage() === 'de' ? known.get(english.trim()) : undefined;
  return german === undefined ? { text: english, language: 'en' } : { text: german, language: 'de' };
}

/** The text alone. */
export const inWords = (english) => said(english).text;
