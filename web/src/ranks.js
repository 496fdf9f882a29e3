// Average ranks and the tests on them.
import { axis, chart, textStyle, tooltip } from './charts.js';
import { el, section, table } from './dom.js';
import { fixed, short } from './format.js';
import { ink, softInk } from './palette.js';

const pValue = (p) => (p == null ? '–' : p < 0.001 ? '< 0.001' : p.toFixed(3));

function bars(averages, control) {
  const order = [...averages].reverse();
  const label = averages.map(([name, rank]) => `${name} ${rank.toFixed(2)}`).join(', ');
  return chart(`Average ranks, 1 is best: ${label}`, 40 + 34 * averages.length, (width) => ({
    tooltip: { ...tooltip, trigger: 'item', valueFormatter: (rank) => fixed(rank, 2) },
    grid: { left: width < 500 ? 120 : 170, right: 50, top: 4, bottom: 28 },
    xAxis: { type: 'value', min: 0, ...axis, name: '' },
    yAxis: {
      type: 'category',
      ...axis,
      data: order.map(([name]) => name),
      axisLabel: { ...textStyle, color: ink, width: width < 500 ? 110 : 160, overflow: 'truncate' },
    },
    series: [
      {
        type: 'bar',
        barMaxWidth: 18,
        label: {
          show: true,
          position: 'right',
          ...textStyle,
          color: ink,
          formatter: ({ value }) => value.toFixed(2),
        },
        data: order.map(([name, rank]) => ({
          value: rank,
          itemStyle: { color: name === control ? '#1c3878' : softInk },
        })),
      },
    ],
  })).box;
}

function pairs({ wilcoxon }) {
  if (!wilcoxon?.length) return null;
  const columns = [
    'Pair',
    'First better',
    'Second better',
    'Median difference',
    'p',
    'p after Holm',
  ].map((label, i) => ({ label, number: i > 0 }));
  const rows = wilcoxon.map((pair) => [
    `${pair.first} and ${pair.second}`,
    String(pair.first_better),
    String(pair.second_better),
    short(pair.median_difference ?? NaN),
    pValue(pair.p),
    pValue(pair.holm_p),
  ]);
  return [el('h3', {}, 'Pairs, by signed ranks'), table('Wilcoxon tests of pairs', columns, rows)];
}

export function ranks({ ranks: found }) {
  const averages = Object.entries(found?.average_rank ?? {}).filter(([, rank]) => rank != null);
  if (!averages.length) return null;
  averages.sort((a, b) => a[1] - b[1]);
  const { friedman, control, bonferroni_dunn_distance: distance } = found;
  const block =
    found.block === 'run' ? 'single runs' : `${found.block}s, by the mean over the runs`;
  return section(
    'ranks',
    'Who is better',
    el(
      'p',
      {},
      `Ranks by ${found.figure} over ${found.blocks} blocks (${block}); 1 is best. `,
      friedman?.iman_davenport_p != null &&
        `Friedman: chi-square ${fixed(friedman.chi_square, 2)}, F ${fixed(friedman.iman_davenport_f, 2)}, p ${pValue(friedman.iman_davenport_p)}. `,
      control &&
        distance != null &&
        `Average ranks ${fixed(distance, 2)} away from that of ${control}, the control, differ (Bonferroni and Dunn).`,
    ),
    bars(averages, control),
    pairs(found),
    found.notes?.length > 0 &&
      el(
        'ul',
        {},
        found.notes.map((note) => el('li', {}, note)),
      ),
  );
}
