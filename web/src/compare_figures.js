// Every figure of every planner, map by map.
import { el, section, table } from './dom.js';
import { fixed, percent, short } from './format.js';
import { placeOf, placesOf } from './places.js';

const names = {
  cost: 'Cost',
  gap: 'Gap',
  coverage_rate: 'Coverage',
  repeat_rate: 'Repeated',
  length_steps: 'Steps',
  turns: 'Turns',
  u_turns: 'U-turns',
  evaluations: 'Evaluations',
  seconds: 'Seconds',
  driven_energy_wh: 'Driven, Wh',
  driven_time_s: 'Driven, s',
  driven_coverage_ratio: 'Driven coverage',
};
const ratios = ['coverage_rate', 'repeat_rate', 'driven_coverage_ratio', 'gap'];

const title = (place) =>
  place.parts
    ? `${place.name}: ${(place.area_m2 / 1e4).toFixed(2)} ha in ${place.parts.length} parts`
    : `${place.name}: ${place.columns} × ${place.rows} cells, ${place.free_cells} free`;

function cell(key, figure) {
  if (!figure || figure.mean == null) return '–';
  if (key === 'seconds') return fixed(figure.mean, 3);
  const text = ratios.includes(key) ? (value) => percent(value) : short;
  const spread = figure.standard_deviation;
  const mean = text(figure.mean);
  return spread > 0 && !ratios.includes(key) ? `${mean} ± ${short(spread)}` : mean;
}

function state({ runs }) {
  const notes = [];
  if (runs.refused) notes.push(`${runs.refused} refused`);
  if (runs.not_run) notes.push(`${runs.not_run} not run`);
  if (runs.with_jumps) notes.push(`${runs.with_jumps} with jumps`);
  return `${runs.planned} of ${runs.asked}${notes.length ? ` (${notes.join(', ')})` : ''}`;
}

export function compareFigures({ comparison, results }) {
  const keys = Object.keys(names).filter((key) =>
    results.some(({ figures }) => figures?.[key]?.mean != null),
  );
  const columns = [
    { label: 'Planner' },
    { label: 'Planned', number: true },
    ...keys.map((key) => ({ label: names[key], number: true })),
  ];
  const places = placesOf(comparison).map((place, i) => {
    const rows = results
      .filter((result) => placeOf(result) === place.name)
      .map((result) => [
        result.planner,
        state(result),
        ...keys.map((key) => cell(key, result.figures?.[key])),
      ]);
    return el(
      'details',
      { class: 'figures map-figures', open: i === 0 },
      el('summary', {}, title(place)),
      table(`Figures on ${place.name}`, columns, rows),
    );
  });
  return section(
    'figures',
    comparison.fields ? 'Figures, field by field' : 'Figures, map by map',
    el('p', {}, 'Means over the runs, ± their standard deviation.'),
    places,
  );
}
