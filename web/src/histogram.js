// How far from its path the machine was, over the distance.
import { axis, chart, textStyle, tooltip } from './charts.js';
import { el, figures } from './dom.js';
import { fixed } from './format.js';
import { ink } from './palette.js';

export function histogram({ data }) {
  const { edges_m: edges, working, turning } = data.tracking;
  if (!working.some((share) => share > 0) && !turning.some((share) => share > 0)) return null;
  const figuresOf = data.metrics?.figures;
  const cm = (m) => Number((100 * m).toFixed(3));
  const bins = working.map((_, k) => cm(0.5 * (edges[k] + edges[k + 1])));
  const first = Math.max(0, bins.findIndex((_, k) => working[k] + turning[k] > 0) - 1);
  const last = Math.min(
    bins.length,
    bins.length -
      [...bins]
        .reverse()
        .findIndex((_, k) => working[bins.length - 1 - k] + turning[bins.length - 1 - k] > 0) +
      1,
  );
  const cut = (values) => values.slice(first, last);
  const rms = figuresOf
    ? `${fixed(100 * figuresOf.track_rms_working_m, 1)} cm root mean square at work, ${fixed(100 * figuresOf.track_rms_turning_m, 1)} cm in turns`
    : '';
  const box = chart(`Histogram of the tracking error: ${rms}`, 260, () => ({
    tooltip: {
      ...tooltip,
      trigger: 'axis',
      axisPointer: { type: 'shadow' },
      valueFormatter: (share) => `${fixed(share, 2)} %`,
    },
    legend: {
      top: 0,
      left: 0,
      itemWidth: 12,
      itemHeight: 12,
      textStyle: { ...textStyle, color: ink },
    },
    grid: { left: 44, right: 8, top: 36, bottom: 46 },
    xAxis: {
      type: 'value',
      min: cm(edges[first]),
      max: cm(edges[last]),
      ...axis,
      name: 'cm off the path, left positive',
      nameLocation: 'middle',
      nameGap: 28,
      axisLabel: { ...textStyle, hideOverlap: true },
    },
    yAxis: { type: 'value', ...axis, axisLabel: { ...textStyle, formatter: '{value} %' } },
    series: [
      {
        type: 'bar',
        stack: 'way',
        name: 'implement down',
        data: cut(working).map((share, k) => [bins[first + k], share]),
        itemStyle: { color: '#1c3878' },
        barCategoryGap: '8%',
      },
      {
        type: 'bar',
        stack: 'way',
        name: 'implement up',
        data: cut(turning).map((share, k) => [bins[first + k], share]),
        itemStyle: { color: '#88ccee' },
      },
    ],
  })).box;
  const rows = bins
    .map((_, k) => [
      `${cm(edges[k])} to ${cm(edges[k + 1])}`,
      fixed(working[k], 2),
      fixed(turning[k], 2),
    ])
    .filter((_, k) => working[k] + turning[k] > 0);
  return [
    el('h3', {}, 'How far off its path'),
    el('p', {}, `Share of the driven distance by tracking error${rms ? `: ${rms}` : ''}.`),
    box,
    figures(
      'Share of the distance, in percent',
      [
        { label: 'Error, cm' },
        { label: 'implement down', number: true },
        { label: 'implement up', number: true },
      ],
      rows,
    ),
  ];
}
