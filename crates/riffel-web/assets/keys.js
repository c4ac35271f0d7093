// The keys of a case: one object with the tables of the case file in it, quantities as "50 kN".

import { unitOfSpeed } from './words.js';

export const get = (keys, path) => path.split('.').reduce((table, part) => table?.[part], keys);

/** Set a key, or remove it with the tables that it leaves empty. */
export function set(keys, path, value) {
  const [first, ...rest] = path.split('.');
  if (!rest.length) {
    if (value === undefined) delete keys[first];
    else keys[first] = value;
    return;
  }
  if (typeof keys[first] !== 'object') {
    if (value === undefined) return;
    keys[first] = {};
  }
  set(keys[first], rest.join('.'), value);
  if (!Object.keys(keys[first]).length) delete keys[first];
}

/** Units in which a quantity is shown where the case does not write it: schema unit → unit and factor. */
const SHOWN = {
  m: ['mm', 1e-3], Pa: ['GPa', 1e9], m4: ['cm⁴', 1e-8], m2: ['cm²', 1e-4], N: ['kN', 1e3], 'N/m': ['MN/m', 1e6],
  'N s/m': ['kN s/m', 1e3],
};
const SHOWN_KEY = {
  'track.support_spacing': ['m', 1], 'track.position': ['m', 1], 'corrugation.amplitude': ['µm', 1e-6], 'wheelset.contact_spacing': ['m', 1],
  'wheelset.suspension.spacing': ['m', 1], 'wheelset.axle.length': ['m', 1],
};

/** A unit with its powers raised: kg m². The reader of a case takes them so. */
const raised = (unit = '') => unit.replace(/([a-z])([2-4])(?!\d)/gi, (_, letter, power) => letter + '⁰¹²³⁴'[power]);

/** Unit and factor to SI in which a key is shown. */
export const shownUnit = (key, unit) => (unit === 'm/s' ? unitOfSpeed() : null) ?? SHOWN_KEY[key] ?? SHOWN[unit] ?? [raised(unit), 1];

/** Number and unit of a written quantity; a bare number is in SI. */
export function split(value, unit) {
  const [, number, written] = /^\s*([+-]?[\d.]+(?:[eE][+-]?\d+)?)\s*(.*?)\s*$/.exec(String(value)) ?? [];
  return number === undefined ? null : { number: Number(number), unit: raised(written || unit || ''), text: number };
}

/** A number with at most five digits, without the noise of binary fractions. */
export const short = (number) => String(Number(number.toPrecision(5)));

/** A value in SI as the form writes it: with the unit in which its key is shown. */
export function inUnit(key, value, ofKey) {
  const [unit, size] = shownUnit(key, ofKey);
  const given = short(value / size);
  return unit ? `${given} ${unit}` : Number(given);
}

/** The SI value of a key of the complete case, in which every unit is that of the schema. */
export function si(complete, key) {
  const value = get(complete, key);
  return value === undefined ? undefined : Number.parseFloat(value);
}

// The address bar holds the case and where one looks: JSON as base64 of the alphabet for addresses, and after a point a sum
// that tells a damaged link from a whole one. Links of before have no sum.

export function pack(state) {
  const bytes = new TextEncoder().encode(JSON.stringify(state));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  const packed = btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
  return `${packed}.${sum(packed)}`;
}

/** Throws for a link that is not whole. */
export function unpack(link) {
  const [packed, given] = link.split('.');
  if (given !== undefined && given !== sum(packed)) throw new Error('damaged');
  const bytes = Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(bytes));
}

/** 32 bits of FNV-1a (Fowler, Noll & Vo), in digits and letters. */
function sum(text) {
  let hash = 0x811c9dc5;
  for (const letter of text) hash = Math.imul(hash ^ letter.charCodeAt(0), 0x01000193) >>> 0;
  return hash.toString(36);
}
