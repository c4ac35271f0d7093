// What a script of the page finds around it: wordings and vocabulary of the program, storage, and elements that are held but not laid out.
//
// `node --import ./page.mjs --test` loads it before the tests. RIFFEL is the program.

import { spawn } from 'node:child_process';
import { registerHooks } from 'node:module';
import { createInterface } from 'node:readline/promises';

const ASSETS = new URL('../../assets/', import.meta.url);

/** The module of the wordings, which the program makes of the Fluent files, and what it tells a page that is opened. */
async function served() {
  const program = spawn(process.env.RIFFEL ?? new URL('../../../../target/debug/riffel', import.meta.url).pathname, ['serve', '--port', '0'], { stdio: ['ignore', 'pipe', 'ignore'] });
  try {
    const [url] = await new Promise((done, fail) => {
      program.once('error', fail);
      createInterface({ input: program.stdout }).once('line', (line) => done([line]));
    });
    const [main] = /\/assets\/\w+\/main\.js/.exec(await (await fetch(url)).text());
    const [script, told] = await Promise.all([main.replace('main.js', 'wordings.js'), '/api/vocabulary'].map((path) => fetch(new URL(path, url))));
    return { wordings: await script.text(), vocabulary: await told.json() };
  } finally {
    program.kill();
  }
}

const { wordings, vocabulary } = await served();
const WORDINGS = new URL('wordings.js', ASSETS).href;
registerHooks({
  resolve: (name, context, next) => (name.endsWith('/wordings.js') ? { url: WORDINGS, format: 'module', shortCircuit: true } : next(name, context)),
  load: (url, context, next) => (url === WORDINGS ? { format: 'module', source: wordings, shortCircuit: true } : next(url, context)),
});

/** Storage of a browser. */
class Kept {
  #items = new Map();
  getItem = (name) => this.#items.get(name) ?? null;
  setItem = (name, value) => void this.#items.set(name, String(value));
  removeItem = (name) => void this.#items.delete(name);
  clear = () => this.#items.clear();
}

/** An element without layout: properties, attributes, children and events. */
class Place extends EventTarget {
  children = [];
  dataset = {};
  style = {};
  hidden = false;
  #attributes = new Map();
  #text = '';
  classes = new Set();
  classList = { toggle: (name, is) => (is ? this.classes.add(name) : this.classes.delete(name)), add: (name) => this.classes.add(name), remove: (name) => this.classes.delete(name) };

  constructor(tag) {
    super();
    this.tagName = tag.toUpperCase();
  }

  setAttribute = (name, value) => void this.#attributes.set(name, String(value));
  getAttribute = (name) => this.#attributes.get(name) ?? null;
  removeAttribute = (name) => void this.#attributes.delete(name);
  append = (...more) => void this.children.push(...more);
  prepend = (...more) => void this.children.unshift(...more);
  replaceChildren(...all) {
    this.#text = '';
    this.children = all;
  }

  get textContent() {
    return this.#text + this.children.map((child) => child.textContent ?? child).join('');
  }

  set textContent(text) {
    this.children = [];
    this.#text = String(text);
  }

  /** All elements inside, in their order. */
  get inside() {
    return this.children.filter((child) => child instanceof Place).flatMap((child) => [child, ...child.inside]);
  }

  getContext = () => ({ measureText: (text) => ({ width: 6 * text.length }) });
  toDataURL = (type) => `data:${type};base64,`;
  querySelector = (selector) => this.inside.find(({ className = '' }) => className.split(' ').includes(selector.slice(1))) ?? null;
  contains = (other) => other === this || this.inside.includes(other);
  querySelectorAll = (selector) => this.inside.filter(({ dataset }) => selector === '[data-t]' && dataset.t !== undefined);
  focus() {}
  select() {}

  /** Type a value, or choose one, as by hand. */
  enter(value) {
    this.value = value;
    this.dispatchEvent(new Event('change'));
  }

  click() {
    this.dispatchEvent(new Event('click'));
  }
}

const root = new Place('html');
Object.assign(globalThis, {
  Node: Place,
  HTMLTableCellElement: class extends Place {},
  document: { documentElement: root, querySelectorAll: root.querySelectorAll, getElementById: () => null, createElement: (tag) => new Place(tag), createElementNS: (_, tag) => new Place(tag) },
});
for (const name of ['localStorage', 'sessionStorage']) Object.defineProperty(globalThis, name, { value: new Kept(), configurable: true });
Object.defineProperty(globalThis, 'navigator', { value: { language: 'en-GB' }, configurable: true });

const { chooseLanguage } = await import(new URL('words.js', ASSETS));

export { vocabulary };

/** An element of the page, and the first inside another that has an id. */
export const place = (tag = 'div') => new Place(tag);
export const withId = (within, id) => within.inside.find((one) => one.id === id);

/** Do something in a language of the page. */
export function inLanguage(name, act) {
  chooseLanguage(name);
  try {
    return act();
  } finally {
    chooseLanguage('en');
  }
}
