// Where the plans of the methods differ, and what that costs.
import { axis, categories, chart, textStyle, tooltip } from './charts.js';
import { el, figures, section, table } from './dom.js';
import { fixed, percent } from './format.js';
import { ink, kinds as kindColours } from './palette.js';

const plurals = {
  swath: 'swaths',
  'headland pass': 'headland passes',
  turn: 'turns',
  'U-turn': 'U-turns',
  transit: 'transits',
};

const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;

function grouped(plans) {
  const groups = new Map();
  for (const plan of plans) {
    if (!groups.has(plan.block)) groups.set(plan.block, []);
    groups.get(plan.block).push(plan);
  }
  return groups;
}

// By method, over the places where every method was driven to the end.
function comparable(plans) {
  const byPlace = grouped(plans);
  const methods = [...new Set(plans.map(({ method }) => method))];
  const whole = [...byPlace.values()].filter(
    (own) => own.length === methods.length && own.every(({ why_not: why }) => why == null),
  );
  return {
    places: whole.length,
    rows: whole.length
      ? methods.map((method) => {
          const own = whole.map((all) => all.find((plan) => plan.method === method));
          const average = (of) => mean(own.map(of));
          const kinds = Object.keys(own[0].predicted_kind_wh ?? {});
          return {
            method,
            energy: average((plan) => plan.energy_wh),
            kinds: Object.fromEntries(
              kinds.map((kind) => [kind, average((plan) => plan.predicted_kind_wh[kind] ?? NaN)]),
            ),
            turns: average((plan) => plan.turns),
            uTurns: average((plan) => plan.u_turns),
            repeats: average((plan) => plan.repeats),
          };
        })
      : [],
  };
}

const usedKinds = (rows) =>
  Object.keys(rows[0]?.kinds ?? {}).filter((kind) => rows.some((row) => row.kinds[kind] > 0.05));

function stacked(rows) {
  const order = [...rows].reverse();
  const kinds = usedKinds(rows);
  const words = rows
    .map(
      ({ method, kinds: own }) =>
        `${method}: ${kinds.map((kind) => `${kind} ${fixed(own[kind], 1)}`).join(', ')}`,
    )
    .join('; ');
  return chart(
    `Energy that measured costs tell of each method's plans by kind of movement, in Wh, mean over the places. ${words}`,
    90 + 30 * rows.length,
    (width) => ({
      tooltip: {
        ...tooltip,
        trigger: 'axis',
        axisPointer: { type: 'shadow' },
        valueFormatter: (wh) => `${fixed(wh, 1)} Wh`,
      },
      legend: {
        top: 0,
        left: 0,
        itemWidth: 14,
        itemHeight: 12,
        textStyle: { ...textStyle, color: ink },
      },
      grid: { left: width < 500 ? 132 : 200, right: 24, top: width < 500 ? 52 : 30, bottom: 46 },
      xAxis: { type: 'value', ...axis, name: 'Wh', nameLocation: 'middle', nameGap: 30 },
      yAxis: categories(
        order.map(({ method }) => method),
        width,
      ),
      series: [
        ...kinds.map((kind) => ({
          type: 'bar',
          stack: 'energy',
          name: kind,
          barMaxWidth: 16,
          itemStyle: { color: kindColours[kind] ?? '#a8abad' },
          data: order.map((row) => row.kinds[kind]),
        })),
        {
          type: 'scatter',
          name: 'driven',
          symbol: 'diamond',
          symbolSize: 11,
          itemStyle: { color: ink, borderColor: '#fff', borderWidth: 1.5 },
          data: order.map((row, i) => [row.energy, i]),
          tooltip: { valueFormatter: undefined },
        },
      ],
    }),
  ).box;
}

// Between the plan that took least and boustrophedon: which movements make the difference.
function why(rows) {
  const reference = rows.find(({ method }) => method === 'boustrophedon');
  const others = rows.filter(({ method }) => method !== 'boustrophedon');
  if (!reference || !others.length) return null;
  const best = others.reduce((a, b) => (b.energy < a.energy ? b : a));
  const parts = usedKinds(rows)
    .map((kind) => ({ kind, change: best.kinds[kind] - reference.kinds[kind] }))
    .filter(({ change }) => Math.abs(change) >= 0.1)
    .sort((a, b) => Math.abs(b.change) - Math.abs(a.change));
  const words = parts.map(
    ({ kind, change }) =>
      `${fixed(Math.abs(change), 1)} Wh ${change < 0 ? 'less' : 'more'} on ${plurals[kind] ?? kind}`,
  );
  if (!words.length) return null;
  return el(
    'p',
    { class: 'lead' },
    `Against boustrophedon, plans by ${best.method} are told to take ${words.join(', ')}. ` +
      `On the grid they have ${fixed(best.turns, 1)} turns instead of ${fixed(reference.turns, 1)}, ` +
      `${fixed(best.uTurns, 1)} U-turns instead of ${fixed(reference.uTurns, 1)}, and ` +
      `${fixed(best.repeats, 1)} cells repeated instead of ${fixed(reference.repeats, 1)}; ` +
      'the machine drives these as bends, turns, U-turns and transits, as their places allow.',
  );
}

const columnsOf = (kinds, first) => [
  { label: first },
  ...['Driven, Wh', ...kinds.map((kind) => `${kind}, Wh`), 'Turns', 'U-turns', 'Repeats'].map(
    (label) => ({
      label,
      number: true,
    }),
  ),
];

function placeTables(plans, kinds) {
  return [...grouped(plans)].map(([block, own]) => {
    const rows = own.map((plan) =>
      plan.why_not == null
        ? [
            plan.method,
            fixed(plan.energy_wh, 1),
            ...kinds.map((kind) => fixed(plan.predicted_kind_wh?.[kind] ?? NaN, 1)),
            String(plan.turns),
            String(plan.u_turns),
            String(plan.repeats),
            percent(plan.coverage_ratio),
          ]
        : [plan.method, `none: ${plan.why_not}`, ...kinds.map(() => '–'), '–', '–', '–', '–'],
    );
    return el(
      'details',
      { class: 'figures map-figures' },
      el('summary', {}, block),
      table(
        `Plans at ${block}`,
        [...columnsOf(kinds, 'Planned by'), { label: 'Covered', number: true }],
        rows,
      ),
    );
  });
}

export function plans({ held_out_plans: all }, pictures) {
  if (!all.length) return null;
  const { places, rows } = comparable(all);
  const kinds = usedKinds(rows);
  return section(
    'plans',
    'Where the plans differ, and why',
    rows.length > 0 && [
      why(rows),
      el(
        'p',
        {},
        `Bars: energy that measured costs tell of the plans, by kind of movement, mean over ${places} place${places === 1 ? '' : 's'} where every method was driven to the end. Diamond: what the drives took.`,
      ),
      stacked(rows),
      figures(
        'Plans of each method, means over the places',
        columnsOf(kinds, 'Planned by'),
        rows.map((row) => [
          row.method,
          fixed(row.energy, 1),
          ...kinds.map((kind) => fixed(row.kinds[kind], 1)),
          fixed(row.turns, 1),
          fixed(row.uTurns, 1),
          fixed(row.repeats, 1),
        ]),
      ),
    ],
    pictures.size > 0 && [...pictures.values()],
    el('h3', {}, 'Place by place'),
    placeTables(all, kinds),
  );
}
