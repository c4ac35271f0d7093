// Measure: a file of a measured rail, held against limits and against the case.

import { card } from './causes.js';
import { Along, span } from './along.js';
import { letterSize } from './colors.js';
import { Columns } from './columns.js';
import { trendWords, fitItems } from './level-trend.js';
import { axis, draw, layout, palette } from './curves.js';
import { Earlier } from './earlier.js';
import { element, worded } from './elements.js';
import { offer } from './figures.js';
import { MapView, drawBar } from './map-view.js';
import { Noise } from './noise.js';
import { caseTitle, inSentences, inWords, once, said } from './messages.js';
import { remember, remembered } from './remembered.js';
import { underWay } from './sent-files.js';
import { Fault, Line, askOnce, askReport, discard, json, send } from './server.js';
import { currentLanguage, fileSize, number, power, range, t, translate } from './words.js';

/** The name of a file before a sentence that does not begin with it. */
const named = ({ message }, name) => (inWords(message).startsWith(name) ? '' : `${name}: `);

/** Where a reload finds the name of the record that the program keeps for this page. */
const RECORD = 'riffel-record';

export function startMeasure({ state, traffic, inLabels, listen, complain, banner, announce, save, showView, leadTo, replace }) {
  const place = document.getElementById('view-measure');
  const line = new Line('/api/ask/measure', json);
  let file = remembered(RECORD);
  let coming = null;
  let answer = null;
  /** The question that was answered, and the keys of its case. */
  let answered = null;
  /** How the record is laid out, where its columns were chosen. */
  let format = file?.format ?? null;
  /** Which part of the line is shown; null is all of it. */
  let part = null;
  /** The record that the program has, with its columns, each time anew. */
  let turn = 0;
  const hold = (upload) => (held = { file, format, upload, turn: ++turn });
  let held = file && { file, format, upload: file.upload, turn };

  // What is asked --------------------------------------------------------------------------------------

  const input = element('input', { type: 'file', id: 'record', className: 'away', accept: '.csv,.txt,.tsv,.dat,.asc,text/plain,text/csv' });
  const choose = worded('label', 'choose', { htmlFor: 'record', className: 'plain' });
  const hint = worded('span', 'drop_file', { className: 'drop-hint' });
  const sample = worded('button', 'sample', { type: 'button', className: 'plain', id: 'sample' });
  sample.addEventListener('click', trySample);
  const source = worded('p', 'sample_source', { className: 'fine', id: 'sample-source', hidden: true });
  const columns = new Columns({ onChoose: (chosen) => {
    [format, part] = [chosen, null];
    hold(held.upload);
    keepRecord(file);
    earlier.reread().then(ask);
  } });
  const earlier = new Earlier({ onChange: () => ask(), reading: () => reading(), complain, banner, inLabels });
  const bar = element('progress', { max: 1, value: 0, hidden: true, id: 'upload' });
  const stop = worded('button', 'cancel', { type: 'button', className: 'plain small', hidden: true });
  const status = element('span', { className: 'aside', id: 'record-state' });
  const traffics = element('button', { type: 'button', className: 'plain', id: 'to-traffic' });
  traffics.addEventListener('click', () => leadTo(document.getElementById('traffic-daily')));
  const against = element('p', { className: 'aside', id: 'measured-against', hidden: true });
  const report = worded('button', 'save_report', { type: 'button', className: 'plain', hidden: true, id: 'report' });
  const drop = element('div', { className: 'panel wide drop', id: 'drop' },
    element('div', { className: 'buttons' }, input, choose, sample, hint, bar, stop, status),
    source, columns.place, earlier.place,
    element('div', { className: 'settings' }, traffics, report), against);

  // What is answered -----------------------------------------------------------------------------------

  const panel = (word, className, ...children) => element('article', { className: `panel ${className}`, hidden: true }, element('header', {}, worded('h2', word)), ...children);
  const verdicts = element('ul', { className: 'sentences' });
  const spectrum = element('div', { className: 'curve tall', id: 'spectrum' });
  const dominant = element('div', { className: 'findings' });
  const outlook = element('ul', { className: 'sentences' });
  /** That the model does not explain the rail: the first that is said of it. */
  const unexplained = element('article', { className: 'panel wide', id: 'unexplained', hidden: true });
  const map = element('div', { className: 'map' });
  const legend = element('div', { className: 'bar' });
  const notes = element('ul');
  const panels = [
    panel('spectrum', 'map-panel', spectrum, verdicts), panel('dominant', 'loop-panel', dominant),
    panel('growth_map', 'map-panel', map, element('footer', {}, legend)), panel('forecast', 'loop-panel', outlook), panel('notes', 'notes', notes),
  ];
  const along = new Along({ question: () => ({ file: sentFile(), ...(format && { format }) }), onPart: choosePart, complain, inLabels, save });
  const noise = new Noise({ question: () => noiseQuestion(), isCurrent: () => !line.pending && state.current, complain, banner, inLabels, save });
  place.append(drop, unexplained, ...along.panels, ...panels.slice(0, -1), ...noise.panels, panels.at(-1));
  for (const [at, figure] of [[0, () => ({ name: 'spectrum', plot: spectrum })], [2, () => ({ name: 'map', map: view })]]) offer(panels[at].querySelector('header'), figure, save);
  const view = new MapView(map, { label: t('growth_map') });

  // The file -------------------------------------------------------------------------------------------

  /** Take a file; one that comes back has the columns and the earlier records that it had. */
  function take(chosen, { columns: chosenColumns = null, earlierThen = null } = {}) {
    coming?.abort();
    const { file: before = null, format: columnsBefore = null, upload: uploadBefore } = held ?? {};
    const answerBefore = file === before ? answer : null;
    let sent = 0;
    banner.clear('success');
    [file, format, part] = [chosen, chosenColumns, null];
    source.hidden = !chosen.isSample;
    columns.offer(chosen, chosenColumns);
    answer = null;
    show();
    earlier.offer(false);
    bar.hidden = stop.hidden = false;
    hint.hidden = true;
    status.textContent = chosen.name;
    coming = send(chosen, (share) => {
      bar.value = sent = share;
      status.textContent = `${chosen.name}, ${underWay(share)}`;
    });
    coming.done.then((upload) => {
      if (file !== chosen) return;
      coming = null;
      hold(upload);
      if (uploadBefore !== undefined) discard(uploadBefore).catch(() => {});
      keepRecord(chosen);
      const earlierBefore = earlier.forget();
      tellFile();
      // The file itself is at hand unless the page was loaded anew meanwhile.
      const undo = before instanceof File ? () => take(before, { columns: columnsBefore, earlierThen: earlierBefore }) : undefined;
      if (before) banner.notice([t('record_taken', chosen.name), earlierBefore && t('earlier_gone')].filter(Boolean).join(' '), undo);
      if (earlierThen) earlier.bringBack(earlierThen);
      ask();
    }, (fault) => {
      // Another file is already on its way.
      if (file !== chosen) return;
      coming = null;
      // What is refused or breaks off takes no place: the program still has the record before.
      if (before && (fault.status >= 400 || sent < 1)) {
        [file, format, answer] = [before, columnsBefore, answerBefore];
        source.hidden = !before.isSample;
        columns.offer(before, format);
        tellFile();
        show();
        ask();
      } else if (before instanceof File) {
        file = held = null;
        take(before, { columns: columnsBefore, earlierThen: earlier.forget() });
      } else forgetFile();
      if (fault instanceof Fault) complain(fault, { what: named(fault, chosen.name) });
    }).finally(() => (bar.hidden = stop.hidden = !coming));
  }

  /** The profile that the program makes to its own recipe. */
  async function trySample() {
    sample.disabled = true;
    try {
      const made = await askOnce('/api/ask/roughness', { synthesise: true });
      take(Object.assign(new File([await made.blob()], 'sample.csv', { type: 'text/csv' }), { isSample: true }));
    } catch (fault) {
      complain(fault, { what: `${t('sample')}: ` });
    } finally {
      sample.disabled = false;
    }
  }

  function forgetFile() {
    file = held = null;
    keepRecord(null);
    earlier.forget();
    tellFile();
  }

  function tellFile(more = '') {
    earlier.offer(Boolean(file) && !coming);
    hint.hidden = Boolean(file);
    status.textContent = file ? `${file.name}, ${more || fileSize(file.size)}` : '';
  }

  const keepRecord = (record) => remember(RECORD, record && { name: record.name, size: record.size, isSample: record.isSample, format, upload: held.upload });

  stop.addEventListener('click', () => coming?.abort());
  input.addEventListener('change', () => {
    if (input.files[0]) take(input.files[0]);
    input.value = '';
  });

  const sentFile = () => ({ upload: held.upload, name: file.name });
  const reading = () => ({ ...(format && { format }), ...(part && { from: part.from_m, to: part.to_m }) });
  /** What all questions about the rail have in common. */
  const rail = () => ({ case: state.accepted, roughness: sentFile(), traffic: traffic.file, months: traffic.values.months, ...reading() });
  const question = () => ({ ...rail(), speed: traffic.speed, ...earlier.question, ...earlier.since(traffic.values.passages_per_day) });
  /** Noise goes on as measured where all records have a date. */
  const noiseQuestion = () => ({ ...rail(), speed: `${traffic.meanSpeed} m/s`, ...(earlier.question.dates && earlier.question) });
  // As on the page, a fitted coefficient is taken only by who asks for it.
  const reportQuestion = () => ({ ...rail(), speed: traffic.speed, ...earlier.question, keep_coefficient: true });

  /** Everything below follows a part of the line, or all of it again. */
  function choosePart(chosen) {
    part = chosen;
    earlier.reread().then(ask);
  }

  function ask() {
    if (!file || coming || !state.accepted || state.view !== 'measure') return;
    if (earlier.comingBack) {
      earlier.comingBack.then(ask);
      return;
    }
    tellFile(t('computing'));
    stale(true);
    const asked = question();
    const [keys, asksFor] = [state.accepted, part];
    line.ask(asked, (given) => {
      answer = given;
      answered = { question: JSON.stringify(asked), keys, part: asksFor };
      banner.clear('success');
      tellFile();
      stale(line.pending || !state.current);
      show();
      announce(answer.roughness.verdicts.map(({ sentence }) => inWords(sentence)).join(' '));
    }, (fault) => {
      // Another record may have come meanwhile.
      if (asked.roughness.upload !== held?.upload) return;
      const { name } = file;
      tellFile();
      if (fault.status === 422 && asksFor) {
        // A part that has no answer leaves what is shown.
        part = answered.part;
        show();
      } else if (fault.status === 422) columns.open();
      // After a restart the program has no record of this page.
      if (fault.status !== 410) return complain(fault, { what: named(fault, name) });
      answer = null;
      forgetFile();
      show();
      banner.say(() => t('record_gone', name), { until: 'closed' });
    });
  }
  line.onCancel = () => {
    tellFile();
    banner.say(() => t('stopped'), { ways: [['again', ask]] });
  };

  /** What is shown is no longer, or again, that of the case and the traffic. */
  const stale = (is) => [...panels, ...along.panels, ...noise.panels].forEach((panel) => panel.classList.toggle('stale', is));

  /** Hand out the page to print; false where no rail is measured. */
  async function saveReport() {
    if (!answer) return false;
    report.disabled = true;
    try {
      save(await askReport(reportQuestion(), currentLanguage()), `${file.name.replace(/\.\w+$/, '')}-report.html`);
    } finally {
      report.disabled = false;
    }
    return true;
  }
  report.addEventListener('click', () => saveReport().catch((fault) => complain(fault, { what: `${t('save_report')}: ` })));

  // Showing it -----------------------------------------------------------------------------------------

  /** Words of the program as an element of the page. */
  const spoken = (name, english, more = {}) => {
    const { text, language } = said(english, inLabels);
    return element(name, { textContent: text, lang: language, ...more });
  };
  const item = (text, className = '') => spoken('li', text, { className });

  function show() {
    for (const one of panels) one.hidden = !answer;
    const doubts = answer?.forecast.unexplained ?? [];
    unexplained.hidden = !doubts.length;
    unexplained.replaceChildren(...doubts.map((one) => element('p', { textContent: inSentences([one]), className: 'why bad' })));
    report.hidden = against.hidden = !answer;
    // A table of levels has no line.
    const { roughness: read } = answer ?? {};
    along.show(read?.rails?.length || (read?.length_m && read.grind) ? held : null, part, read?.length_m);
    noise.show(answer);
    if (!answer) return;
    against.textContent = [t('measured_against', caseTitle(answered.keys)), answered.part && `${span(answered.part)} m.`].filter(Boolean).join(' ');
    const { roughness, diagnosis, forecast } = answer;
    verdicts.replaceChildren(...roughness.verdicts.map(({ within, sentence }) => item(sentence, within ? 'good' : 'bad')));
    dominant.replaceChildren(...(diagnosis.fault ? [spoken('p', diagnosis.fault.message)] : diagnosis.dominant_wavelengths.map(finding)));
    if (!dominant.childElementCount) dominant.append(element('p', { textContent: t('nothing_dominant'), lang: currentLanguage() }));
    outlook.replaceChildren(...(forecast.fault ? [item(forecast.fault.message)] : [...once(forecast.findings, doubts).map((one) => item(one)), ...fitItems(forecast, { item, take: takeCoefficient })]));
    const remarks = once([...roughness.warnings, ...(diagnosis.warnings ?? []), ...(forecast.remarks ?? [])]);
    notes.replaceChildren(...remarks.map((remark) => item(remark)));
    panels.at(-1).hidden = !remarks.length;
    translate(dominant);
    drawSpectrum();
    drawMap();
  }

  function finding(one) {
    const heading = element('h3', {}, `${number(1e3 * one.wavelength_m)} mm`, element('small', { textContent: ` ${range([one.frequency_min_hz, one.frequency_max_hz])} Hz, ${number(one.prominence_db, 2)} dB ${t('excess')}`, lang: currentLanguage() }));
    const cards = one.candidates.filter(({ share }) => share > 0.02).map((candidate) => card(candidate.mechanism, [
      spoken('h4', candidate.mechanism), element('meter', { value: candidate.share, max: 1, ariaLabel: inWords(candidate.mechanism) }), element('span', { className: 'unit', textContent: number(candidate.share, 2) }),
    ], [candidate.reasons_for, candidate.reasons_against].map((reasons) => reasons.map((reason) => spoken('span', reason))), spoken('span', candidate.measurement)));
    const where = one.rail == null ? [] : [element('p', { className: 'aside', textContent: whereOn(one), lang: currentLanguage() })];
    const course = one.course ? [element('p', { className: 'aside course', textContent: trendWords(one.course), lang: currentLanguage() })] : [];
    const summary = spoken('p', one.summary);
    summary.textContent = summary.textContent.replace(/^./, (letter) => letter.toUpperCase());
    return element('section', {}, heading, ...where, ...course, summary, ...cards);
  }

  /** The wear coefficient that was fitted, in the place of that of the case. */
  const takeCoefficient = (coefficient) => replace({ case: { ...structuredClone(state.keys), wear: { ...state.keys.wear, coefficient: Number(coefficient.toPrecision(4)) } }, point: state.point, tab: 'measure' }, t('coefficient_used', power(coefficient)));

  /** "rail low, 1200–1240 m, 300–310 m: 14.8 dB": the places of a wavelength, the highest level first. */
  function whereOn({ rail, places, all_along: allAlong, level_db: level }) {
    const spans = allAlong ? [t('all_along')] : places.map((place) => `${span(place)} m`);
    return `${t('rail_named', rail)}, ${spans.join(', ')}: ${number(level, 3)} dB`;
  }

  /** Spectra of the whole record behind those of a part, and of earlier records, in the colour of their rail; the older the paler. */
  function behind(rails, curve, levels) {
    const colors = palette();
    const { spectra } = earlier;
    const oldest = Math.max(...spectra.map(({ age }) => age)) + 1;
    const whole = (answered.part && along.answer?.roughness.rails) || [];
    const all = [...whole.map(({ name, spectrum: own }) => ({ rail: name, words: t('whole_record'), age: oldest, spectrum: own })), ...spectra];
    return all.map(({ rail, words, age, spectrum: own }) => {
      const k = rails.findIndex(({ name }) => name === rail);
      const name = rails.length > 1 && rail ? `${t('rail_named', rail)}, ${words}` : words;
      return { ...curve(levels(own), name, colors[k > 0 ? 3 + (k % 4) : 0], 'dot'), opacity: spectra.length ? Math.min(0.9, 0.4 + (0.5 * (age + 1)) / oldest) : 0.6 };
    });
  }

  async function drawSpectrum() {
    const { roughness, forecast, limits, diagnosis } = answer;
    const colors = palette();
    const curve = (points, name, color, dash = 'solid') => ({
      type: 'scatter', mode: 'lines', x: points.map(([wavelength]) => 1e3 * wavelength), y: points.map(([, level]) => level), name,
      line: { color, width: dash === 'solid' ? 1.8 : 1.4, dash }, hovertemplate: `%{x:.3~g} mm · %{y:.1f} dB<extra>${name.replaceAll('<', '&lt;')}</extra>`,
    });
    // Each rail is judged by its own levels, the worst first.
    const rails = roughness.rails ?? [];
    const levels = (list) => list.map(({ wavelength_m, level_db }) => [wavelength_m, level_db]);
    const traces = [
      ...(rails.length > 1 ? rails.map((rail, k) => curve(levels(rail.spectrum), `${t('rail_named', rail.name)}, ${t('now')}`, colors[k ? 3 + (k % 4) : 0])) : [curve(levels(roughness.spectrum), t('now'), colors[0])]),
      ...(forecast.fault ? [] : [curve(levels(forecast.spectrum_then), t('in_months', number(forecast.horizon.months)), colors[1])]),
      ...behind(rails, curve, levels),
      ...limits.map((limit, k) => curve(limit.wavelength_m_and_level_db, limit.edition, colors[2 + k], 'dash')),
    ];
    const ticks = [2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000];
    const all = traces.flatMap(({ x }) => x).filter((x) => x > 0);
    const marks = (diagnosis.dominant_wavelengths ?? []).map(({ wavelength_m }) => ({ type: 'line', xref: 'x', yref: 'paper', x0: 1e3 * wavelength_m, x1: 1e3 * wavelength_m, y0: 0, y1: 1, line: { color: colors[2], width: 1 } }));
    await draw(spectrum, traces, layout({
      // Long waves to the left, as on every roughness spectrum.
      xaxis: axis(`${t('wavelength')} λ [mm]`, { type: 'log', tickvals: ticks, range: [Math.log10(Math.max(...all)), Math.log10(Math.min(...all))] }),
      yaxis: axis(t('level_axis')), shapes: marks, showlegend: true, margin: { l: 4 * letterSize(), r: 10, t: 2.2 * letterSize(), b: 3 * letterSize() },
    }));
  }

  function drawMap() {
    if (!state.map || !answer) return;
    view.marks = (answer.diagnosis.dominant_wavelengths ?? []).map(({ wavelength_m }) => ({ wavelength: wavelength_m, label: `${number(1e3 * wavelength_m)} mm` }));
    view.show(state.map);
    drawBar(legend, view, t('growth_rate'));
  }

  const tellTraffic = () => (traffics.textContent = `${t('traffic')}: ${t(traffic.given ? 'traffic_given' : 'traffic_default', number(traffic.values.passages_per_day, 4))}`);
  listen((what) => {
    if (what === 'words') {
      translate(place);
      tellTraffic();
      columns.reword();
      along.reword();
      noise.reword();
      earlier.reword();
      show();
    } else if (what === 'view') {
      if (answer) show();
      if (!answer || answered.question !== JSON.stringify(question())) ask();
      else stale(!state.current);
    } else if (what === 'case') {
      if (answer) stale(true);
    } else if (what === 'traffic') {
      tellTraffic();
      ask();
    } else if (what === 'map') {
      // The case has no error.
      drawMap();
      ask();
    }
  });
  source.hidden = !file?.isSample;
  tellTraffic();
  tellFile();
  return {
    saveReport,
    /** Where the model does not explain the rail that is open, as the program says of this case and traffic; else empty. */
    get unexplained() {
      return file && answer && answered.question === JSON.stringify(question()) ? (answer.forecast.unexplained ?? []) : [];
    },
    /** The record that is open with all that belongs to it, null where there is none. */
    get record() {
      return file && { file, name: file.name, kept: held?.upload, format, table: along.table, earlier: earlier.kept };
    },
    /** The record of a project. */
    bringBack({ file: chosen, format: columnsThen, table, earlier: earlierThen }) {
      along.table = table;
      take(chosen, { columns: columnsThen, earlierThen });
    },
    /** Take a file from any view; one that is dropped on the earlier records is one of them. */
    take(chosen, target) {
      if (earlier.place.contains(target)) return void earlier.add([chosen]);
      if (state.view !== 'measure') showView('measure', true);
      take(chosen);
    },
  };
}
