// Elements of the page, made in one line.

export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Show a field of the case and put the cursor into it. */
export function lead(input) {
  input.closest('details').open = true;
  input.closest('.row').scrollIntoView({ block: 'center' });
  input.focus();
}

/** An element of a drawing. */
export function svgElement(tag, attributes = {}, ...children) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** A row of a table: its name, and its cells, each a cell of its own or what stands in one. */
export const row = (name, cells) => element('tr', {}, name instanceof Node ? name : element('th', { scope: 'row', textContent: name }), ...cells.map((cell) => (cell instanceof HTMLTableCellElement ? cell : element('td', {}, cell ?? ''))));

/** Fill a table; an empty head is that of nothing. */
export const fillTable = (table, heads, rows) =>
  table.replaceChildren(element('thead', {}, element('tr', {}, ...heads.map((textContent) => (textContent === '' ? element('td') : element('th', { scope: 'col', textContent }))))), element('tbody', {}, ...rows));

/** An element with a word of the catalogue, which follows the language. */
export function worded(tag, word, properties = {}, ...children) {
  const made = element(tag, properties, ...children);
  made.dataset.t = word;
  return made;
}

/** Give an element properties where they are others: what is set anew is laid out anew, even where it is the same. */
export function put(place, properties) {
  for (const [name, value] of Object.entries(properties)) if (place[name] !== value) place[name] = value;
}
