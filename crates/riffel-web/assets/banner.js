// What went wrong, in every view: the fields that are not accepted, with the way to each, and what failed last.

import { element } from './elements.js';
import { currentLanguage, t } from './words.js';

/** How long a notice stays with nothing to do in it [ms]. */
const NOTICE = 20_000;

export class Banner {
  constructor(place, notices) {
    Object.assign(this, { place, notices, fields: [], said: null, shown: '' });
  }

  /** The fields that are not accepted: `label` and `go`, which leads to it; and whether there was a case before, which is still shown. */
  setFields(fields, isShown) {
    Object.assign(this, { fields, isShown });
    this.render();
  }

  /**
   * What failed, in `words` of the language at hand, called when they are shown, that stays `until` the next 'success' of what is done by hand, until a 'case' is accepted, or until it is 'closed'.
   * `ways` are words with what their buttons do.
   */
  say(words, { language, ways = [], until = 'success' } = {}) {
    this.said = { words, language, ways, until };
    this.render();
  }

  /** What was said is obsolete: closed by hand, or by what it stays until. */
  clear(event = 'closed') {
    if (!this.said || (event !== 'closed' && event !== this.said.until)) return;
    this.said = null;
    this.render();
  }

  render() {
    const { fields, isShown, said } = this;
    const text = said?.words();
    const state = JSON.stringify([currentLanguage(), fields.map(({ label }) => label), isShown, text]);
    // Told again only when it has changed: a screen reader reads all of it.
    if (state === this.shown) {
      this.place.querySelectorAll('[data-field]').forEach((button, k) => (button.onclick = fields[k].go));
      return;
    }
    this.shown = state;
    const lines = [];
    if (fields.length) {
      const buttons = fields.map(({ label, go }) => {
        const button = element('button', { type: 'button', className: 'plain small', textContent: label, onclick: go });
        button.dataset.field = '';
        return button;
      });
      lines.push(element('p', {}, element('span', { textContent: t('not_accepted', { count: fields.length, isShown }) }), ...buttons));
    }
    if (said) {
      const ways = said.ways.map(([word, act]) => element('button', { type: 'button', className: 'plain small', textContent: t(word), onclick: () => (this.clear(), act()) }));
      const close = element('button', { type: 'button', className: 'plain small', textContent: '×', ariaLabel: t('close'), onclick: () => this.clear() });
      lines.push(element('p', {}, element('span', { textContent: text, lang: said.language ?? currentLanguage(), className: 'said' }), ...ways, close));
    }
    this.place.replaceChildren(...lines);
    this.place.hidden = !lines.length;
  }

  /** Tell more beside what was told just now. */
  add(text) {
    if (this.notices.hidden) this.notice(text);
    else this.notices.firstChild.textContent += ` ${text}`;
  }

  /** Tell what was done, with the way back. */
  notice(text, undo, more = []) {
    clearTimeout(this.leaving);
    const hide = () => (this.notices.hidden = true);
    const back = element('button', { type: 'button', className: 'plain small', textContent: t('undo'), onclick: () => (hide(), undo()) });
    const close = element('button', { type: 'button', className: 'plain small', textContent: '×', ariaLabel: t('close'), onclick: hide });
    this.notices.replaceChildren(element('span', { textContent: text }), ...more, ...(undo ? [back] : []), close);
    this.notices.hidden = false;
    // What can be undone or selected stays until it is closed.
    if (!undo && !more.length) this.leaving = setTimeout(hide, NOTICE);
  }
}
