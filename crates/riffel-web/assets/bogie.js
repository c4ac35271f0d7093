// Curve: profiles of a wheel and a rail, nominal or from files, and how a typical metro bogie stands on them.

import { letterSize } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, worded } from './elements.js';
import { Fault, Line } from './server.js';
import { currentLanguage, t, translate } from './words.js';

const NOMINAL = { wheel: ['S1002', 'cone-1:40'], rail: ['60E1', '60E2', '54E1', 'BS113A'] };
/** Largest file [bytes]: some thousand points. */
const LARGEST = 80_000;

export function startBogie({ state, listen, complain, banner }) {
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
  const radius = element('input', { id: 'curve-radius', type: 'number', value: '180', min: '5', max: '100000', step: 'any' });
  const speed = element('input', { id: 'curve-speed', type: 'number', value: '45', min: '1', max: '400', step: 'any' });
  const numbers = [[radius, 'curve_radius'], [speed, 'curve_speed']].map(([field, word]) => {
    field.addEventListener('change', ask);
    return element('span', { className: 'choice' }, worded('label', word, { htmlFor: field.id }), field);
  });
  const outlines = element('div', { className: 'curve tall', id: 'outlines' });
  const curvatures = element('div', { className: 'curve', id: 'curvatures' });
  const table = element('table', { className: 'comparison', id: 'wheels' });
  const trouble = element('p', { className: 'why', id: 'no-equilibrium', hidden: true });
  const remarks = element('ul', { id: 'profile-remarks' });
  place.append(
    element('div', { className: 'panel wide strip' }, ...choices.map(({ part }) => part), ...numbers, worded('p', 'bogie_intro', { className: 'why' })),
    element('article', { className: 'panel half' }, element('header', {}, worded('h2', 'profiles_panel')), outlines, curvatures),
    element('article', { className: 'panel half' }, element('header', {}, worded('h2', 'wheels_panel')), trouble, element('div', { className: 'sideways' }, table), remarks),
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
    const [radius_m, kilometres] = [radius, speed].map((field) => field.valueAsNumber);
    if (!Number.isFinite(radius_m) || !Number.isFinite(kilometres)) return;
    line.ask({ ...chosen, radius_m, speed_m_per_s: kilometres / 3.6 }, (answer) => {
      shown = answer;
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
    trouble.textContent = fault ? `${t('no_equilibrium')} ${fault.message}` : '';
    table.hidden = Boolean(fault);
    const cell = (value, digits) => element('td', { textContent: value.toLocaleString(currentLanguage(), { minimumFractionDigits: digits, maximumFractionDigits: digits }).replace('-', '−') });
    const heads = ['shift_mm', 'attack_mrad', 'along_percent', 'across_percent', 'angle_degrees', 'load_kn', 't_gamma'];
    table.replaceChildren(
      element('thead', {}, element('tr', {}, element('td'), ...heads.map((head) => element('th', { scope: 'col', textContent: t(head) })))),
      element('tbody', {}, ...wheels.map((wheel) => {
        const { lateral_shift_m, angle_of_attack_rad } = wheelsets[wheel.wheelset - 1];
        return element('tr', {}, element('th', { scope: 'row', textContent: `${wheel.wheelset} ${t(wheel.rail)}` }),
          cell(1e3 * lateral_shift_m, 2), cell(1e3 * angle_of_attack_rad, 2), cell(100 * wheel.longitudinal_creepage, 3), cell(100 * wheel.lateral_creepage, 3),
          cell((180 / Math.PI) * wheel.contact_angle_rad, 1), cell(1e-3 * wheel.normal_force_n, 1), cell(wheel.t_gamma_n, 0));
      })),
    );
    remarks.replaceChildren(...[...shown.remarks, ...(shown.curve.remarks ?? [])].filter((words, k, all) => all.indexOf(words) === k)
      .map((words) => element('li', { textContent: words, lang: 'en' })));
  }

  listen((what) => {
    if (what === 'words') {
      translate(place);
      show();
    } else if (what === 'view' && state.view === 'curve' && !shown) ask();
  });
}
