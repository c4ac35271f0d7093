// Words of the page and of the program: wordings filled with values, in every language.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { inLanguage, place, vocabulary } from './page.mjs';
import { caseTitle, inSentences, inWords, knowTitles, once, said, titled } from '../../assets/messages.js';
import { nameOfValue, unitInWords, withNames } from '../../assets/priors.js';
import { fitItems, trendWords } from '../../assets/level-trend.js';
import { words as loopInWords } from '../../assets/phasors.js';
import { decimalMark, languageOf, marked, pieces } from '../../assets/wording.js';
import { labelOf, nameOf, t, wordsOf } from '../../assets/words.js';
import { LANGUAGES } from '../../assets/wordings.js';

const ASSETS = new URL('../../assets/', import.meta.url);
const WHOLE = ['en', 'de'];
const text = (name) => readFileSync(new URL(name, ASSETS), 'utf8');
const scripts = readdirSync(ASSETS, { recursive: true }).filter((name) => name.endsWith('.js'));
const idOf = (key) => `web-${key.replace(/[^a-z0-9]+/gi, '-')}`;

test('every word that a script or the page asks for is there in both languages', () => {
  const asked = /(?:\b(?:t|wordsOf)\(|\bworded\('\w+', |\bdataset\.(?:t|tLabel|tTitle) = |data-t(?:-label|-title)?=)["'](\w[\w./-]*)["']/g;
  const found = [...scripts, 'page.html'].flatMap((name) => [...text(name).matchAll(asked)].map(([, key]) => key));
  assert.ok(found.length > 250, `${found.length}`);
  for (const language of WHOLE) assert.deepEqual(found.filter((key) => !(idOf(key) in LANGUAGES[language].wordings)), []);
});

/** Small words without which English gets nowhere, and which German does not have. */
const ENGLISH = /\b(the|of|and|is|are|at|from|with|by|not|over|under|after|which|that|must|no|wheels?|track|speed|force|growth|now|length|wavelength|choose|give|soft|sleepers?|half|driven|chosen)\b/;
/** Names of keys, standards and sources stay, as do quotations. */
const KEPT = /\b[a-z_]+(?:\.[a-z_]+)+|\b[a-z_]+ = |\b[a-z]+(?:-[a-z]+)+|`[^`]*`|"[^"]*"|„[^“]*“|--[a-z-]+|\([^)]*(?:19|20)\d\d[^)]*\)|Shock and Vibration|Figure \d|riffel [a-z-]+/g;

test('no wording of the page says in German what is English', () => {
  const wordsIn = (wording) => [wording].flat().flatMap((part) => (typeof part === 'string' ? [part] : part.choice !== undefined ? Object.values(part.among).flatMap(wordsIn) : [])).join(' ');
  const { en, de } = LANGUAGES;
  const web = Object.keys(de.wordings).filter((id) => id.startsWith('web-'));
  assert.ok(web.length > 400);
  assert.deepEqual(web.filter((id) => ENGLISH.test(wordsIn(de.wordings[id]).replace(KEPT, ''))), []);
  // A wording of several words that is the same in both was forgotten.
  const same = web.filter((id) => JSON.stringify(de.wordings[id]) === JSON.stringify(en.wordings[id]) && /[a-z]{3,} [a-z]{3,}/.test(wordsIn(de.wordings[id])));
  assert.deepEqual(same, []);
});

/** Keys of a schema with what it says of them. */
function* keysOf(node, key = '') {
  if (node.$ref) return yield* keysOf({ ...vocabulary.schema.$defs[node.$ref.split('/').at(-1)] }, key);
  for (const choice of node.anyOf ?? []) yield* keysOf(choice, key);
  for (const [name, child] of Object.entries(node.properties ?? {})) {
    const own = key ? `${key}.${name}` : name;
    yield [own, child.description];
    yield* keysOf(child, own);
  }
}

test('every key of a case has a name and a hint in German', () => {
  // A page names no files.
  const keys = [...keysOf(vocabulary.schema)].filter(([key]) => !/^(track\.measurement|wheelset\.file)/.test(key));
  assert.ok(keys.length > 150);
  const unnamed = inLanguage('de', () => keys.filter(([key]) => nameOf(key) === key.split('.').at(-1).replaceAll('_', ' ')));
  assert.deepEqual(unnamed.map(([key]) => key), []);
  for (const [key, hint] of keys) {
    assert.equal(languageOf(hint, 'de'), 'de', key);
    assert.notEqual(inLanguage('de', () => inWords(hint)), inWords(hint), key);
  }
});

test('presets tell in German what they are and what is of our own choice', () => {
  for (const { name, title, values } of vocabulary.presets) {
    assert.equal(languageOf(title, 'de'), 'de', name);
    assert.ok(values.length > 0, name);
    for (const { badge, source } of values) {
      // What others have published stays as they are cited.
      if (badge === 'assumed') assert.equal(languageOf(source, 'de'), 'de', `${name}: ${source.english}`);
    }
  }
});

test('values are filled into a wording, numbers with the decimal mark of the language', () => {
  assert.equal(t('read_as', '7.5 kN'), '= 7.5 kN');
  assert.equal(t('no_such_word_at_all'), 'no_such_word_at_all');
  assert.equal(decimalMark('de'), ',');
  assert.equal(marked('0.35 to 1.2, v1.', 'de'), '0,35 to 1,2, v1.');
  const told = { number: '537.5' };
  assert.deepEqual([pieces(told, 'en'), pieces(told, 'de')], [['537.5'], ['537,5']]);
  assert.deepEqual(pieces([told, { text: '1.5 mm', si: 0.0015 }, null], 'de'), ['537,5, ', { text: '1,5 mm', si: 0.0015 }, ', ']);
  assert.deepEqual(pieces({ capital: 'growth' }, 'en'), ['Growth']);
  assert.deepEqual(pieces({ capital: { key: 'wheel.mass' } }, 'en'), [{ text: 'wheel.mass', key: 'wheel.mass' }]);
  assert.deepEqual(pieces({ id: 'no-such-message', english: 'as it was' }, 'de'), ['as it was']);
  assert.deepEqual(pieces({ id: 'no-such-message' }, 'de'), ['no-such-message']);
});

test('a plural and a choice go by their value', () => {
  const of = (count, language = 'en') => inLanguage(language, () => t('holds_variants', count));
  assert.notEqual(of(1).replace('1', ''), of(2).replace('2', ''));
  assert.notEqual(of(1, 'de'), of(1));
  assert.notEqual(t('growth_time', { time: 'a', mass: 'b', isDefault: true }), t('growth_time', { time: 'a', mass: 'b', isDefault: false }));
});

test('a message is in the language of the page where that has words for it', () => {
  const [{ english, ...title }] = vocabulary.titles;
  const both = (message) => [said(message), inLanguage('de', () => said(message))];
  const [own, german] = both({ ...title, english });
  assert.deepEqual(own, { text: english, language: 'en' });
  assert.equal(german.language, 'de');
  assert.match(german.text, /^Hauptstrecke: /);
  assert.deepEqual(both({ id: 'no-such-message', english: 'x' }).map(({ language }) => language), ['en', 'en']);
  assert.equal(languageOf({ capital: title }, 'de'), 'de');
  assert.equal(languageOf('text', 'de'), 'en');
});

test('a minus before a number is that of the numbers of the page', () => {
  assert.equal(inWords('from -3 dB (-0.5) to x-3, key = -1'), 'from −3 dB (−0.5) to x-3, key = −1');
  assert.equal(inWords('-7'), '−7');
});

test('keys and quantities are shown as the reader has them', () => {
  const message = ['mass ', { key: 'wheel.mass' }];
  assert.equal(said(message, ({ key }) => `<${key}>`).text, 'mass , <wheel.mass>');
  assert.equal(inSentences(['it grows', 'it stays']), 'It grows. It stays.');
});

test('a message is told once', () => {
  const [one, other] = [{ id: 'a' }, { id: 'b' }];
  assert.deepEqual(once([one, other, { id: 'a' }]), [one, other]);
  assert.deepEqual(once([one, other], [{ id: 'a' }]), [other]);
});

test('titles of lines that come with the page are in its language, others as they are written', () => {
  knowTitles(vocabulary.titles);
  const [{ english }] = vocabulary.titles;
  assert.equal(titled(english), english);
  const german = inLanguage('de', () => vocabulary.lines.map(({ name, case: { title } }) => `${name}, ${titled(title)}`.split(': ')[0]));
  assert.deepEqual(german, ['main-line, Hauptstrecke', 'freight, Güterstrecke', 'metro, U-Bahn', 'tram, Straßenbahn']);
  assert.equal(inLanguage('de', () => titled('My line')), 'My line');
  assert.equal(caseTitle({ title: 'My line' }), '“My line”');
  assert.equal(inLanguage('de', () => caseTitle({ title: 'My line' })), '„My line“');
  assert.notEqual(caseTitle({}), caseTitle({ title: 'x' }));
});

test('keys have names, with their group where the name alone would not tell', () => {
  assert.equal(labelOf('contact.friction'), 'friction μ');
  assert.equal(inLanguage('de', () => labelOf('contact.friction')), 'Reibung μ');
  assert.equal(labelOf('map.wavelength.points'), 'Wavelengths, points');
  assert.equal(labelOf('track.pad.stiffness'), 'Rail pad, stiffness k');
  assert.equal(inLanguage('de', () => labelOf('track.pad.stiffness')), 'Zwischenlage, Steifigkeit k');
  assert.equal(nameOf('no.such_key'), 'such key');
  assert.equal(wordsOf('verdict_columns').length, wordsOf('verdict_columns').filter(Boolean).length);
});

test('uncertain values of a calibration have the names of the page', () => {
  assert.equal(nameOfValue('track.pad.stiffness'), 'Rail pad, stiffness k');
  assert.equal(nameOfValue('track.pad.stiffness (tram)'), 'Rail pad, stiffness k (tram)');
  assert.match(nameOfValue('growth.discrepancy'), /growth/);
  assert.notEqual(nameOfValue('vehicle.speed.mean'), 'mean');
  assert.equal(withNames('the chains disagree on track.pad.stiffness: R̂ is 1.1', ['track.pad', 'track.pad.stiffness']), 'the chains disagree on Rail pad, stiffness k: R̂ is 1.1');
  assert.notEqual(unitInWords('2 dB per 1e6 passages'), '2 dB per 1e6 passages');
});

test('a course of levels is told by its records, its change and its slope', () => {
  const course = { records: ['2025-05-01', '2026-05-01'], levels_db: [12.06, 17.3], slope_db: 5.24, slope_scatter_db: 0.8, per: 'year' };
  const told = trendWords(course);
  assert.match(told, /^2025-05-01 12\.1 dB, 2026-05-01 17\.3 dB/);
  assert.match(told, /\+5\.2 dB/);
  assert.match(told, /\+5\.2 ± 0\.8 dB a year/);
  assert.match(inLanguage('de', () => trendWords(course)), /12,1 dB.*im Jahr/);
  assert.doesNotMatch(trendWords({ ...course, per: 'record' }), /a year/);
  assert.match(trendWords({ ...course, levels_db: [17.3, 12.06], slope_db: -5.24 }), /−5\.2/);
  // Of a rail that was ground the program has its sentence.
  assert.equal(trendWords({ ...course, ground_before: '2026-05-01', sentence: 'fell' }), 'fell');
});

test('a fit of the wear coefficient is told with what it was fitted to, and may be taken', () => {
  const taken = [];
  const ways = { item: (message) => Object.assign(place('li'), { textContent: inWords(message) }), take: (coefficient) => taken.push(coefficient) };
  const fit = { passages_between: 1.5e6, sentences: ['the coefficient is 3e-9 kg/J', 'by two records'], verdict: 'fitted', coefficient_kg_per_j: 3e-9 };
  const told = (given) => fitItems(given, ways);
  const items = told({ wear_fit: fit });
  assert.match(items[0].textContent, /the last two dated records, over 1\.5 million axle passages/);
  assert.deepEqual(items.slice(1).map(({ textContent }) => textContent), ['the coefficient is 3e-9 kg/J Use it in the case', 'by two records']);
  items[1].inside[0].click();
  assert.deepEqual(taken, [3e-9]);
  assert.match(inLanguage('de', () => told({ wear_fit: fit })[0].textContent), /1,5 Mi.* Achs/);
  // What was not fitted cannot be taken.
  assert.deepEqual(told({ wear_fit: { ...fit, verdict: 'against' } }).flatMap(({ inside }) => inside), []);
  assert.deepEqual(told({ wear_fit: fit, fit_fault: { message: 'no two dates' } }).map(({ textContent }) => textContent), ['no two dates']);
  assert.deepEqual(told({}), []);
});

test('the loop in words says where the force leads and what becomes of the wave', () => {
  const state = { wavelength_m: 0.055, speed_m_per_s: 30, frequency_hz: 545.4, normal_force_n: [0, 100], dissipation_lag_w: [-1, 0.1], growth_rate_per_passage: 1e-6 };
  const told = (more) => loopInWords({ ...state, ...more }, (count, grows) => `${Math.round(count)} ${grows}`);
  assert.match(told(), /55 mm/);
  assert.match(told(), /108 km\/h/);
  assert.match(told(), /545 Hz/);
  assert.match(told(), /90°/);
  assert.match(told(), /693147 true/);
  assert.match(told(), /corrugation grows/);
  assert.match(told({ growth_rate_per_passage: -1e-6 }), /693147 false/);
  assert.match(told({ growth_rate_per_passage: -1e-6 }), /decays/);
  assert.notEqual(told({ dissipation_lag_w: [1, 0.1] }), told());
  assert.notEqual(told({ normal_force_n: [0, -100] }), told());
  assert.notEqual(told({ normal_force_n: [100, 1] }), told());
  assert.match(inLanguage('de', () => told()), /Riffel wächst/);
});
