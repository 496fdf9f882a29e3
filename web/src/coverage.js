// What was covered how often, and what was missed.
import { chart, textStyle } from './charts.js';
import { el, figures, section, table } from './dom.js';
import { area, percent, place } from './format.js';
import { ground, ink } from './palette.js';

const classes = [
  ['once', 'Once'],
  ['twice', 'Twice'],
  ['more', 'Three times or more'],
  ['missed', 'Missed'],
];

function bar(areas) {
  const workable = classes.reduce((sum, [key]) => sum + areas[key], 0);
  const label = classes
    .map(([key, name]) => `${name}: ${percent(areas[key] / workable)}`)
    .join('; ');
  return chart(`Workable ground by times worked. ${label}`, 96, () => ({
    aria: { enabled: false },
    legend: {
      bottom: 0,
      left: 0,
      itemWidth: 14,
      itemHeight: 14,
      textStyle: { ...textStyle, color: ink },
      selectedMode: false,
    },
    grid: { left: 0, right: 0, top: 4, height: 34 },
    xAxis: { type: 'value', max: workable, show: false },
    yAxis: { type: 'category', data: [''], show: false },
    series: classes.map(([key, name]) => ({
      type: 'bar',
      name: `${name} ${percent(areas[key] / workable)}`,
      stack: 'ground',
      barWidth: 34,
      data: [areas[key]],
      itemStyle: { color: ground[key] },
    })),
  })).box;
}

// Patches worth going to, largest first.
function patchesTable(patches) {
  const shown = patches.slice(0, 10);
  if (!shown.length) return el('p', {}, 'No missed patch is larger than half a square metre.');
  const rest = patches.length - shown.length;
  return [
    table(
      'Largest missed patches',
      [{ label: 'Patch' }, { label: 'Area', number: true }, { label: 'Place', number: true }],
      shown.map((patch, i) => [String(i + 1), area(patch.area_m2), place(patch.at)]),
    ),
    rest > 0 &&
      el('p', { class: 'note' }, `And ${rest === 190 ? 'at least ' : ''}${rest} smaller ones.`),
  ];
}

export function coverage({ data, pictures }) {
  const areas = data.areas_m2;
  const total = areas.once + areas.twice + areas.more + areas.missed;
  const summary = total
    ? `${area(total - areas.missed)} of ${area(total)} workable ground was worked; ${area(areas.missed)} was missed` +
      `${areas.outside > 0 ? `, and ${area(areas.outside)} was worked outside the field` : ''}.`
    : 'No ground is known to be worked.';
  return section(
    'coverage',
    'Covered and missed',
    el('p', { class: 'lead' }, summary),
    total > 0 && [
      bar(areas),
      figures(
        'Workable ground by times worked',
        [{ label: 'Worked' }, { label: 'Area', number: true }, { label: 'Share', number: true }],
        classes.map(([key, name]) => [name, area(areas[key]), percent(areas[key] / total, 2)]),
      ),
    ],
    pictures.get('field.png'),
    el('h3', {}, 'Where it was missed'),
    patchesTable(data.missed_patches),
  );
}
