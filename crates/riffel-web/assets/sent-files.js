// Files that the program keeps for this page, in rows: the name, how far each is, a way to remove it, and why it is refused.

import { element } from './elements.js';
import { said } from './messages.js';
import { number, t } from './words.js';

/** How far a file on its way is. */
export const underWay = (share) => `${t('uploading')} ${number(100 * share, 3)} %`;

/** Give a record its row; `fields` stand behind the name, and their `faults` below. */
export function addRow(record, remove, { fields = [], faults = [], className = '' } = {}) {
  const { name } = record;
  record.state = element('span', { className: 'aside' });
  record.trouble = element('p', { className: 'fault', hidden: true });
  record.drop = element('button', { type: 'button', className: 'plain small', textContent: '✕' });
  record.drop.addEventListener('click', () => remove(record));
  record.place = element('li', { className }, element('span', { className: 'name', textContent: name, title: name }), ...fields, record.drop, record.state, ...faults, record.trouble);
  return record;
}

/** Say what a record is, or that it is left out and why; `shown` gives the words of keys and quantities, `whole` the rest of what is said. */
export function tell(record, what, shown, whole) {
  const { refused } = record;
  record.drop.setAttribute('aria-label', `${t('drop')}: ${record.name}`);
  if (what || refused) record.state.textContent = refused ? t('left_out') : what;
  record.trouble.hidden = !refused;
  if (!refused) return;
  const { text, language } = said(refused.message, shown);
  Object.assign(record.trouble, { textContent: whole(text, refused), lang: language });
}

/** What a reload has of records that the program holds. */
export const held = (records) => records.filter(({ upload }) => upload !== undefined).map(({ name, size, date, upload }) => ({ name, size, date, upload }));
