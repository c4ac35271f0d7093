// A report of the variants: one page to print, which needs nothing else.

import { element } from './elements.js';
import { svgOf } from './figures.js';
import { currentLanguage, t } from './words.js';

const STYLE = `body { font: 14px/1.45 system-ui, "DejaVu Sans", sans-serif; color: #16191d; background: #fff; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.1rem; margin: 1.6rem 0 .4rem; } p { margin: .3rem 0; } img { max-width: 100%; }
figure { margin: .6rem 0; break-inside: avoid; } figcaption { color: #535c66; } a { overflow-wrap: anywhere; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: .9rem; } th, td { padding: 3px 9px; border-top: 1px solid #c6ccd3; text-align: right; font-weight: 400; }
thead th { font-weight: 600; border-top: 0; } th:first-child { text-align: left; color: #535c66; }
.maps { display: grid; grid-template-columns: repeat(auto-fit, minmax(18rem, 1fr)); gap: .8rem; }
@page { size: A4 landscape; margin: 12mm; } @media print { body { margin: 0; max-width: none; } .maps { grid-template-columns: repeat(3, 1fr); } }`;

const picture = (svg) => element('img', { src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`, alt: '' });

/** The page as text: table, curves at one speed, both maps and their difference, and the link that opens them. */
export async function reportOf({ names, table, panels, curvesPlace, speed }) {
  const caption = ({ name, aside }, k) => (name === 'difference' ? `${t('difference')}: ${aside.textContent}` : `${t('growth_map')}: ${panels[k].panel.querySelector('select').selectedOptions[0].textContent}`);
  const maps = [];
  for (const [k, panel] of panels.entries()) {
    const bar = panel.legend.textContent ? [...panel.legend.querySelectorAll('.name, .end')].map(({ textContent }) => textContent).join(' · ') : '';
    maps.push(element('figure', {}, picture(await svgOf({ map: panel.view })), element('figcaption', { textContent: [caption(panel, k), bar].filter(Boolean).join('. ') })));
  }
  const body = element('body', {},
    element('h1', { textContent: t('report_of_variants') }), element('p', { textContent: names.join(' · ') }),
    element('p', {}, element('a', { href: location.href, textContent: t('opens_variants') })),
    element('div', { className: 'wide' }, table.cloneNode(true)),
    element('h2', { textContent: `${t('growth_curve')}, ${speed}` }), element('figure', {}, picture(await svgOf({ plot: curvesPlace }))),
    element('h2', { textContent: t('maps_of_variants') }), element('div', { className: 'maps' }, ...maps),
  );
  // As text: a style of its own is not for this page to apply.
  const head = `<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${t('report_of_variants')}</title><style>${STYLE}</style>`;
  return `<!DOCTYPE html>\n<html lang="${currentLanguage()}"><head>${head}</head>${body.outerHTML}</html>\n`;
}
