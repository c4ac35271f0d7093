// On paper: every figure on white, as wide as the sheet.

import { CONFIG } from './curves.js';
import { whitened } from './figures.js';

const seen = (selector) => [...document.querySelectorAll(`.view:not([hidden]) ${selector}`)].filter((place) => place.getClientRects().length);

/** `redraw` draws the page anew in the theme that `applyTheme` sets. A browser waits for no picture: all is drawn at once. */
export function startPrinting({ applyTheme, redraw }) {
  const { classList, dataset } = document.documentElement;
  let figures = [];
  addEventListener('beforeprint', () => {
    figures = seen('.js-plotly-plot').map((plot) => ({ plot, data: plot.data, layout: plot.layout, white: whitened({ data: plot.data, layout: plot.layout }) }));
    dataset.theme = 'light';
    classList.add('printing');
    for (const { plot, white } of figures) {
      const { width, height } = plot.getBoundingClientRect();
      window.Plotly.react(plot, white.data, { ...white.layout, width, height, autosize: false }, CONFIG);
    }
    for (const place of seen('.map')) {
      if (!place.view?.map) continue;
      const paper = document.createElement('div');
      paper.className = 'paper-map';
      paper.innerHTML = place.view.svg();
      place.append(paper);
    }
    for (const bar of seen('.bar')) bar.redraw?.();
  });
  addEventListener('afterprint', () => {
    classList.remove('printing');
    applyTheme();
    for (const paper of document.querySelectorAll('.paper-map')) paper.remove();
    // Their size follows the page again.
    for (const { plot, data, layout } of figures) window.Plotly.react(plot, data, { ...layout, width: undefined, height: undefined, autosize: true }, CONFIG);
    figures = [];
    redraw();
  });
}
