// How questions reach the program: here over HTTP, in the page that is one file by way of `file/workers.js`.

/** A question, and the Response to it. */
export const reach = (path, options) => fetch(path, options);

/** The case that lies inside the page; a page that is served has none. */
export const inside = null;
