// Calibrate: what measurements say of the case of the page, and what to do about it.

import { CalibrationAnswer } from './calibration-answer.js';
import { CalibrationData } from './calibration-data.js';
import { Decision } from './decision.js';
import { element, worded } from './elements.js';
import { said } from './messages.js';
import { inUnit, set } from './keys.js';
import { Priors, nameOfValue, withNames } from './priors.js';
import { remember, remembered } from './remembered.js';
import { Fault, Line, askOnce, json, progress } from './server.js';
import { currentLanguage, sentence, t, translate } from './words.js';

/** How often is asked how far the chains are [ms]. */
const LOOK = 500;
/** Draws of each chain that count: the first are those of the program for the page. */
const DRAWS = [1500, 3000, 6000];
/** Where a reload finds them. */
const KEPT = 'riffel-draws';

export function startCalibrate({ state, traffic, inLabels, unitOf, listen, complain, banner, announce, save, replace }) {
  const place = document.getElementById('view-calibrate');
  const line = new Line('/api/calibration', json);
  /** The plan as the program has it, and the question that was answered. */
  let [plan, answered] = [null, null];
  /** Costs of the example, where it is open. */
  let examples = null;

  // What is asked --------------------------------------------------------------------------------------

  const data = new CalibrationData({ onChange: () => askPlan(), plan: (files) => (state.current ? ask('/api/calibration/plan', { ...question(), data: files, changes: {} }) : null), complain, banner, inLabels });
  const priors = new Priors({ onChange: () => askPlan() });
  const hint = worded('p', 'calibrate_comes', { className: 'why' });
  const example = worded('button', 'try_example', { type: 'button', className: 'plain', id: 'calibration-example' });
  const source = worded('p', 'example_source', { className: 'fine', hidden: true });
  const draws = element('select', { id: 'draws' }, ...DRAWS.map((count) => element('option', { value: count, textContent: count })));
  const takeDraws = (count) => DRAWS.includes(count) && (draws.value = count);
  takeDraws(remembered(KEPT));
  draws.addEventListener('change', () => {
    remember(KEPT, Number(draws.value));
    askPlan();
  });
  const run = worded('button', 'calibrate_now', { type: 'button', className: 'plain', id: 'calibrate', disabled: true });
  const bar = element('progress', { max: 1, value: 0, hidden: true, id: 'chains' });
  bar.dataset.tLabel = 'draws_word';
  const stop = worded('button', 'cancel', { type: 'button', className: 'plain small', hidden: true });
  const status = element('span', { className: 'aside', id: 'calibration-state' });
  const trouble = element('p', { className: 'fault', id: 'plan-fault', hidden: true });
  const savePlan = worded('button', 'save_plan', { type: 'button', className: 'plain', id: 'save-plan', hidden: true });
  const drop = element('div', { className: 'panel wide drop', id: 'calibration-drop' },
    element('div', { className: 'buttons' }, data.input, data.choose, example, worded('span', 'drop_data', { className: 'drop-hint' })), hint, source, data.list);
  const known = element('article', { className: 'panel wide', id: 'priors-panel', hidden: true }, element('header', {}, worded('h2', 'known_before'), worded('span', 'known_before_help', { className: 'aside' })),
    priors.place, trouble, element('div', { className: 'settings' }, element('label', { className: 'choice' }, worded('span', 'draws_of_chain'), draws), run, bar, stop, status, savePlan));

  const question = () => ({ case: { keys: state.accepted }, traffic: traffic.file, data: data.question, changes: { parameters: priors.changes, draws: Number(draws.value) } });
  const ask = async (path, body) => json(await askOnce(path, body));

  /** The newest plan counts. */
  let turn = 0;
  async function askPlan() {
    const own = ++turn;
    known.hidden = !data.question.length;
    // What was chosen for data goes with the last of them.
    if (!data.files.length) {
      priors.take({});
      examples = null;
      source.hidden = true;
    }
    hint.hidden = data.files.length > 0;
    stale();
    if (known.hidden || !state.current || state.view !== 'calibrate') return;
    try {
      const given = await ask('/api/calibration/plan', question());
      if (own !== turn) return;
      plan = given;
      trouble.hidden = true;
    } catch (fault) {
      if (own !== turn || !(fault instanceof Fault)) return;
      const { text, language } = said(fault.message);
      Object.assign(trouble, { textContent: withNames(text, priors.usual.map(({ name }) => name)), lang: language, hidden: false });
    }
    if (plan) priors.show(plan);
    run.disabled = !trouble.hidden || Boolean(line.running);
    savePlan.hidden = !plan;
  }

  // Drawing --------------------------------------------------------------------------------------------

  function draw() {
    const asked = question();
    drawing(true);
    line.ask(asked, (given) => {
      drawing(false);
      answered = { asked: JSON.stringify(asked), plan };
      show(given);
      announce(answer.verdict.textContent);
      decision.offer(given, answered.plan, examples);
    }, (fault) => {
      drawing(false);
      complain(fault, { what: `${t('calibrate_now')}: ` });
    });
  }
  line.onCancel = () => {
    drawing(false);
    status.textContent = t('stopped_drawing');
  };
  run.addEventListener('click', draw);
  stop.addEventListener('click', () => line.running?.abort.abort('cancelled'));

  let looking;
  function drawing(is) {
    clearInterval(looking);
    run.disabled = is || !trouble.hidden;
    bar.hidden = stop.hidden = !is;
    bar.removeAttribute('value');
    status.textContent = is ? t('computing') : '';
    if (is) looking = setInterval(look, LOOK);
  }
  async function look() {
    const { done, of } = await progress(line.path);
    if (bar.hidden || !of) return;
    bar.value = done / of;
    status.textContent = t('draws_done', { done, of });
  }

  // What is answered -----------------------------------------------------------------------------------

  const answer = new CalibrationAnswer({ save, unitOf });
  const take = worded('button', 'take_medians', { type: 'button', className: 'plain', id: 'take-medians' });
  const taking = element('span', { className: 'aside', id: 'taking' });
  answer.ways.append(take, taking);
  const decision = new Decision({ state, traffic, complain, save, spoken: (text) => answer.spoken(text) });
  place.append(drop, known, ...answer.panels, ...decision.panels);

  const written = () => answer.answer?.parameters.filter((one) => one.may_be_written_back) ?? [];
  function show(given) {
    answer.show(given);
    take.disabled = !written().length;
    const not = given?.parameters.filter((one) => one.key && !one.may_be_written_back).map(({ name }) => nameOfValue(name)) ?? [];
    taking.textContent = given?.is_conclusive ? (not.length ? t('not_taken_these', not.join('; ')) : '') : given ? t('not_taken_any') : '';
    stale();
  }

  /** Medians of what the data tell, in the place of the values of the case. */
  take.addEventListener('click', () => {
    const keys = structuredClone(state.keys);
    for (const { key, unit, quantiles } of written()) set(keys, key, inUnit(key, Number(quantiles[2].toPrecision(4)), unitOf(key) ?? unit));
    replace({ case: keys, point: state.point, tab: 'calibrate' }, sentence(t('medians_taken', written().map(({ name }) => nameOfValue(name)).join('; '))));
  });

  savePlan.addEventListener('click', () => {
    for (const [name, text] of [['plan', plan.text], ['case', plan.case], ['traffic', plan.traffic]]) save(new Blob([text], { type: 'application/toml' }), `${name}.toml`);
  });

  /** Whether the answer is that of the case, the traffic and the priors. */
  const isOfCase = () => state.current && answered?.asked === JSON.stringify(question());

  /** What is shown is no longer, or again, that. */
  function stale() {
    const is = Boolean(answered) && !isOfCase();
    for (const panel of [...answer.panels, ...decision.panels]) panel.classList.toggle('stale', is);
  }

  example.addEventListener('click', async () => {
    example.disabled = true;
    try {
      const response = await fetch('/api/calibration/example');
      const given = await json(response);
      if (!response.ok) throw new Fault(given, response.status);
      const { keys } = await ask('/api/case', { case: { toml: given.case } });
      replace({ case: keys, point: null, tab: 'calibrate', traffic: given.traffic }, t('example_open'));
      priors.take(given.changes.parameters);
      examples = given.costs;
      source.hidden = false;
      await data.add(given.data.map(({ name, text }) => new File([text], name, { type: 'text/csv' })));
    } catch (fault) {
      complain(fault, { what: `${t('try_example')}: ` });
    } finally {
      example.disabled = false;
    }
  });

  const reread = () => state.view === 'calibrate' && data.reread().then(askPlan);
  listen((what) => {
    if (what === 'words') {
      translate(place);
      data.show();
      if (plan) priors.show(plan);
      if (answer.answer) show(answer.answer);
      decision.reword();
      place.lang = currentLanguage();
    } else if (what === 'view') {
      if (state.view !== 'calibrate') return;
      if (answer.answer) show(answer.answer);
      reread();
    } else if (what === 'map' || what === 'traffic') reread();
    else if (what === 'case') stale();
  });
  data.show();
  hint.hidden = data.files.length > 0;
  return {
    take: (files) => data.add(files),
    /** How likely each of some remedies helps; null without chains of this case that tell of its growth. */
    likelihood: (remedies) => (isOfCase() && decision.isOffered ? decision.likelihood(remedies) : null),
    /** The plan that is open: its data, what is changed of its priors, and its draws; null without data. */
    get plan() {
      return data.kept.length ? { data: data.kept, priors: priors.changes, draws: Number(draws.value), costs: decision.costsGiven } : null;
    },
    /** The plan of a project, in the place of that which is open. */
    bringBack({ data: files, priors: changes, draws: count, costs }) {
      priors.take(changes);
      takeDraws(count);
      decision.take(costs);
      examples = null;
      source.hidden = true;
      return data.replace(files);
    },
  };
}
