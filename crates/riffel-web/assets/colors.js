// Colours of growth, those of the program's maps: pale to dark blue in equal steps of OKLab lightness
// (B. Ottosson, 2020), so that they differ for colour-blind readers too. On a dark page the same colours
// stand in the opposite order, and strong growth shines.

const STEPS = 10;

function blue(t) {
  const lightness = 0.955 + (0.4 - 0.955) * t;
  const chroma = 0.022 + (0.13 - 0.022) * (1 - (1 - t) ** 2);
  return oklch(lightness, chroma, 225 + (262 - 225) * t);
}

function oklch(lightness, chroma, degrees) {
  const hue = (degrees * Math.PI) / 180;
  const [a, b] = [chroma * Math.cos(hue), chroma * Math.sin(hue)];
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((linear) => {
    const encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
    return Math.round(255 * Math.min(1, Math.max(0, encoded)));
  });
}

/** The steps of growth from weak to strong, as [r, g, b]. */
export function growthSteps(dark) {
  const steps = Array.from({ length: STEPS }, (_, step) => blue(step / (STEPS - 1)));
  return dark ? steps.reverse() : steps;
}

/** Steps of a difference: vermilion for more growth, blue for less, weak in the middle of each. */
export function differenceSteps(dark) {
  const fade = (t) => (dark ? 0.3 + 0.45 * t : 0.95 - 0.42 * t);
  const side = (degrees) =>
    Array.from({ length: STEPS }, (_, step) => oklch(fade(step / (STEPS - 1)), 0.02 + (0.13 * step) / (STEPS - 1), degrees));
  return { more: side(48), less: side(250) };
}

/** Colours of an ordered family of curves, from 0 to 1: from dark blue to bright vermilion; lightness tells them apart, too. */
export function orderedColor(share, dark) {
  return css(oklch(dark ? 0.92 - 0.3 * share : 0.34 + 0.32 * share, 0.13, 265 - 225 * share));
}

export const css = ([r, g, b]) => `rgb(${r},${g},${b})`;

/** Size of the letters of the page [px]. */
export const letterSize = () => Number.parseFloat(getComputedStyle(document.documentElement).fontSize);

/** Colours by the name of the theme: the style of the page is asked once for each, for asking costs a layout. */
const themes = new Map();

/** The colours of the page at present, by the names of page.css. */
export function theme() {
  const { theme: name } = document.documentElement.dataset;
  if (!themes.has(name)) themes.set(name, asked());
  return themes.get(name);
}

function asked() {
  const style = getComputedStyle(document.documentElement);
  const color = (name) => style.getPropertyValue(`--${name}`).trim();
  return {
    dark: style.colorScheme === 'dark',
    ink: color('ink'), soft: color('soft'), line: color('line'), sheet: color('sheet'), accent: color('accent'),
    warm: color('warm'), grid: color('grid'), green: color('green'), font: style.fontFamily,
  };
}

/** What is drawn as on a white page; nothing of it is seen. */
export function onWhite(draw) {
  const { dataset } = document.documentElement;
  const { theme: before } = dataset;
  dataset.theme = 'light';
  try {
    return draw();
  } finally {
    dataset.theme = before;
  }
}
