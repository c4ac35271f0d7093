// Earlier records of the measured rail, with their dates: what has grown since.

import { element, worded } from './elements.js';
import { remember, remembered } from './remembered.js';
import { addRow, held, tell, underWay } from './sent-files.js';
import { Fault, askOnce, cancelled, discard, json, send } from './server.js';
import { currentLanguage, fileSize, t, translate } from './words.js';

/** Where a reload finds names and dates of the records that the program keeps for this page. */
const EARLIER = 'riffel-earlier';
/** Most records that the program takes. */
const MOST = 6;
const DAY = 24 * 3600 * 1000;
/** No rail was measured in this way before; a year that is being typed is earlier still. */
const FIRST_DATE = '1900-01-01';

/** Date fields that were made, for their names. */
let dateFields = 0;

/** A day as a date field has it, once its year is whole. */
const isDay = (text) => /^\d{4}-\d\d-\d\d$/.test(text) && text >= FIRST_DATE;

export class Earlier {
  /** `onChange` is told that there are other records or dates; `reading` gives the columns and the part of the line that were chosen, `inLabels` puts keys of the program into those of the form. */
  constructor({ onChange, reading, complain, banner, inLabels }) {
    Object.assign(this, { onChange, layout: reading, complain, banner, inLabels, records: [], date: '', rail: 0 });
    this.own = this.#dateField('record-date');
    this.ownRow = element('div', { className: 'earlier-record' }, worded('label', 'measured_on', { htmlFor: 'record-date' }), this.own.input, this.own.fault);
    this.list = element('ul', { className: 'earlier-records', id: 'earlier-records' });
    this.input = element('input', { type: 'file', id: 'earlier-file', className: 'away', multiple: true, accept: '.csv,.txt,.tsv,.dat,.asc,text/plain,text/csv' });
    this.choose = worded('label', 'add_earlier', { htmlFor: 'earlier-file', className: 'plain', id: 'add-earlier' });
    this.hint = worded('span', 'earlier_hint', { className: 'fine' });
    this.place = element('div', { className: 'earlier', id: 'earlier', hidden: true }, this.ownRow, this.list, element('div', { className: 'buttons' }, this.input, this.choose, this.hint));
    this.input.addEventListener('change', () => {
      this.add([...this.input.files]);
      this.input.value = '';
    });
    this.#restore();
  }

  /** There is a record, or there is none, to which earlier ones belong. */
  offer(isThere) {
    this.place.hidden = !isThere;
    this.#show();
  }

  /** Another record has taken the place of that to which these belong: what `bringBack` takes, null if there were none. */
  forget() {
    const gone = this.kept;
    this.coming?.abort();
    for (const { upload } of this.records) if (upload !== undefined) discard(upload).catch(() => {});
    // Files on their way belong to the rail before.
    Object.assign(this, { records: [], date: '', rail: this.rail + 1 });
    this.own.input.value = '';
    this.own.fault.hidden = true;
    this.#keep();
    this.#show();
    return gone;
  }

  /** The files, or the numbers by which the program has them, with their dates, and that of the record; null if there are none. */
  get kept() {
    return this.records.length ? { date: this.date, files: this.records.map(({ file, name, date, upload }) => ({ file, name, date, kept: upload })) } : null;
  }

  /** The record to which these belonged is back: send them again, with their dates. */
  bringBack({ date, files }) {
    this.date = this.own.input.value = date;
    return this.#sendAll(files);
  }

  /** Those that could be read, by date where all have one. */
  get good() {
    const good = this.records.filter(({ spectra }) => spectra);
    return good.every(({ date }) => date) ? [...good].sort((a, b) => (a.date < b.date ? -1 : 1)) : good;
  }

  /** What a question has of them, with the dates of all records where all have one. */
  get question() {
    const earlier = this.good.map(({ upload, name }) => ({ upload, name }));
    const dates = [...this.good.map(({ date }) => date), this.date];
    return earlier.length ? { earlier, ...(dates.every(Boolean) && { dates }) } : {};
  }

  /** Where not all have a date, the latest that has one, and the axle passages since then under so many a day. */
  since(daily) {
    const dated = this.good.filter(({ date }) => date);
    if (!this.date || !dated.length || this.question.dates) return {};
    const { upload, name, date } = dated.reduce((latest, one) => (one.date > latest.date ? one : latest));
    return { since: { upload, name }, passages_between: (daily * (Date.parse(this.date) - Date.parse(date))) / DAY };
  }

  /** Their spectra: name of a rail, date or else name of the file, levels; the oldest first. */
  get spectra() {
    return this.good.flatMap(({ spectra, date, name }, age) => {
      const rails = spectra.rails?.length ? spectra.rails : [{ name: '', spectrum: spectra.spectrum }];
      return rails.map((rail) => ({ rail: rail.name, words: date || name, age, spectrum: rail.spectrum }));
    });
  }

  /** Take files whose dates are still to be told. */
  add(files) {
    return this.#sendAll(files.map((file) => ({ file, date: '' })));
  }

  /** Send files, one after the other, as long as the rail is the same. */
  async #sendAll(files) {
    const { rail } = this;
    for (const { file, date } of files) {
      if (this.rail !== rail) return;
      if (this.records.length >= MOST) {
        this.banner.say(() => t('most_earlier', { most: MOST, name: file.name }), { until: 'closed' });
        return;
      }
      await this.#send(file, date);
    }
  }

  async #send(file, date) {
    const record = this.#record({ file, name: file.name, size: file.size, date });
    this.records.push(record);
    this.#show();
    this.coming = send(file, (share) => (record.state.textContent = underWay(share)));
    try {
      Object.assign(record, { upload: await this.coming.done, isAsked: true });
    } catch (fault) {
      this.records = this.records.filter((other) => other !== record);
      this.#show();
      if (fault instanceof Fault) this.complain(fault, { what: `${file.name}: ` });
      return;
    } finally {
      this.coming = null;
    }
    // Meanwhile another record may have come, which these do not belong to.
    if (!this.records.includes(record)) return;
    this.#keep();
    await this.#read(record);
    this.onChange();
  }

  /** Ask what a record says; one that cannot be read says why, and is left out. */
  async #read(record) {
    record.isAsked = true;
    record.state.textContent = t('computing');
    // Other columns may be chosen before it is read: the last question counts.
    const turn = (record.turn = (record.turn ?? 0) + 1);
    let [spectra, refused] = [null, null];
    try {
      spectra = await json(await askOnce('/api/ask/roughness', { file: { upload: record.upload, name: record.name }, ...this.layout() }));
    } catch (fault) {
      if (!(fault instanceof Fault) && !cancelled(fault)) throw fault;
      refused = fault instanceof Fault ? fault : { message: t('stopped_once') };
    }
    if (record.turn !== turn) return;
    Object.assign(record, { spectra, refused });
    this.#show();
  }

  /** Read all anew, by other columns or after a reload. */
  async reread() {
    for (const record of [...this.records]) if (record.upload !== undefined) await this.#read(record);
  }

  /** After a reload the files are there and their spectra are not: a promise that they are, or null. */
  get comingBack() {
    if (this.records.some(({ upload, isAsked }) => upload !== undefined && !isAsked)) this.reading ??= this.reread().finally(() => (this.reading = null));
    return this.reading ?? null;
  }

  #remove(record) {
    this.records = this.records.filter((other) => other !== record);
    if (record.upload === undefined) this.coming?.abort();
    else discard(record.upload).catch((fault) => this.complain(fault, { what: `${record.name}: ` }));
    this.#checkDates();
    this.#keep();
    this.#show();
    this.input.focus();
    this.onChange();
  }

  // Dates ------------------------------------------------------------------------------------------------

  #dateField(id) {
    const input = element('input', { type: 'date', id, min: FIRST_DATE });
    const fault = element('p', { className: 'fault', id: `${id}-fault`, hidden: true });
    input.setAttribute('aria-describedby', fault.id);
    // While the year is typed it is the year 2 or 20, which nobody means.
    input.addEventListener('change', () => (!input.value || isDay(input.value)) && !input.validity.badInput && this.#dated());
    input.addEventListener('blur', () => (input.validity.badInput || (input.value && !isDay(input.value))) && this.#tell({ input, fault }, t('no_date')));
    return { input, fault };
  }

  #tell({ input, fault }, sentence) {
    Object.assign(fault, { hidden: !sentence, textContent: sentence, lang: currentLanguage() });
    input.setAttribute('aria-invalid', String(Boolean(sentence)));
  }

  /** The dates as they stand in the fields: taken if they can be those of the records, in any order. */
  #dated() {
    if (!this.#checkDates()) return;
    const changed = this.date !== this.own.input.value || this.records.some(({ date, field }) => date !== field.input.value);
    this.date = this.own.input.value;
    for (const record of this.records) record.date = record.field.input.value;
    if (!changed) return;
    this.#keep();
    this.onChange();
  }

  #checkDates() {
    const own = this.own.input.value;
    const seen = new Map();
    let good = true;
    this.#tell(this.own, '');
    for (const { name, field } of this.records) {
      const date = field.input.value;
      const refusal = date && own && date >= own ? t('date_not_before', own) : date && seen.has(date) ? t('date_twice', { date, name: seen.get(date) }) : '';
      this.#tell(field, refusal);
      seen.set(date, name);
      good &&= !refusal;
    }
    return good;
  }

  // Showing them -----------------------------------------------------------------------------------------

  /** A record and its row; one that a reload found has no `file`. */
  #record({ file, name, size, date, upload }) {
    const field = this.#dateField(`earlier-date-${++dateFields}`);
    field.input.value = date;
    const record = { file, name, size, date, upload, spectra: null, refused: null, field };
    return addRow(record, () => this.#remove(record), { fields: [field.input], faults: [field.fault], className: 'earlier-record' });
  }

  #show() {
    this.ownRow.hidden = this.hint.hidden = !this.records.length;
    this.choose.classList.toggle('off', this.records.length >= MOST);
    this.input.disabled = this.records.length >= MOST;
    for (const record of this.records) {
      record.field.input.setAttribute('aria-label', `${record.name}, ${t('measured_on')}`);
      const byColumns = (sentence) => (this.layout().format ? `${sentence.replace(/\.?$/, '.')} ${t('by_columns')}` : sentence);
      tell(record, record.spectra && fileSize(record.size), this.inLabels, byColumns);
    }
    // Rows that are there stay in place: one may be typed into.
    const places = this.records.map(({ place }) => place);
    if (places.length !== this.list.children.length || places.some((place, k) => this.list.children[k] !== place)) this.list.replaceChildren(...places);
  }

  reword() {
    translate(this.place);
    this.#checkDates();
    this.#show();
  }

  #keep() {
    const records = held(this.records);
    remember(EARLIER, records.length ? { date: this.date, records } : null);
  }

  #restore() {
    const { date, records } = remembered(EARLIER) ?? { date: '', records: [] };
    this.date = this.own.input.value = date;
    this.records = records.map((record) => this.#record(record));
  }
}
