// The drive, moment by moment: the map stays in sight while the charts go by, and both show the
// same moment.
import { el, section, table } from './dom.js';
import { fixed, percent, place, power, clock } from './format.js';
import { histogram } from './histogram.js';
import { momentPanel } from './moment_panel.js';
import { stripChart } from './strip_chart.js';
import { showMoment } from './show_moment.js';
import { trackMap } from './track_map.js';

const peaks = [
  ['Wheel slip, lasting', 'slip', (v) => percent(v)],
  ['Load transfer, lasting', 'load_transfer_ratio', (v) => fixed(v, 2)],
  ['Tracking error at work', 'cross_track_working_m', (v) => `${fixed(v, 3)} m`],
  ['Tracking error in turns', 'cross_track_turning_m', (v) => `${fixed(v, 3)} m`],
  ['Battery power', 'battery_power_w', power],
  ['Lowest voltage', 'min_voltage_v', (v) => `${fixed(v, 1)} V`],
  ['Roll', 'roll_rad', (v) => `${fixed((v * 180) / Math.PI, 1)}°`],
  ['Pitch', 'pitch_rad', (v) => `${fixed((v * 180) / Math.PI, 1)}°`],
];

function peaksTable({ data, moment }) {
  const all = data.metrics?.peaks;
  if (!all) return null;
  const rows = peaks
    .filter(([, key]) => all[key] && Number.isFinite(all[key].value))
    .map(([name, key, text]) => {
      const peak = all[key];
      return [
        name,
        text(peak.value),
        showMoment(moment, peak.time_s, clock(peak.time_s)),
        place([peak.x_m, peak.y_m]),
      ];
    });
  return [
    el('h3', {}, 'Extremes'),
    table(
      'Extremes of the run, at the full rate of the physics',
      [
        { label: 'What' },
        { label: 'Value', number: true },
        { label: 'When', number: true },
        { label: 'Where', number: true },
      ],
      rows,
    ),
  ];
}

export function driveMoments(run) {
  if (run.series.count < 2) {
    return section(
      'moments',
      'The drive, moment by moment',
      el('p', {}, 'There is no time series to show.'),
    );
  }
  const map = trackMap(run);
  const charts = stripChart(run);
  return section(
    'moments',
    'The drive, moment by moment',
    el(
      'p',
      { class: 'lead' },
      'Point at or tap a moment in a chart to see the place, or a place on the map to see the moment. ',
      'Slip and load transfer are those of the moment; the verdict looks at what lasts half a second.',
    ),
    el(
      'div',
      { class: 'moments' },
      el('div', { class: 'moments-map' }, map, momentPanel(run)),
      el('div', { class: 'moments-charts' }, charts),
    ),
    peaksTable(run),
    histogram(run),
  );
}
