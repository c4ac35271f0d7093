// Lists of a case in a field: quantities between commas, or tables as TOML has them, one a line.

/** A list as text. */
export const written = (list) => (list.some((item) => typeof item === 'object') ? list.map(table).join(',\n') : list.join(', '));

const table = (item) => `{ ${Object.entries(item).map(([key, value]) => `${key} = ${typeof value === 'object' ? table(value) : JSON.stringify(value)}`).join(', ')} }`;

/** What is written in a field as a list; text that is none stays text, for the program to say so. */
export function read(text) {
  const tables = text.trim().startsWith('{');
  if (!tables) return text.split(/;|,(?!\d)/).map((item) => item.trim()).filter(Boolean).map((item) => (Number.isFinite(Number(item)) ? Number(item) : item));
  try {
    return JSON.parse(`[${text.replace(/([{,]\s*)([a-z_]+)\s*=/g, '$1"$2":')}]`);
  } catch {
    return text;
  }
}
