// Questions to the program. Of each kind only the newest is wanted: an older one that is still under way
// gives up its place, here by AbortController and there by the name of this page.

const page = crypto.randomUUID?.() ?? Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16)).join('');

/** An error of the case or of the program: a sentence, the key it is about, what would be right. */
export class Fault extends Error {
  constructor({ message, key, help, line }, status) {
    super(message);
    Object.assign(this, { key, help, line, status });
  }
}

/** Counts of what happened to questions, for who wants to watch. */
export const traffic = { asked: 0, answered: 0, superseded: 0, retried: 0 };

/** Ask once, and again where the program is busy. */
async function ask(path, body, signal, headers = {}) {
  for (let attempt = 0; ; attempt++) {
    traffic.asked++;
    let response;
    try {
      response = await fetch(path, {
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
      if (signal?.aborted) throw new DOMException('superseded', 'AbortError');
      continue;
    }
    const fault = await response.json().catch(() => ({ message: `${response.status} ${response.statusText}` }));
    throw new Fault(fault, response.status);
  }
}

/** A question on its own: its whole answer. */
export const askOnce = (path, body, headers) => ask(path, body, undefined, headers);

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

  async #run() {
    const { body, show, refuse } = this.next;
    this.next = null;
    const abort = new AbortController();
    this.running = { abort, since: performance.now() };
    try {
      const answer = await this.read(await ask(this.path, body, abort.signal));
      show(answer);
    } catch (error) {
      if (abort.signal.aborted) traffic.superseded++;
      else if (error instanceof Fault) refuse(error);
      else throw error;
    } finally {
      this.running = null;
      if (this.next) this.#run();
    }
  }
}

/** Send a file as it is, with a report of how far it is; `abort` breaks off. */
export function send(path, file, progress) {
  const request = new XMLHttpRequest();
  const done = new Promise((resolve, reject) => {
    request.upload.onprogress = (event) => event.lengthComputable && progress(event.loaded / event.total);
    request.onload = () => {
      let answer;
      try {
        answer = JSON.parse(request.responseText);
      } catch {
        answer = { message: `${request.status}` };
      }
      if (request.status === 200) resolve(answer);
      else reject(new Fault(answer, request.status));
    };
    request.onerror = () => reject(new Fault({ message: 'gone' }, 0));
    request.onabort = () => reject(new DOMException('aborted', 'AbortError'));
  });
  request.open('POST', path);
  request.setRequestHeader('X-Riffel-Page', page);
  request.setRequestHeader('Content-Type', /\.csv$/i.test(file.name) ? 'text/csv' : 'text/plain');
  request.send(file);
  return { done, abort: () => request.abort() };
}

export const json = (response) => response.json();

/** Head and values of a framed answer. */
export async function framed(response) {
  const bytes = await response.arrayBuffer();
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  return { head, values: new Float32Array(bytes, 4 + length) };
}
