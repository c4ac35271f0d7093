// Fields of numbers and what stands on them: the traffic with its vehicles, the columns of a record, dates of earlier ones.

import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { inLanguage, place, withId } from './page.mjs';
import { Columns, decoded, layoutOf } from '../../assets/columns.js';
import { Earlier } from '../../assets/earlier.js';
import { NumberField, UNITS } from '../../assets/number-field.js';
import { Traffic, readTraffic } from '../../assets/traffic.js';
import { meanLoad, readVehicles } from '../../assets/vehicles.js';
import { chooseSpeedUnit } from '../../assets/words.js';

const near = (found, expected, relative = 1e-12) => assert.ok(Math.abs(found - expected) <= relative * Math.abs(expected), `${found} is not ${expected}`);
const visible = (one) => (one.hidden ? null : one.textContent);

/** A field with what it has taken. */
function field(units, low, high, refuse = () => '') {
  const taken = [];
  const troubles = [];
  const one = new NumberField({ id: 'f', word: 'remedy_cost', units: UNITS[units], low, high, accept: (value) => refuse(value) || (taken.push(value), one.show(value ?? null, undefined), ''), onTrouble: () => troubles.push(one.isWrong) });
  one.show(null, undefined);
  return { one, taken, troubles, type: (text) => one.input.enter(text) };
}

test('a field takes a value in any of its units and echoes what it read', () => {
  for (const [units, text, value, echo] of [
    ['force', '50', 50e3, null], ['force', '10,000.5 lbf', 10000.5 * 4.4482216152605, '= 44.48 kN'], ['force', '22 kip', 97860.9, '= 97.86 kN'], ['speed', '28 mph', 28 * 1.609344, '= 45.06 km/h'], ['speed', '25 m/s', 90, '= 90 km/h'], ['speed', '60 kph', 60, '= 60 km/h'],
    ['percent', '30', 0.3, null], ['ratio', '30 %', 0.3, '= 0.3'], ['length', '-1000 ft', -304.8, '= −304.8 m'], ['length', '60 cm', 0.6, '= 0.6 m'], ['millimetres', '2 in', 0.0508, '= 50.8 mm'], ['micrometres', '0.05 mm', 5e-5, '= 50 µm'], ['mass', '10500 kg', 10500, '= 10.5 t'], ['mass', '770 lb', 770 * 0.45359237, '= 0.3493 t'],
    ['stiffness', '8.5', 8.5e6, null], ['stiffness', '12 kN/mm', 12e6, '= 12 MN/m'], ['daily', '1,234.5', 1234.5, '= 1235 1/d'], ['none', '12', 12, null],
  ]) {
    const { one, taken, type } = field(units, -1e9, 1e9);
    type(text);
    assert.equal(taken.length, 1, `${units} ${text}`);
    near(taken[0], value, 1e-6);
    assert.equal(one.input.value, text, 'what was typed stays');
    assert.equal(visible(one.echo), echo, text);
    assert.equal(one.isWrong, false);
  }
});

test('a field refuses what it cannot take, and keeps what was typed', () => {
  for (const [units, text, words] of [
    ['force', '50 kg', 'no unit of this field'], ['force', 'many', '“many” is not a number'], ['daily', '3 kN', 'no unit'], ['none', '3 kN', 'is not a number'], ['daily', '1e9', 'must be 0.01 to 1000000 1/d'], ['daily', '-3', 'must be 0.01 to 1000000 1/d'], ['force', '1e400', 'is not a number'],
  ]) {
    const { one, taken, troubles, type } = field(units, 0.01, 1e6);
    type(text);
    assert.ok(one.fault.textContent.includes(words), `${text}: ${one.fault.textContent}`);
    assert.deepEqual([taken, troubles, one.input.value, one.input.getAttribute('aria-invalid')], [[], [true], text, 'true']);
    assert.ok(one.row.classes.has('wrong'));
    // What is refused stays refused until it is typed anew.
    one.show(3, 1);
    assert.equal(one.input.value, text);
    type('7');
    assert.deepEqual([one.isWrong, one.input.getAttribute('aria-invalid'), one.row.classes.has('wrong')], [false, null, false]);
  }
  const { one, type } = field('none', 0, 9, () => 'not that one');
  type('3');
  assert.equal(visible(one.fault), 'not that one');
});

test('the ends of a range are taken', () => {
  for (const [text, good] of [['0.01', true], ['0.0099', false], ['1000', true], ['1000.1', false]]) {
    const { taken, type } = field('none', 0.01, 1000);
    type(text);
    assert.equal(taken.length === 1, good, text);
  }
});

test('a number that can be read two ways is asked about', () => {
  const { one, taken, type } = field('daily', 0.01, 1e6);
  type('7,500');
  assert.match(visible(one.fault), /7,500/);
  const buttons = one.fault.inside.filter(({ tagName }) => tagName === 'BUTTON');
  assert.deepEqual(buttons.map(({ textContent }) => textContent), ['7500 1/d', '7.5 1/d']);
  assert.deepEqual(taken, []);
  buttons[0].click();
  assert.deepEqual([taken, one.isWrong, one.input.value], [[7500], false, '7500']);
  // An amount of money in either manner, and out of range once it is chosen.
  const money = field('money', 0.01, 1e3);
  money.type('7.500');
  assert.equal(money.one.isWrong, true);
  money.one.fault.inside[0].click();
  assert.match(visible(money.one.fault), /must be 0.01 to 1000/);
});

test('a value that is a hundred times another is asked about, and what was typed stays for its value alone', () => {
  const { one, type } = field('daily', 0.01, 1e6);
  one.show(6000, 1);
  type('6.000');
  assert.equal(visible(one.echo), '= 6 1/d; before it was 6000 1/d. Is that meant?');
  assert.ok(one.echo.classes.has('far'));
  assert.equal(one.input.value, '6.000');
  one.show(7, 1);
  assert.deepEqual([one.input.value, visible(one.echo)], ['7', null]);
  for (const [before, text, far] of [[100, '1', true], [99, '1', false], [1, '100', true], [1, '99', false]]) {
    one.show(before, 1);
    type(text);
    assert.equal(visible(one.echo) !== null, far, `${before} ${text}`);
  }
});

test('a field shows its value in the unit and the language of the page', () => {
  const { one, type } = field('speed', 0.1, 700);
  type('120 mph');
  assert.equal(visible(one.echo), '= 193.1 km/h');
  chooseSpeedUnit('m/s');
  one.show(193.1208, 80);
  assert.deepEqual([one.input.value, visible(one.echo), one.beside.textContent, one.input.placeholder], ['53.645', null, 'm/s', '22.222']);
  chooseSpeedUnit('km/h');
  inLanguage('de', () => {
    one.show(12.5, 2.1);
    assert.deepEqual([one.input.value, one.input.placeholder], ['12,5', '2,1']);
    type('1.000');
    assert.match(visible(one.fault), /Was ist gemeint\?/);
    type('');
  });
  one.show(null, 'as the case');
  assert.deepEqual([one.input.value, one.input.placeholder], ['', 'as the case']);
  const empty = field('none', 0, 9);
  empty.type(' ');
  assert.deepEqual(empty.taken, [undefined]);
});

// The traffic --------------------------------------------------------------------------------------------

const MAIN_LINE = { speeds_m_per_s: [80 / 3.6, 140 / 3.6], passages_per_day: 6000, in_curve: false, fastest_doubling_days: 96 };

function traffic(usual = MAIN_LINE) {
  const given = [];
  const one = new Traffic(place(), { onChange: (values) => given.push(structuredClone(values)), onTrouble: () => {} });
  one.show(null);
  one.setUsual(usual);
  const field = (name) => one.fields.find((own) => own.name === name);
  const type = (name, text) => field(name).input.enter(text);
  return { one, given, field, type, last: () => given.at(-1) };
}

test('the usual traffic stands in until one is given, and comes back', () => {
  const { one, given, field, type, last } = traffic();
  assert.deepEqual(one.values, { from_km_per_h: 80, to_km_per_h: 140, passages_per_day: 6000, months: 12 });
  assert.deepEqual([one.givenFile, field('passages_per_day').input.placeholder, one.note.hidden], [null, '6000', false]);
  type('passages_per_day', '4000');
  assert.deepEqual(last(), { from_km_per_h: 80, to_km_per_h: 140, passages_per_day: 4000, months: 12 });
  assert.deepEqual([one.givenFile.line, one.note.hidden], [{ passages_per_day: 4000 }, true]);
  type('passages_per_day', '');
  assert.equal(last(), null);
  assert.equal(given.length, 2);
  type('from_km_per_h', '150');
  assert.equal(given.length, 2, 'the lowest speed is above the highest');
  assert.equal(one.troubles.length, 1);
  type('from_km_per_h', '140');
  assert.equal(last().from_km_per_h, 140);
});

test('another line has its own usual traffic, unless one is given', () => {
  const { one, type } = traffic();
  assert.equal(one.setUsual(MAIN_LINE), false);
  assert.equal(one.setUsual({ ...MAIN_LINE, speeds_m_per_s: [40 / 3.6, 70 / 3.6] }), true);
  assert.deepEqual([one.values.from_km_per_h, one.values.to_km_per_h], [40, 70]);
  type('months', '24');
  assert.equal(one.setUsual(MAIN_LINE), false);
  assert.equal(one.values.from_km_per_h, 40);
});

test('speeds between two ends keep the mean and the scatter of even ones', () => {
  const { one, type } = traffic();
  type('passages_per_day', '4000');
  const [{ speed, ...vehicle }] = one.file.vehicle;
  assert.deepEqual(vehicle, { name: 'the wheel of the case', share: 1 });
  near(speed.mean, 110 / 3.6);
  near(speed.standard_deviation, 60 / 3.6 / Math.sqrt(12));
  // Of a width at which a normal distribution would reach below standstill: so many speeds.
  type('from_km_per_h', '36');
  type('to_km_per_h', '144');
  const { speeds } = one.file.vehicle[0];
  assert.equal(speeds.length, 16);
  near(speeds.reduce((sum, { share }) => sum + share, 0), 1);
  const mean = speeds.reduce((sum, { share, speed: own }) => sum + share * own, 0);
  near(mean, 25);
  // n middles of equal parts have √(1 − 1/n²) of the scatter.
  near(Math.sqrt(speeds.reduce((sum, { share, speed: own }) => sum + share * (own - mean) ** 2, 0)), (30 / Math.sqrt(12)) * Math.sqrt(1 - 1 / 256));
  // A quarter of the mean is the widest normal distribution.
  for (const [to, isNormal] of [[90.7, true], [91, false]]) {
    one.show({ from_km_per_h: 36, to_km_per_h: to, passages_per_day: 1, months: 1 });
    assert.equal('speed' in one.file.vehicle[0], isNormal, `${to}`);
  }
  one.show({ from_km_per_h: 36, to_km_per_h: 36, passages_per_day: 1, months: 1 });
  assert.deepEqual(one.file.vehicle[0].speed, { mean: 10 });
  assert.deepEqual(one.speed, ['10 m/s..10 m/s']);
  near(one.meanSpeed, 10);
});

test('growth is told in time and gross tonnes', () => {
  const { one, type } = traffic();
  const passagesOf = (days) => days * 6000;
  for (const [days, time] of [[100, '3.3 months'], [20 * 30.436875, '20 months'], [40 * 30.436875, '3.3 years'], [96, '3.2 months'], [95.9, 'faster than any railway known']]) assert.equal(one.words(passagesOf(days), 50e3).time, time);
  assert.equal(one.words(passagesOf(20), 50e3, false).time, '20 days');
  assert.equal(one.words(passagesOf(31), 50e3, false).time, '1 months');
  const { days, months, megatonnes } = one.span(6e6, 50e3);
  near(days, 1000);
  near(months, 1000 / 30.436875);
  // An axle has two wheels.
  near(megatonnes, (6e6 * 100e3) / 9.80665 / 1e9);
  assert.match(one.words(6e6, 50e3).whole, /^6 million .*\(.*33 months.*61 MGT.*usual/);
  type('passages_per_day', '4000');
  assert.doesNotMatch(one.words(6e6, 50e3).whole, /usual/);
  assert.equal(one.doubling(6e6), '6 million passages, 4.1 years');
  assert.match(one.doubling(6e4), /faster than any railway known/);
});

test('in a curve all wheels of the traffic may run', () => {
  const { one, last } = traffic({ ...MAIN_LINE, in_curve: true });
  assert.equal(one.inCurve.hidden, false);
  one.allWheels.checked = true;
  one.allWheels.enter('on');
  assert.equal(last().all_wheels, true);
  assert.equal(one.givenFile.vehicle[0].curve, true);
  // A case that has no curve any more has one wheel.
  one.setUsual(MAIN_LINE);
  assert.deepEqual([one.inCurve.hidden, one.givenFile.vehicle[0].curve], [true, undefined]);
  one.allWheels.checked = false;
  one.allWheels.enter('on');
  assert.equal(last(), null);
});

const TRAM = { name: 'tram', share: 0.7, from_km_per_h: 40, to_km_per_h: 60 };
const WORKS = { name: 'works car', share: 0.3, from_km_per_h: 20, to_km_per_h: 70, wheel_load_n: 55e3, tractive_ratio: 0.05 };

test('the traffic of a link is read, where it is one', () => {
  const values = { from_km_per_h: 30, to_km_per_h: 70, passages_per_day: 4000, months: 12 };
  assert.deepEqual(readTraffic(values), values);
  assert.deepEqual(readTraffic({ ...values, unknown: 1 }), values);
  assert.equal(readTraffic({ ...values, all_wheels: true }).all_wheels, true);
  assert.equal('all_wheels' in readTraffic({ ...values, all_wheels: 'yes' }), false);
  for (const wrong of [null, 'x', { ...values, from_km_per_h: 71 }, { ...values, passages_per_day: 0 }, { ...values, passages_per_day: 1e7 }, { ...values, to_km_per_h: 701 }, { ...values, months: 0.05 }, { ...values, vehicles: [TRAM] }]) assert.equal(readTraffic(wrong), null, JSON.stringify(wrong));
  const both = readTraffic({ ...values, vehicles: [TRAM, WORKS] });
  assert.deepEqual([both.from_km_per_h, both.to_km_per_h, both.vehicles], [20, 70, [TRAM, WORKS]]);
});

test('vehicles of a link make a traffic or none', () => {
  assert.deepEqual(readVehicles(undefined), []);
  assert.deepEqual(readVehicles([]), []);
  assert.deepEqual(readVehicles([TRAM, { ...WORKS, other: 1 }]), [TRAM, WORKS]);
  for (const wrong of ['x', [TRAM], [TRAM, { ...WORKS, share: 0.31 }], [TRAM, { ...WORKS, name: 'tram' }], [TRAM, { ...WORKS, name: ' ' }], [TRAM, { ...WORKS, from_km_per_h: 71 }], [TRAM, { ...WORKS, wheel_load_n: 0.5 }], [TRAM, { ...WORKS, tractive_ratio: 1 }], [TRAM, { ...WORKS, to_km_per_h: undefined }], [TRAM, null],
    Array.from({ length: 13 }, (_, k) => ({ ...TRAM, name: `${k}`, share: 1 / 13 }))]) assert.equal(readVehicles(wrong), null, JSON.stringify(wrong));
  assert.equal(readVehicles([TRAM, { ...WORKS, share: 0.3019 }]).length, 2);
  assert.equal(readVehicles([{ ...TRAM, share: 1, name: 'x'.repeat(70) }])[0].name.length, 60);
});

test('the mean load goes by shares, with that of the case where a vehicle has none', () => {
  near(meanLoad([TRAM, WORKS], 50e3), 0.7 * 50e3 + 0.3 * 55e3);
  near(meanLoad([{ ...TRAM, share: 1.4 }, { ...WORKS, share: 0.6 }], 50e3), 0.7 * 50e3 + 0.3 * 55e3);
  assert.equal(meanLoad([], 50e3), 50e3);
  assert.equal(meanLoad(undefined, 50e3), 50e3);
});

function twoVehicles() {
  const { one, ...rest } = traffic();
  one.show(readTraffic({ from_km_per_h: 20, to_km_per_h: 70, passages_per_day: 4000, months: 12, vehicles: [TRAM, WORKS] }));
  const typed = (k, name, text) => (name === 'name' ? one.vehicles.rows[k].name : one.vehicles.rows[k].fields.find(({ input }) => input.id === `vehicle-${k}-${name}`).input).enter(text);
  return { one, typed, ...rest };
}

test('vehicles are keys of a traffic file', () => {
  const { one } = twoVehicles();
  const [tram, works] = one.file.vehicle;
  assert.deepEqual(Object.keys(tram), ['name', 'share', 'speed']);
  near(tram.speed.mean, 50 / 3.6);
  assert.deepEqual([works.wheel_load, works.tractive_ratio, works.speeds.length], [55e3, 0.05, 16]);
  assert.deepEqual(one.speed, []);
  near(one.meanSpeed, (0.7 * 50 + 0.3 * 45) / 3.6);
  assert.deepEqual(one.fields.filter(({ row }) => row.hidden).map(({ name }) => name), ['from_km_per_h', 'to_km_per_h']);
  near(one.span(1e6, 50e3).megatonnes, (1e6 * 2 * 51.5e3) / 9.80665 / 1e9);
});

test('vehicles that make no traffic say why', () => {
  for (const [name, texts, words] of [
    ['share', ['0', '-20', '120 %'], 'must be'], ['share', ['40'], 'sum to 110 %'], ['share', [''], 'share'], ['from', ['80'], 'highest speed'], ['to', ['30 knots'], 'no unit'], ['wheel', ['6 t', '3 GN'], 'no unit'], ['wheel', ['5,000'], 'two ways'],
    ['tractive', ['1.2'], 'must be'], ['name', ['', 'tram', ' tram '], 'vehicle'],
  ]) {
    for (const text of texts) {
      const { one, given, typed } = twoVehicles();
      typed(1, name, text);
      const told = [...one.vehicles.place.inside.filter(({ className, hidden }) => className === 'fault' && !hidden)].map(({ textContent }) => textContent);
      assert.equal(told.length, 1, text);
      assert.ok(told[0].includes(words), told[0]);
      assert.deepEqual([one.troubles.length, given.length], [1, 0], text);
    }
  }
});

test('a change of a vehicle is one of the traffic, and an empty field is that of the case', () => {
  const { typed, last } = twoVehicles();
  typed(1, 'wheel', '10,000.5 lbf');
  near(last().vehicles[1].wheel_load_n, 44484.4, 1e-5);
  typed(1, 'wheel', '');
  assert.equal('wheel_load_n' in last().vehicles[1], false);
  typed(1, 'to', '90');
  assert.equal(last().to_km_per_h, 90);
  typed(0, 'name', ' metro ');
  assert.equal(last().vehicles[0].name, 'metro');
});

test('one more vehicle takes half of the last, and what is left keeps its proportions', () => {
  const { one, last } = traffic();
  one.vehicles.add.click();
  assert.deepEqual(last().vehicles, [{ name: 'vehicle 1', share: 1, from_km_per_h: 80, to_km_per_h: 140 }]);
  one.vehicles.add.click();
  one.vehicles.add.click();
  assert.deepEqual(last().vehicles.map(({ name, share }) => [name, share]), [['vehicle 1', 0.5], ['vehicle 2', 0.25], ['vehicle 3', 0.25]]);
  one.vehicles.rows[0].drop.click();
  assert.deepEqual(last().vehicles.map(({ name, share }) => [name, share]), [['vehicle 2', 0.5], ['vehicle 3', 0.5]]);
  one.vehicles.rows[0].drop.click();
  one.vehicles.rows[0].drop.click();
  assert.equal(last().vehicles, undefined);
  for (let k = 0; k < 12; k++) one.vehicles.add.click();
  assert.equal(one.vehicles.add.disabled, true);
});

// Columns of a record ------------------------------------------------------------------------------------

test('a file is read as the program reads it, whatever its encoding', () => {
  const bytes = (...all) => new Uint8Array(all);
  assert.equal(decoded(new TextEncoder().encode('Höhe [µm]')), 'Höhe [µm]');
  assert.equal(decoded(bytes(0x48, 0xf6, 0x68, 0x65, 0x20, 0xb5, 0x6d)), 'Höhe µm');
  assert.equal(decoded(bytes(0xff, 0xfe, 0x48, 0, 0xf6, 0)), 'Hö');
  assert.equal(decoded(bytes(0xfe, 0xff, 0, 0x48, 0, 0xf6)), 'Hö');
  // The end may be within a letter.
  assert.equal(decoded(bytes(0x48, 0xc3)), 'H');
});

test('the layout of a table follows from its first lines', async () => {
  const of = (text) => layoutOf(new Blob([text]));
  const named = async (text) => {
    const { delimiter, decimal, headerLines, names } = await of(text);
    return [delimiter, decimal, headerLines, names];
  };
  assert.deepEqual(await named('position_m,left_um\n0.000,1.2\n0.001,1.3\n'), ['comma', 'point', 1, ['position_m', 'left_um']]);
  assert.deepEqual(await named('\uFEFFWeg [m];Höhe links [mm]\r\n0,000;1,2\r\n0,001;1,3\r\n'), ['semicolon', 'comma', 1, ['Weg [m]', 'Höhe links [mm]']]);
  assert.deepEqual(await named('# made by a trolley\nx\ty\n0\t1\n1\t2\n'), ['tab', 'point', 2, ['x', 'y']]);
  // A line with one number is part of the head.
  assert.deepEqual(await named('trolley,7\nposition_m,left_um\n0,1\n1,2\n'), ['comma', 'point', 2, ['position_m', 'left_um']]);
  assert.deepEqual(await named('0 1 2\n1 2 3\n'), ['space', 'point', 0, ['', '', '']]);
  assert.deepEqual(await named('"a";"b"\n1;2\n3;4\n'), ['semicolon', 'point', 1, ['a', 'b']]);
  const { examples } = await of('a,b\n1,2\n3,4\n5,6\n7,8\n9');
  assert.deepEqual(examples, [['1', '2'], ['3', '4'], ['5', '6']]);
  for (const none of ['Dear all,\nit rains\n', '', '\x89PNG\r\n\x1a\n']) assert.equal(await of(none), null);
  assert.equal((await of(`${Array(30).fill('c').join(',')}\n${Array(30).fill('1').join(',')}\n`)).names.length, 24);
});

test('one column of heights is one, and a decimal comma is no column', async () => {
  const alone = await layoutOf(new Blob(['height\n0,0012\n0,0034\n0,0021\n']));
  assert.deepEqual([alone.delimiter, alone.decimal, alone.headerLines, alone.names, alone.examples.length], ['tab', 'comma', 1, ['height'], 3]);
  assert.equal((await layoutOf(new Blob(['0.1\n0.2\n']))).decimal, 'point');
  // What stands before a comma and rises from line to line is a position.
  assert.equal((await layoutOf(new Blob(['0,12\n1,13\n2,11\n']))).delimiter, 'comma');
});

async function columns(text, chosen) {
  const taken = [];
  const one = new Columns({ onChoose: (format) => taken.push(format) });
  await one.offer(new Blob([text]), chosen);
  const choose = () => withId(one.place, 'columns-use').click();
  return { one, taken, choose, kinds: () => one.rows.map(({ kind, unit }) => [kind.value, unit.value]) };
}

test('columns are guessed by their names and units', async () => {
  for (const [head, guess] of [
    ['position_m,left_um', [['position', 'm'], ['height', 'um']]], ['Weg [km];Höhe links [mm];Höhe rechts [µm]', [['position', 'km'], ['height', 'mm'], ['height', 'um']]], ['km;speed;inner;outer;gauge', [['position', 'km'], ['none', 'um'], ['height', 'um'], ['height', 'um'], ['none', 'um']]],
    ['distance [ft],height [in]', [['position', 'ft'], ['height', 'in']]], ['x (cm),low (nm)', [['position', 'cm'], ['height', 'nm']]],
  ]) {
    const mark = head.includes(';') ? ';' : ',';
    const width = head.split(mark).length;
    const { kinds } = await columns(`${head}\n${Array(width).fill('1').join(mark)}\n${Array(width).fill('2').join(mark)}\n`);
    assert.deepEqual(kinds(), guess, head);
  }
});

test('columns that are chosen are a reader profile of the program', async () => {
  const { one, taken, choose, kinds } = await columns('km;speed;inner;outer;gauge\n0,001;80;1,5;1,6;1435\n0,002;80;1,5;1,6;1435\n');
  one.rows[2].unit.value = 'mm';
  choose();
  assert.deepEqual(taken, [{ delimiter: 'semicolon', decimal: 'comma', header_lines: 1, position: { column: 1, unit: 'km', name: '' }, rails: [{ column: 3, unit: 'mm', name: 'inner' }, { column: 4, unit: 'um', name: 'outer' }] }]);
  assert.equal(one.step.row.hidden, true);
  // As they were chosen for it before.
  const again = await columns('km;speed;inner;outer;gauge\n0,001;80;1,5;1,6;1435\n', { position: { column: 1, unit: 'm' }, rails: [{ column: 5, unit: 'mm' }] });
  assert.deepEqual(again.kinds().map(([kind]) => kind), ['position', 'none', 'none', 'none', 'height']);
  assert.deepEqual([again.kinds()[0][1], again.kinds()[4][1]], ['m', 'mm']);
  // Nothing chosen is told, and asks nothing.
  for (const k of [2, 3]) one.rows[k].kind.enter('none');
  choose();
  assert.match(visible(one.fault), /at least one column/i);
  one.rows[1].kind.enter('position');
  one.rows[2].kind.enter('height');
  choose();
  assert.match(visible(one.fault), /not several/);
  assert.equal(taken.length, 1);
  assert.equal(kinds()[1][1], 'm');
});

test('heights alone have a step of their own', async () => {
  const { one, taken, choose, kinds } = await columns('0,0012\n0,0034\n0,0021\n');
  assert.deepEqual(kinds().map(([kind]) => kind), ['height']);
  assert.equal(one.step.row.hidden, false);
  for (const [text, words] of [['0', /must be 0.001 to 1000 mm/], ['1,000', /1,000/], ['5 kN', /no unit/]]) {
    one.step.input.enter(text);
    assert.match(visible(one.step.fault), words);
    choose();
    assert.deepEqual(taken, []);
  }
  one.step.input.enter('0.5');
  choose();
  assert.deepEqual(taken, [{ delimiter: 'tab', decimal: 'comma', header_lines: 0, spacing: '0.0005 m', rails: [{ column: 1, unit: 'um', name: 'column 1' }] }]);
});

test('what is no table has no columns', async () => {
  const { one } = await columns('Dear all,\n');
  assert.equal(one.place.hidden, true);
  one.open();
  assert.equal(one.place.open, false);
  await one.offer({ name: 'of before a reload' });
  assert.equal(one.place.hidden, true);
});

// Earlier records ----------------------------------------------------------------------------------------

beforeEach(() => sessionStorage.clear());

function earlier(...records) {
  const changes = [];
  const one = new Earlier({ onChange: () => changes.push(1), reading: () => ({}), complain: () => {}, banner: {}, inLabels: undefined });
  one.records = records.map(({ name, upload, spectra = {}, date = '' }) => {
    const field = { input: Object.assign(place('input'), { value: date }), fault: Object.assign(place('p'), { hidden: true }) };
    return { name, upload, spectra, date, field, size: 10, place: place('li'), drop: place('button'), state: place('span'), trouble: place('p'), refused: spectra ? null : { message: 'no table' } };
  });
  const dated = (...days) => {
    one.records.forEach(({ field }, k) => (field.input.value = days[k]));
    one.own.input.validity = { badInput: false };
    one.own.input.enter(days.at(-1));
  };
  return { one, changes, dated };
}

test('a question has the records that can be read, by date where all have one', () => {
  const { one, changes, dated } = earlier({ name: 'last.csv', upload: 1 }, { name: 'older.csv', upload: 2 }, { name: 'notes.txt', upload: 3, spectra: null });
  const files = [{ upload: 1, name: 'last.csv' }, { upload: 2, name: 'older.csv' }];
  assert.deepEqual(one.question, { earlier: files });
  dated('2025-05-01', '2024-05-01', '', '2026-05-01');
  assert.deepEqual(one.question, { earlier: [...files].reverse(), dates: ['2024-05-01', '2025-05-01', '2026-05-01'] });
  assert.equal(changes.length, 1);
  assert.deepEqual(one.since(4000), {}, 'all have a date');
  dated('2025-05-01', '', '', '2026-05-01');
  assert.equal(one.question.dates, undefined);
  assert.deepEqual(one.since(4000), { since: files[0], passages_between: 4000 * 365 });
  assert.deepEqual(earlier().one.question, {});
  assert.equal(earlier().one.kept, null);
});

test('a date that cannot be one of an earlier record is told and not taken', () => {
  const { one, changes, dated } = earlier({ name: 'last.csv', upload: 1 }, { name: 'older.csv', upload: 2 });
  dated('2026-06-01', '', '2026-05-01');
  const [last, older] = one.records.map(({ field }) => field);
  assert.match(visible(last.fault), /before 2026-05-01/);
  assert.equal(last.input.getAttribute('aria-invalid'), 'true');
  inLanguage('de', () => one.reword());
  assert.match(visible(last.fault), /vor dem 2026-05-01/);
  dated('2026-05-01', '', '2026-05-01');
  assert.equal(last.fault.hidden, false, 'the day of the record itself');
  dated('2024-05-01', '2024-05-01', '2026-05-01');
  assert.match(visible(older.fault), /last\.csv/);
  assert.deepEqual([changes.length, one.records[0].date], [0, '']);
  dated('2025-05-01', '2024-05-01', '2026-05-01');
  assert.deepEqual([last.fault.hidden, older.fault.hidden, changes.length], [true, true, 1]);
  // A year that is being typed is none yet.
  dated('2025-05-01', '2024-05-01', '0020-05-01');
  assert.equal(one.date, '2026-05-01');
});

test('spectra of earlier records stand by their dates, the oldest first', () => {
  const rail = (name) => ({ name, spectrum: [name] });
  const { one, dated } = earlier({ name: 'last.csv', upload: 1, spectra: { spectrum: ['one'] } }, { name: 'older.csv', upload: 2, spectra: { rails: [rail('left'), rail('right')] } });
  assert.deepEqual(one.spectra.map(({ words, age, rail: own }) => [words, age, own]), [['last.csv', 0, ''], ['older.csv', 1, 'left'], ['older.csv', 1, 'right']]);
  dated('2025-05-01', '2024-05-01', '2026-05-01');
  assert.deepEqual(one.spectra.map(({ words, age }) => [words, age]), [['2024-05-01', 0], ['2024-05-01', 0], ['2025-05-01', 1]]);
});

test('another record has no earlier ones, and undo brings them back with their dates', () => {
  const { one, dated } = earlier({ name: 'old.csv', upload: 1 });
  dated('2025-05-01', '2026-05-01');
  const { fetch } = globalThis;
  const asked = [];
  globalThis.fetch = async (path) => (asked.push(path), new Response('{}'));
  try {
    const gone = one.forget();
    assert.deepEqual(gone, { date: '2026-05-01', files: [{ file: undefined, name: 'old.csv', date: '2025-05-01', kept: 1 }] });
    assert.deepEqual([one.question, one.date, one.own.input.value, asked], [{}, '', '', ['/api/upload/remove']]);
    one.bringBack({ ...gone, files: [] });
    assert.deepEqual([one.date, one.own.input.value], ['2026-05-01', '2026-05-01']);
  } finally {
    globalThis.fetch = fetch;
  }
});
