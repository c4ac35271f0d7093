// Compare: variants that were kept beside the case at hand.

import { palette } from './curves.js';
import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords, said } from './messages.js';
import { shownUnit, si } from './keys.js';
import { MapView, drawBar, toMap } from './map-view.js';
import { Line, framed, json } from './server.js';
import { Sweep, drawCurves } from './sweep.js';
import { reportOf } from './variant-report.js';
import { MOST_VARIANTS, ownName } from './variants.js';
import { labelOf, wordsOf, number, passages, power, range, speed, t, translate, unitOfSpeed, written } from './words.js';

/** How long an answer may take before what is shown pales [ms]. */
const PATIENCE = 150;

/** Keys with their values, dotted. */
const flat = (table, path = '') =>
  Object.entries(table ?? {}).flatMap(([key, value]) => (value !== null && typeof value === 'object' ? flat(value, `${path}${key}.`) : [[path + key, value]]));

export function startCompare({ state, traffic, listen, complain, setVariants, replace, save, unitOf }) {
  const place = document.getElementById('view-compare');
  const maps = new Line('/api/compare', framed);
  const growth = new Line('/api/growth', json);
  /** Head and map of each case that is shown, by case, window and traffic: while the case changes, the variants stay. */
  let known = new Map();
  let curves = null;
  /** Places of the two whose maps are shown; null is the case at hand. */
  let pair = [0, null];

  // What is kept ---------------------------------------------------------------------------------------

  const keep = worded('button', 'keep', { type: 'button', className: 'plain', id: 'keep' });
  const report = worded('button', 'report_variants', { type: 'button', className: 'plain', id: 'report-variants', hidden: true });
  const list = element('ul', { className: 'variants' });
  const hint = worded('p', 'nothing_kept', { className: 'why' });
  const bar = element('div', { className: 'panel wide strip' }, element('div', { className: 'buttons' }, keep, report), hint, list);

  // The maps -------------------------------------------------------------------------------------------

  const choices = ['first', 'second'].map((which, k) => {
    const choice = element('select', { id: `compare-${which}` });
    choice.dataset.tLabel = which;
    choice.addEventListener('change', () => {
      pair[k] = choice.value === 'now' ? null : Number(choice.value);
      show();
    });
    return choice;
  });
  const panels = ['left', 'right', 'difference'].map((name, k) => {
    const heading = k < 2 ? element('h2', {}, choices[k]) : worded('h2', name);
    const aside = element('span', { className: 'aside' });
    const map = element('div', { className: 'map' });
    const legend = element('div', { className: 'bar' });
    const header = element('header', {}, heading, aside);
    const panel = element('article', { className: 'panel', hidden: true, id: `compare-${name}` }, header, map, element('footer', {}, legend));
    const view = new MapView(map, { kind: name === 'difference' ? 'difference' : 'growth', label: name });
    offer(header, () => ({ name: `compare-${name}`, map: view }), save);
    return { name, panel, legend, aside, view };
  });
  const [, , difference] = panels;
  const curvesPlace = element('div', { className: 'curve tall', id: 'compare-curves' });
  const atSpeed = element('span', { className: 'aside' });
  const curvesHead = element('header', {}, worded('h2', 'growth_curve'), atSpeed);
  const curvesPanel = element('article', { className: 'panel wide', hidden: true }, curvesHead, curvesPlace);
  offer(curvesHead, () => ({ name: 'compare-growth', plot: curvesPlace }), save);
  const table = element('table', { className: 'comparison' });
  const common = element('p', { className: 'fine', id: 'compare-window' });
  const tablePanel = element('article', { className: 'panel wide', hidden: true }, common, element('div', { className: 'sideways' }, table));
  const sweep = new Sweep({ state, traffic, complain, save, onKeep: setVariants });
  place.append(bar, ...panels.map(({ panel }) => panel), curvesPanel, tablePanel, sweep.panel);

  keep.addEventListener('click', () => {
    if (state.variants.length < MOST_VARIANTS) setVariants([...state.variants, { name: ownName('', state.variants), case: structuredClone(state.keys) }]);
  });
  report.addEventListener('click', () => reportOf({ names: entries().map(({ name }) => name), table, panels, curvesPlace, speed: speed(state.point.speed) })
    .then((html) => save(new Blob([html], { type: 'text/html' }), 'variants.html'), (fault) => complain(fault, { what: `${t('report_variants')}: ` })));

  function rename(at, text) {
    const { variants } = state;
    const name = ownName(text, variants.filter((_, k) => k !== at));
    if (text.trim() && name !== variants[at].name) setVariants(variants.map((one, k) => (k === at ? { ...one, name } : one)));
    else showList();
  }

  function showList() {
    const { variants } = state;
    keep.disabled = variants.length >= MOST_VARIANTS;
    keep.title = keep.disabled ? t('most_kept', MOST_VARIANTS) : '';
    hint.hidden = variants.length > 0;
    list.replaceChildren(...variants.map((variant, k) => {
      const name = element('input', { type: 'text', value: variant.name, ariaLabel: t('name_of_variant'), maxLength: 40, spellcheck: false });
      name.addEventListener('change', () => rename(k, name.value));
      const show = element('button', { type: 'button', className: 'plain small', textContent: t('open_variant') });
      show.setAttribute('aria-label', `${t('open_variant')}: ${variant.name}`);
      show.addEventListener('click', () => replace({ case: structuredClone(variant.case), point: state.point, tab: 'compare' }, t('variant_open', variant.name)));
      const drop = element('button', { type: 'button', className: 'plain small', textContent: '✕', title: t('drop') });
      drop.setAttribute('aria-label', `${t('drop')}: ${variant.name}`);
      drop.addEventListener('click', () => setVariants(variants.filter((_, at) => at !== k)));
      const mark = element('i', {});
      mark.style.background = colorOf(k);
      return element('li', {}, mark, name, show, drop);
    }));
  }

  const colorOf = (k) => (k === null ? palette()[0] : palette()[1 + k]);

  /** What stands beside each other: the variants, then the case at hand. */
  const entries = () => [...state.variants, { name: t('now'), case: state.keys }].map((one) => ({ ...one, key: JSON.stringify([one.case, state.keys.map ?? null, traffic.given]) }));

  // Asking ---------------------------------------------------------------------------------------------

  function ask() {
    showList();
    sweep.caseChanged();
    if (!state.variants.length) show();
    if (!state.variants.length || state.view !== 'compare' || !state.keys) return;
    const missing = [...new Map(entries().filter(({ key }) => !known.has(key)).map((one) => [one.key, one])).values()];
    askCurves();
    if (!missing.length) {
      stale(false);
      show();
      return;
    }
    stale(true);
    const given = structuredClone(state.keys);
    maps.ask({ variants: missing.map(({ name, case: keys }) => ({ name, case: { keys } })), case: { keys: given }, traffic: traffic.givenFile }, ({ head, values }) => {
      let offset = 0;
      head.variants.forEach((one, k) => {
        const map = toMap(one, values, offset);
        offset += map.values.length;
        known.set(missing[k].key, { head: one, map });
      });
      const needed = new Set(entries().map(({ key }) => key));
      if ([...needed].every((key) => known.has(key))) known = new Map([...known].filter(([key]) => needed.has(key)));
      stale(maps.pending);
      show();
    }, (fault) => {
      // What the case at hand is refused for stands at its field.
      if (!fault.key) complain(fault, { until: 'case' });
    });
  }

  function askCurves() {
    if (!state.variants.length || state.view !== 'compare' || !state.point) return;
    const given = entries();
    const at = state.point.speed;
    growth.ask({ for: 'variants', curves: given.map(({ name, case: keys }) => ({ name, case: { keys }, speed_m_per_s: at })), case: { keys: structuredClone(state.keys) } }, (answer) => {
      curves = { lines: answer.map((one, k) => ({ ...one, variant: k < given.length - 1 ? k : null, name: given[k].name })), speed: at };
      showCurves();
    }, () => {
      // The question for the maps tells of the same fault.
    });
  }

  /** What is shown is no longer, or again, that of the case. */
  let paling;
  function stale(is) {
    clearTimeout(paling);
    const pale = () => [...panels.map(({ panel }) => panel), curvesPanel, tablePanel].forEach((panel) => panel.classList.toggle('stale', is));
    if (is) paling = setTimeout(pale, PATIENCE);
    else pale();
  }

  // Showing --------------------------------------------------------------------------------------------

  function show() {
    const all = entries();
    const there = state.variants.length > 0 && all.every(({ key }) => known.has(key));
    const hidden = !state.variants.length || (!there && tablePanel.hidden);
    const appears = curvesPanel.hidden && !hidden;
    for (const panel of [...panels.map(({ panel: one }) => one), curvesPanel, tablePanel, report]) panel.hidden = hidden;
    // Curves may be answered before the maps.
    if (appears) showCurves();
    if (!there) return;
    pair = pair.map((at) => (at === null || at < state.variants.length ? at : 0));
    const place = (at) => (at === null ? all.length - 1 : at);
    choices.forEach((choice, k) => {
      choice.replaceChildren(...all.map(({ name }, at) => element('option', { value: at === all.length - 1 ? 'now' : at, textContent: name })));
      choice.value = pair[k] ?? 'now';
    });
    const [one, other] = pair.map((at) => known.get(all[place(at)].key).map);
    // How fast something decays that grows in neither case is of no interest.
    const between = (value, k) => (value > 0 || one.values[k] > 0 ? Math.max(value, 0) - Math.max(one.values[k], 0) : 0);
    const change = { ...other, ridge: null, branches: null, bestFit: null, values: other.values.map(between) };
    change.strongest = change.values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    // Both maps in one scale, or they could not be compared.
    const scale = Math.max(one.strongest, other.strongest) || null;
    const names = pair.map((at) => all[place(at)].name);
    difference.aside.textContent = `${names[1]} − ${names[0]}`;
    [one, other, change].forEach((map, k) => {
      const { view, legend } = panels[k];
      view.held = k < 2 ? scale : null;
      view.label = k < 2 ? names[k] : t('difference');
      view.show(map);
      drawBar(legend, view, k < 2 ? t('growth_rate') : `${t('less')} / ${t('more')}`);
    });
    rows(all);
  }

  function showCurves() {
    if (!curves || curvesPanel.hidden || state.view !== 'compare') return;
    atSpeed.textContent = speed(curves.speed);
    // The case at hand is drawn last, over the others.
    drawCurves(curvesPlace, curves.lines.map((one) => ({ ...one, name: one.variant === null ? t('now') : one.name, color: colorOf(one.variant), width: one.variant === null ? 2.4 : 1.6 })));
  }

  /** The value of a key of a complete case as the form shows it: "39.7 kg m²". */
  function shown(key, value, digits) {
    if (value === undefined || value === null) return '–';
    const unit = unitOf(key);
    const [name, size] = shownUnit(key, unit);
    const plain = Number.parseFloat(value);
    if (unit !== undefined && Number.isFinite(plain)) return `${number(plain / size, digits)} ${name}`.trim();
    return typeof value === 'number' ? number(value, digits) : written(value);
  }

  /** The values of a key, with as many digits as tell them apart. */
  function values(key, cases) {
    const all = cases.map((one) => one.get(key));
    const count = new Set(all).size;
    const texts = [3, 6, 12].map((digits) => all.map((value) => shown(key, value, digits)));
    return texts.find((given) => new Set(given).size === count) ?? texts.at(-1);
  }

  /** The window that all maps have, and whose own is another: their highest growth may lie outside. */
  function windowInWords(all, { wavelength_m: wavelength, speed_m_per_s: at }) {
    const window = JSON.stringify(state.keys.map ?? null);
    const others = all.filter(({ case: keys }) => JSON.stringify(keys.map ?? null) !== window).map(({ name }) => t('quoted', name));
    const mm = range([wavelength.min, wavelength.max], (value) => number(1e3 * value));
    return [t('common_window', `${mm} mm, ${range([at.min, at.max], (value) => speed(value).replace(/ .*/, ''))} ${unitOfSpeed()[0]}`), others.length && t('other_windows', others.join(', '))].filter(Boolean).join(' ');
  }

  function rows(all) {
    const heads = all.map(({ key }) => known.get(key).head);
    const of = (value, format) => (value === null || value === undefined ? '–' : format(value));
    const millimetres = (wavelength, digits) => `${number(1e3 * wavelength, digits)} mm`;
    const onTheLine = ({ under_traffic: { fault, fastest, doubles_in: time }, complete }) => {
      if (fault) return [said(fault.message).text, '–', '–', '–'];
      if (!fastest) return [t('nothing_grows_here'), '–', '–', '–'];
      const count = fastest.doubling_passages;
      return [millimetres(fastest.wavelength_m, 2), inWords(time), passages(count), traffic.words(count, si(complete, 'contact.normal_load')).mass];
    };
    common.textContent = windowInWords(all, heads[0].window);
    const columns = heads.map((head) => {
      const high = head.highest;
      return [
        ...onTheLine(head), of(high?.growth_rate_per_passage, (v) => power(v, 3)), of(high?.wavelength_m, (v) => millimetres(v)), of(high?.speed_m_per_s, speed),
        of(high?.frequency_hz, (v) => `${number(v)} Hz`), of(head.best_fit_frequency_hz, (v) => `${number(v)} Hz`),
        `${number(100 * head.derived.creepage)} %`, `${number(1e-6 * head.derived.contact_stiffness_n_per_m)} MN/m`,
      ];
    });
    const cases = heads.map(({ complete }) => new Map(flat(complete)));
    const differ = (key) => cases.some((one) => one.get(key) !== cases[0].get(key));
    const keys = [...new Set(cases.flatMap((one) => [...one.keys()]))].filter((key) => key !== 'title' && differ(key));
    fillTable(table, ['', ...all.map(({ name }) => name)], wordsOf('compare_rows').map((name, k) => row(name, columns.map((column) => column[k]))));
    table.append(element('tbody', { className: 'changes' }, ...keys.map((key) => row(`${labelOf(key)} (${key})`, values(key, cases)))));
  }

  listen((what) => {
    if (what === 'words') {
      translate(place);
      showList();
      show();
      showCurves();
      sweep.reword();
    } else if (what === 'case' || what === 'view' || what === 'variants' || what === 'traffic') ask();
    else if (what === 'point') askCurves();
    // By then it is known whether the track has pads.
    else if (what === 'map') sweep.caseChanged();
  });
}
