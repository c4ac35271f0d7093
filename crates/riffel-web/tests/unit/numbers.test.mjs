// Numbers as people write them, and as the page writes them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inLanguage } from './page.mjs';
import { readNumber } from '../../assets/numbers.js';
import { chooseSpeedUnit, fileSize, inUnits, number, passages, power, range, sentence, speed, written } from '../../assets/words.js';

const read = (text, language, isMoney) => readNumber(text, language, isMoney);

test('a number with a single mark before three digits can be read two ways', () => {
  for (const [language, text, choices] of [
    ['en', '1,000', ['1000', '1']], ['de', '1.000', ['1000', '1']], ['en', '1000,000', ['1000000', '1000']], ['en', '-7,500', ['-7500', '-7.5']], ['de', '-7.500', ['-7500', '-7.5']],
    ['en', '12,345e3', ['12345e3', '12.345e3']],
  ]) {
    const { choices: found, number: none } = read(text, language);
    assert.equal(none, undefined);
    assert.deepEqual(found.map(Number), choices.map(Number), text);
  }
  assert.equal(read('1,000 kg', 'en').rest, 'kg');
  // Zero before the mark is no thousand.
  assert.equal(read('0,350', 'en').number, '0.350');
  assert.equal(read('0350,125', 'en').number, '0350.125');
  // Two or four digits are no thousands.
  for (const [text, value] of [['1,00', 1], ['1,2345', 1.2345], ['1,5', 1.5]]) assert.equal(Number(read(text, 'en').number), value, text);
});

test('separators of thousands and marks of decimals are those of any language', () => {
  for (const [language, text, value, odd] of [
    ['en', '1,234.5', 1234.5, true], ['en', '1 000', 1000, true], ['en', '350,5', 350.5, true], ['en', '1.000', 1, true], ['en', '12.5', 12.5, false], ['en', '350', 350, false], ['de', '1.234,5', 1234.5, true],
    ['de', "1'000", 1000, true], ['de', '1,000', 1, true], ['de', '0,35', 0.35, false], ['de', '0.35', 0.35, true], ['en', '1.234.567', 1234567, true], ['en', '1,234,567', 1234567, true], ['de', '1.234.567,25', 1234567.25, true],
    ['en', '1\u00a0234\u202f567.5', 1234567.5, true], ['en', '1_000', 1000, true], ['en', '1’000', 1000, true], ['en', '.5', 0.5, false], ['de', ',5', 0.5, false], ['en', '5.', 5, false], ['en', '+3', 3, false], ['en', '−3.5', -3.5, false],
    ['en', '1 234,5', 1234.5, true], ['en', '1e3', 1000, false], ['en', '2.5e−9', 2.5e-9, false], ['de', '2,5E+3', 2500, false],
  ]) {
    const found = read(text, language);
    assert.equal(Number(found.number), value, text);
    assert.equal(Boolean(found.odd), odd, text);
    assert.equal(found.rest, '', text);
  }
});

test('what follows a number is its unit', () => {
  for (const [text, value, rest] of [
    ['770 lb', 770, 'lb'], ['0.35 t', 0.35, 't'], ['18 in', 18, 'in'], ['125 mph', 125, 'mph'], ['22 kip', 22, 'kip'], ['40 %', 40, '%'], ['40%', 40, '%'], ['  50 kN ', 50, 'kN'], ['10,000.5 lbf', 10000.5, 'lbf'], ['35O', 35, 'O'], ['1 0O0', 1, '0O0'],
    ['12 345 kg', 12345, 'kg'], ['1 m/s', 1, 'm/s'],
  ]) {
    const found = read(text, 'en');
    assert.equal(Number(found.number), value, text);
    assert.equal(found.rest, rest, text);
  }
});

test('powers of ten are read as the page and papers write them', () => {
  for (const [text, value, rest] of [['2.5·10⁻⁹', 2.5e-9, ''], ['2.5 × 10^-9 kg/J', 2.5e-9, 'kg/J'], ['1.5·10⁻⁸', 1.5e-8, ''], ['3x10^2', 300, ''], ['3*10⁺²', 300, ''], ['4·10⁷', 4e7, ''], ['4·10⁰¹²³', 4e123, '']]) {
    const found = read(text, 'en');
    assert.equal(Number(found.number), value, text);
    assert.equal(found.rest, rest, text);
  }
  assert.equal(Number(read('2,5 × 10^-9', 'de').number), 2.5e-9);
  // Nothing says that this is a power.
  assert.equal(read('3x10-9', 'en').rest, 'x10-9');
});

test('what is no number is none', () => {
  for (const text of ['', 'many', 'kg', '-', '1e400', '1,23,4', '1.2.3', '1,234.567,8', '1 23', '1,2345.6', '1 000.5.2', '12 34 567', '1 234 5']) {
    const found = read(text, 'en');
    assert.ok(found === null || found.rest !== '', `${text} is read as ${JSON.stringify(found)}`);
  }
  for (const text of ['', 'many', '1e400', '1.2.3', '1,2345.6']) assert.equal(read(text, 'en'), null, text);
});

test('a sum of money with three digits behind its only mark is asked about in both languages', () => {
  for (const language of ['en', 'de']) {
    for (const text of ['1.000', '1,000']) assert.deepEqual(read(text, language, true).choices.map(Number), [1000, 1], `${text} ${language}`);
    assert.equal(read('0.125', 'en', true).choices, undefined);
    assert.equal(Number(read('12.50', 'en', true).number), 12.5);
  }
});

test('numbers are written with three digits in the manner of the language', () => {
  const cases = [[1234.5, '1235', '1235'], [12345.6, '12,346', '12.346'], [0.35, '0.35', '0,35'], [0.000123, '0.000123', '0,000123'], [0.0000123, '1.2·10⁻⁵', '1,2·10⁻⁵'], [1e6, '1.0·10⁶', '1,0·10⁶'], [-3.456, '−3.46', '−3,46'], [0, '0', '0'], [-0, '0', '0'], [NaN, '–', '–'], [Infinity, '–', '–'], [99.96, '100', '100']];
  for (const [value, english, german] of cases) {
    assert.equal(number(value), english);
    assert.equal(inLanguage('de', () => number(value)), german);
  }
  assert.equal(number(12.3456, 5), '12.346');
  assert.equal(number(0.5, 1), '0.5');
  assert.equal(inLanguage('de', () => written('0.35 kN')), '0,35 kN');
});

test('ends that are written alike are one value', () => {
  for (const [ends, words] of [[[47, 88], '47–88'], [[0.3, 0.3], '0,3'], [[49.98, 50.02], '50'], [[-1.2, 3], '−1,2–3'], [[1000.2, 1000.4], '1000']]) assert.equal(inLanguage('de', () => range(ends)), words);
});

test('powers of ten have raised digits', () => {
  for (const [value, words] of [[2.5e-9, '2.5·10⁻⁹'], [-4e12, '−4.0·10¹²'], [0, '0'], [NaN, '–']]) assert.equal(power(value), words);
  assert.equal(power(123456, 3), '1.23·10⁵');
});

test('sizes of files are readable', () => {
  for (const [size, words] of [[0, '0 B'], [28, '28 B'], [999, '999 B'], [1000, '1 kB'], [2850, '2.85 kB'], [99_999, '100 kB'], [100_000, '0.1 MB'], [1.23e6, '1.23 MB']]) assert.equal(fileSize(size), words);
});

test('passages are told in millions', () => {
  for (const [count, words] of [[950, '950'], [4.63e6, '4.6 million'], [2.51e9, '2.5 billion'], [Infinity, '–'], [1e6, '1 million']]) assert.equal(passages(count), words);
  assert.match(inLanguage('de', () => passages(4.63e6)), /^4,6 Mi/);
});

test('speeds stand in the unit that was chosen', () => {
  assert.equal(speed(25), '90 km/h');
  const piece = { text: '80–140 km/h', speeds_m_per_s: [80 / 3.6, 140 / 3.6] };
  assert.equal(inUnits(piece), '80–140 km/h');
  for (const [unit, one, ends] of [['m/s', '25 m/s', '22.2–38.9 m/s'], ['mph', '55.9 mph', '49.7–87 mph']]) {
    chooseSpeedUnit(unit);
    assert.equal(speed(25), one);
    assert.equal(inUnits(piece), ends);
    // What has no speed stays.
    assert.equal(inUnits({ text: '7 mm' }), '7 mm');
  }
  chooseSpeedUnit('furlongs');
  assert.match(speed(25), /mph$/);
  chooseSpeedUnit('km/h');
});

test('a sentence begins with a capital and ends with a point', () => assert.equal(sentence('it grows'), 'It grows.'));
