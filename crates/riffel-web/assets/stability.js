// Stability: where over speed and friction the loop of the case oscillates without any profile, as in squeal.

import { startCasePanel } from './case-panel.js';
import { theme } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { si } from './keys.js';
import { number, range, speed as inUnit, t, unitOfSpeed } from './words.js';

const COLUMNS = ['speed_m_per_s', 'friction', 'unstable_roots', 'frequency_hz', 'growth_rate_per_s'];

export function startStability(shared) {
  const { state } = shared;

  function fill(answer, plot) {
    plot.hidden = !answer.branches.length;
    if (plot.hidden) return;
    const [unit, size] = unitOfSpeed();
    const { soft, warm } = theme();
    const colors = palette();
    const squares = (points, name, color, more = {}) => ({
      type: 'scatter', mode: 'markers', name, x: points.map((point) => point.speed_m_per_s / size), y: points.map((point) => point.friction), marker: { color, size: 9, symbol: 'square', ...more },
      text: points.map((point) => [inUnit(point.speed_m_per_s), `μ ${number(point.friction)}`, point.frequency_hz && `${number(point.frequency_hz)} Hz, ${number(point.growth_rate_per_s)}/s`].filter(Boolean).join(' · ')), hovertemplate: '%{text}<extra></extra>',
    });
    const fastest = answer.branches[0].growth_rate_per_s || 1;
    const traces = answer.branches.map(({ frequency_min_hz: low, frequency_max_hz: high }, k) => {
      const points = answer.points.filter(({ frequency_hz: frequency }) => frequency >= low && frequency <= high && frequency !== null);
      // The paler, the slower it grows.
      return squares(points, `${range([low, high])} Hz`, colors[1 + (k % (colors.length - 1))], { opacity: points.map((point) => 0.35 + 0.65 * Math.sqrt(Math.min(1, (point.growth_rate_per_s ?? 0) / fastest))) });
    });
    const unknown = answer.points.filter((point) => point.unstable_roots === null);
    if (unknown.length) traces.push(squares(unknown, t('not_known'), soft, { symbol: 'x-thin-open', size: 6 }));
    const own = si(state.head.complete, 'contact.friction');
    const shapes = [{ type: 'line', xref: 'paper', yref: 'y', x0: 0, x1: 1, y0: own, y1: own, line: { color: warm, width: 1, dash: 'dash' } }];
    const ends = (values) => [values[0], values.at(-1)];
    const within = (values, by) => [ends(values)[0] - by * (values[1] - values[0]), ends(values)[1] + by * (values[1] - values[0])];
    draw(plot, traces, layout({ xaxis: axis(`${t('speed')} [${unit}]`, { range: within(answer.speeds_m_per_s.map((speed) => speed / size), 0.6) }), yaxis: axis(t('friction_axis'), { range: within(answer.friction, 0.6) }), showlegend: true, shapes }));
  }

  startCasePanel(shared, { view: 'motion', path: '/api/stability', word: 'stability', fill, rows: ({ points }) => [COLUMNS, ...points.map((point) => COLUMNS.map((column) => point[column]))] });
}
