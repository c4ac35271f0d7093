// Curves by plotly.js, in the colours and words of the page.

import { letterSize, theme } from './colors.js';
import { decimalMark } from './wording.js';
import { currentLanguage, power, t, written } from './words.js';

/** plotly.js is large: it loads while the page already stands. */
let loading;
export function plotly() {
  loading ??= new Promise((done, fail) => {
    const script = document.createElement('script');
    script.src = document.querySelector('meta[name=plotly]').content;
    script.onload = () => done(window.Plotly);
    script.onerror = fail;
    document.head.append(script);
  });
  return loading;
}

export const CONFIG = { displayModeBar: false, responsive: true, doubleClick: 'reset' };

/** Okabe & Ito (2008); black gives way to white on a dark page. */
export const palette = () => {
  const { dark, ink } = theme();
  return [ink, dark ? '#56b4e9' : '#0072b2', dark ? '#ff8a3d' : '#d55e00', dark ? '#2fc79b' : '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#f0e442'];
};

export function axis(title, more = {}) {
  const { soft, grid, line } = theme();
  return {
    title: { text: title, font: { size: 0.85 * letterSize(), color: soft }, standoff: 6 }, ticks: 'inside', ticklen: 4, tickcolor: soft, showline: true, linewidth: 1,
    linecolor: line, mirror: true, gridcolor: grid, zeroline: false, tickfont: { size: 0.8 * letterSize(), color: soft }, automargin: true, ...more,
  };
}

export function layout(more = {}) {
  const { ink, sheet, font, line } = theme();
  return {
    margin: { l: 4 * letterSize(), r: 10, t: 8, b: 3 * letterSize() }, paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)', font: { family: font, size: 0.85 * letterSize(), color: ink },
    hovermode: 'closest', hoverlabel: { bgcolor: sheet, bordercolor: line, font: { color: ink, size: 0.85 * letterSize() } }, dragmode: 'zoom',
    legend: { orientation: 'h', x: 0, y: 1.02, yanchor: 'bottom', font: { size: 0.82 * letterSize() } }, showlegend: false,
    separators: decimalMark(currentLanguage()) === ',' ? ',.' : '.,', ...more,
  };
}

/** Curves of a view that is shown again: the window may have another size. */
export function refit(view) {
  loading?.then(({ Plots }) => view.querySelectorAll('.js-plotly-plot').forEach((plot) => plot.offsetParent && Plots?.resize(plot)));
}

/** How many curves are being drawn. */
export const drawings = { open: 0 };

export async function draw(place, traces, shape) {
  drawings.open++;
  try {
    const { react } = await plotly();
    await react(place, traces, shape, CONFIG);
  } finally {
    drawings.open--;
  }
}

const line = (x, y, name, color, more = {}) => ({ type: 'scatter', mode: 'lines', x, y, name, line: { color, width: 1.6, ...more.line }, hovertemplate: `%{x:.4~g} · %{y:.3~g}<extra>${name}</extra>`, ...more.trace });

/** The same curve of the state before, pale. */
const ghostly = (x, y) => ({ ...line(x, y, '', theme().line, { line: { width: 3 } }), hoverinfo: 'skip', hovertemplate: null, name: 'ghost' });

const upright = (x, color, dash = 'solid') => ({ type: 'line', xref: 'x', yref: 'paper', x0: x, x1: x, y0: 0, y1: 1, line: { color, width: 1, dash } });

/** Whole powers of ten: plotly.js writes them with styles that the policy of the page forbids. */
export function decades(values) {
  const logs = values.filter((value) => value > 0).map(Math.log10);
  const [low, high] = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))];
  const ticks = Array.from({ length: high - low + 1 }, (_, k) => 10 ** (low + k));
  return { type: 'log', tickvals: ticks, ticktext: ticks.map((tick) => (tick >= 0.01 && tick <= 1e4 ? written(tick) : power(tick, 1).replace('1·', ''))) };
}
const hertz = () => axis(`${t('frequency')} f [Hz]`, { type: 'log', tickvals: [20, 50, 100, 200, 500, 1000, 2000, 5000], range: [Math.log10(20), Math.log10(5000)] });

export async function drawReceptance(place, { spectrum, state }, ghost) {
  const [, blue, orange, green] = palette();
  const f = spectrum.frequency_hz;
  const size = (pairs) => pairs.map(([re, im]) => 1e9 * Math.hypot(re, im));
  const contact = 1e9 / state.contact_stiffness_n_per_m;
  const [rail, wheel] = [size(spectrum.rail_receptance_m_per_n), size(spectrum.wheel_receptance_m_per_n)];
  const before = ghost ? [ghost.spectrum.rail_receptance_m_per_n, ghost.spectrum.wheel_receptance_m_per_n].map((pairs) => ghostly(ghost.spectrum.frequency_hz, size(pairs))) : [];
  const traces = [
    ...before,
    line(f, rail, t('rail'), blue),
    line(f, wheel, t('wheel'), orange, { line: { dash: 'dash' } }),
    line([f[0], f.at(-1)], [contact, contact], t('contact'), green, { line: { dash: 'dot' } }),
  ];
  await draw(place, traces, layout({ xaxis: hertz(), yaxis: axis('|H| [nm/N]', decades([...rail, ...wheel])), showlegend: true, margin: { l: 4 * letterSize(), r: 10, t: 2 * letterSize(), b: 3 * letterSize() }, shapes: [upright(state.frequency_hz, theme().soft)] }));
}

export async function drawForce(place, { spectrum, state }, ghost) {
  const [, blue] = palette();
  const size = (one) => one.normal_force_ratio.map(([re, im]) => Math.hypot(re, im));
  const ratio = size(spectrum);
  const before = ghost ? [ghostly(ghost.spectrum.frequency_hz, size(ghost.spectrum))] : [];
  const phase = spectrum.normal_force_ratio.map(([re, im]) => (180 * Math.atan2(im, re)) / Math.PI);
  const trace = line(spectrum.frequency_hz, ratio, '|P₁/P₀|', blue, { trace: { customdata: phase, hovertemplate: '%{x:.4~g} Hz · %{y:.3~g} · %{customdata:.0f}°<extra></extra>' } });
  const { warm, soft } = theme();
  // Above one wheel and rail part.
  const apart = { type: 'line', xref: 'paper', yref: 'y', x0: 0, x1: 1, y0: 1, y1: 1, line: { color: warm, width: 1, dash: 'dash' } };
  const shapes = [upright(state.frequency_hz, soft), ...(Math.max(...ratio) > 0.8 ? [apart] : [])];
  await draw(place, [...before, trace], layout({ xaxis: hertz(), yaxis: axis('|P₁/P₀| [-]', { rangemode: 'tozero' }), shapes }));
}

/** Fastest decay, zero or below, and fastest growth, zero or above. */
const extremes = (rates) => rates.reduce(([low, high], rate) => [Math.min(low, rate), Math.max(high, rate)], [0, 0]);

/** Power of ten of the fastest growth, or of the decay where nothing grows. */
export function growthUnit(rates) {
  const [low, high] = extremes(rates);
  return 10 ** Math.floor(Math.log10(high || -low || 1));
}

/** Range of an axis of growth rates, whose decay goes as far below zero as growth goes above it at most; none where nothing grows. */
export function growthRange(rates) {
  const [low, high] = extremes(rates);
  return high > 0 ? { range: [1.05 * Math.max(low, -high), 1.05 * high] } : {};
}

export async function drawGrowth(place, { growth, state }, ghost) {
  const { warm, soft } = theme();
  const [, blue] = palette();
  const mm = growth.wavelength_m.map((value) => 1e3 * value);
  const lines = growth.lines.filter((line) => line.growth_rate_per_passage > 0);
  // One power of ten for the whole axis, in its title.
  const unit = growthUnit(growth.growth_rate_per_passage);
  const before = ghost ? [ghostly(ghost.growth.wavelength_m.map((value) => 1e3 * value), ghost.growth.growth_rate_per_passage.map((rate) => rate / unit))] : [];
  const traces = [
    ...before,
    { ...line(mm, growth.growth_rate_per_passage.map((rate) => rate / unit), '', blue), fill: 'tozeroy', fillcolor: 'rgba(0,114,178,.10)' },
    { type: 'scatter', mode: 'markers', x: lines.map((line) => 1e3 * line.wavelength_m), y: lines.map((line) => line.growth_rate_per_passage / unit), marker: { color: warm, size: 7 }, customdata: lines.map((line) => line.frequency_hz), hovertemplate: '%{x:.3~g} mm · %{customdata:.0f} Hz<extra></extra>' },
  ];
  const zero = { type: 'line', xref: 'paper', yref: 'y', x0: 0, x1: 1, y0: 0, y1: 0, line: { color: soft, width: 1 } };
  await draw(place, traces, layout({ xaxis: axis(`${t('wavelength')} λ [mm]`), yaxis: axis(`${t('rate')} [${power(unit, 1).replace('1·', '')}]`, growthRange([...before, ...traces.slice(-2)].flatMap(({ y }) => y))), shapes: [zero, upright(1e3 * state.wavelength_m, soft)] }));
}
