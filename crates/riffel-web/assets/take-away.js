// Take away: the case as a link or a file, the project, and back from a file.

import { element } from './elements.js';
import { PROJECT, inWords, read, written } from './project.js';
import { askOnce, askReport, json, work } from './server.js';
import { currentLanguage, t } from './words.js';

export function save(blob, name) {
  const link = Object.assign(document.createElement('a'), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

const fileName = (state) => (state.keys.title ?? 'case').toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') || 'case';

export function startTakeAway({ state, traffic, banner, complain, replace, measure, calibrate, remedies }) {
  const menu = document.getElementById('take-away');
  const open = () => ({ case: state.keys, variants: state.variants, traffic: traffic.given });
  const actions = {
    link: async (button) => {
      // A page that is not served over HTTPS has no clipboard: the link stands to be selected.
      const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
      const link = element('input', { readOnly: true, value: location.href, id: 'link', ariaLabel: t('the_link') });
      link.addEventListener('focus', () => link.select());
      const record = measure.record?.file.name;
      const left = [record && t('left_record', record), calibrate.plan && t('left_plan'), Object.keys(remedies.costs).length && t('left_costs')].filter(Boolean).join(', ');
      banner.notice([t('link_holds', inWords(open())), left && t('link_without', left)].filter(Boolean).join(' '), undefined, [link]);
      if (!isCopied) return link.focus();
      button.textContent = t('copied');
      setTimeout(() => (button.textContent = t('copy_link')), 1500);
    },
    project: async () => {
      const { text, holds, left } = await written({ ...open(), costs: remedies.costs, record: measure.record, plan: calibrate.plan });
      save(new Blob([text], { type: 'application/json' }), `${fileName(state)}${PROJECT}`);
      banner.notice([t('project_saved', holds), left && t('project_without_record', left)].filter(Boolean).join(' '));
    },
    toml: async () => {
      const answer = await json(await askOnce('/api/case', { case: { keys: state.keys }, language: currentLanguage() }));
      save(new Blob([answer.toml], { type: 'application/toml' }), `${fileName(state)}.toml`);
    },
    ...Object.fromEntries(['csv', 'png', 'svg', 'html'].map((kind) => [kind, async () => {
      const answer = await askOnce(`/api/export/${kind}`, { case: { keys: state.keys } });
      save(await answer.blob(), `${fileName(state)}-map.${kind}`);
    }])),
    // Of the measured rail if there is one, else of the case alone.
    report: async () => {
      if (await measure.saveReport()) return;
      save(await askReport({ case: state.keys, traffic: traffic.givenFile }, currentLanguage()), `${fileName(state)}-report.html`);
    },
    nominal: async () => replace({ case: structuredClone(state.vocabulary.nominal), point: null, tab: state.view }, t('started_over')),
  };
  const running = new Set();
  menu.addEventListener('click', async (event) => {
    const button = event.target.closest('[data-take]');
    if (!button) return;
    const { take } = button.dataset;
    // A second click while the first is under way would give the file twice.
    if (running.has(take)) return;
    running.add(take);
    const what = button.firstChild.textContent;
    try {
      await actions[take](button);
      banner.clear('success');
    } catch (fault) {
      complain(fault, { what: `${t('not_done', what)} `, until: fault.key ? 'case' : 'success' });
    } finally {
      running.delete(take);
    }
    if (take !== 'link') menu.hidePopover();
  });

  document.getElementById('open-toml').addEventListener('change', async (event) => {
    const [file] = event.target.files;
    if (file) await openFile(file);
    event.target.value = '';
    menu.hidePopover();
  });

  /** A project takes the place of all that is open. */
  async function openProject(file) {
    const project = await read(file);
    // What the program refuses is not opened.
    await askOnce('/api/case', { case: { keys: project.case } });
    replace({ ...project, point: null, tab: state.view }, t('project_opened', { name: file.name, holds: inWords(project) }));
    remedies.take(project.costs);
    if (project.record) measure.bringBack(project.record);
    if (project.plan) await calibrate.bringBack(project.plan);
  }

  /** A case file fills the form; one with an error says at which field and line. */
  async function openCase(file) {
    const answer = await json(await askOnce('/api/case', { case: { toml: await file.text() } }));
    replace({ case: answer.keys, point: null, tab: state.view }, t('comments_gone', file.name));
  }

  async function openFile(file) {
    // Under way from the first byte read until the case is shown.
    const opening = new AbortController();
    work.begin(opening);
    try {
      await (file.name.endsWith(PROJECT) ? openProject : openCase)(file);
      banner.clear();
    } catch (fault) {
      if (typeof fault === 'string') banner.say(() => fault, { until: 'closed' });
      else complain(fault, { what: t('file_fault', { name: file.name, line: fault.line }) });
    } finally {
      work.end(opening);
    }
  }

  const over = (is) => document.querySelectorAll('.drop').forEach((one) => one.classList.toggle('over', is));
  addEventListener('dragover', (event) => {
    event.preventDefault();
    over(true);
  });
  for (const end of ['dragleave', 'drop', 'dragend']) addEventListener(end, () => over(false));
  addEventListener('drop', (event) => {
    event.preventDefault();
    const files = [...(event.dataTransfer?.files ?? [])];
    const isOurs = ({ name }) => name.endsWith('.toml') || name.endsWith(PROJECT);
    const [ours, records] = [files.find(isOurs), files.filter((file) => !isOurs(file))];
    if (ours) openFile(ours);
    if (state.view === 'calibrate') calibrate.take(records);
    else if (records.length) measure.take(records[0], event.target);
  });
}
