// What a reload of the page finds again, as far as the browser keeps anything.

/** Keep a value under a name; null takes it away. */
export function remember(name, value) {
  try {
    if (value === null) sessionStorage.removeItem(name);
    else sessionStorage.setItem(name, JSON.stringify(value));
  } catch {
    // Then a reload begins anew.
  }
}

/** What was kept, or null. */
export function remembered(name) {
  try {
    return JSON.parse(sessionStorage.getItem(name));
  } catch {
    return null;
  }
}
