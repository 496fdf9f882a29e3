// How well each form tells the driven energy, and the weights it was given.
import { axis, chart, tooltip } from './charts.js';
import { el, section, table } from './dom.js';
import { fixed, percent, short } from './format.js';
import { softInk } from './palette.js';

export const formNames = {
  weighted: 'Wu et al. (weighted)',
  tractor: 'Wang et al. (tractor)',
  length: 'length',
  measured: 'measured costs',
};
const formName = (form) => formNames[form] ?? form;

function scatter({ form, held_out: heldOut }, plans, most) {
  const points = plans
    .map((plan) => ({ plan, told: plan.fitted_wh?.[form] }))
    .filter(({ plan, told }) => plan.why_not == null && told != null);
  if (!points.length) return null;
  const error = percent(heldOut.fitted?.mean_absolute_error ?? NaN);
  return el(
    'div',
    {},
    el('h3', {}, `${formName(form)}: error ${error}`),
    chart(
      `Energy told by ${formName(form)} against the driven one, ${points.length} held-out plans, mean error ${error}`,
      (width) => Math.min(width, 340),
      () => ({
        tooltip: {
          ...tooltip,
          formatter: ({ seriesIndex, dataIndex }) => {
            if (seriesIndex !== 0) return '';
            const { plan, told } = points[dataIndex];
            return `${plan.block}<br>${plan.method}<br>driven ${fixed(plan.energy_wh, 1)} Wh, told ${fixed(told, 1)} Wh`;
          },
        },
        grid: { left: 58, right: 16, top: 8, bottom: 46 },
        xAxis: {
          type: 'value',
          min: 0,
          max: most,
          ...axis,
          name: 'driven, Wh',
          nameLocation: 'middle',
          nameGap: 30,
        },
        yAxis: {
          type: 'value',
          min: 0,
          max: most,
          ...axis,
          name: 'told, Wh',
          nameLocation: 'middle',
          nameGap: 40,
        },
        series: [
          {
            type: 'scatter',
            symbolSize: 6,
            itemStyle: { color: '#1c5d8f', opacity: 0.65 },
            data: points.map(({ plan, told }) => [plan.energy_wh, told]),
          },
          {
            type: 'line',
            silent: true,
            showSymbol: false,
            lineStyle: { color: softInk, width: 1, type: 'dashed' },
            data: [
              [0, 0],
              [most, most],
            ],
          },
        ],
      }),
    ).box,
  );
}

function predictionTable(forms) {
  const columns = [
    'Energy told by',
    'Plans',
    'R²',
    'Spearman',
    'Spearman in a place',
    'Mean error',
  ].map((label, i) => ({ label, number: i > 0 }));
  const row = (form, weights, told) => [
    `${formName(form)}, ${weights}`,
    String(told?.plans ?? '–'),
    fixed(told?.r2 ?? NaN, 3),
    fixed(told?.spearman ?? NaN, 3),
    fixed(told?.spearman_in_block ?? NaN, 3),
    percent(told?.mean_absolute_error ?? NaN),
  ];
  return table(
    'How well forms tell the driven energy of held-out plans',
    columns,
    forms.flatMap(({ form, held_out: heldOut }) => [
      row(form, 'printed', heldOut.printed),
      row(form, 'fitted', heldOut.fitted),
    ]),
  );
}

function terms(forms) {
  const columns = ['Term', 'Fitted, Wh', 'From', 'To'].map((label, i) => ({
    label,
    number: i > 0,
  }));
  return table(
    'Fitted coefficients and their 95 % intervals',
    columns,
    forms.flatMap(({ form, terms: own }) =>
      (own ?? []).map((term) => [
        `${formName(form)}: ${term.name}`,
        short(term.coefficient_wh),
        short(term.low_wh),
        short(term.high_wh),
      ]),
    ),
  );
}

function search(forms) {
  const searched = forms.filter(({ search: found }) => found?.least_so_far?.length);
  if (!searched.length) return null;
  const columns = ['Form', 'Weights found', 'Tried', 'First', 'Best'].map((label, i) => ({
    label,
    number: i > 1,
  }));
  return [
    el('h3', {}, 'Weights looked for by driving'),
    el(
      'p',
      {},
      'Energy a hectare on training fields over the usual there: below 1 is less than the mean of the training plans.',
    ),
    table(
      'Search by driven energy',
      columns,
      searched.map(({ form, search: found }) => [
        formName(form),
        found.weights.map(short).join(', '),
        String(found.evaluations),
        fixed(found.least_so_far[0], 3),
        fixed(found.loss, 3),
      ]),
    ),
  ];
}

export function fits({ forms, held_out_plans: plans }) {
  if (!forms.length) return null;
  const told = plans.flatMap((plan) => [plan.energy_wh, ...Object.values(plan.fitted_wh ?? {})]);
  const most = Math.ceil((1.02 * Math.max(...told.filter(Number.isFinite), 1)) / 50) * 50;
  return section(
    'fits',
    'How well forms tell the energy',
    el(
      'p',
      {},
      'Every form was fitted to driven plans of training fields; below it tells the energy of plans it has not seen. On the dashed line it is right. Printed weights tell no energy by themselves and are scaled by one factor.',
    ),
    el(
      'div',
      { class: 'columns' },
      forms.map((form) => scatter(form, plans, most)),
    ),
    el('h3', {}, 'Held-out plans, in figures'),
    predictionTable(forms),
    el('h3', {}, 'Fitted weights'),
    terms(forms),
    search(forms),
  );
}
