// The page: one case, one cursor, and everything that follows from them.

import { theme } from './colors.js';
import { startCompare } from './compare.js';
import { drawForce, drawGrowth, drawReceptance } from './curves.js';
import { Form } from './form.js';
import { get, pack, unpack } from './keys.js';
import { MapView, drawBar, toMap } from './map-view.js';
import { startMeasure } from './measure.js';
import { startPaper } from './paper.js';
import { drawPhasors, words } from './phasors.js';
import { Fault, Line, framed, json, traffic } from './server.js';
import { save, startTakeAway } from './take-away.js';
import { chooseLanguage, currentLanguage, nameOf, number, passages, power, t, translate } from './words.js';

const $ = (id) => document.getElementById(id);

/** What the page shows. `point` is the cursor in m and m/s, `kept` the variant to compare with. */
const state = { keys: null, kept: null, point: null, view: 'explore', map: null, head: null, at: null, vocabulary: null };

const vocabulary = await fetch('/api/vocabulary').then((response) => response.json());
state.vocabulary = vocabulary;

// Light and dark -------------------------------------------------------------------------------------

const darkSystem = matchMedia('(prefers-color-scheme: dark)');
function applyTheme() {
  document.documentElement.dataset.theme = localStorage.getItem('riffel-theme') ?? (darkSystem.matches ? 'dark' : 'light');
}
applyTheme();
darkSystem.addEventListener('change', () => (applyTheme(), redraw()));
$('theme').addEventListener('click', () => {
  localStorage.setItem('riffel-theme', theme().dark ? 'light' : 'dark');
  applyTheme();
  redraw();
});

// The map and the loop -------------------------------------------------------------------------------

const view = new MapView($('map'), { onPoint: (point, pinned) => movePoint(point, pinned) });
const maps = new Line('/api/map', framed);
const points = new Line('/api/point', json);

/** Ask for everything anew after a change of the case. */
function caseChanged() {
  const keys = structuredClone(state.keys);
  maps.ask({ case: { keys } }, showMap, refuse);
  for (const listener of listeners) listener('case');
  saveAddress();
}

function showMap({ head, values }) {
  state.head = head;
  state.map = toMap(head, values);
  form.clear();
  trouble('');
  $('map').classList.remove('stale');
  form.show(state.keys, head.complete);
  const { wavelength, speed, highest } = state.map;
  const inside = state.point && state.point.wavelength >= wavelength.min && state.point.wavelength <= wavelength.max && state.point.speed >= speed.min && state.point.speed <= speed.max;
  if (!inside) state.point = highest ? { wavelength: highest.wavelength_m, speed: highest.speed_m_per_s } : { wavelength: (wavelength.min + wavelength.max) / 2, speed: (speed.min + speed.max) / 2 };
  view.point = state.point;
  view.show(state.map);
  speedHandle();
  mapWords();
  askPoint();
  for (const listener of listeners) listener('map');
  performance.mark('riffel-map-shown');
}

function mapWords() {
  const { head } = state;
  drawBar($('bar'), view, t('growth_rate'));
  $('map-title').textContent = head.title ?? '';
  const high = head.highest;
  const place = high && { lambda: number(1e3 * high.wavelength_m), kmh: number(3.6 * high.speed_m_per_s), hertz: number(high.frequency_hz), n: passages(Math.LN2 / high.growth_rate_per_passage) };
  const sentences = high ? [t(high.at_edge ? 'highest_edge' : 'highest', place)] : [t('no_growth')];
  if (head.branches.length) sentences.push(sentence(head.branches_in_words[currentLanguage()]));
  $('verdict').textContent = sentences.join(' ');
  announce(sentences.join(' '));
  $('notes').replaceChildren(...head.remarks.map((remark) => Object.assign(document.createElement('li'), { textContent: remark[currentLanguage()] })));
  $('notes-panel').hidden = !head.remarks.length;
}

/** Words with a capital at the beginning and a full stop. */
function sentence(words) {
  return `${words[0].toUpperCase()}${words.slice(1)}.`;
}

function movePoint(point, pinned) {
  state.point = point;
  view.following = pinned ? false : view.following;
  view.moveTo(point);
  speedHandle();
  askPoint();
  saveAddress();
}

function askPoint() {
  const { wavelength, speed } = state.point;
  view.label = t('map_label', `${number(1e3 * wavelength)} mm, ${number(3.6 * speed)} km/h`);
  points.ask({ case: { keys: structuredClone(state.keys) }, wavelength_m: wavelength, speed_m_per_s: speed }, showPoint);
}

function showPoint(at) {
  state.at = at;
  drawPhasors($('phasors'), $('amplitudes'), at.state);
  const parts = Math.hypot(...at.state.normal_force_n) > at.state.static_normal_force_n;
  $('why').textContent = words(at.state) + (parts ? ` ${t('parts')}` : '');
  $('place').textContent = `Re Ŵ₁ = ${number(at.state.normalized_dissipation[0])}; ${power(at.state.growth_rate_per_passage)} ${t('per_passage')}`;
  for (const place of document.querySelectorAll('.at-speed')) place.textContent = `${number(3.6 * at.state.speed_m_per_s)} km/h`;
  curves();
}

/** The curves are slower to draw than the map: the newest are drawn when there is time. */
let drawing = false;
async function curves() {
  if (drawing) return;
  drawing = true;
  let drawn;
  while (drawn !== state.at && state.view === 'explore') {
    drawn = state.at;
    for (const [draw, place] of [[drawGrowth, 'growth'], [drawReceptance, 'receptance'], [drawForce, 'force']]) {
      await new Promise((done) => setTimeout(done));
      await draw($(place), drawn);
      if (drawn !== state.at && !maps.idle) break;
    }
  }
  drawing = false;
}

$('to-highest').addEventListener('click', () => {
  const high = state.map?.highest;
  if (high) movePoint({ wavelength: high.wavelength_m, speed: high.speed_m_per_s }, true);
});
$('hold').addEventListener('click', (event) => {
  view.held = view.held ? null : state.map.strongest;
  event.currentTarget.setAttribute('aria-pressed', String(Boolean(view.held)));
  view.draw();
  drawBar($('bar'), view, t('growth_rate'));
});

// The case -------------------------------------------------------------------------------------------

const form = new Form({ place: $('keys'), handles: $('handles'), vocabulary, onChange: () => (form.show(state.keys), caseChanged()) });
$('case').addEventListener('submit', (event) => event.preventDefault());

/** The slider of the speed moves the cursor. */
const speedSlider = (() => {
  const place = Object.assign(document.createElement('div'), { className: 'handle' });
  const label = Object.assign(document.createElement('label'), { htmlFor: 'slide-speed' });
  label.dataset.t = 'speed';
  const output = Object.assign(document.createElement('output'), { htmlFor: 'slide-speed' });
  const input = Object.assign(document.createElement('input'), { type: 'range', id: 'slide-speed', min: 0, max: 1000, step: 1 });
  input.addEventListener('input', () => {
    const { min, max } = state.map.speed;
    movePoint({ ...state.point, speed: min + ((max - min) * input.value) / 1000 }, true);
  });
  place.append(label, output, input);
  $('handles').append(place);
  return { input, output };
})();

function speedHandle() {
  const { min, max } = state.map.speed;
  speedSlider.input.value = Math.round((1000 * (state.point.speed - min)) / (max - min));
  speedSlider.output.textContent = `${number(3.6 * state.point.speed)} km/h`;
  speedSlider.input.setAttribute('aria-valuetext', speedSlider.output.textContent);
}

/** A fault stands at its field; one without a field, or of a file that was to be opened, above the map. */
function refuse(fault, ofFile = false) {
  const placed = form.refuse(fault, ofFile);
  const message = fault.status === 0 ? t('gone') : fault.help ? `${fault.message}\n${fault.help}` : fault.message;
  // Sentences of the program are in English.
  const language = fault.status === 0 ? '' : 'en';
  trouble(placed && !ofFile ? '' : message, language);
  announce(message, language);
  $('map').classList.toggle('stale', !ofFile);
}

function trouble(message, language = '') {
  $('trouble').textContent = message;
  $('trouble').lang = language || currentLanguage();
  $('trouble').hidden = !message;
}

/** Tell a screen reader, but not every step of a slider. */
let telling;
function announce(message, language = '') {
  clearTimeout(telling);
  telling = setTimeout(() => Object.assign($('live'), { textContent: message, lang: language || currentLanguage() }), 600);
}

// The address bar ------------------------------------------------------------------------------------

let saving;
let saved = '';
function saveAddress() {
  clearTimeout(saving);
  saving = setTimeout(() => {
    const { point, view: tab, kept } = state;
    saved = `#${pack({ case: state.keys, point: point && [point.wavelength, point.speed], tab, ...(kept && { kept }) })}`;
    history.replaceState(null, '', saved);
  }, 250);
}

/** The state of a link; the nominal case where there is none, or none that reads. */
function fromAddress() {
  const nominal = { case: structuredClone(vocabulary.nominal), kept: null, point: null, tab: 'explore' };
  const isCase = (keys) => typeof keys === 'object' && keys !== null;
  if (location.hash.length < 2) return nominal;
  try {
    const { case: keys, kept, point, tab } = unpack(location.hash.slice(1));
    if (!isCase(keys)) return nominal;
    const place = Array.isArray(point) && point.every(Number.isFinite) ? { wavelength: point[0], speed: point[1] } : null;
    return { case: keys, kept: isCase(kept) ? kept : null, point: place, tab: $(`tab-${tab}`) ? tab : 'explore' };
  } catch {
    return nominal;
  }
}

/** Show a case; the variant that is kept stays unless another comes with it. */
function open({ case: keys, kept = state.kept, point, tab }) {
  Object.assign(state, { keys, kept, point });
  form.show(keys);
  showView(tab);
  caseChanged();
}
addEventListener('hashchange', () => location.hash !== saved && open(fromAddress()));

// Views ----------------------------------------------------------------------------------------------

const tabs = [...document.querySelectorAll('[role=tab]')];
function showView(name) {
  state.view = name;
  for (const tab of tabs) {
    const chosen = tab.id === `tab-${name}`;
    tab.setAttribute('aria-selected', String(chosen));
    tab.tabIndex = chosen ? 0 : -1;
    $(tab.getAttribute('aria-controls')).hidden = !chosen;
  }
  for (const listener of listeners) listener('view');
  if (name === 'explore' && state.at) curves();
  saveAddress();
}
for (const tab of tabs) {
  tab.addEventListener('click', () => showView(tab.id.slice(4)));
  tab.addEventListener('keydown', (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    const next = tabs[(tabs.indexOf(tab) + by + tabs.length) % tabs.length];
    next.focus();
    next.click();
  });
}

// Words ----------------------------------------------------------------------------------------------

function redraw() {
  if (!state.map) return;
  view.draw();
  mapWords();
  speedHandle();
  form.show(state.keys);
  if (state.at) showPoint(state.at);
  for (const listener of listeners) listener('words');
}
$('language').value = currentLanguage();
$('language').addEventListener('change', (event) => {
  chooseLanguage(event.target.value);
  redraw();
});

/** What the other views need. They are told 'case', 'map', 'view' or 'words' when that has changed. */
const listeners = [];
const shared = {
  state, form, open, refuse, trouble, announce, nameOf, get, saveAddress,
  listen: (listener) => listeners.push(listener),
  save,
};
startCompare(shared);
const { saveReport } = startMeasure(shared);
startPaper(shared);
startTakeAway({ ...shared, saveReport });
translate();
open(fromAddress());

// For whoever watches from outside: what has been asked and answered.
window.riffel = { traffic, state, idle: () => maps.idle && points.idle && !drawing };
export { Fault };
