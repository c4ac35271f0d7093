// The variants that are kept beside the case at hand: their names, and what a link has of them.

/** Most variants at a time. */
export const MOST_VARIANTS = 6;

const isTable = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
const NAMES = 'ABCDEF';
const LONGEST_NAME = 40;

/** A name that no other variant has. */
export function ownName(wanted, others) {
  const taken = new Set(others.map(({ name }) => name));
  const name = wanted.trim().slice(0, LONGEST_NAME);
  if (name && !taken.has(name)) return name;
  if (!name) return [...NAMES].find((letter) => !taken.has(letter)) ?? ownName('A', others);
  for (let k = 2; ; k++) if (!taken.has(`${name} (${k})`)) return `${name} (${k})`;
}

/** The variants of a link; those of before have one, without a name, as `kept`. */
export function readVariants({ variants, kept }) {
  const given = Array.isArray(variants) ? variants : isTable(kept) ? [{ name: '', case: kept }] : [];
  const read = [];
  for (const variant of given.slice(0, MOST_VARIANTS)) {
    if (isTable(variant?.case)) read.push({ name: ownName(String(variant.name ?? ''), read), case: variant.case });
  }
  return read;
}
