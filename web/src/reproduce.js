// How to get the same run again.
import { el, section } from './dom.js';

export function reproduce({ data }) {
  const { scenario, version } = data;
  return section(
    'reproduce',
    'How to reproduce this',
    el(
      'p',
      {},
      `headland ${version} made this run with seed ${scenario.seed}. Save the scenario below as `,
      el('code', {}, 'scenario.yaml'),
      '; the same version gives the same numbers:',
    ),
    el(
      'pre',
      {},
      el(
        'code',
        {},
        `headland evaluate scenario.yaml -o out/${scenario.name.replace(/[^\w.-]/g, '_')}`,
      ),
    ),
    el(
      'details',
      { class: 'figures' },
      el('summary', {}, 'The scenario, every default written out'),
      el('pre', { class: 'scenario' }, el('code', {}, scenario.text)),
    ),
    el(
      'p',
      { class: 'note' },
      'This page holds everything it shows and loads nothing. Charts: Apache ECharts; map: Leaflet; 3D: three.js; typeface: Inter.',
    ),
  );
}
