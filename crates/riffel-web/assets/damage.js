// Damage: where the contact of the case stands between the limits of shakedown over a wave at the cursor, and cracks along the waves of a rail after grinding.

import { startCasePanel } from './case-panel.js';
import { letterSize } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, fillTable, row } from './elements.js';
import { number, speed, t } from './words.js';

/** Highest p₀/k that is drawn. */
const TOP = 7;
/** Limits of p₀/k with the dash of their lines. */
const LIMITS = [['elastic', 'dash'], ['line', 'solid'], ['surface', 'solid'], ['subsurface', 'dash']];
const COLUMNS = ['phase_deg', 'profile_m', 'normal_force_n', 'tangential_force_n', 'p0_over_k', 'utilised_friction', 'fi_surf', 'demand'];

export function startDamage(shared) {
  const { state, traffic } = shared;
  const table = element('table', { className: 'comparison', id: 'cracks' });

  function fill({ shakedown, cracks, months }, plot) {
    const colors = palette();
    const { map, mean, loop } = shakedown;
    const lines = LIMITS.map(([limit, dash], k) => {
      const rows = map.filter((row) => row[limit] !== null && row[limit] <= TOP);
      return { type: 'scatter', mode: 'lines', name: t(`limit_${limit}`), x: rows.map((row) => row.utilised_friction), y: rows.map((row) => row[limit]), line: { color: colors[1 + k], width: 1.6, dash }, hoverinfo: 'skip' };
    });
    const points = (name, rows, color, more) => ({
      type: 'scatter', name, x: rows.map((row) => row.utilised_friction), y: rows.map((row) => row.p0_over_k), text: rows.map((row) => [row.phase_deg !== undefined && `${row.phase_deg}°`, t('demand', number(row.demand))].filter(Boolean).join(' · ')),
      hovertemplate: `%{text}<extra>${name}</extra>`, mode: 'markers', marker: { color, size: 9 }, ...more,
    });
    const at = (degrees) => loop.filter((row) => row.phase_deg === degrees);
    const traces = [...lines, points(t('along_wave'), [...loop, loop[0]], colors[0], { mode: 'lines', line: { color: colors[0], width: 1.6 } }), points(t('mean_state'), [mean], colors[0]), points(t('crest'), at(0), colors[5]), points(t('trough'), at(180), colors[6])];
    draw(plot, traces, layout({ xaxis: axis(t('utilised_friction')), yaxis: axis('p₀/k', { range: [0, TOP] }), showlegend: true, margin: { l: 4 * letterSize(), r: 10, t: 4 * letterSize(), b: 3 * letterSize() } }));
    table.hidden = !cracks.length;
    const of = (phase) => cracks.filter((crack) => crack.phase === phase);
    const cells = (crack) => [number(1e3 * crack.crack_length_m), crack.crack_growth_mm_per_month === null ? '–' : number(crack.crack_growth_mm_per_month)];
    const troughs = of('trough');
    const rows = of('crest').map((crest, k) => row(number(1e3 * crest.wavelength_m), [...cells(crest), ...cells(troughs[k])]));
    fillTable(table, ['wavelength_mm', 'crest', 'crest_monthly', 'trough', 'trough_monthly'].map((word) => t(`cracks_${word}`, number(months ?? NaN))), rows);
  }

  startCasePanel(shared, {
    view: 'motion', path: '/api/damage', word: 'damage', fill, below: [table],
    more: () => state.point && { wavelength_m: state.point.wavelength, speed_m_per_s: state.point.speed, traffic: traffic.givenFile },
    at: ({ wavelength_m: wavelength, speed_m_per_s: own }) => `${number(1e3 * wavelength)} mm, ${speed(own)}`,
    rows: ({ shakedown: { loop } }) => [COLUMNS, ...loop.map((row) => COLUMNS.map((column) => row[column]))],
  });
}
