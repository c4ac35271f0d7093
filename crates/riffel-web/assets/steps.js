// Undo and redo: the cases that were seen, kept for the tab so that a reload loses none.

import { remember, remembered } from './remembered.js';

const STORE = 'riffel-steps';
/** Steps back that are kept. */
const MOST = 100;

export class Steps {
  /** `onChange` is told when there is more or less to undo or redo. */
  constructor(onChange) {
    Object.assign(this, { onChange, past: [], present: null, future: [], gesture: null });
  }

  /** Begin with a case; what was before a reload comes back if it led here. */
  begin(present) {
    const text = JSON.stringify(present);
    const kept = remembered(STORE);
    if (kept && JSON.stringify(kept.present) === text) Object.assign(this, { past: kept.past, future: kept.future });
    this.present = JSON.parse(text);
    this.#tell();
  }

  /** A case that is now open; true if it is a step of its own. Those of one `gesture`, such as a drag, are one step. */
  record(present, gesture = null) {
    const text = JSON.stringify(present);
    if (text === JSON.stringify(this.present)) return false;
    const goesOn = gesture !== null && gesture === this.gesture;
    if (!goesOn) this.past = [...this.past, this.present].slice(-MOST);
    Object.assign(this, { present: JSON.parse(text), future: [], gesture });
    this.#tell();
    return !goesOn;
  }

  /** The case at hand is completed, without a step of its own. */
  amend(present) {
    this.present = structuredClone(present);
    this.#tell();
  }

  /** The gesture has ended. */
  settle() {
    this.gesture = null;
  }

  /** The case before, or after the one at hand; undefined if there is none. */
  undo() {
    return this.#go(this.past, this.future);
  }

  redo() {
    return this.#go(this.future, this.past);
  }

  #go(from, to) {
    if (!from.length) return undefined;
    to.push(this.present);
    this.present = from.pop();
    this.gesture = null;
    this.#tell();
    return structuredClone(this.present);
  }

  #tell() {
    const { past, present, future } = this;
    // Full or forbidden: undo works until the page is left.
    remember(STORE, { past, present, future });
    this.onChange({ undo: past.length > 0, redo: future.length > 0 });
  }
}
