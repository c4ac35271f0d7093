// Curve: profiles of a wheel and a rail, nominal or from files, and how a bogie stands on them.

import { drawBogie } from './bogie-drawing.js';
import { letterSize } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { inWords } from './german.js';
import { Fault, Line } from './server.js';
import { currentLanguage, t, translate } from './words.js';

const NOMINAL = { wheel: ['S1002', 'cone-1:40'], rail: ['60E1', '60E2', '54E1', 'BS113A'] };
/** Largest file [bytes]: some thousand points. */
const LARGEST = 80_000;

/** Place in the page, word, key of the question, value at first, least and most, and what a unit of the field is in SI. */
const FIELDS = [
  ['curve-radius', 'curve_radius', 'radius_m', '180', 5, 100000, 1],
  ['curve-speed', 'curve_speed', 'speed_m_per_s', '45', 1, 400, 1 / 3.6],
  ['curve-cant', 'curve_cant', 'cant_m', '100', 0, 300, 1e-3],
  ['curve-gauge', 'curve_gauge', 'gauge_m', '1435', 900, 1800, 1e-3],
  ['bogie-wheelbase', 'bogie_wheelbase', 'wheelbase_m', '2.1', 0.5, 6, 1],
  ['bogie-axle-load', 'bogie_axle_load', 'mass_per_axle_kg', '10', 2, 50, 1e3],
  ['bogie-longitudinal', 'bogie_longitudinal', 'longitudinal_stiffness_n_per_m', '8', 0.01, 1000, 1e6],
  ['bogie-lateral', 'bogie_lateral', 'lateral_stiffness_n_per_m', '4', 0.01, 1000, 1e6],
  ['friction-high', 'friction_high', 'friction_high', '0.4', 0.01, 1, 1],
  ['friction-low', 'friction_low', 'friction_low', '0.4', 0.01, 1, 1],
];

export function startBogie({ state, listen, complain, banner, save }) {
  const place = document.getElementById('view-curve');
  const line = new Line('/api/curve', (answer) => answer.json());
  const chosen = { wheel: { name: 'S1002' }, rail: { name: '60E1' } };
  let shown = null;

  const choices = Object.entries(NOMINAL).map(([kind, names]) => {
    const select = element('select', { id: `profile-${kind}` }, ...names.map((name) => element('option', { value: name, textContent: name })));
    const file = element('input', { type: 'file', id: `profile-file-${kind}`, className: 'away' });
    select.addEventListener('change', () => {
      // The option of a file stays as long as it is chosen.
      if (select.value !== chosen[kind].name) choose(kind, { name: select.value });
    });
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
      kind, select,
      part: element('span', { className: 'choice' }, worded('label', `${kind}_profile`, { htmlFor: select.id }), select, worded('label', 'choose', { htmlFor: file.id, className: 'button plain' }), file),
    };
  });
  const fields = FIELDS.map(([id, word, key, value, low, high, factor]) => {
    const input = element('input', { id, type: 'number', value, min: key === 'radius_m' ? -high : low, max: high, step: 'any' });
    input.addEventListener('change', ask);
    return { input, word, key, low, high, factor, part: element('span', { className: 'choice' }, worded('label', word, { htmlFor: id }), input) };
  });
  const refused = element('p', { className: 'why', id: 'curve-refused', role: 'alert', hidden: true });
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
    element('div', { className: 'panel wide strip' }, ...choices.map(({ part }) => part), ...fields.map(({ part }) => part), refused, worded('p', 'bogie_intro', { className: 'why' })),
    element('article', { className: 'panel half' }, heads.outlines, outlines, heads.curvatures, curvatures),
    element('article', { className: 'panel half' }, heads.wheels, trouble, above, element('div', { className: 'sideways' }, table), remarks),
  );

  function choose(kind, profile) {
    chosen[kind] = profile;
    const { select } = choices.find((one) => one.kind === kind);
    select.querySelectorAll('[data-file]').forEach((option) => option.remove());
    if (profile.text !== undefined) {
      const option = element('option', { value: profile.name, textContent: profile.name });
      option.dataset.file = 'true';
      select.append(option);
    }
    select.value = profile.name;
    ask();
  }

  function ask() {
    if (state.view !== 'curve') return;
    const wrong = fields.filter(({ input, low, high }) => !(Math.abs(input.valueAsNumber) >= low && input.valueAsNumber <= high));
    for (const field of fields) field.input.setAttribute('aria-invalid', String(wrong.includes(field)));
    refused.hidden = !wrong.length;
    refused.textContent = wrong.map(({ word, low, high }) => t('bogie_value', { label: t(word), low, high })).join(' ');
    if (wrong.length) return;
    const asked = Object.fromEntries(fields.map(({ input, key, factor }) => [key, factor * input.valueAsNumber]));
    line.ask({ ...chosen, ...asked }, (answer) => {
      shown = { ...answer, asked };
      banner.clear();
      show();
    }, (fault) => complain(fault, { until: 'success' }));
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
    trouble.textContent = fault ? `${t('no_equilibrium')} ${inWords(fault.message)}` : '';
    table.hidden = above.hidden = heads.wheels.querySelector('.take').hidden = Boolean(fault);
    if (!fault) drawBogie(above, shown.curve, { radius: shown.asked.radius_m, wheelbase: shown.asked.wheelbase_m, label: t('bogie_from_above') });
    const cell = (value, digits) => element('td', { textContent: value.toLocaleString(currentLanguage(), { minimumFractionDigits: digits, maximumFractionDigits: digits }).replace('-', '−') });
    const columns = ['shift_mm', 'attack_mrad', 'along_percent', 'across_percent', 'angle_degrees', 'load_kn', 't_gamma'];
    table.replaceChildren(
      element('thead', {}, element('tr', {}, element('td'), ...columns.map((head) => element('th', { scope: 'col', textContent: t(head) })))),
      element('tbody', {}, ...wheels.map((wheel) => {
        const { lateral_shift_m, angle_of_attack_rad } = wheelsets[wheel.wheelset - 1];
        return element('tr', {}, element('th', { scope: 'row', textContent: `${wheel.wheelset} ${t(wheel.rail)}` }),
          cell(1e3 * lateral_shift_m, 2), cell(1e3 * angle_of_attack_rad, 2), cell(100 * wheel.longitudinal_creepage, 3), cell(100 * wheel.lateral_creepage, 3),
          cell((180 / Math.PI) * wheel.contact_angle_rad, 1), cell(1e-3 * wheel.normal_force_n, 1), cell(wheel.t_gamma_n, 0));
      })),
    );
    remarks.replaceChildren(...[...shown.remarks, ...(shown.curve.remarks ?? [])].map((note) => note[currentLanguage()]).filter((words, k, all) => all.indexOf(words) === k)
      .map((words) => element('li', { textContent: words })));
  }

  listen((what) => {
    if (what === 'words') {
      translate(place);
      show();
    } else if (what === 'view' && state.view === 'curve' && !shown) ask();
  });
}
