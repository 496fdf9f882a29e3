// What the machine does at the moment, and a slider through the run.
import { rowAt, worst } from './data.js';
import { el } from './dom.js';
import { clock, fixed, percent, power } from './format.js';

const fields = [
  [
    'Movement',
    ({ data, series }, i) => data.segment_kinds[Math.round(series.poses.segment[i])] ?? '–',
  ],
  ['Speed', ({ series }, i) => `${fixed(series.envelopes.speed_mps.low[i], 2)} m/s`],
  ['Power', ({ series }, i) => power(worst(series.envelopes.battery_power_w, i))],
  ['Charge', ({ series }, i) => percent(series.envelopes.soc.low[i], 1)],
  ['Slip', ({ series }, i) => percent(worst(series.envelopes.slip, i))],
  ['Load transfer', ({ series }, i) => fixed(worst(series.envelopes.load_transfer_ratio, i), 2)],
  [
    'Off the path',
    ({ series }, i) => `${fixed(100 * worst(series.envelopes.cross_track_error_m, i), 1)} cm`,
  ],
  [
    'Place',
    ({ series }, i) => `${fixed(series.poses.x_m[i], 1)}, ${fixed(series.poses.y_m[i], 1)} m`,
  ],
];

export function momentSlider(moment, source) {
  const input = el('input', {
    type: 'range',
    min: 0,
    max: moment.end,
    step: 'any',
    value: 0,
    'aria-label': 'Moment of the run',
    oninput: () => moment.set(Number(input.value), source),
  });
  const text = () => input.setAttribute('aria-valuetext', clock(Number(input.value)));
  moment.watch((time) => {
    if (Number(input.value) !== time) input.value = time;
    text();
  });
  text();
  return input;
}

export function momentPanel(run) {
  const { moment, series } = run;
  const time = el('output', { class: 'moment-time' }, clock(0));
  const values = fields.map(() => el('dd', {}, '–'));
  const update = (now) => {
    const i = rowAt(series.poses.time_s, now);
    time.textContent = clock(now);
    fields.forEach(([, text], k) => {
      values[k].textContent = text(run, i);
    });
  };
  moment.watch(update);
  update(0);
  return el(
    'div',
    { class: 'moment-panel' },
    el('div', { class: 'moment-bar' }, time, momentSlider(moment, 'panel')),
    el(
      'dl',
      {},
      fields.map(([name], k) => el('div', {}, el('dt', {}, name), values[k])),
    ),
  );
}
