// How the best plan so far came down with the work that was put in.
import { axis, chart, textStyle, tooltip } from './charts.js';
import { el, section } from './dom.js';
import { short } from './format.js';
import { ink } from './palette.js';
import { placeOf, placesOf } from './places.js';

const colours = [
  '#332288',
  '#cc6677',
  '#117733',
  '#ddaa33',
  '#0f6a86',
  '#882255',
  '#999933',
  '#aa4499',
  '#545a60',
];
const dashes = ['solid', 'dashed', 'dotted'];

// Median over the runs of the best cost so far, as steps over evaluations.
function medianLine(runs) {
  const lines = runs.map(({ convergence }) => convergence).filter((line) => line?.length);
  if (!lines.length) return [];
  const places = [
    ...new Set(lines.flatMap((line) => line.map(([, evaluations]) => Math.max(1, evaluations)))),
  ].sort((a, b) => a - b);
  const cursor = lines.map(() => 0);
  const points = [];
  for (const place of places) {
    const costs = [];
    lines.forEach((line, k) => {
      while (cursor[k] + 1 < line.length && line[cursor[k] + 1][1] <= place) ++cursor[k];
      if (Math.max(1, line[cursor[k]][1]) <= place) costs.push(line[cursor[k]][2]);
    });
    if (costs.length < lines.length) continue; // from where all runs have a plan
    costs.sort((a, b) => a - b);
    points.push([place, costs[Math.floor(costs.length / 2)]]);
  }
  return points;
}

function mapChart(map, planners, runs) {
  const lines = planners.map(({ label }) => ({
    label,
    points: medianLine(runs.filter((run) => placeOf(run) === map && run.planner === label)),
  }));
  const drawn = lines.filter(({ points }) => points.length);
  if (!drawn.length) return null;
  const end = Math.max(
    ...runs.filter((run) => placeOf(run) === map).map((run) => run.figures?.evaluations ?? 1),
    2,
  );
  for (const { points } of drawn)
    points.push([Math.max(end, points[points.length - 1][0]), points[points.length - 1][1]]);
  const label = drawn
    .map(({ label: name, points }) => `${name} ends at ${short(points[points.length - 1][1])}`)
    .join('; ');
  const legendRows = (width) => Math.ceil((drawn.length * 150) / width);
  return [
    el('h3', {}, map),
    chart(
      `Median cost of the best plan so far on ${map}: ${label}`,
      (width) => 270 + 22 * legendRows(width),
      (width) => ({
        tooltip: { ...tooltip, trigger: 'axis', valueFormatter: short },
        legend: { top: 0, left: 0, itemWidth: 22, textStyle: { ...textStyle, color: ink } },
        grid: { left: 52, right: 16, top: 16 + 22 * legendRows(width), bottom: 48 },
        xAxis: {
          type: 'log',
          min: 1,
          max: end,
          ...axis,
          name: 'evaluations',
          nameLocation: 'middle',
          nameGap: 30,
          axisLabel: { ...textStyle, formatter: (n) => n.toLocaleString('en') },
        },
        yAxis: { type: 'value', scale: true, ...axis },
        series: drawn.map(({ label: name, points }) => {
          const k = planners.findIndex((planner) => planner.label === name);
          const color = colours[k % colours.length];
          return {
            type: 'line',
            name,
            step: 'end',
            data: points,
            showSymbol: points.length < 3,
            symbolSize: 5,
            lineStyle: { width: 1.8, color, type: dashes[Math.floor(k / 3) % 3] },
            itemStyle: { color },
          };
        }),
      }),
    ).box,
  ];
}

export function convergence({ comparison, runs }) {
  const charts = placesOf(comparison)
    .map(({ name }) => mapChart(name, comparison.planners, runs))
    .filter(Boolean);
  if (!charts.length) return null;
  return section(
    'convergence',
    'How the searches came along',
    el('p', {}, 'Median over the runs of the best plan so far.'),
    charts,
  );
}
