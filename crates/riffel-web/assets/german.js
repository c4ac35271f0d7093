// Sentences of the program in German, by the catalogue that the program has for itself (crates/riffel-words).

import WORDINGS from './catalogue.js';
import { currentLanguage } from './words.js';

/** A sentence in a sentence in a sentence … */
const DEEPEST = 8;
/** What is longer is data and no sentence. */
const LONGEST = 2000;
/** Name of a value that must be a sentence of the catalogue. */
const SENTENCE = 'sentence';
/** Names of values that stand as they are. */
const AS_WRITTEN = ['case', 'title', 'path', 'file', 'folder', 'key', 'names', 'url', 'choices', 'version', 'assignment'];
/** Name of a value that somebody gave: a number, or a word that stands as it is. */
const GIVEN = 'value';

/** Wordings without values, and those with them in pieces: words at even places, names at odd ones; the longest first, and apart those whose own are marks alone. */
const whole = new Map();
const ofWords = [];
const ofMarks = [];
for (const [english, german] of WORDINGS) {
  if (!english.includes('{')) {
    if (!whole.has(english)) whole.set(english, german);
    continue;
  }
  const pieces = english.split(/[{}]/);
  const own = pieces.filter((_, k) => k % 2 === 0).join('');
  (/\p{L}/u.test(own) ? ofWords : ofMarks).push({ pieces, german: german.split(/[{}]/), own: own.length });
}
for (const entries of [ofWords, ofMarks]) entries.sort((a, b) => b.own - a.own);

const SENTENCE_END = /\. (?=\p{Lu})/u;
/** What may stand at a name; that a sentence is one is told by the catalogue. */
function mayStand(name, value) {
  if (name === 'edition' || name === 'sentence') return value !== '';
  if (name === 'name') return value !== '' && !value.includes(' ');
  if (name === 'what' && value.includes(': ')) return false;
  if (name === 'count' || name === 'number') return /^[-+−.,e0-9]*[0-9][-+−.,e0-9]*$/.test(value);
  return value !== '' && !value.includes('; ') && !SENTENCE_END.test(value);
}

/** The values that make the sentence of a wording; none where it is another. */
function valuesOf(pieces, sentence, at = 0) {
  if (!sentence.startsWith(pieces[at])) return null;
  const rest = sentence.slice(pieces[at].length);
  if (at + 1 === pieces.length) return rest ? null : [];
  const words = pieces[at + 2];
  if (at + 3 === pieces.length && words === '') return mayStand(pieces[at + 1], rest) ? [[pieces[at + 1], rest]] : null;
  for (let end = rest.indexOf(words, 1); end >= 1; end = rest.indexOf(words, end + 1)) {
    const more = mayStand(pieces[at + 1], rest.slice(0, end)) ? valuesOf(pieces, rest.slice(end), at + 2) : null;
    if (more) return [[pieces[at + 1], rest.slice(0, end)], ...more];
    if (end >= rest.length) break;
  }
  return null;
}

/** Whether a value has the file or the key before the sentence in it, as in "a.toml: the radius is …". */
function swallows(pieces, values) {
  if (values.some(([, value], k) => pieces[2 * k].endsWith('`') && value.includes('`'))) return true;
  const isPrefix = pieces[2] === ': ' && pieces[4] === '' && pieces.length === 5;
  if (pieces[0] !== '' || isPrefix) return false;
  const [name, value] = values[0];
  return name !== 'edition' && name !== SENTENCE && (value.includes(': ') || value.endsWith(':'));
}

/** Numbers with the decimal comma; what is quoted, names of files and keys stay. */
function withComma(words) {
  let quoted = null;
  return words.split(/(?<= )/).map((word) => {
    const isWhole = /\.[a-z]|[_/=]/i.test(word);
    return [...word].map((letter, k, all) => {
      if (!quoted && (letter === '"' || letter === '`')) quoted = letter;
      else if (letter === quoted) quoted = null;
      const isDigit = (other) => /^[0-9]$/.test(other ?? '');
      return letter === '.' && !isWhole && !quoted && isDigit(all[k - 1]) && isDigit(all[k + 1]) ? ',' : letter;
    }).join('');
  }).join('');
}

function exact(english, depth, entries) {
  if (whole.has(english)) return whole.get(english);
  for (const { pieces, german } of entries) {
    const values = valuesOf(pieces, english);
    if (!values || swallows(pieces, values)) continue;
    const found = new Map();
    for (const [k, [name, value]] of values.entries()) {
      // A word in quotation marks is one that somebody wrote.
      const isQuoted = /["`'“]$/.test(pieces[2 * k]);
      if (AS_WRITTEN.includes(name) || (isQuoted && !value.includes(' '))) {
        found.set(name, value);
        continue;
      }
      if (name === GIVEN && !isQuoted) {
        found.set(name, withComma(value));
        continue;
      }
      const known = sought(value.trim(), depth - 1);
      if (known !== null) found.set(name, value.replace(value.trim(), () => known));
      else if (name === SENTENCE) break;
      else if (isQuoted) found.set(name, value);
      else found.set(name, value.split(', ').map((part) => sought(part, depth - 1) ?? withComma(part)).join(', '));
    }
    if (found.size === new Set(values.map(([name]) => name)).size) return german.map((piece, k) => (k % 2 ? found.get(piece) : piece)).join('');
  }
  return null;
}

function both(english, [end, begin], depth) {
  const first = sought(english.slice(0, end), depth);
  const rest = first === null ? null : sought(english.slice(begin), depth);
  return rest === null ? null : first + english.slice(end, begin) + rest;
}

function sought(english, depth) {
  if (!english || depth === 0) return null;
  const stop = english.search(SENTENCE_END);
  const sentences = stop < 0 ? null : both(english, [stop + 1, stop + 2], depth);
  if (sentences !== null) return sentences;
  const words = one(english, depth, ofWords);
  if (words !== null) return words;
  const semicolon = english.indexOf('; ');
  const clauses = semicolon < 0 ? null : both(english, [semicolon, semicolon + 2], depth);
  return clauses ?? one(english, depth, ofMarks);
}

/** One wording, with or without a stop, in the middle of a sentence or at its beginning. */
function one(english, depth, entries) {
  const stopped = (text) => exact(text, depth, entries) ?? (text.endsWith('.') ? ((german) => german && `${german}.`)(exact(text.slice(0, -1), depth, entries)) : null);
  const german = stopped(english);
  if (german !== null) return german;
  const small = english[0].toLowerCase() + english.slice(1);
  const capital = small === english ? null : stopped(small);
  return capital === null ? null : capital[0].toUpperCase() + capital.slice(1);
}

/** The German of what the program says; null of what the catalogue does not have. */
export const inGerman = (english) => (english.length > LONGEST ? null : sought(english.trim(), DEEPEST));

/** What the program says, in the language of the page where the catalogue has it, and that language. */
export function said(english) {
  const german = currentLanguage() === 'de' ? inGerman(english) : null;
  return german === null ? { text: english, language: 'en' } : { text: german, language: 'de' };
}

/** The text alone. */
export const inWords = (english) => said(english).text;
