// Where the energy went: by movement and cause, as bars and as a flow.
import { axis, chart, textStyle, tooltip } from './charts.js';
import { el, figures, section } from './dom.js';
import { energyFlow } from './energy_flow.js';
import { distance, energy as energyText, fixed, percent, tick } from './format.js';
import { causeColour, ink } from './palette.js';

const kSmall = 0.015; // of all energy: causes below this are shown together

// {kinds: [{kind, count, distance, total, causes: Map(cause -> Wh)}], causes: [name, largest first]}.
export function readEnergy(metrics) {
  const kinds = [];
  const sums = new Map();
  for (const [kind, totals] of Object.entries(metrics.by_kind)) {
    if (!totals.count) continue;
    const causes = new Map();
    for (const [key, joule] of Object.entries(totals.energy)) {
      if (key === 'battery_j') continue;
      const cause = key.replace(/_j$/, '').replaceAll('_', ' ');
      const wh = (joule ?? 0) / 3600;
      causes.set(cause, wh);
      sums.set(cause, (sums.get(cause) ?? 0) + wh);
    }
    const total = (totals.energy.battery_j ?? 0) / 3600;
    kinds.push({
      kind,
      count: totals.count,
      distance: totals.distance_m,
      time: totals.time_s,
      total,
      causes,
    });
  }
  const all = kinds.reduce((sum, { total }) => sum + Math.abs(total), 0);
  const causes = [...sums].sort((a, b) => b[1] - a[1]).map(([cause]) => cause);
  const small = causes.filter((cause) =>
    kinds.every((kind) => Math.abs(kind.causes.get(cause)) < kSmall * all),
  );
  return { kinds, causes: causes.filter((cause) => !small.includes(cause)), small, all };
}

export const sumOf = (kind, causes) =>
  causes.reduce((sum, cause) => sum + (kind.causes.get(cause) ?? 0), 0);

function bars({ kinds, causes, small, all }) {
  const shown = [...causes, ...(small.length ? ['other'] : [])];
  const value = (kind, cause) => (cause === 'other' ? sumOf(kind, small) : kind.causes.get(cause));
  const order = [...kinds].reverse();
  const label = kinds.map(({ kind, total }) => `${kind} ${energyText(total)}`).join(', ');
  const legendRows = (width) => Math.ceil((shown.length * 165) / width);
  return chart(
    `Energy by movement and cause: ${label}`,
    (width) => 60 + 44 * kinds.length + 24 * legendRows(width),
    (width) => ({
      tooltip: {
        ...tooltip,
        trigger: 'axis',
        axisPointer: { type: 'shadow' },
        valueFormatter: (wh) => energyText(wh),
      },
      legend: {
        top: 0,
        left: 0,
        itemWidth: 12,
        itemHeight: 12,
        textStyle: { ...textStyle, color: ink },
      },
      grid: {
        left: width < 500 ? 92 : 110,
        right: 24,
        top: 14 + 24 * legendRows(width),
        bottom: 28,
      },
      xAxis: {
        type: 'value',
        min: ({ min }) => (min > -0.02 * all ? 0 : null),
        ...axis,
        axisLabel: {
          ...textStyle,
          formatter: (wh) => `${tick(wh / 1000)} kWh`,
          hideOverlap: true,
        },
      },
      yAxis: {
        type: 'category',
        ...axis,
        data: order.map(({ kind }) => kind),
        axisLabel: { ...textStyle, color: ink },
      },
      series: shown.map((cause) => ({
        type: 'bar',
        name: cause,
        stack: 'energy',
        barMaxWidth: 26,
        itemStyle: { color: causeColour(cause), borderColor: '#fcfcfa', borderWidth: 0.5 },
        data: order.map((kind) => value(kind, cause)),
      })),
    }),
  ).box;
}

function energyTable({ kinds, causes, small }) {
  const columns = [
    { label: 'Cause' },
    ...kinds.map(({ kind }) => ({ label: kind, number: true })),
    { label: 'all', number: true },
    { label: 'share', number: true },
  ];
  const all = kinds.reduce((sum, { total }) => sum + total, 0);
  const row = (name, values) => {
    const sum = values.reduce((a, b) => a + b, 0);
    return [name, ...values.map((wh) => fixed(wh, 1)), fixed(sum, 1), percent(sum / all)];
  };
  const rows = [...causes, ...small].map((cause) =>
    row(
      cause,
      kinds.map((kind) => kind.causes.get(cause)),
    ),
  );
  rows.push(
    row(
      'from the battery',
      kinds.map(({ total }) => total),
    ),
  );
  rows.push(['each', ...kinds.map(({ total, count }) => fixed(total / count, 2)), '', '']);
  rows.push([
    'per metre',
    ...kinds.map(({ total, distance: m }) => (m > 0 ? fixed(total / m, 3) : '–')),
    '',
    '',
  ]);
  return figures('Energy by cause and movement, in Wh', columns, rows);
}

export function energy({ data, pictures }) {
  if (!data.metrics) return null;
  const read = readEnergy(data.metrics);
  if (!read.kinds.length) return null;
  const { figures: all } = data.metrics;
  const residual =
    all.ledger_residual_ratio < 1e-4 ? 'less than 0.01 %' : percent(all.ledger_residual_ratio, 2);
  return section(
    'energy',
    'Where the energy went',
    el(
      'p',
      { class: 'lead' },
      `The battery gave ${energyText(all.energy_wh)} over ${distance(all.distance_m)}. `,
      `The causes below account for all but ${residual} of it.`,
    ),
    el('h3', {}, 'By movement and cause'),
    bars(read),
    energyTable(read),
    el('h3', {}, 'As a flow'),
    energyFlow(read),
    pictures.get('energy.png'),
  );
}
