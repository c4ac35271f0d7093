// Motion: the wheel over a wave in time, and the wheelset in its modes.

import { letterSize, theme } from './colors.js';
import { axis, draw, layout, palette } from './curves.js';
import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { caseTitle, inWords, said } from './messages.js';
import { NumberField, UNITS } from './number-field.js';
import { Line, json } from './server.js';
import { WheelsetDrawing } from './wheelset-drawing.js';
import { currentLanguage, number, speed, t, translate } from './words.js';

/** Time of one swing of a mode on the screen [ms]: what takes milliseconds in truth. */
const SWING = 1800;
/** Amplitudes that are taken [m]. */
const [LOWEST, HIGHEST] = [0.01e-6, 2000e-6];

export function startMotion({ state, listen, banner, inLabels, save }) {
  const place = document.getElementById('view-motion');
  const still = matchMedia('(prefers-reduced-motion: reduce)');

  // The wheel over a wave ------------------------------------------------------------------------------

  const passage = { line: new Line('/api/passage', json), answer: null, fault: null, asked: '', of: '' };
  /** The amplitude [m] that was written; none, and it is that of the case. */
  let written = null;
  const amplitude = new NumberField({
    id: 'wave-amplitude', word: 'wave_amplitude', units: UNITS.micrometres, low: LOWEST, high: HIGHEST, onTrouble: () => [waveWords, wave, waveNotes].forEach((part) => part.classList.toggle('pale', amplitude.isWrong)),
    accept: (value = null) => {
      written = value;
      showAmplitude();
      askPassage();
      return '';
    },
  });
  const showAmplitude = () => amplitude.show(written, state.at?.state.amplitude_m);
  const waveHead = element('header', {}, worded('h2', 'passage'), element('span', { className: 'aside', id: 'wave-at' }));
  const waveWords = element('p', { className: 'why', id: 'wave-words' });
  const wave = element('div', { className: 'curve strips', id: 'wave' });
  const waveNotes = element('ul', { className: 'fine', id: 'wave-notes' });
  offer(waveHead, () => passage.answer && { name: 'passage', plot: wave }, save);

  /** What the case and the cursor ask now. */
  const passageNow = () => ({ case: { keys: state.accepted }, wavelength_m: state.point?.wavelength, speed_m_per_s: state.point?.speed, amplitude_m: written ?? state.at?.state.amplitude_m });

  function askPassage() {
    paleIfOld();
    if (state.view !== 'motion' || !state.accepted || !state.point) return;
    const question = passageNow();
    if (amplitude.isWrong || !question.amplitude_m) return;
    const asked = JSON.stringify(question);
    if (asked === passage.asked) return;
    passage.asked = asked;
    const keys = state.accepted;
    const shown = (answer, fault) => {
      Object.assign(passage, { answer, fault, of: asked, at: () => `${caseTitle(keys)}: ${number(1e3 * question.wavelength_m)} mm, ${speed(question.speed_m_per_s)}` });
      showPassage();
      paleIfOld();
    };
    passage.line.ask(question, (answer) => shown(answer, null), (fault) => {
      passage.asked = '';
      shown(null, fault);
    });
  }
  passage.line.onCancel = () => {
    passage.asked = '';
    banner.say(() => t('stopped'), { ways: [['again', askPassage]] });
  };

  function showPassage() {
    const { answer, fault } = passage;
    document.getElementById('wave-at').textContent = passage.at?.() ?? '';
    showAmplitude();
    wave.hidden = waveNotes.hidden = waveHead.querySelector('.take').hidden = !answer;
    if (!answer) {
      tell(waveWords, fault);
      return;
    }
    const { course, linear, static_normal_force_n: mean, contact_loss_fraction: lost } = answer;
    const least = Math.min(...linear.normal_force_n) / mean;
    Object.assign(waveWords, {
      textContent: lost > 0 ? t('wave_apart', { percent: number(100 * lost, 2) }) : t(least < 0.5 ? 'wave_large' : 'wave_small', { share: number(Math.min(...course.normal_force_n) / mean, 2) }),
      lang: currentLanguage(),
    });
    waveNotes.replaceChildren(...answer.remarks.map((note) => element('li', { textContent: inWords(note) })));
    drawPassage(answer);
  }

  async function drawPassage({ course, linear, static_normal_force_n: mean }) {
    const [ink, blue, orange] = palette();
    const x = course.position_m.map((value) => 1e3 * value);
    const strips = [
      ['wave_height', '', [[course.height_m, 1e6]]],
      ['wave_force', 'kN', [[course.normal_force_n, 1e-3], [linear.normal_force_n, 1e-3]]],
      ['wave_creepage', '%', [[course.creepage, 100]]],
      ['wave_dissipation', 'J/m', [[course.dissipation_j_per_m, 1], [linear.dissipation_j_per_m, 1]]],
    ];
    const gap = 0.05;
    const high = (1 - gap * (strips.length - 1)) / strips.length;
    const axes = {};
    const traces = strips.flatMap(([word, , curves], k) => {
      const name = k ? `y${k + 1}` : 'y';
      const top = 1 - k * (high + gap);
      axes[k ? `yaxis${k + 1}` : 'yaxis'] = axis(t(word), { domain: [Math.max(0, top - high), top], nticks: 4 });
      return curves.map(([values, unit], of) => ({
        type: 'scatter', mode: 'lines', x, y: values.map((value) => unit * value), yaxis: name, name: t(of ? 'wave_linear' : 'wave_time'), legendgroup: of ? 'linear' : 'time', showlegend: k === 1,
        line: { width: 1.7, color: k === 0 ? ink : of ? orange : blue, dash: of ? 'dash' : 'solid' }, hovertemplate: `%{x:.3~g} mm · %{y:.4~g}<extra>${t(of ? 'wave_linear' : 'wave_time')}</extra>`,
      }));
    });
    // Where the wheel is in the air.
    const shapes = [];
    course.normal_force_n.forEach((force, k, all) => {
      if (force > 1e-9 * mean) return;
      const last = shapes.at(-1);
      if (k && all[k - 1] <= 1e-9 * mean && last) last.x1 = x[k];
      else shapes.push({ type: 'rect', xref: 'x', yref: 'paper', x0: x[k], x1: x[k], y0: 0, y1: 1, line: { width: 0 }, fillcolor: theme().warm, opacity: 0.14 });
    });
    await draw(wave, traces, layout({
      xaxis: axis(t('wave_place'), { anchor: `y${strips.length}`, range: [0, x.at(-1)] }), ...axes, shapes, showlegend: true, margin: { l: 4.4 * letterSize(), r: 10, t: 2 * letterSize(), b: 3 * letterSize() },
    }));
  }

  // The wheelset ---------------------------------------------------------------------------------------

  const modes = { line: new Line('/api/wheelset', json), answer: null, fault: null, asked: '', of: '', chosen: 0, drawing: null, playing: !still.matches, begun: 0 };
  const wheelOf = element('span', { className: 'aside', id: 'wheelset-of' });
  const wheelHead = element('header', {}, worded('h2', 'wheelset_modes'), wheelOf);
  const wheelWords = element('p', { className: 'why', id: 'wheelset-words' });
  const picture = element('div', { id: 'wheelset-drawing' });
  const play = element('button', { type: 'button', className: 'plain small', id: 'wheelset-play' });
  const list = element('fieldset', { className: 'modes', id: 'wheelset-modes' });
  const table = element('table', { hidden: true });
  offer(wheelHead, () => modes.answer && { name: 'wheelset', drawing: picture, table }, save);

  function askModes() {
    paleIfOld();
    if (state.view !== 'motion' || !state.accepted) return;
    const asked = JSON.stringify(state.accepted);
    if (asked === modes.asked) return;
    modes.asked = asked;
    const keys = state.accepted;
    const shown = (answer, fault) => {
      Object.assign(modes, { answer, fault, keys, of: asked, chosen: Math.max(0, Math.min(modes.chosen, (answer?.modes.length ?? 1) - 1)) });
      showModes();
      paleIfOld();
    };
    // A lone wheel has no modes to ask for.
    if (!state.accepted.wheelset) return shown(null, null);
    modes.line.ask({ case: { keys: state.accepted } }, (answer) => {
      // The first that is no motion of the rigid body says most.
      if (!modes.answer) modes.chosen = Math.max(0, answer.modes.findIndex(({ name }) => !name.id?.startsWith('rigid-body')));
      shown(answer, null);
    }, (fault) => {
      modes.asked = '';
      shown(null, fault);
    });
  }
  modes.line.onCancel = () => (modes.asked = '');

  function showModes() {
    const { answer, fault } = modes;
    wheelOf.textContent = modes.keys ? caseTitle(modes.keys) : '';
    picture.hidden = list.hidden = play.hidden = wheelHead.querySelector('.take').hidden = !answer;
    if (!answer) {
      if (fault || !modes.asked) tell(wheelWords, fault);
      else Object.assign(wheelWords, { textContent: t('wheelset_none'), lang: currentLanguage() });
      return;
    }
    Object.assign(wheelWords, { textContent: t('wheelset_drawn'), lang: currentLanguage() });
    list.replaceChildren(worded('legend', 'wheelset_list', { textContent: t('wheelset_list') }), ...answer.modes.map(({ frequency_hz: frequency, name }, k) => {
      const { text, language } = said(name);
      const input = element('input', { type: 'radio', name: 'wheelset-mode', value: k, checked: k === modes.chosen });
      input.addEventListener('change', () => {
        modes.chosen = k;
        modes.begun = 0;
        step();
      });
      return element('label', {}, input, element('b', { textContent: `${number(frequency)} Hz` }), element('span', { textContent: text, lang: language }));
    }));
    table.replaceChildren(element('tbody', {}, element('tr', {}, element('th', { textContent: 'frequency_hz' }), element('th', { textContent: 'mode' })),
      ...answer.modes.map(({ frequency_hz: frequency, name }) => element('tr', {}, element('td', { textContent: frequency }), element('td', { textContent: name })))));
    modes.drawing = new WheelsetDrawing(picture, answer, t('wheelset_modes'));
    step();
  }

  /** The share of the amplitude that is drawn: one that stands still is drawn where it is largest, and nothing moves unseen. */
  let frame = 0;
  let seen = false;
  new IntersectionObserver(([entry]) => {
    seen = entry.isIntersecting;
    step();
  }).observe(picture);
  function step(now = performance.now()) {
    cancelAnimationFrame(frame);
    const mode = modes.answer?.modes[modes.chosen];
    play.textContent = t(modes.playing ? 'wheelset_stop' : 'wheelset_play');
    if (!mode) return;
    const moves = modes.playing && seen;
    modes.begun ||= now - SWING / 4;
    modes.drawing.draw(mode, moves ? Math.sin((2 * Math.PI * (now - modes.begun)) / SWING) : 1);
    if (moves) frame = requestAnimationFrame(step);
  }
  play.addEventListener('click', () => {
    modes.playing = !modes.playing;
    modes.begun = 0;
    step();
  });
  still.addEventListener('change', () => {
    modes.playing = !still.matches;
    step();
  });

  // ----------------------------------------------------------------------------------------------------

  function tell(words, fault) {
    const { text, language } = fault?.status === 0 ? { text: t('gone'), language: currentLanguage() } : fault ? said(fault.message, inLabels) : { text: '', language: currentLanguage() };
    Object.assign(words, { textContent: text, lang: language });
  }

  const wavePanel = element('article', { className: 'panel half' }, waveHead, element('div', { className: 'settings' }, amplitude.row), waveWords, wave, waveNotes);
  const wheelPanel = element('article', { className: 'panel half' }, wheelHead, wheelWords, picture, element('div', { className: 'settings' }, play), list);
  place.append(wavePanel, wheelPanel);

  /** What is not of the case, cursor and amplitude at hand is pale. */
  function paleIfOld() {
    const isOld = (of, now) => !state.current || of !== JSON.stringify(now);
    wavePanel.classList.toggle('stale', passage.of !== '' && isOld(passage.of, passageNow()));
    wheelPanel.classList.toggle('stale', modes.of !== '' && isOld(modes.of, state.accepted));
  }
  listen((what) => {
    if (what === 'words') {
      translate(place);
      showPassage();
      showModes();
    } else if (what === 'case') paleIfOld();
    else if (what === 'view' || what === 'point' || what === 'map') {
      askPassage();
      askModes();
      if (what === 'view' && state.view === 'motion') {
        if (passage.answer) showPassage();
      }
    }
  });
}
