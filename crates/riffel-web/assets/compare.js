// Compare: a variant that was kept beside the case at hand.

import { element } from './elements.js';
import { get, si } from './keys.js';
import { MapView, drawBar, toMap } from './map-view.js';
import { Line, framed } from './server.js';
import { labelOf, number, passages, power, speed, t, translate, written } from './words.js';

/** How long an answer may take before what is shown pales [ms]. */
const PATIENCE = 150;

/** Keys with their values, dotted. */
const flat = (table, path = '') =>
  Object.entries(table ?? {}).flatMap(([key, value]) => (value !== null && typeof value === 'object' ? flat(value, `${path}${key}.`) : [[path + key, value]]));

export function startCompare({ state, traffic, listen, complain, record }) {
  const place = document.getElementById('view-compare');
  const line = new Line('/api/compare', framed);
  let shown = null;

  const keep = element('button', { type: 'button', className: 'plain', id: 'keep' });
  keep.dataset.t = 'keep';
  const drop = element('button', { type: 'button', className: 'plain', hidden: true });
  drop.dataset.t = 'drop';
  const hint = element('p', { className: 'why' });
  hint.dataset.t = 'nothing_kept';
  const bar = element('div', { className: 'panel wide strip' }, element('div', { className: 'buttons' }, keep, drop), hint);
  const panels = ['kept', 'now', 'difference'].map((name) => {
    const heading = element('h2');
    heading.dataset.t = name;
    const map = element('div', { className: 'map' });
    const legend = element('div', { className: 'bar' });
    const panel = element('article', { className: 'panel', hidden: true, id: `compare-${name}` }, element('header', {}, heading), map, element('footer', {}, legend));
    return { name, panel, legend, view: new MapView(map, { kind: name === 'difference' ? 'difference' : 'growth', label: name }) };
  });
  const table = element('table', { className: 'comparison' });
  const tablePanel = element('article', { className: 'panel wide', hidden: true }, table);
  place.append(bar, ...panels.map(({ panel }) => panel), tablePanel);

  keep.addEventListener('click', () => {
    state.kept = structuredClone(state.keys);
    record();
    ask();
  });
  drop.addEventListener('click', () => {
    state.kept = null;
    record();
    ask();
  });

  function ask() {
    if (!state.kept) {
      shown = null;
      show();
    }
    if (!state.kept || state.view !== 'compare') return;
    drop.hidden = false;
    stale(true);
    line.ask({ kept: { keys: state.kept }, case: { keys: structuredClone(state.keys) } }, (answer) => {
      shown = answer;
      stale(line.pending);
      show();
    }, (fault) => {
      // What the case at hand is refused for stands at its field.
      if (!fault.key) complain(fault, { until: 'case' });
    });
  }

  /** What is shown is no longer, or again, that of the case. */
  let paling;
  function stale(is) {
    clearTimeout(paling);
    const pale = () => place.querySelectorAll('article').forEach((panel) => panel.classList.toggle('stale', is));
    if (is) paling = setTimeout(pale, PATIENCE);
    else pale();
  }

  function show() {
    const there = Boolean(state.kept && shown);
    for (const { panel } of panels) panel.hidden = !there;
    tablePanel.hidden = !there;
    drop.hidden = !state.kept;
    hint.hidden = there;
    if (!there) return;
    const { head, values } = shown;
    const before = toMap(head.kept, values);
    const after = toMap(head.case, values, before.values.length);
    // How fast something decays that grows in neither case is of no interest.
    const between = (value, k) => (value > 0 || before.values[k] > 0 ? Math.max(value, 0) - Math.max(before.values[k], 0) : 0);
    const difference = { ...after, ridge: null, branches: null, bestFit: null, values: after.values.map(between) };
    difference.strongest = difference.values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    // Both maps in one scale, or they could not be compared.
    const scale = Math.max(before.strongest, after.strongest) || null;
    [before, after, difference].forEach((map, k) => {
      const { view, legend, name } = panels[k];
      view.held = k < 2 ? scale : null;
      view.label = t(name);
      view.show(map);
      drawBar(legend, view, k < 2 ? t('growth_rate') : `${t('less')} / ${t('more')}`);
    });
    rows(head.kept, head.case);
  }

  function rows(before, after) {
    const of = (value, format) => (value === null || value === undefined ? '–' : format(value));
    const doubling = ({ highest, complete }) => {
      if (!highest) return ['–', '–', '–'];
      const count = Math.LN2 / highest.growth_rate_per_passage;
      const { time, mass } = traffic.words(count, si(complete, 'contact.normal_load'));
      return [passages(count), time, mass];
    };
    const columns = (head) => {
      const high = head.highest;
      return [
        of(high?.growth_rate_per_passage, (v) => power(v, 3)), of(high?.wavelength_m, (v) => `${number(1e3 * v)} mm`), of(high?.speed_m_per_s, speed),
        of(high?.frequency_hz, (v) => `${number(v)} Hz`), of(head.best_fit_frequency_hz, (v) => `${number(v)} Hz`), ...doubling(head),
        `${number(100 * head.derived.creepage)} %`, `${number(1e-6 * head.derived.contact_stiffness_n_per_m)} MN/m`,
      ];
    };
    const [left, right] = [columns(before), columns(after)];
    const [a, b] = [new Map(flat(before.complete)), new Map(flat(after.complete))];
    const changed = [...new Set([...a.keys(), ...b.keys()])].filter((key) => key !== 'title' && a.get(key) !== b.get(key));
    const given = (keys, whole, key) => written(get(keys, key) ?? whole.get(key) ?? '–');
    const row = (name, one, other) => element('tr', {}, element('th', { scope: 'row', textContent: name }), element('td', { textContent: one }), element('td', { textContent: other }));
    const head = element('thead', {}, element('tr', {}, element('td'), ...['kept', 'now'].map((name) => element('th', { scope: 'col', textContent: t(name) }))));
    const body = element('tbody', {}, ...t('compare_rows').map((name, k) => row(name, left[k], right[k])));
    const changes = element('tbody', { className: 'changes' }, ...changed.map((key) => row(`${labelOf(key)} (${key})`, given(state.kept, a, key), given(state.keys, b, key))));
    table.replaceChildren(head, body, changes);
  }

  listen((what) => {
    if (what === 'words') {
      translate(place);
      if (shown) show();
    } else if (what === 'traffic') {
      if (shown) show();
    } else if (what === 'case' || what === 'view') ask();
  });
}
