// Paper: Figures 2–8 of Afferrante & Ciavarella (2009), computed when they are looked at.

import { letterSize } from './colors.js';
import { axis, decades, draw, layout, palette } from './curves.js';
import { element } from './elements.js';
import { offer } from './figures.js';
import { MapView, drawBar } from './map-view.js';
import { askOnce, json } from './server.js';
import { currentLanguage, translate } from './words.js';

const NUMBERS = [2, 3, 4, 5, 6, 7, 8];

export function startPaper({ state, listen, complain, save }) {
  const place = document.getElementById('view-paper');
  const choice = element('select', { id: 'paper-contact' });
  for (const [value, word] of [['quasi-static', 'quasi'], ['spring-dashpot', 'dashpot'], ['non-steady', 'non_steady']]) {
    const option = element('option', { value });
    option.dataset.t = word;
    choice.append(option);
  }
  const label = element('label', { htmlFor: choice.id });
  label.dataset.t = 'contact_model';
  const intro = element('p', { className: 'why' });
  intro.dataset.t = 'paper_intro';
  place.append(element('div', { className: 'panel wide strip' }, element('span', { className: 'choice' }, label, choice), intro));
  const figures = NUMBERS.map((number) => {
    const heading = element('h2', { textContent: `${number}` });
    const panels = element('div', { className: 'pair' });
    const caption = element('p', { className: 'fine' });
    const waiting = element('p', { className: 'waiting' });
    waiting.dataset.t = 'computing';
    const panel = element('article', { className: 'panel half', id: `figure-${number}` }, element('header', {}, heading), waiting, panels, caption);
    place.append(panel);
    return { number, heading, panels, caption, waiting, shown: null };
  });

  const watch = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (isIntersecting) show(figures.find(({ number }) => target.id === `figure-${number}`));
    }
  }, { rootMargin: '200px' });
  for (const { number } of figures) watch.observe(document.getElementById(`figure-${number}`));
  choice.addEventListener('change', lookAgain);

  /** Whether a figure is seen is told anew. */
  function lookAgain() {
    for (const { number } of figures) {
      const panel = document.getElementById(`figure-${number}`);
      watch.unobserve(panel);
      watch.observe(panel);
    }
  }

  /** What a figure depends on: the contact, and the language of its words. */
  const wanted = () => `${choice.value} ${currentLanguage()}`;

  async function show(figure) {
    if (figure.shown === wanted() || state.view !== 'paper') return;
    const asked = (figure.shown = wanted());
    figure.waiting.hidden = false;
    try {
      const data = await json(await askOnce('/api/figure', { number: figure.number, contact: choice.value, language: currentLanguage() }));
      if (figure.shown !== asked) return;
      figure.data = data;
      await drawFigure(figure);
    } catch (fault) {
      figure.shown = null;
      figure.waiting.hidden = true;
      complain(fault);
    }
  }

  async function drawFigure({ number, data, heading, panels, caption, waiting }) {
    heading.textContent = data.title;
    caption.textContent = data.caption;
    waiting.hidden = true;
    panels.replaceChildren();
    const all = data.maps ?? data.lines;
    const nameOf = (k) => (all.length > 1 ? `figure-${number}-${k + 1}` : `figure-${number}`);
    (data.maps ?? []).forEach((map, k) => drawMap(map, panels, nameOf(k)));
    // Every panel has its place before the first is drawn, which takes its size from it.
    const places = (data.lines ?? []).map(({ subtitle }, k) => {
      const curve = element('div', { className: 'curve' });
      panels.append(element('figure', {}, captioned(subtitle, () => ({ name: nameOf(k), plot: curve })), curve));
      return curve;
    });
    for (const [k, lines] of (data.lines ?? []).entries()) await drawLines(lines, places[k]);
  }

  /** The caption of a panel, with what hands it out. */
  function captioned(subtitle, figure) {
    const caption = element('figcaption', {}, element('span', { textContent: subtitle }));
    offer(caption, figure, save);
    return caption;
  }

  function drawMap(panel, panels, name) {
    const map = element('div', { className: 'map' });
    const bar = element('div', { className: 'bar' });
    panels.append(element('figure', {}, captioned(panel.subtitle, () => ({ name, map: view, rows: rowsOf(panel) })), map, bar));
    const range = (values) => ({ min: values[0], max: values.at(-1), points: values.length });
    const view = new MapView(map, { label: `${panel.subtitle}, ${panel.value_label}` });
    const values = Float32Array.from(panel.values, (value) => -value);
    view.show({
      wavelength: range(panel.wavelength_m), speed: range(panel.speed_m_per_s), columns: panel.wavelength_m.length, rows: panel.speed_m_per_s.length,
      values, strongest: values.reduce((most, value) => Math.max(most, value), 0), ridge: panel.ridge, branches: panel.branches, bestFit: panel.best_fit_frequency_hz, rays: panel.rays_hz,
    });
    drawBar(bar, view, `−${panel.value_label}`);
  }

  /** Every point of a map in SI; values with the sign of the paper. */
  const rowsOf = ({ wavelength_m: wavelengths, speed_m_per_s: speeds, values, value_label: label }) => [
    ['wavelength_m', 'speed_m_per_s', label], ...speeds.flatMap((speed, y) => wavelengths.map((wavelength, x) => [wavelength, speed, values[y * wavelengths.length + x]])),
  ];

  async function drawLines(panel, curve) {
    const colors = palette();
    const traces = panel.series.map((series, k) => ({
      type: 'scatter', mode: series.style === 'markers' ? 'markers' : 'lines', x: series.x, y: series.y, name: series.label, showlegend: Boolean(series.label),
      line: { color: colors[k % colors.length], width: 1.6, dash: series.style === 'markers' ? 'solid' : series.style },
      hovertemplate: `%{x:.4~g} · %{y:.4~g}<extra>${series.label}</extra>`,
    }));
    const along = (label, scale, range, values) => axis(label, {
      ...(scale === 'log' ? decades(values) : {}), ...(range ? { range: scale === 'log' ? range.map(Math.log10) : range } : {}),
    });
    const all = (part) => panel.series.flatMap((series) => series[part]).filter((value) => value !== null);
    await draw(curve, traces, layout({
      xaxis: along(panel.x_label, panel.x_scale, panel.x_range, all('x')), yaxis: along(panel.y_label, panel.y_scale, panel.y_range, all('y')),
      showlegend: traces.some(({ showlegend }) => showlegend), legend: { orientation: 'h', x: 0, y: -0.24, yanchor: 'top', font: { size: 0.82 * letterSize() } },
    }));
  }

  listen((what) => {
    if (what === 'words') {
      translate(place);
      for (const figure of figures) if (figure.data && figure.shown === wanted()) drawFigure(figure);
      lookAgain();
    } else if (what === 'view' && state.view === 'paper') lookAgain();
  });
}
