// How questions are asked: the newest of a kind alone, again where the program is busy, and when nothing changes any more.

import assert from 'node:assert/strict';
import { afterEach, beforeEach, test } from 'node:test';
import './page.mjs';
import { Calm } from '../../assets/calm.js';
import { Fault, Line, askOnce, askReport, cancelled, discard, framed, json, progress, traffic, work } from '../../assets/server.js';

const { fetch } = globalThis;
/** Questions under way: each is answered by hand. */
let open = [];
let counts;

beforeEach(() => {
  open = [];
  counts = { ...traffic };
  globalThis.fetch = (path, { body, headers, signal }) => new Promise((answer, fail) => {
    signal?.addEventListener('abort', () => fail(signal.reason));
    open.push({ path, body, headers, signal, answer: (given, more) => answer(new Response(JSON.stringify(given), more)), fail });
  });
});
afterEach(() => (globalThis.fetch = fetch));

const since = (name) => traffic[name] - counts[name];
/** Until all promises that can be kept are. */
const settled = () => new Promise((done) => setImmediate(done));

test('one question of a kind is under way, and of those that come meanwhile the newest is asked next', async () => {
  const line = new Line('/api/map', json);
  const shown = [];
  for (let k = 0; k < 300; k++) line.ask({ friction: k }, (answer) => shown.push(answer));
  assert.equal(open.length, 1);
  assert.ok(line.pending && !line.idle);
  open[0].answer('first');
  await settled();
  assert.deepEqual(open.map(({ path, body }) => [path, JSON.parse(body).friction]), [['/api/map', 0], ['/api/map', 299]]);
  assert.equal(line.pending, false);
  open[1].answer('last');
  await settled();
  assert.deepEqual(shown, ['first', 'last']);
  assert.ok(line.idle);
  assert.deepEqual([since('asked'), since('answered'), since('superseded')], [2, 2, 298]);
});

test('a question that takes long is broken off by a newer one', async (context) => {
  let now = 0;
  context.mock.method(performance, 'now', () => now);
  const line = new Line('/api/map', json);
  const shown = [];
  const ask = (k) => line.ask({ k }, (answer) => shown.push(answer));
  ask(0);
  now = 250;
  ask(1);
  assert.equal(open[0].signal.aborted, false);
  now = 251;
  ask(2);
  assert.equal(open[0].signal.aborted, true);
  await settled();
  assert.equal(JSON.parse(open[1].body).k, 2);
  open[1].answer('two');
  await settled();
  assert.deepEqual(shown, ['two']);
});

test('a refusal is told, and the next question is asked', async () => {
  const line = new Line('/api/map', json);
  const refused = [];
  line.ask({}, assert.fail, (fault) => refused.push(fault));
  open[0].answer({ message: 'no', key: 'wheel.mass', help: 'yes', line: 3 }, { status: 422 });
  await settled();
  const [fault] = refused;
  assert.ok(fault instanceof Fault);
  assert.deepEqual([fault.message, fault.key, fault.help, fault.line, fault.status], ['no', 'wheel.mass', 'yes', 3, 422]);
  line.ask({}, assert.fail, (other) => refused.push(other));
  open[1].fail(new TypeError('Failed to fetch'));
  await settled();
  assert.deepEqual([refused[1].message, refused[1].status, line.idle], ['gone', 0, true]);
});

test('an answer that is no JSON is told by its status', async () => {
  const asked = askOnce('/api/map', {});
  globalThis.fetch = fetch;
  open[0].answer(undefined, { status: 500, statusText: 'Internal Server Error' });
  await assert.rejects(asked, { message: '500 Internal Server Error', status: 500 });
});

test('a busy program is asked again when it says so, twenty times', async (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  context.mock.method(Math, 'random', () => 0.5);
  const busy = { status: 503, headers: { 'Retry-After': '2' } };
  const asked = askOnce('/api/map', { friction: 0.6 });
  for (let k = 0; k < 20; k++) {
    open[k].answer({ message: 'busy' }, busy);
    await settled();
    context.mock.timers.tick(1999);
    await settled();
    assert.equal(open.length, k + 1);
    context.mock.timers.tick(1);
    await settled();
    assert.equal(open.length, k + 2);
  }
  assert.equal(since('retried'), 20);
  open[20].answer({ message: 'too much' }, busy);
  await assert.rejects(asked, { message: 'too much', status: 503 });
  const again = askOnce('/api/map', {});
  open[21].answer({}, { status: 503 });
  await settled();
  context.mock.timers.tick(1000);
  await settled();
  open[22].answer('there');
  assert.equal(await json(await again), 'there');
});

test('what is under way can be seen and broken off', async (context) => {
  let now = 1000;
  let changes = 0;
  context.mock.method(performance, 'now', () => now);
  work.onChange = () => changes++;
  assert.deepEqual([work.age, work.oldest], [0, undefined]);
  const line = new Line('/api/remedies', json);
  let stopped = 0;
  line.onCancel = () => stopped++;
  line.ask({}, assert.fail);
  const once = askOnce('/api/figure', {});
  now = 1200;
  assert.deepEqual([work.age, work.oldest.path, work.running.size, changes], [200, '/api/remedies', 2, 2]);
  line.ask({}, assert.fail);
  work.cancel();
  await assert.rejects(once, cancelled);
  await settled();
  // What waited for it is dropped, too.
  assert.deepEqual([stopped, open.length, line.idle, work.running.size], [1, 2, true, 0]);
  work.onChange = () => {};
  assert.equal(cancelled(new Error('cancelled')), false);
});

test('a question has the name of the page, and its kind of answer', async () => {
  const [progressOf, report, drop] = [progress('/api/ask/noise'), askReport({ case: 1 }, 'de'), discard(7)];
  assert.deepEqual(open.map(({ path, body }) => [path, JSON.parse(body)]), [['/api/progress', { subject: 'noise' }], ['/api/ask/report', { case: 1 }], ['/api/upload/remove', { upload: 7 }]]);
  assert.equal(open[1].headers['Accept-Language'], 'de');
  assert.equal(new Set(open.map(({ headers }) => headers['X-Riffel-Page'])).size, 1);
  assert.ok(open[0].headers['X-Riffel-Page'].length >= 8);
  open[0].answer({ done: 3, of: 8 });
  open[1].answer({ page: '<p>' });
  open[2].answer({});
  assert.deepEqual(await progressOf, { done: 3, of: 8 });
  const blob = await report;
  assert.deepEqual([await blob.text(), blob.type], ['<p>', 'text/html']);
  await drop;
  const unknown = progress('/api/map');
  assert.deepEqual(JSON.parse(open[3].body), { subject: 'map' });
  open[3].answer({ message: 'no' }, { status: 500 });
  assert.deepEqual(await unknown, { done: 0, of: 0 });
});

test('a framed answer is its head and its values', async () => {
  const head = new TextEncoder().encode('{"a": "µ"}');
  // The values begin where a 32-bit number may.
  const length = Math.ceil(head.length / 4) * 4;
  const bytes = new Uint8Array(4 + length + 8).fill(32);
  new DataView(bytes.buffer).setUint32(0, length, true);
  bytes.set(head, 4);
  bytes.set(new Uint8Array(Float32Array.of(1.5, -2).buffer), 4 + length);
  const found = await framed(new Response(bytes));
  assert.deepEqual([found.head, [...found.values]], [{ a: 'µ' }, [1.5, -2]]);
});

test('what waits for calm begins anew with each change, and comes once', (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  let came = 0;
  const calm = new Calm(200, () => came++);
  calm.begin();
  context.mock.timers.tick(199);
  calm.begin();
  context.mock.timers.tick(199);
  assert.deepEqual([came, calm.isWaiting], [0, true]);
  context.mock.timers.tick(1);
  assert.deepEqual([came, calm.isWaiting], [1, false]);
  calm.begin();
  calm.stop();
  context.mock.timers.tick(1000);
  assert.deepEqual([came, calm.isWaiting], [1, false]);
});
