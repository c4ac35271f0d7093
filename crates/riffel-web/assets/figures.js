// Figures to take away: each as SVG, PNG and CSV, on white whatever the page looks like.

import { onWhite, theme } from './colors.js';
import { palette, plotly } from './curves.js';
import { element, svgElement } from './elements.js';
import { t } from './words.js';

const KINDS = ['svg', 'png', 'csv'];
const TYPES = { svg: 'image/svg+xml', png: 'image/png', csv: 'text/csv' };
/** Pixels of a PNG for each of the page. */
const SCALE = 2;

const cell = (value) => {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};
/** A table as text, with a point before the decimals in every language. */
export const csv = (rows) => rows.map((row) => row.map(cell).join(',')).join('\n').concat('\n');

/** Curves one below the other. */
function plotRows({ data, layout }) {
  const title = (axis) => layout[axis]?.title?.text ?? axis;
  const quantity = ({ yaxis = 'y' }) => title(`yaxis${yaxis.slice(1)}`);
  const points = data.filter(({ x }) => x?.length).flatMap((trace) => Array.from(trace.x, (x, k) => [(trace.name ?? '').replaceAll('&lt;', '<'), x, trace.y[k], quantity(trace)]));
  return [['curve', title('xaxis'), 'value', 'quantity'], ...points];
}

/** Every point of a map in SI. */
function mapRows({ map, kind }) {
  const { wavelength, speed, columns, rows, values } = map;
  const at = ({ min, max }, k, count) => Number((min + ((max - min) * k) / (count - 1)).toPrecision(12));
  const name = kind === 'difference' ? 'growth_rate_difference_per_passage' : 'growth_rate_per_passage';
  const table = [['wavelength_m', 'speed_m_per_s', name]];
  for (let y = 0; y < rows; y++) for (let x = 0; x < columns; x++) table.push([at(wavelength, x, columns), at(speed, y, rows), Number(values[y * columns + x].toPrecision(7))]);
  return table;
}

/** The cells of a table of the page. */
const tableRows = (table) => [...table.rows].map((row) => [...row.cells].map(({ textContent }) => textContent.trim()));

/** An SVG of the page with the colours that its style sheet gives it. */
function withStyles(svg) {
  const copy = svg.cloneNode(true);
  const place = svg.getBoundingClientRect();
  const box = (svg.getAttribute('viewBox') ?? `0 0 ${place.width} ${place.height}`).split(/[\s,]+/).map(Number);
  // As large as on the page, without the empty sides of its place.
  const scale = Math.min(place.width / box[2], place.height / box[3]);
  const [from, to] = [[svg, ...svg.querySelectorAll('*')], [copy, ...copy.querySelectorAll('*')]];
  from.forEach((one, k) => {
    const style = getComputedStyle(one);
    for (const name of ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'font-size', 'font-weight', 'font-family', 'color']) to[k].setAttribute(name, style.getPropertyValue(name));
    for (const name of ['class', 'style']) to[k].removeAttribute(name);
  });
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', scale * box[2]);
  copy.setAttribute('height', scale * box[3]);
  const [x, y, width, height] = box;
  copy.prepend(svgElement('rect', { x, y, width, height, fill: '#fff' }));
  return new XMLSerializer().serializeToString(copy);
}

/** A figure of plotly.js in the colours of a white page. */
export function whitened(figure) {
  const here = [theme(), palette()];
  const white = onWhite(() => [theme(), palette()]);
  let text = JSON.stringify(figure);
  const colors = here.flatMap((one, k) => Object.keys(one).map((name) => [one[name], white[k][name]])).filter(([own, other]) => typeof own === 'string' && own !== other);
  // By way of marks that stand for no colour, so that none is changed twice.
  colors.forEach(([own], k) => (text = text.replaceAll(`"${own}"`, `"\u0000${k}"`)));
  colors.forEach(([, other], k) => (text = text.replaceAll(`"\u0000${k}"`, `"${other}"`)));
  return JSON.parse(text);
}

/** A figure as SVG. */
export async function svgOf({ map, plot, drawing }) {
  if (drawing) return onWhite(() => withStyles(drawing.querySelector('svg')));
  if (map) {
    const svg = onWhite(() => map.svg());
    map.draw();
    return svg;
  }
  const { width, height } = plot.getBoundingClientRect();
  const library = await plotly();
  const { data, layout } = whitened({ data: plot.data, layout: plot.layout });
  const beside = element('div', { className: 'beside' });
  document.body.append(beside);
  try {
    // Every point of a curve, for figures that are looked at closely.
    const whole = data.map((trace) => ({ ...trace, line: { ...trace.line, simplify: false } }));
    await library.react(beside, whole, { ...layout, width, height, autosize: false }, { staticPlot: true });
    return merged([...beside.querySelectorAll('.main-svg')], width, height);
  } finally {
    library.purge(beside);
    beside.remove();
  }
}

/** Layers that lie over each other as one. Styles become attributes, which the policy of the page lets a picture have. */
function merged(layers, width, height) {
  const size = `width="${width}" height="${height}"`;
  const inner = layers.flatMap((layer) => {
    for (const one of layer.querySelectorAll('[style]')) {
      for (const name of [...one.style]) one.setAttribute(name, one.style.getPropertyValue(name));
      one.removeAttribute('style');
    }
    return [...layer.childNodes].map((node) => new XMLSerializer().serializeToString(node));
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" ${size} viewBox="0 0 ${width} ${height}"><rect ${size} fill="#fff"/>${inner.join('')}</svg>`;
}

/** SVG drawn as PNG. */
export async function pngOf(svg) {
  const url = URL.createObjectURL(new Blob([svg], { type: TYPES.svg }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = element('canvas', { width: Math.round(SCALE * image.width), height: Math.round(SCALE * image.height) });
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((done) => canvas.toBlob(done, TYPES.png));
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** A figure may have rows of its own. */
const rowsOf = ({ rows, map, plot, table }) => rows ?? (map ? mapRows(map) : plot ? plotRows(plot) : tableRows(table));

/** Put a button into the head of a panel that hands out its figure: `figure` says which at the time of the click; null is none yet. */
export function offer(header, figure, save, kinds = KINDS) {
  const menu = element('details', { className: 'take' });
  const summary = element('summary', {});
  summary.dataset.t = 'take_figure';
  const buttons = kinds.map((kind) => {
    const button = element('button', { type: 'button', className: 'plain small', textContent: kind.toUpperCase() });
    button.dataset.figure = kind;
    button.addEventListener('click', async () => {
      const given = figure();
      menu.open = false;
      if (!given) return;
      const text = kind === 'csv' ? csv(rowsOf(given)) : await svgOf(given);
      save(kind === 'png' ? await pngOf(text) : new Blob([text], { type: TYPES[kind] }), `${given.name}.${kind}`);
    });
    return button;
  });
  menu.append(summary, element('span', { className: 'buttons' }, ...buttons));
  if (!header.querySelector('.push')) header.append(element('span', { className: 'push' }));
  header.append(menu);
  summary.textContent = t('take_figure');
}
