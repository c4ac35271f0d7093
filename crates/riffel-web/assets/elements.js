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

/** The head of a table; an empty cell is the head of nothing. */
export const headed = (cells) => element('thead', {}, element('tr', {}, ...cells.map((textContent) => (textContent === '' ? element('td') : element('th', { scope: 'col', textContent })))));

/** An element with a word of the catalogue, which follows the language. */
export function worded(tag, word, properties = {}, ...children) {
  const made = element(tag, properties, ...children);
  made.dataset.t = word;
  return made;
}
