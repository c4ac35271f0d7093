// Elements of the page, made in one line.

export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** An element with a word of the catalogue, which follows the language. */
export function worded(tag, word, properties = {}, ...children) {
  const made = element(tag, properties, ...children);
  made.dataset.t = word;
  return made;
}
