// The measurements by which a case is calibrated: files that the program keeps for this page, each with what it is taken as.

import { element, worded } from './elements.js';
import { said } from './messages.js';
import { remember, remembered } from './remembered.js';
import { addRow, held, tell, underWay } from './sent-files.js';
import { Fault, discard, send } from './server.js';
import { currentLanguage, fileSize, t, translate } from './words.js';

/** Where a reload finds the names of the files that the program keeps for this page. */
const KEPT = 'riffel-calibration-data';
/** Most files that the program takes. */
const MOST = 6;

export class CalibrationData {
  /** `onChange` is told that there are other files; `plan` asks for the plan of one of them alone. */
  constructor({ onChange, plan, complain, banner, inLabels }) {
    Object.assign(this, { onChange, plan, complain, banner, inLabels, files: [] });
    this.input = element('input', { type: 'file', id: 'calibration-file', className: 'away', multiple: true, accept: '.csv,.txt,.tsv,.dat,text/plain,text/csv' });
    this.input.addEventListener('change', () => {
      this.add([...this.input.files]);
      this.input.value = '';
    });
    this.choose = worded('label', 'choose_data', { htmlFor: 'calibration-file', className: 'plain' });
    this.list = element('ul', { className: 'calibration-files', id: 'calibration-files' });
    this.files = (remembered(KEPT) ?? []).map((file) => this.#record(file));
  }

  /** Those that the program can take. */
  get question() {
    return this.files.filter(({ upload, refused }) => upload !== undefined && !refused).map(({ upload, name }) => ({ upload, name }));
  }

  /** The files, or the numbers by which the program has them. */
  get kept() {
    return this.files.map(({ file, name, upload }) => ({ file, name, kept: upload }));
  }

  /** Take files in the place of those that are there. */
  replace(chosen) {
    for (const { upload } of this.files) if (upload !== undefined) this.#drop(upload);
    this.files = [];
    this.#keep();
    return this.add(chosen);
  }

  #drop(upload) {
    discard(upload).catch((fault) => this.complain(fault));
  }

  async add(chosen) {
    for (const file of chosen) {
      if (this.files.length >= MOST) return this.banner.say(() => t('most_data', { most: MOST, name: file.name }), { until: 'closed' });
      await this.#send(file);
    }
    return undefined;
  }

  async #send(file) {
    const record = this.#record({ file, name: file.name, size: file.size });
    this.files.push(record);
    this.show();
    const coming = send(file, (share) => (record.state.textContent = underWay(share)));
    try {
      record.upload = await coming.done;
    } catch (fault) {
      this.files = this.files.filter((other) => other !== record);
      this.show();
      if (fault instanceof Fault) this.complain(fault, { what: `${file.name}: ` });
      return;
    }
    this.#keep();
    await this.read(record);
    this.onChange();
  }

  /** Ask what a file is taken as; one that cannot be told says why, and is left out. */
  async read(record) {
    try {
      const plan = await this.plan([{ upload: record.upload, name: record.name }]);
      if (plan) Object.assign(record, { kind: plan.data[0].kind, refused: null });
    } catch (fault) {
      if (!(fault instanceof Fault)) throw fault;
      // One that was removed meanwhile is missed by nobody.
      if (fault.status === 410) return this.files.includes(record) ? this.#gone() : undefined;
      Object.assign(record, { kind: null, refused: fault });
    }
    return this.show();
  }

  /** Another case may take what this one refused. */
  async reread() {
    for (const record of [...this.files]) if (record.upload !== undefined) await this.read(record);
  }

  /** After a restart the program has no files of this page. */
  #gone() {
    const names = this.files.map(({ name }) => name).join(', ');
    this.files = [];
    this.#keep();
    this.show();
    if (names) this.banner.say(() => t('record_gone', names), { until: 'closed' });
  }

  #remove(record) {
    this.files = this.files.filter((other) => other !== record);
    if (record.upload !== undefined) this.#drop(record.upload);
    this.#keep();
    this.show();
    this.input.focus();
    this.onChange();
  }

  /** A file and its row; one that a reload found has no `file`. */
  #record({ file, name, size, upload }) {
    return addRow({ file, name, size, upload, kind: null, refused: null }, (record) => this.#remove(record));
  }

  show() {
    for (const record of this.files) {
      tell(record, record.kind && t('taken_as', { kind: t(record.kind), size: fileSize(record.size) }), this.inLabels, (text, { help }) => (help ? `${text} (${said(help, this.inLabels).text})` : text));
    }
    this.list.replaceChildren(...this.files.map(({ place }) => place));
    this.list.lang = currentLanguage();
    translate(this.choose);
  }

  #keep() {
    const files = held(this.files);
    remember(KEPT, files.length ? files : null);
  }
}
