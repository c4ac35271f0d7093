// Curve: profiles of a wheel and a rail, nominal or from files, and how a bogie stands on them.

import { drawBogie } from './bogie-drawing.js';
import { BogieWheels } from './bogie-wheels.js';
import { letterSize } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, fillTable, row, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords } from './messages.js';
import { NumberField, UNITS } from './number-field.js';
import { remember, remembered } from './remembered.js';
import { Fault, Line, json } from './server.js';
import { currentLanguage, t, translate } from './words.js';

const NOMINAL = { wheel: ['S1002', 'cone-1:40'], rail: ['60E1', '60E2', '54E1', 'BS113A'] };
/** How the coordinates of a file may stand. */
const ORIENTATIONS = ['found', 'as-written', 'mirrored', 'upside-down', 'turned'];
/** Largest file [bytes]: some thousand points. */
const LARGEST = 80_000;

/** Place in the page, word, key of the case of the curve or side of the friction, units, value at first, least and most. */
const FIELDS = [
  ['curve-radius', 'curve_radius', 'curve.radius', 'length', 180, -100000, 100000],
  ['curve-speed', 'curve_speed', 'curve.speed', 'speed', 45, 1, 400],
  ['curve-cant', 'curve_cant', 'curve.cant', 'millimetres', 0.1, 0, 0.3],
  ['curve-gauge', 'curve_gauge', 'profiles.gauge', 'millimetres', 1.435, 0.9, 1.8],
  ['bogie-wheelbase', 'bogie_wheelbase', 'bogie.wheelbase', 'length', 2.1, 0.5, 6],
  ['bogie-axle-load', 'bogie_axle_load', 'bogie.mass_per_axle', 'mass', 10e3, 2e3, 50e3],
  ['bogie-longitudinal', 'bogie_longitudinal', 'bogie.primary_longitudinal_stiffness', 'stiffness', 8e6, 0.01e6, 1000e6],
  ['bogie-lateral', 'bogie_lateral', 'bogie.primary_lateral_stiffness', 'stiffness', 4e6, 0.01e6, 1000e6],
  ['friction-high', 'friction_high', 'friction_high', 'ratio', 0.4, 0.01, 1],
  ['friction-low', 'friction_low', 'friction_low', 'ratio', 0.4, 0.01, 1],
];
/** Narrowest curve to either side [m]. */
const NARROWEST = 5;
/** Where a reload finds the fields and the profiles. */
const KEPT = 'riffel-curve';

/** Fields and profiles as they were before a reload, as far as they are such. */
function kept() {
  const { values = {}, chosen = {} } = remembered(KEPT) ?? {};
  const isGood = ([, , key, , , low, high]) => values[key] >= low && values[key] <= high && (key !== 'curve.radius' || Math.abs(values[key]) >= NARROWEST);
  const isProfile = ([kind, { name, text, orientation = 'found' }]) => (text === undefined ? NOMINAL[kind]?.includes(name) : kind in NOMINAL && typeof name === 'string' && typeof text === 'string' && ORIENTATIONS.includes(orientation));
  return { values: Object.fromEntries(FIELDS.filter(isGood).map(([, , key]) => [key, values[key]])), chosen: Object.entries(chosen).filter(isProfile) };
}

export function startBogie({ state, traffic, listen, complain, banner, inLabels, unitOf, replace, save }) {
  const place = document.getElementById('view-curve');
  const line = new Line('/api/curve', json);
  const chosen = { wheel: { name: 'S1002' }, rail: { name: '60E1' } };
  const growth = new BogieWheels({ state, traffic, unitOf, inLabels, replace, save });
  let shown = null;
  /** Whether the last question had no answer: it is asked again as soon as a map has one. */
  let failed = false;

  const choices = Object.entries(NOMINAL).map(([kind, names]) => {
    const select = element('select', { id: `profile-${kind}` }, ...names.map((name) => element('option', { value: name, textContent: name })));
    const file = element('input', { type: 'file', id: `profile-file-${kind}`, className: 'away' });
    select.addEventListener('change', () => {
      // The option of a file stays as long as it is chosen.
      if (select.value !== chosen[kind].name) choose(kind, { name: select.value });
    });
    const orientation = element('select', { id: `orientation-${kind}`, hidden: true }, ...ORIENTATIONS.map((value) => worded('option', `stands_${value}`, { value })));
    orientation.dataset.tLabel = `${kind}_orientation`;
    orientation.addEventListener('change', () => choose(kind, { ...chosen[kind], orientation: orientation.value === 'found' ? undefined : orientation.value }));
    file.addEventListener('change', async () => {
      const [one] = file.files;
      file.value = '';
      if (!one) return;
      if (one.size > LARGEST) {
        complain(new Fault({ message: t('profile_large', one.name) }, 413));
        return;
      }
      choose(kind, { name: one.name, text: await one.text() });
    });
    return {
      kind, select, orientation,
      part: element('span', { className: 'choice' }, worded('label', `${kind}_profile`, { htmlFor: select.id }), select, worded('label', 'choose', { htmlFor: file.id, className: 'button plain' }), file, orientation),
    };
  });
  const before = kept();
  const values = { ...Object.fromEntries(FIELDS.map(([, , key, , value]) => [key, value])), ...before.values };
  const fields = FIELDS.map(([id, word, key, units, otherwise, low, high]) => Object.assign(new NumberField({
    id, word, units: UNITS[units], low, high, onTrouble: settle,
    accept: (value = otherwise) => {
      if (key === 'curve.radius' && Math.abs(value) < NARROWEST) return t('too_narrow', { label: t(word), narrowest: NARROWEST });
      values[key] = value;
      keep();
      showFields();
      ask();
      return '';
    },
  }), { key, otherwise }));
  const showFields = () => fields.forEach((field) => field.show(values[field.key], field.otherwise));
  const outlines = element('div', { className: 'curve tall', id: 'outlines' });
  const curvatures = element('div', { className: 'curve', id: 'curvatures' });
  const table = element('table', { className: 'comparison', id: 'wheels' });
  const above = element('div', { id: 'bogie-above' });
  const trouble = element('p', { className: 'why', id: 'no-equilibrium', hidden: true });
  const remarks = element('ul', { id: 'profile-remarks' });
  const titled = (word) => element('header', {}, worded('h2', word));
  const heads = { outlines: titled('profiles_panel'), curvatures: titled('curvatures_panel'), wheels: titled('wheels_panel') };
  offer(heads.outlines, () => shown && { name: 'profiles', plot: outlines }, save);
  offer(heads.curvatures, () => shown && { name: 'curvatures', plot: curvatures }, save);
  offer(heads.wheels, () => shown && { name: 'bogie', drawing: above, table }, save);
  place.append(
    element('div', { className: 'panel wide strip' }, ...choices.map(({ part }) => part), ...fields.map(({ row }) => row), worded('p', 'bogie_intro', { className: 'why' })),
    element('article', { className: 'panel half' }, heads.outlines, outlines, heads.curvatures, curvatures),
    element('article', { className: 'panel half' }, heads.wheels, trouble, above, element('div', { className: 'sideways' }, table), remarks),
    growth.panel,
  );

  function choose(kind, profile) {
    chosen[kind] = profile;
    const { select, orientation } = choices.find((one) => one.kind === kind);
    select.querySelectorAll('[data-file]').forEach((option) => option.remove());
    if (profile.text !== undefined) {
      const option = element('option', { value: profile.name, textContent: profile.name });
      option.dataset.file = 'true';
      select.append(option);
    }
    select.value = profile.name;
    orientation.hidden = profile.text === undefined;
    orientation.value = profile.orientation ?? 'found';
    keep();
    ask();
  }

  const keep = () => remember(KEPT, { values, chosen });

  function ask() {
    if (state.view !== 'curve') return;
    if (fields.some(({ isWrong }) => isWrong)) return;
    const { friction_high: high, friction_low: low, ...keys } = values;
    // The outer rail of a curve to the right is the left one. Speeds are held in the unit that all of them have in the page.
    const [left, right] = keys['curve.radius'] > 0 ? [high, low] : [low, high];
    const asked = { ...chosen, set: { ...keys, 'curve.speed': keys['curve.speed'] / 3.6, 'contact.friction.left': left, 'contact.friction.right': right } };
    settle(true);
    line.ask(asked, (answer) => {
      shown = { ...answer, set: asked.set };
      failed = false;
      banner.clear();
      settle();
      show();
      growth.ask(answer.curve.fault ? null : asked);
    }, (fault) => {
      failed = true;
      complain(fault, { until: 'success' });
    });
  }

  /** What is shown is no longer, or again, that of the fields. */
  function settle(asked = false) {
    const is = asked || line.pending || fields.some(({ isWrong }) => isWrong);
    for (const panel of place.querySelectorAll('.panel.half')) panel.classList.toggle('stale', is);
    growth.settle(is);
  }

  function show() {
    if (!shown) return;
    const colors = palette();
    const { profiles } = shown.outlines;
    const words = [t('wheel'), t('rail')];
    const trace = (of) => profiles.map((profile, k) => ({
      type: 'scatter', mode: 'lines', name: words[k], x: profile.x_m.map((x) => 1e3 * x), y: of(profile), line: { color: colors[k + 1], width: 1.6 },
      hovertemplate: `%{x:.1f} · %{y:.4~g}<extra>${words[k]}</extra>`,
    }));
    const across = () => axis(t('across_profile'));
    const legend = { showlegend: true, margin: { l: 4 * letterSize(), r: 10, t: 2 * letterSize(), b: 3 * letterSize() } };
    draw(outlines, trace((profile) => profile.height_m.map((y) => 1e3 * y)), layout({ xaxis: across(), yaxis: axis(t('height_profile')), ...legend }));
    // Corners of nominal profiles would hide all else.
    const visible = (value) => (Math.abs(value) < 100 ? value : null);
    draw(curvatures, trace((profile) => profile.curvature_1_per_m.map(visible)), layout({ xaxis: across(), yaxis: axis(t('curvature_profile')) }));
    const { fault, wheels = [], wheelsets = [] } = shown.curve;
    trouble.hidden = !fault;
    trouble.textContent = fault ? `${t('no_equilibrium')} ${inWords(fault.message, inLabels)}` : '';
    table.hidden = above.hidden = heads.wheels.querySelector('.take').hidden = Boolean(fault);
    if (!fault) drawBogie(above, shown.curve, { radius: shown.set['curve.radius'], gauge: shown.set['profiles.gauge'], wheelbase: shown.set['bogie.wheelbase'], label: t('bogie_from_above') });
    const cell = (value, digits) => value.toLocaleString(currentLanguage(), { minimumFractionDigits: digits, maximumFractionDigits: digits }).replace('-', '−');
    const columns = ['shift_mm', 'attack_mrad', 'along_percent', 'across_percent', 'angle_degrees', 'load_kn', 't_gamma'];
    fillTable(table, ['', ...columns.map((head) => t(head))], wheels.map((wheel) => {
      const { lateral_shift_m, angle_of_attack_rad } = wheelsets[wheel.wheelset - 1];
      return row(`${wheel.wheelset} ${t(wheel.rail)}`, [
        cell(1e3 * lateral_shift_m, 2), cell(1e3 * angle_of_attack_rad, 2), cell(100 * wheel.longitudinal_creepage, 3), cell(100 * wheel.lateral_creepage, 3),
        cell((180 / Math.PI) * wheel.contact_angle_rad, 1), cell(1e-3 * wheel.normal_force_n, 1), cell(wheel.t_gamma_n, 0),
      ]);
    }));
    remarks.replaceChildren(...[...shown.remarks, ...(shown.curve.remarks ?? [])].map((one) => inWords(one)).filter((words, k, all) => all.indexOf(words) === k)
      .map((words) => element('li', { textContent: words })));
  }

  showFields();
  for (const [kind, profile] of before.chosen) choose(kind, profile);
  listen((what) => {
    if (what === 'words') {
      translate(place);
      showFields();
      show();
      growth.reword();
    } else if (what === 'traffic') growth.reword();
    else if ((what === 'view' && !shown) || (what === 'map' && failed)) ask();
    else if ((what === 'view' || what === 'map') && shown && state.view === 'curve') growth.caseChanged();
  });
}
