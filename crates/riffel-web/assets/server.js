// Questions to the program. Of each kind only the newest is wanted: an older one that is still under way
// gives up its place, here by AbortController and there by the name of this page.

import { inside, reach } from './transport.js';

const NAME = 'riffel-page';
/** How long a reload may take to give back the name of the page [ms]. */
const HANDING_OVER = 400;

/** The name of this page. A reload keeps it, and with it the file that was sent; a copy of the tab gets another. */
async function ownName() {
  const fresh = crypto.randomUUID?.() ?? Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16)).join('');
  try {
    const before = sessionStorage.getItem(NAME);
    if (before && (await holds(before))) return before;
    sessionStorage.setItem(NAME, fresh);
  } catch {
    // Without storage a reload begins anew.
  }
  holds(fresh);
  return fresh;
}

/** Hold the lock of a name as long as the page lives; false if another page has it. */
function holds(name) {
  // There are locks on this machine alone, or over https.
  if (!navigator.locks) return Promise.resolve(false);
  return new Promise((got) => {
    const signal = AbortSignal.timeout(HANDING_OVER);
    navigator.locks.request(name, { signal }, () => {
      got(true);
      return new Promise(() => {});
    }).catch(() => got(false));
  });
}

const page = await ownName();

/** An error of the case or of the program: a sentence, the key it is about, what would be right. */
export class Fault extends Error {
  constructor({ message, key, help, line }, status) {
    super();
    Object.assign(this, { message, key, help, line, status });
  }
}

/** Counts of what happened to questions, for who wants to watch. */
export const traffic = { asked: 0, answered: 0, superseded: 0, retried: 0 };

/** What is under way, so that it can be shown and broken off. `onChange` is told when that begins and ends. */
export const work = {
  running: new Map(),
  onChange: () => {},
  begin(abort, path) {
    this.running.set(abort, { since: performance.now(), path });
    this.onChange();
  },
  end(abort) {
    this.running.delete(abort);
    this.onChange();
  },
  /** How long the oldest has been under way [ms]; 0 if nothing is. */
  get age() {
    return this.oldest ? performance.now() - this.oldest.since : 0;
  },
  get oldest() {
    return this.running.values().next().value;
  },
  cancel() {
    for (const abort of this.running.keys()) abort.abort('cancelled');
  },
};

/** True for what `work.cancel` broke off. */
export const cancelled = (error) => error === 'cancelled';

/** Ask once, and again where the program is busy. */
async function ask(path, body, signal, headers = {}) {
  for (let attempt = 0; ; attempt++) {
    traffic.asked++;
    let response;
    try {
      response = await reach(path, {
        method: 'POST',
        headers: { 'Content-Type': 'application/json', 'X-Riffel-Page': page, ...headers },
        body: typeof body === 'string' || body instanceof Blob ? body : JSON.stringify(body),
        signal,
      });
    } catch (error) {
      if (signal?.aborted) throw error;
      throw new Fault({ message: 'gone' }, 0);
    }
    if (response.ok) {
      traffic.answered++;
      return response;
    }
    if (response.status === 503 && attempt < 20) {
      traffic.retried++;
      const seconds = Number(response.headers.get('Retry-After')) || 1;
      await new Promise((done) => setTimeout(done, 1000 * seconds * (0.5 + Math.random())));
      signal?.throwIfAborted();
      continue;
    }
    const fault = await json(response).catch(() => ({ message: `${response.status} ${response.statusText}` }));
    throw new Fault(fault, response.status);
  }
}

/** A question on its own: its whole answer. */
export async function askOnce(path, body, headers) {
  const abort = new AbortController();
  work.begin(abort, path);
  try {
    return await ask(path, body, abort.signal, headers);
  } finally {
    work.end(abort);
  }
}

/** A report in a language, as a page to be saved. */
export async function askReport(question, language) {
  const { page } = await json(await askOnce('/api/ask/report', question, { 'Accept-Language': language }));
  return new Blob([page], { type: 'text/html' });
}

/** Let the program remove a file that was sent. */
export const discard = (upload) => askOnce('/api/upload/remove', { upload });

/** How far the work on what was asked at a path is: `done` of `of` steps, of none where nothing is known. */
const UNKNOWN = { done: 0, of: 0 };
export const progress = async (path) => (inside ? UNKNOWN : ask('/api/progress', { subject: path.replace(/^\/api\/(ask\/)?/, '') }).then(json, () => UNKNOWN));

/** How long a question may be under way before a newer one breaks it off [ms]. */
const PATIENCE = 250;

/**
 * A line of questions of one kind. One is under way at a time; of those that come meanwhile the newest is
 * asked next. So a slider that moves faster than the answers come still shows an answer at every moment.
 */
export class Line {
  constructor(path, read) {
    Object.assign(this, { path, read, next: null, running: null });
  }

  /** Ask; `show` is called with the answer, `refuse` with a Fault. */
  ask(body, show, refuse = () => {}) {
    if (this.next) traffic.superseded++;
    this.next = { body, show, refuse };
    if (!this.running) this.#run();
    else if (performance.now() - this.running.since > PATIENCE) this.running.abort.abort();
  }

  get idle() {
    return !this.running && !this.next;
  }

  /** Whether a newer question waits for the one that is under way. */
  get pending() {
    return Boolean(this.next);
  }

  async #run() {
    const { body, show, refuse } = this.next;
    this.next = null;
    const abort = new AbortController();
    this.running = { abort, since: performance.now() };
    work.begin(abort, this.path);
    try {
      const answer = await this.read(await ask(this.path, body, abort.signal));
      show(answer);
    } catch (error) {
      if (cancelled(abort.signal.reason)) {
        this.next = null;
        this.onCancel?.();
      } else if (abort.signal.aborted) traffic.superseded++;
      else if (error instanceof Fault) refuse(error);
      else throw error;
    } finally {
      this.running = null;
      work.end(abort);
      if (this.next) this.#run();
    }
  }
}

/** Send a file as it is, with a report of how far it is: `done` is the number by which the program has it; `abort` breaks off. */
export function send(file, progress) {
  const request = new XMLHttpRequest();
  const done = new Promise((resolve, reject) => {
    request.upload.onprogress = (event) => event.lengthComputable && progress(event.loaded / event.total);
    request.upload.onload = () => progress(1);
    request.onload = () => {
      let answer;
      try {
        answer = JSON.parse(request.responseText);
      } catch {
        answer = { message: `${request.status}` };
      }
      if (request.status === 200) resolve(answer.upload);
      else reject(new Fault(answer, request.status));
    };
    request.onerror = () => reject(new Fault({ message: 'gone' }, 0));
    request.onabort = () => reject(new DOMException('aborted', 'AbortError'));
  });
  request.open('POST', '/api/upload');
  request.setRequestHeader('X-Riffel-Page', page);
  request.setRequestHeader('Content-Type', /\.csv$/i.test(file.name) ? 'text/csv' : 'text/plain');
  request.send(file);
  return { done, abort: () => request.abort() };
}

/** An answer in JSON. */
export const json = async (response) => response.json();

/** Head and values of a framed answer. */
export async function framed(response) {
  const bytes = await response.arrayBuffer();
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  return { head, values: new Float32Array(bytes, 4 + length) };
}
