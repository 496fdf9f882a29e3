// The time series, one strip above the other on one axis: power to tracking error, with the limits
// of the verdict.
import { axis, chart, textStyle } from './charts.js';
import { rowAt } from './data.js';
import { el } from './dom.js';
import { clock, tick } from './format.js';
import { grades, ink, rule, softInk } from './palette.js';

const kTop = 30;
const kStrip = 74; // px, and kGap above each for its name
const kGap = 42;
const kBottom = 78;

function strips({ data }) {
  const { limits } = data;
  const both = ([warn, fail]) => [
    { value: warn, grade: 'WARN' },
    { value: fail, grade: 'FAIL' },
    { value: -warn, grade: 'WARN' },
    { value: -fail, grade: 'FAIL' },
  ];
  const upper = ([warn, fail]) => both([warn, fail]).slice(0, 2);
  return [
    { name: 'Power from the battery', unit: 'W', column: 'battery_power_w', color: '#332288' },
    { name: 'Speed', unit: 'm/s', column: 'speed_mps', color: '#1b7a5a' },
    {
      name: 'State of charge',
      unit: '%',
      column: 'soc',
      factor: 100,
      color: '#7a5c00',
      limits: upper(limits.reserve_soc).map((l) => ({ ...l, value: 100 * l.value })),
    },
    { name: 'Battery voltage', unit: 'V', column: 'battery_voltage_v', color: '#882255' },
    { name: 'Elevation', unit: 'm', column: 'ground_m', color: '#6d5a3c', area: true },
    {
      name: 'Wheel slip',
      unit: '%',
      column: 'slip',
      factor: 100,
      color: '#a03a55',
      limits: upper(limits.slip).map((l) => ({ ...l, value: 100 * l.value })),
    },
    {
      name: 'Load transfer, + left',
      unit: '',
      column: 'load_transfer_ratio',
      color: '#0f6a86',
      limits: both(limits.load_transfer),
    },
    {
      name: 'Tracking error, + left',
      unit: 'cm',
      column: 'cross_track_error_m',
      factor: 100,
      color: '#2c5d2f',
      limits: both(limits.track_error_m).map((l) => ({ ...l, value: 100 * l.value })),
    },
  ];
}

// Both extremes of every bucket as x, y, x, y, ...; the least and the most of all beside them.
function points({ low, high }, x, factor) {
  const flat = low === high;
  const line = new Float64Array((flat ? 2 : 4) * x.length);
  let least = Infinity;
  let most = -Infinity;
  for (let i = 0, k = 0; i < x.length; ++i) {
    least = Math.min(least, Number.isNaN(low[i]) ? Infinity : low[i] * factor);
    most = Math.max(most, Number.isNaN(high[i]) ? -Infinity : high[i] * factor);
    line[k++] = x[i];
    line[k++] = low[i] * factor;
    if (flat) continue;
    line[k++] = 0.5 * (x[i] + (x[i + 1] ?? x[i]));
    line[k++] = high[i] * factor;
  }
  return { line, least, most };
}

// Limits that lie far from anything driven are named and not drawn: they would flatten the line.
const isNear = (value, { least, most }) => {
  const span = Math.max(most - least, 1e-9);
  return value > least - span && value < most + span;
};

function limitLine(strip, extent) {
  const near = (strip.limits ?? []).filter(({ value }) => isNear(value, extent));
  return {
    silent: true,
    symbol: 'none',
    animation: false,
    data: near.map(({ value, grade }) => ({
      yAxis: value,
      lineStyle: { color: grades[grade], type: grade === 'FAIL' ? 'solid' : 'dashed', width: 1 },
      label: {
        show: true,
        position: grade === 'FAIL' ? 'insideEndTop' : 'insideStartTop',
        formatter: `${grade === 'FAIL' ? 'fails' : 'warns'} at ${tick(value)}`,
        fontSize: 11,
        color: grades[grade],
        distance: 2,
      },
    })),
  };
}

function nameOf(strip, extent) {
  const far = (strip.limits ?? []).filter(({ value }) => value > 0 && !isNear(value, extent));
  const limits = far
    .map(({ value, grade }) => `${grade === 'FAIL' ? 'fails' : 'warns'} at ${tick(value)}`)
    .join(', ');
  return `{name|${strip.name}}${strip.unit ? `{unit| ${strip.unit}}` : ''}${limits ? `{unit|   ${limits}}` : ''}`;
}

function options(all, drawn, byTime) {
  const grids = all.map((_, k) => ({
    left: 54,
    right: 16,
    top: kTop + k * (kStrip + kGap),
    height: kStrip,
  }));
  const axisText = byTime
    ? (ms) => clock(ms / 1000)
    : (m) => (m >= 1000 ? `${(m / 1000).toFixed(m % 1000 ? 1 : 0)} km` : `${m} m`);
  const limited = (k) => {
    const near = (all[k].limits ?? [])
      .map(({ value }) => value)
      .filter((value) => isNear(value, drawn[k]));
    return { min: Math.min(drawn[k].least, ...near), max: Math.max(drawn[k].most, ...near) };
  };
  return {
    aria: { enabled: false },
    axisPointer: {
      link: [{ xAxisIndex: 'all' }],
      lineStyle: { color: ink, width: 1, type: 'solid' },
      label: { show: false },
    },
    useUTC: true, // times are counted from 0, as a clock would from midnight
    tooltip: { trigger: 'axis', showContent: false },
    title: all.map((strip, k) => ({
      text: nameOf(strip, drawn[k]),
      left: 0,
      top: kTop + k * (kStrip + kGap) - 24,
      padding: 0,
      textStyle: {
        ...textStyle,
        rich: {
          name: { fontSize: 13, fontWeight: 600, color: ink },
          unit: { fontSize: 12, color: softInk },
        },
      },
    })),
    grid: grids,
    xAxis: all.map((_, k) => ({
      gridIndex: k,
      type: byTime ? 'time' : 'value',
      min: 'dataMin',
      max: 'dataMax',
      ...axis,
      axisLine: { ...axis.axisLine, onZero: false },
      axisLabel: {
        ...textStyle,
        show: k === all.length - 1,
        formatter: axisText,
        hideOverlap: true,
        showMaxLabel: false,
      },
      splitLine: { show: false },
    })),
    yAxis: all.map((_, k) => {
      const { min, max } = limited(k);
      const pad = 0.06 * Math.max(max - min, 1e-6);
      return {
        gridIndex: k,
        type: 'value',
        min: min - pad,
        max: max + pad,
        splitNumber: 3,
        ...axis,
        axisLabel: { ...textStyle, formatter: tick, showMinLabel: false, showMaxLabel: false },
      };
    }),
    dataZoom: [
      {
        type: 'slider',
        xAxisIndex: all.map((_, k) => k),
        bottom: 10,
        left: 54,
        right: 16,
        height: 26,
        borderColor: rule,
        fillerColor: 'rgba(28,56,120,0.10)',
        handleStyle: { color: softInk },
        labelFormatter: axisText,
        textStyle,
        showDataShadow: false,
        brushSelect: false,
      },
    ],
    series: all.map((strip, k) => ({
      type: 'line',
      xAxisIndex: k,
      yAxisIndex: k,
      name: strip.name,
      dimensions: ['x', 'y'],
      data: drawn[k].line,
      showSymbol: false,
      sampling: 'minmax',
      lineStyle: { width: 1.2, color: strip.color },
      itemStyle: { color: strip.color },
      areaStyle: strip.area ? { color: strip.color, opacity: 0.12, origin: 'start' } : undefined,
      markLine: limitLine(strip, drawn[k]),
    })),
  };
}

export function stripChart(run) {
  const { series, moment } = run;
  const all = strips(run).filter(({ column }) => series.envelopes[column]);
  const x = { time: series.poses.time_s, way: series.poses.travel_m };
  const milliseconds = Float64Array.from(x.time, (time) => 1000 * time);
  let by = 'time';
  const draw = () =>
    options(
      all,
      all.map((strip) =>
        points(
          series.envelopes[strip.column],
          by === 'time' ? milliseconds : x.way,
          strip.factor ?? 1,
        ),
      ),
      by === 'time',
    );
  const names = all.map(({ name }) => name.toLowerCase()).join('; ');
  const strip = chart(
    `Over time: ${names}. Their extremes stand in the table below.`,
    kTop + all.length * (kStrip + kGap) + kBottom - kGap,
    draw,
    { renderer: 'canvas' },
  );

  strip.ready((instance) => {
    instance.on('updateAxisPointer', ({ axesInfo }) => {
      if (telling || !axesInfo?.length) return;
      const value = axesInfo[0].value;
      moment.set(by === 'time' ? value / 1000 : x.time[rowAt(x.way, value)], 'charts');
    });
  });
  // ECharts reports what it is told, too.
  let telling = false;
  moment.watch((time, source) => {
    if (source === 'charts' || !strip.instance) return;
    const value = by === 'time' ? 1000 * time : x.way[rowAt(x.time, time)];
    telling = true;
    strip.instance.dispatchAction({
      type: 'showTip',
      x: strip.instance.convertToPixel({ xAxisIndex: 0 }, value),
      y: kTop + 4,
    });
    telling = false;
  });

  const choice = (value, label) =>
    el(
      'label',
      {},
      el('input', {
        type: 'radio',
        name: 'strip-axis',
        value,
        checked: value === by,
        onchange: () => {
          by = value;
          strip.redraw();
        },
      }),
      label,
    );
  return [
    el(
      'fieldset',
      { class: 'choice' },
      el('legend', {}, 'Over'),
      choice('time', 'time'),
      choice('way', 'distance'),
    ),
    strip.box,
  ];
}
