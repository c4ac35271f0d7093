// The decision over a calibration: what remedies and grinding cost, which pays, and what a further measurement is worth.
import { element, worded } from './elements.js';

export class Decision {
  constructor() {
    this.panels = [];
  }
  offer() {}
  reword() {}
}
