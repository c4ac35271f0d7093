// Three hints for who is new here, one after the other, each at its place.

import { element, worded } from './elements.js';
import { t, translate } from './words.js';

/** Where each hint belongs, and its word. */
const HINTS = [['handles', 'tour_sliders'], ['map', 'tour_map'], ['tab-measure', 'tour_measure']];
const SPACE = 10;

export class Tour {
  constructor() {
    this.words = element('p', {});
    this.count = element('span', { className: 'fine' });
    this.next = element('button', { type: 'button', className: 'plain small', id: 'tour-next' });
    const close = worded('button', 'close', { type: 'button', className: 'plain small', id: 'tour-close' });
    this.bubble = element('div', { className: 'bubble tour', id: 'tour', hidden: true }, this.words, element('p', {}, this.count, ' ', this.next, ' ', close));
    this.bubble.setAttribute('role', 'dialog');
    this.bubble.setAttribute('aria-labelledby', (this.words.id = 'tour-words'));
    document.body.append(this.bubble);
    this.next.addEventListener('click', () => this.#go(this.at + 1));
    close.addEventListener('click', () => this.end());
    this.bubble.addEventListener('keydown', (event) => event.key === 'Escape' && this.end());
    addEventListener('resize', () => this.#place());
  }

  begin() {
    this.#go(0);
  }

  end() {
    this.#mark(null);
    this.bubble.hidden = true;
  }

  reword() {
    if (!this.bubble.hidden) this.#tell();
  }

  #go(at) {
    if (at === HINTS.length) return this.end();
    this.at = at;
    this.#mark(document.getElementById(HINTS[at][0]));
    this.bubble.hidden = false;
    this.#tell();
    this.next.focus();
  }

  #mark(place) {
    this.marked?.classList.remove('hinted');
    this.marked = place;
    place?.classList.add('hinted');
    place?.scrollIntoView({ block: 'nearest' });
  }

  #tell() {
    translate(this.bubble);
    this.words.textContent = t(HINTS[this.at][1]);
    this.count.textContent = `${this.at + 1} / ${HINTS.length}`;
    this.next.textContent = t(this.at + 1 < HINTS.length ? 'tour_next' : 'tour_done');
    this.#place();
  }

  /** Below its place where there is room, for which the page moves up as far as the place stays in sight; else within it. */
  #place() {
    if (this.bubble.hidden) return;
    const { width, height } = this.bubble.getBoundingClientRect();
    const room = this.marked.getBoundingClientRect();
    const short = room.bottom + 2 * SPACE + height - innerHeight;
    if (short > 0 && room.top >= short) scrollBy(0, short);
    const { left, top, bottom } = this.marked.getBoundingClientRect();
    const below = bottom + SPACE + height <= innerHeight;
    this.bubble.style.left = `${Math.max(8, Math.min(left + SPACE, innerWidth - width - 8))}px`;
    this.bubble.style.top = `${below ? bottom + SPACE : Math.max(8, Math.min(top + 4 * SPACE, innerHeight - height - 8))}px`;
  }
}
