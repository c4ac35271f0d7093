// The page: one case, one cursor, and everything that follows from them.

import { Banner } from './banner.js';
import { theme } from './colors.js';
import { startBogie } from './bogie.js';
import { startCalibrate } from './calibrate.js';
import { startCompare } from './compare.js';
import { drawForce, drawGrowth, drawReceptance, drawings, refit } from './curves.js';
import { startDamage } from './damage.js';
import { furtherFaults, inLabels, wording } from './faults.js';
import { element, lead } from './elements.js';
import { startField } from './field.js';
import { Form } from './form.js';
import { inWords, knowTitles, titled } from './messages.js';
import { get, pack, set, short, si, unpack } from './keys.js';
import { MapView, drawBar, toMap } from './map-view.js';
import { startMeasure } from './measure.js';
import { startMotion } from './motion.js';
import { Outlook } from './outlook.js';
import { startPaper } from './paper.js';
import { drawPhasors, words } from './phasors.js';
import { startPrinting } from './printing.js';
import { Fault, Line, cancelled, framed, json, progress, traffic as requests, work } from './server.js';
import { Sidebar } from './sidebar.js';
import { Steps } from './steps.js';
import { offer } from './figures.js';
import { startStability } from './stability.js';
import { Start } from './start.js';
import { save, startTakeAway } from './take-away.js';
import { Tour } from './tour.js';
import { Traffic, readTraffic } from './traffic.js';
import { inside, reach } from './transport.js';
import { MOST_VARIANTS, ownName, readVariants } from './variants.js';
import { CODES } from './wording.js';
import { chooseLanguage, chooseSpeedUnit, currentLanguage, number, power, sentence, speed as inUnit, t, translate, unitOfSpeed } from './words.js';

const $ = (id) => document.getElementById(id);

/**
 * What the page shows. `point` is the cursor in m and m/s, `pinned` where the user has put it; until then it stands on `headline`, the place of what grows fastest under
 * the traffic. `variants` is what was kept to compare with, `accepted` the keys of the last case without an error; `current` is true while what is shown is that of `keys`.
 */
const state = { keys: null, variants: [], point: null, headline: null, view: 'explore', map: null, head: null, at: null, accepted: null, current: false, vocabulary: null };

const banner = new Banner($('trouble'), $('notice'));
const trouble = (words, more) => banner.say(words, more);
translate();

const vocabulary = await reach('/api/vocabulary').then((response) => (response.ok ? json(response) : Promise.reject(response.status))).catch((fault) => {
  trouble(() => t('gone'), { until: 'closed', ways: [['reload', () => location.reload()]] });
  throw fault;
});
state.vocabulary = vocabulary;
knowTitles(vocabulary.titles);

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

const view = new MapView($('map'), { onPoint: (point, pinned) => movePoint(point, pinned), onLeave: () => standOnHeadline() });
view.onZoom = (zoomed) => ($('whole-map').hidden = !zoomed);
$('whole-map').addEventListener('click', () => view.zoomOut());
const maps = new Line('/api/map', framed);
const points = new Line('/api/point', json);

const onCancel = () => trouble(() => t('stopped'), { until: 'case', ways: [['again', caseChanged]] });
maps.onCancel = points.onCancel = onCancel;

/** How far beyond a place the map is widened to hold it; a wave at the edge of the bands is held within them, for more bands would move it. */
const WIDER = 1.15;
const WITHIN_BAND = 1.003;

/** Panels whose case is no longer that of the form, by what they wait for. They pale when an answer takes its time. */
const PATIENCE = 150;
const waiting = new Map();
function stale(what, at = PATIENCE) {
  clearTimeout(waiting.get(what));
  waiting.set(what, setTimeout(() => $('view-explore').querySelectorAll(`.of-${what}`).forEach((panel) => panel.classList.add('stale')), at));
}
function fresh(what) {
  clearTimeout(waiting.get(what));
  for (const panel of $('view-explore').querySelectorAll(`.of-${what}`)) panel.classList.remove('stale');
}

/** Ask for everything anew after a change of the case. */
function caseChanged() {
  const keys = structuredClone(state.keys);
  state.current = false;
  for (const what of ['map', 'point', 'line', 'remedies']) stale(what);
  maps.ask({ case: { keys } }, (answer) => showMap(answer, keys), (fault) => refuseCase(fault, keys));
  for (const listener of listeners) listener('case');
  saveAddress();
}

function showMap({ head, values }, keys) {
  state.head = head;
  state.map = toMap(head, values);
  const otherTraffic = traffic.setUsual(head.usual_traffic);
  state.map.highest = highestOfTraffic();
  state.accepted = keys;
  state.current = !maps.pending;
  if (!state.point || beyondMap(state.point).length) state.point = placeOnMap();
  view.point = state.point;
  view.band = band();
  // The map first: drawing it asks for its size, which is dear once something else has changed.
  view.show(state.map);
  fresh('map');
  if (maps.pending) stale('map');
  form.clear();
  banner.clear('case');
  showTroubles();
  form.show(state.keys, head.complete, state.current);
  form.fold(head.idle);
  sidebar.show();
  speedHandle();
  mapWords();
  outlook.ask();
  askPoint();
  if (otherTraffic) for (const listener of listeners) listener('traffic');
  for (const listener of listeners) listener('map');
  performance.mark('riffel-map-shown');
}

function mapWords() {
  const { head } = state;
  drawBar($('bar'), view, t('growth_rate'));
  $('map-title').textContent = titled(head.title ?? '');
  $('branches').textContent = sentence(inWords(head.branches_in_words));
  $('notes').replaceChildren(...head.remarks.map((remark) => element('li', { textContent: inWords(remark) })));
  $('notes-panel').hidden = !head.remarks.length;
}

/** The highest growth of the map at the speeds of the traffic; that of the whole map, where nothing grows at these. */
function highestOfTraffic() {
  const { ridge, highest } = state.head;
  const { from, to } = band();
  const inside = ridge.speed_m_per_s.flatMap((speed, k) => (speed >= from * (1 - 1e-9) && speed <= to * (1 + 1e-9) ? [k] : []));
  const k = inside.reduce((most, one) => (most === null || ridge.growth_rate_per_passage[one] > ridge.growth_rate_per_passage[most] ? one : most), null);
  return k === null ? highest : { wavelength_m: ridge.wavelength_m[k], speed_m_per_s: ridge.speed_m_per_s[k] };
}

/** Passages with the time and the gross tonnes that they take. */
const countInWords = (count, grows) => traffic.words(count, si(state.head.complete, 'contact.normal_load'), grows).whole;

/** The axes along which a place lies beyond the map. */
const beyondMap = (place) => ['wavelength', 'speed'].filter((name) => place[name] < state.map[name].min || place[name] > state.map[name].max);

let moved = false;
function movePoint({ wavelength, speed }, pinned) {
  state.point = { wavelength, speed, pinned };
  moved = pinned;
  view.moveTo(state.point);
  speedHandle();
  askPoint();
  for (const listener of listeners) listener('point');
  saveAddress();
}

function askPoint() {
  const { wavelength, speed } = state.point;
  view.label = t('map_label', `${number(1e3 * wavelength)} mm, ${inUnit(speed)}`);
  points.ask({ case: { keys: state.accepted }, wavelength_m: wavelength, speed_m_per_s: speed, passages_per_day: traffic.values.passages_per_day }, (at) => {
    if (state.current) fresh('point');
    showPoint(at);
    // A cursor that was moved by hand or key is told of.
    if (moved) announce($('why').textContent);
    moved = false;
  }, (fault) => complain(fault, { until: 'case' }));
}

function showPoint(at) {
  state.at = at;
  drawPhasors($('phasors'), $('amplitudes'), at.state, countInWords);
  const parts = Math.hypot(...at.state.normal_force_n) > at.state.static_normal_force_n;
  $('why').textContent = [words(at.state, countInWords), parts && t('parts'), at.reported_growth && sentence(inWords(at.reported_growth))].filter(Boolean).join(' ');
  $('place').textContent = `Re Ŵ₁ = ${number(at.state.normalized_dissipation[0])}; ${power(at.state.growth_rate_per_passage)} ${t('per_passage')}`;
  for (const place of document.querySelectorAll('.at-speed')) place.textContent = inUnit(at.state.speed_m_per_s);
  curves();
}

/** When what was drawn is on the screen; a page that is not shown has no screen to wait for. */
const painted = () => new Promise((done) => {
  if (document.hidden) setTimeout(done);
  else requestAnimationFrame(() => setTimeout(done));
});

/** How long a curve may wait for maps that are under way [ms]. */
const CURVE_WAIT = 100;

/** The curves are slower to draw than the map: each in turn is drawn when that is on the screen, and under a slider between two maps. */
const figures = [[drawGrowth, 'growth'], [drawReceptance, 'receptance'], [drawForce, 'force']].map(([draw, place]) => ({ draw, place, drawn: null }));
let drawing = false;
/** Draw all curves anew, for another state or in other colours or words. */
async function curves() {
  for (const figure of figures) figure.drawn = null;
  if (drawing) return;
  drawing = true;
  let last = performance.now();
  const late = () => figures.find(({ drawn }) => drawn !== state.at);
  while (late() && state.view === 'explore') {
    await painted();
    const shown = state.map;
    while (late() && state.map === shown && (maps.idle || performance.now() - last > CURVE_WAIT)) {
      const figure = late();
      figure.drawn = state.at;
      await figure.draw($(figure.place), state.at, ghost);
      figures.push(...figures.splice(figures.indexOf(figure), 1));
      last = performance.now();
      await new Promise((done) => setTimeout(done));
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

const form = new Form({
  place: $('keys'), handles: $('handles'), vocabulary, onAsk: () => showTroubles(),
  onChange: (gesture) => {
    form.show(state.keys);
    record(gesture);
    caseChanged();
  },
});
const sidebar = new Sidebar($('keys'), { form, state });
$('case').addEventListener('submit', (event) => event.preventDefault());
// A drag of a slider is one step, which ends where it is let go.
// The curves of before stay behind those of now, pale, until then.
let ghost = null;
$('handles').addEventListener('input', () => (ghost ??= state.at), true);
$('handles').addEventListener('change', () => {
  steps.settle();
  ghost = null;
  if (state.at) showPoint({ ...state.at });
});

const traffic = new Traffic($('traffic'), {
  onTrouble: () => showTroubles(),
  onChange: () => {
    record();
    trafficChanged();
  },
});

/** The speeds of the traffic on the map. */
const band = () => ({ from: traffic.values.from_km_per_h / 3.6, to: traffic.values.to_km_per_h / 3.6, label: t(traffic.given ? 'band' : 'band_default') });

/** Words and forecasts of another traffic. */
function trafficChanged() {
  view.band = band();
  view.draw();
  if (state.map) {
    state.map.highest = highestOfTraffic();
    outlook.ask();
    askPoint();
  }
  for (const listener of listeners) listener('traffic');
  saveAddress();
}

/** The slider of the speed moves the cursor. */
const speedSlider = (() => {
  const place = Object.assign(document.createElement('div'), { className: 'handle' });
  const label = Object.assign(document.createElement('label'), { htmlFor: 'slide-speed' });
  label.dataset.t = 'speed';
  const output = Object.assign(document.createElement('output'), { htmlFor: 'slide-speed' });
  const input = Object.assign(document.createElement('input'), { type: 'range', id: 'slide-speed', min: 0, max: 1000, step: 1 });
  input.addEventListener('input', () => {
    if (!state.map) return;
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
  speedSlider.output.textContent = inUnit(state.point.speed);
  speedSlider.input.setAttribute('aria-valuetext', speedSlider.output.textContent);
}

/** A case that is not accepted: each fault at its field, what has no field above the view. */
async function refuseCase(fault, keys) {
  for (const what of ['map', 'point', 'line', 'remedies']) stale(what, 0);
  if (fault.status !== 422 || !fault.key) return complain(fault, { until: 'case' });
  const show = (faults) => {
    const rest = form.refuse(faults);
    showTroubles();
    if (rest.length) complain(rest[0], { until: 'case' });
    const { text, language } = wording(fault, form);
    announce(text, language);
  };
  show([fault]);
  const all = await furtherFaults(keys, fault, state.accepted);
  // Meanwhile the case may have changed.
  if (all.length > 1 && maps.idle && JSON.stringify(keys) === JSON.stringify(state.keys)) show(all);
}

/** What failed, said above the view; `what` was to be done. */
function complain(fault, { what = '', until = 'success' } = {}) {
  if (cancelled(fault)) return trouble(() => t('stopped_once'));
  if (!(fault instanceof Fault)) {
    trouble(() => `${what}${fault.message ?? fault}`, { language: 'en' });
    throw fault;
  }
  const { text, language } = wording(fault, form);
  const lost = fault.status === 0 || fault.status >= 500;
  // In the language of the page, but for sentences of the program.
  trouble(() => what + wording(fault, form).text, { language: fault.status ? language : undefined, until: lost ? 'case' : until, ways: lost ? [['again', caseChanged], ['reload', () => location.reload()]] : [] });
  announce(what + text, language);
}

/** The fields that are not accepted, with the way to each. */
function showTroubles() {
  banner.setFields([...form.troubles, ...traffic.troubles].map(({ label, input }) => ({ label, go: () => leadTo(input) })), Boolean(state.map));
}

/** Show a field and put the cursor into it, from any view. */
function leadTo(input) {
  if (state.view === 'paper') showView('explore');
  lead(input);
}

/** Tell a screen reader, but not every step of a slider. */
let telling;
function announce(message, language = '') {
  clearTimeout(telling);
  telling = setTimeout(() => Object.assign($('live'), { textContent: message, lang: language || currentLanguage() }), 600);
}

// What is under way ----------------------------------------------------------------------------------

/** A sign of a question that takes longer than this [ms], with a way to stop it. */
const SIGN_AFTER = 500;
/** How often a question that takes longer still is asked how far it is [ms]. */
const LOOK = 1000;
let sign;
work.onChange = () => {
  clearTimeout(sign);
  $('working').hidden = work.age < SIGN_AFTER;
  $('share').hidden = true;
  if (work.oldest) sign = setTimeout(look, Math.max(SIGN_AFTER - work.age, 0), work.oldest);
};
async function look(asked) {
  $('working').hidden = false;
  // The page reads files itself, and knows no share of that.
  if (!asked.path) return;
  const { done, of } = await progress(asked.path);
  if (asked !== work.oldest) return;
  $('share').hidden = !of;
  if (of) Object.assign($('share'), { max: of, value: done });
  sign = setTimeout(look, LOOK, asked);
}
$('stop-work').addEventListener('click', () => work.cancel());

// Steps back and forth -------------------------------------------------------------------------------

const steps = new Steps(({ undo, redo }) => {
  $('undo').disabled = !undo;
  $('redo').disabled = !redo;
});
const snapshot = () => ({ case: state.keys, variants: state.variants, traffic: traffic.given });

/** The case has changed by hand: a step to undo, and one for the browser to go back. */
function record(gesture) {
  if (steps.record(snapshot(), gesture)) saveAddress(true);
}

function step(to) {
  if (to) open({ ...to, point: state.point, tab: state.view }, { widen: false });
}
$('undo').addEventListener('click', () => step(steps.undo()));
$('redo').addEventListener('click', () => step(steps.redo()));
addEventListener('keydown', (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  const key = event.key.toLowerCase();
  const redo = key === 'y' || (key === 'z' && event.shiftKey);
  if (!redo && key !== 'z') return;
  // Within a text that is being written the browser undoes letters.
  if (writing) return;
  event.preventDefault();
  step(redo ? steps.redo() : steps.undo());
});
let writing = false;
addEventListener('input', ({ target }) => target.type === 'text' && (writing = true));
for (const end of ['change', 'focusout']) addEventListener(end, () => (writing = false));

// The address bar ------------------------------------------------------------------------------------

/** Where the last state is kept, for a visit without a link. */
const LAST = 'riffel-last';
let saving;
let saved = '';

/** Put what is shown into the address; as a step for the browser to go back, or in place of the address at hand. */
function saveAddress(asStep = false) {
  clearTimeout(saving);
  const write = () => {
    saving = 0;
    const { point, view: tab, variants } = state;
    const address = `#${pack({ case: state.keys, point: point?.pinned ? [point.wavelength, point.speed] : null, tab, ...(variants.length && { variants }), ...(traffic.given && { traffic: traffic.given }) })}`;
    if (address === saved) return;
    saved = address;
    if (asStep) history.pushState(null, '', saved);
    else history.replaceState(null, '', saved);
    try {
      localStorage.setItem(LAST, saved);
    } catch {
      // The link in the address bar holds it all the same.
    }
  };
  if (asStep) write();
  else saving = setTimeout(write, 250);
}

const isCase = (keys) => typeof keys === 'object' && keys !== null && !Array.isArray(keys);
const nominal = () => ({ case: structuredClone(vocabulary.nominal), variants: [], point: null, tab: 'explore', traffic: null });

/** The state of a link; null where it cannot be read. */
function readLink(link) {
  try {
    const { case: keys, point, tab, traffic, ...kept } = unpack(link.slice(1));
    if (!isCase(keys)) return null;
    const place = Array.isArray(point) && point.every(Number.isFinite) ? { wavelength: point[0], speed: point[1], pinned: true } : null;
    return { case: keys, variants: readVariants(kept), point: place, tab: $(`tab-${tab}`) ? tab : 'explore', traffic: readTraffic(traffic) };
  } catch {
    return null;
  }
}

/** The last state of a visit before; null where there was none. */
function lastState() {
  try {
    return readLink(localStorage.getItem(LAST) ?? '');
  } catch {
    return null;
  }
}

/** Whether the case has just been opened, and its map is still to be widened to hold the headline. */
let isOpening = false;

/** Show a case; the variants that are kept and the traffic stay unless others come with it. */
function open({ case: keys, variants = state.variants, point, tab, traffic: given = traffic.given }, { asStep = true, widen = true } = {}) {
  Object.assign(state, { keys, variants, point });
  isOpening = widen;
  form.forget();
  form.show(keys);
  traffic.show(given);
  showView(tab);
  steps.record(snapshot());
  if (asStep) saveAddress(true);
  for (const listener of listeners) listener('traffic');
  caseChanged();
}

/** Open a case in place of the one at hand, and say so with the way back. */
function replace(given, text) {
  sidebar.begin(given.case);
  open(given);
  banner.notice(text, () => step(steps.undo()));
}

addEventListener('hashchange', () => {
  if (location.hash === saved) return;
  const given = location.hash.length > 1 ? readLink(location.hash) : nominal();
  if (!given) {
    trouble(() => t('damaged'), { until: 'closed' });
    history.replaceState(null, '', saved);
    return;
  }
  saved = location.hash;
  // What was said of another link, or of the case before, is over.
  banner.clear();
  open(given, { asStep: false });
});

// Views ----------------------------------------------------------------------------------------------

const tabs = [...document.querySelectorAll('[role=tab]')];
function showView(name, asStep = false) {
  state.view = name;
  for (const tab of tabs) {
    const chosen = tab.id === `tab-${name}`;
    tab.setAttribute('aria-selected', String(chosen));
    tab.tabIndex = chosen ? 0 : -1;
    $(tab.getAttribute('aria-controls')).hidden = !chosen;
  }
  for (const listener of listeners) listener('view');
  refit($(`view-${name}`));
  if (name === 'explore' && state.at) {
    curves();
    // What a measured rail says of the model may have come meanwhile.
    outlook.reword();
    outlook.remedies.askLikelihood();
  }
  saveAddress(asStep);
}
for (const tab of tabs) {
  tab.addEventListener('click', () => state.view !== tab.id.slice(4) && showView(tab.id.slice(4), true));
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
  form.reword();
  sidebar.reword();
  form.show(state.keys, state.head?.complete, state.current);
  traffic.show(traffic.given);
  banner.render();
  if (state.map) {
    view.band = band();
    markHeadline();
    view.draw();
    mapWords();
    speedHandle();
    outlook.reword();
  }
  if (state.at) showPoint(state.at);
  for (const listener of listeners) listener('words');
}
$('language').append(...CODES.map((lang) => element('option', { value: lang, lang, textContent: lang.toUpperCase() })));
$('language').value = currentLanguage();
$('language').addEventListener('change', (event) => {
  chooseLanguage(event.target.value);
  redraw();
});

$('speed-unit').value = unitOfSpeed()[0];
$('speed-unit').addEventListener('change', (event) => {
  chooseSpeedUnit(event.target.value);
  form.reunit();
  redraw();
});

/** What is said of a map that is widened to hold a place. */
const widened = ({ wavelength, speed }) => t('map_widened', `${number(1e3 * wavelength)} mm, ${inUnit(speed)}`);

/** The case with a map that holds a place. */
function wideEnough(place) {
  const keys = structuredClone(state.keys);
  for (const name of beyondMap(place)) {
    const isHeld = name === 'wavelength' && place.isEdge;
    const by = isHeld ? WITHIN_BAND : WIDER;
    const end = place[name] > state.map[name].max ? 'max' : 'min';
    const value = Number((end === 'max' ? place[name] * by : place[name] / by).toPrecision(isHeld ? 4 : 2));
    set(keys, `map.${name}.${end}`, name === 'wavelength' ? `${short(1e3 * value)} mm` : `${short(value)} m/s`);
  }
  return keys;
}

/** Let go of the cursor, which goes back to the headline; growth under the traffic is known beyond the map, which is widened to hold it, with a word. */
function leadToHeadline() {
  const place = state.headline;
  if (!beyondMap(place).length) return movePoint(place, false);
  return replace({ case: wideEnough(place), point: place, tab: 'explore' }, widened(place));
}

/** Where the cursor stands by itself: on the headline, or else where the map is highest. */
function placeOnMap() {
  const { headline, map: { wavelength, speed, highest } } = state;
  if (headline && !beyondMap(headline).length) return { wavelength: headline.wavelength, speed: headline.speed, pinned: false };
  if (highest) return { wavelength: highest.wavelength_m, speed: highest.speed_m_per_s, pinned: false };
  return { wavelength: (wavelength.min + wavelength.max) / 2, speed: (speed.min + speed.max) / 2, pinned: false };
}

/** Stand there unless the user has put the cursor elsewhere. */
function standOnHeadline() {
  const place = placeOnMap();
  if (!state.point.pinned && JSON.stringify(place) !== JSON.stringify(state.point)) movePoint(place, false);
}

/** The mark of the headline on the map, at the speeds of the traffic. */
function markHeadline() {
  const { headline } = state;
  view.marks = headline ? [{ wavelength: headline.wavelength, isOfTraffic: true, label: t('headline_mark', `${number(Number((1e3 * headline.wavelength).toPrecision(2)))} mm`) }] : [];
}

/** The headline has changed to another place, or to none: it is marked on the map. A case that was just opened gets a map that holds it, as part of its opening. */
function showHeadline(place) {
  state.headline = place;
  markHeadline();
  if (place && isOpening && beyondMap(place).length) {
    state.keys = wideEnough(place);
    steps.amend(snapshot());
    sidebar.begin(state.keys);
    banner.add(widened(place));
    caseChanged();
  } else {
    view.draw();
    standOnHeadline();
  }
  isOpening = false;
}

/** Keep other variants beside the case at hand. */
function setVariants(variants) {
  state.variants = variants;
  record();
  saveAddress();
  for (const listener of listeners) listener('variants');
}

/** What the other views need. They are told 'case', 'map', 'point', 'view', 'traffic', 'variants' or 'words' when that has changed. */
const listeners = [];
const shared = {
  state, traffic, inLabels: inLabels(form), unitOf: (key) => form.fields.get(key)?.node.unit, complain, banner, announce, setVariants, saveAddress, record, replace, showView, leadTo, save,
  listen: (listener) => listeners.push(listener),
};
let measure;
const outlook = new Outlook($('view-explore'), {
  ...shared, stale, fresh, onCancel, onFault: (fault) => complain(fault, { until: 'case' }), onHeadline: showHeadline, onWhy: leadToHeadline, onTraffic: () => leadTo(traffic.fields.find(({ name }) => name === 'to_km_per_h').input),
  question: () => ({ case: { keys: state.accepted }, traffic: traffic.givenFile }), likelihood: (remedies) => calibrate.likelihood(remedies), unexplained: () => measure?.unexplained ?? [],
  onKeep: (name, keys) => {
    if (state.variants.length >= MOST_VARIANTS) return banner.notice(t('most_kept', MOST_VARIANTS));
    setVariants([...state.variants, { name: ownName(name, state.variants), case: keys }]);
    return banner.notice(t('remedy_kept', name), () => step(steps.undo()));
  },
});
const tour = new Tour();
const start = new Start({
  vocabulary, done: () => tour.begin(),
  open: (keys) => {
    sidebar.begin(keys);
    open({ case: keys, point: null, tab: 'explore' });
  },
});
document.querySelector('.stage').before(start.panel);
shared.listen((what) => what === 'words' && (start.reword(), tour.reword()));
$('version').textContent = `Riffel ${vocabulary.version}`;
$('help-start').addEventListener('click', () => {
  $('help').hidePopover();
  showView('explore');
  start.show();
});
$('help-tour').addEventListener('click', () => {
  $('help').hidePopover();
  showView('explore');
  tour.begin();
});
startCompare(shared);
measure = startMeasure(shared);
const calibrate = startCalibrate(shared);
startBogie(shared);
startMotion(shared);
startStability(shared);
startDamage(shared);
startPaper(shared);
startField(shared);
startTakeAway({ ...shared, measure, calibrate, remedies: outlook.remedies });
startPrinting({ applyTheme, redraw });
for (const [id, figure] of [
  ['map', () => ({ name: 'map', map: view })], ['phasors', () => ({ name: 'loop', drawing: $('phasors'), table: $('amplitudes').parentElement })],
  ...['growth', 'receptance', 'force'].map((name) => [name, () => ({ name, plot: $(name) })]),
]) offer($(id).closest('article').querySelector('header'), figure, save);
translate();

const link = location.hash.length > 1 ? readLink(location.hash) : null;
const last = inside ? { ...nominal(), case: structuredClone(inside) } : lastState();
const isNew = !link && !last && location.hash.length <= 1;
const first = link ?? last ?? (isNew ? { ...nominal(), case: start.first } : nominal());
Object.assign(state, { keys: first.case, variants: first.variants });
traffic.show(first.traffic);
steps.begin(snapshot());
sidebar.begin(first.case);
open(first, { asStep: false });
if (isNew) start.show();
if (!link && location.hash.length > 1) trouble(() => t('damaged_first'), { until: 'closed' });
else if (!link && last && !inside && JSON.stringify(last.case) !== JSON.stringify(vocabulary.nominal)) banner.notice(t('went_on'));

// For whoever watches from outside: what has been asked and answered.
window.riffel = { traffic: requests, state, idle: () => !drawing && !outlook.isWaiting && !sidebar.calm.isWaiting && !drawings.open && !work.running.size && !saving };
export { Fault };
