// How the time was spent.
import { axis, chart, textStyle, tooltip } from './charts.js';
import { el, section, table } from './dom.js';
import { clock, distance, duration, percent } from './format.js';
import { ink, kinds as kindColours } from './palette.js';

const steps = [10, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400];
const roundStep = (seconds) =>
  steps.find((step) => step >= seconds) ?? 14400 * Math.ceil(seconds / 14400);

export function timeUse({ data }) {
  if (!data.metrics) return null;
  const kinds = Object.entries(data.metrics.by_kind).filter(([, totals]) => totals.count);
  if (!kinds.length) return null;
  const all = kinds.reduce((sum, [, totals]) => sum + (totals.time_s ?? 0), 0);
  const order = [...kinds].reverse();
  const longest = Math.max(...kinds.map(([, { time_s }]) => time_s));
  const label = kinds.map(([kind, { time_s }]) => `${kind} ${duration(time_s)}`).join(', ');
  const bars = chart(`Time by movement: ${label}`, 34 + 40 * kinds.length, (width) => ({
    tooltip: { ...tooltip, trigger: 'item', valueFormatter: duration },
    grid: { left: width < 500 ? 92 : 110, right: 76, top: 4, bottom: 28 },
    xAxis: {
      type: 'value',
      ...axis,
      axisLabel: { ...textStyle, formatter: clock, hideOverlap: true },
    },
    yAxis: {
      type: 'category',
      ...axis,
      data: order.map(([kind]) => kind),
      axisLabel: { ...textStyle, color: ink },
    },
    series: [
      {
        type: 'bar',
        barMaxWidth: 24,
        label: {
          show: true,
          position: 'right',
          ...textStyle,
          color: ink,
          formatter: ({ value }) => percent(value / all),
        },
        data: order.map(([kind, { time_s }]) => ({
          value: time_s,
          itemStyle: { color: kindColours[kind] },
        })),
      },
    ],
  }));
  const columns = ['Movement', 'Count', 'Time', 'Share', 'Distance', 'Mean speed'].map(
    (name, i) => ({ label: name, number: i > 0 }),
  );
  const rows = kinds.map(([kind, { count, time_s, distance_m }]) => [
    kind,
    String(count),
    duration(time_s),
    percent(time_s / all),
    distance(distance_m),
    time_s > 0 ? `${(distance_m / time_s).toFixed(2)} m/s` : '–',
  ]);
  const working = kinds.find(([kind]) => kind === 'swath')?.[1].time_s ?? 0;
  return section(
    'time',
    'Where the time went',
    el(
      'p',
      { class: 'lead' },
      `${duration(all)} in all, ${percent(working / all, 0)} of it on swaths.`,
    ),
    bars.box,
    table('Time by movement', columns, rows),
  );
}
