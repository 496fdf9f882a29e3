// What plans by each method save, driven, with intervals.
import { axis, categories, chart, tooltip, whiskers } from './charts.js';
import { el, figures, section, table } from './dom.js';
import { duration, fixed, percent, short } from './format.js';
import { softInk } from './palette.js';

export const boustrophedon = 'boustrophedon';
export const isControl = (method) => method === 'shuffled';
const methodName = (method) => (isControl(method) ? 'control: shuffled energies' : method);

export const ratioText = (ratio) => percent(ratio).replace('-', '−');
export const pText = (p) => (p == null ? '–' : p < 0.001 ? '< 0.001' : fixed(p, 3));

export const energySaving = (figures, reference) =>
  figures.saves_over?.[reference]?.find(({ quantity }) => quantity === 'energy_wh');

const colour = (method) => (isControl(method) ? '#a8abad' : '#1c5d8f');

// One bar a method: the mean over the places and its 95 % interval.
function bars(reference, rows) {
  const order = [...rows].reverse();
  const words = rows
    .map(({ method, saving }) => `${methodName(method)} ${ratioText(saving.mean_ratio)}`)
    .join(', ');
  const ends = rows.flatMap(({ saving: { mean_ratio: mean, ci95_ratio: half } }) => [
    100 * (mean - (half ?? 0)),
    100 * (mean + (half ?? 0)),
  ]);
  const nice = (value, up) => (up ? Math.ceil(value / 5) : Math.floor(value / 5)) * 5;
  return chart(
    `Energy saved over ${reference}, mean and 95 % interval: ${words}`,
    64 + 30 * rows.length,
    (width) => ({
      tooltip: { ...tooltip, trigger: 'item' },
      grid: { left: width < 500 ? 132 : 200, right: 24, top: 4, bottom: 46 },
      xAxis: {
        type: 'value',
        ...axis,
        min: Math.min(nice(Math.min(...ends), false), 0),
        max: Math.max(nice(Math.max(...ends), true), 5),
        axisLabel: { ...axis.axisLabel, showMinLabel: false, showMaxLabel: false },
        name: 'energy saved, %',
        nameLocation: 'middle',
        nameGap: 30,
      },
      yAxis: {
        ...categories(
          order.map(({ method }) => methodName(method)),
          width,
        ),
        axisLine: { onZero: false, show: false },
      },
      series: [
        {
          type: 'bar',
          barMaxWidth: 16,
          data: order.map(({ method, saving }) => ({
            value: 100 * saving.mean_ratio,
            itemStyle: { color: colour(method) },
          })),
          tooltip: {
            formatter: ({ dataIndex }) => {
              const { method, saving } = order[dataIndex];
              const spread = saving.ci95_ratio == null ? '' : ` ± ${ratioText(saving.ci95_ratio)}`;
              return `${methodName(method)}<br>${ratioText(saving.mean_ratio)}${spread}, p ${pText(saving.p)}`;
            },
          },
          markLine: {
            silent: true,
            symbol: 'none',
            label: { show: false },
            lineStyle: { color: softInk, type: 'solid', width: 1 },
            data: [{ xAxis: 0 }],
          },
        },
        whiskers(
          order.map(({ saving: { mean_ratio: mean, ci95_ratio: half } }, i) =>
            half == null ? null : [i, 100 * (mean - half), 100 * (mean + half)],
          ),
        ),
      ],
    }),
  ).box;
}

function savingTable(reference, rows) {
  const columns = ['Planned by', 'Saves', '95 %', 'Less at', 'More at', 'p'].map((label, i) => ({
    label,
    number: i > 0,
  }));
  return figures(
    `Energy saved over ${reference}`,
    columns,
    rows.map(({ method, saving }) => [
      methodName(method),
      ratioText(saving.mean_ratio),
      saving.ci95_ratio == null ? '–' : `± ${ratioText(saving.ci95_ratio)}`,
      `${saving.wins} of ${saving.blocks}`,
      `${saving.losses} of ${saving.blocks}`,
      pText(saving.p),
    ]),
  );
}

function over(reference, methods) {
  const rows = methods
    .map((figures) => ({ method: figures.method, saving: energySaving(figures, reference) }))
    .filter(({ method, saving }) => method !== reference && saving?.mean_ratio != null)
    .sort((a, b) => b.saving.mean_ratio - a.saving.mean_ratio);
  if (!rows.length) return null;
  return el(
    'div',
    {},
    el('h3', {}, `Over ${reference}`),
    bars(reference, rows),
    savingTable(reference, rows),
  );
}

function means(methods) {
  const columns = ['Planned by', 'Driven', 'Wh', 'Wh/ha', 'Time', 'Charge used', 'Covered'].map(
    (label, i) => ({ label, number: i > 0 }),
  );
  const rows = methods.map(({ method, runs, without_figures: without, mean }) => [
    methodName(method),
    `${runs - without} of ${runs}`,
    fixed(mean?.energy_wh ?? NaN, 1),
    short(mean?.energy_wh_per_ha ?? NaN),
    duration(mean?.time_s ?? NaN),
    percent(mean?.delta_soc ?? NaN, 2),
    percent(mean?.coverage_ratio ?? NaN),
  ]);
  return [
    el('h3', {}, 'What a drive took'),
    table('Means over the held-out places', columns, rows),
  ];
}

export function savings({ methods }) {
  const references = new Set(methods.flatMap(({ saves_over: over }) => Object.keys(over ?? {})));
  // First what everybody knows, last what nobody would do.
  const order = [boustrophedon, ...[...references].filter((name) => name !== 'length'), 'length'];
  return section(
    'savings',
    'What the weights save',
    el(
      'p',
      {},
      'Energy of plans driven at places that nothing was tuned on, against that of a reference at the same place. Bars are means over the places, whiskers their 95 % intervals; where a whisker crosses zero, the saving may be chance. p is of Wilcoxon’s signed-rank test, not adjusted for looking at many.',
    ),
    el(
      'div',
      { class: 'columns' },
      [...new Set(order)].map((reference) => over(reference, methods)),
    ),
    means(methods),
  );
}
