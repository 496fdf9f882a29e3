// Verdict first: what it is, why, and the figures that people ask for.
import { el } from './dom.js';
import { area, distance, duration, energy, percent } from './format.js';
import { gradeSigns } from './palette.js';
import { showMoment } from './show_moment.js';

const sentences = {
  PASS: 'Every judged figure is within its limits.',
  WARN: 'The run can be done, with care: some figures passed their warning limits.',
  FAIL: 'This run is not to be driven as it is.',
};

export function badge(grade) {
  return el(
    'span',
    { class: `badge ${grade.toLowerCase()}` },
    el('span', { 'aria-hidden': 'true' }, gradeSigns[grade]),
    ` ${grade}`,
  );
}

function subtitle({ data }) {
  const { vehicle, field, scenario } = data;
  const driven = scenario.path_file ? `path ${scenario.path_file}` : `planner ${scenario.planner}`;
  return [
    `${vehicle.name} with ${vehicle.working_width_m} m on ${area(field.area_m2)}`,
    `${field.soil} soil`,
    driven,
    `seed ${scenario.seed}`,
  ].join(' · ');
}

function reasons(run, verdict) {
  if (!verdict.reasons?.length) return null;
  return el(
    'ol',
    { class: 'reasons' },
    verdict.reasons.map((reason) =>
      el(
        'li',
        {},
        badge(reason.grade),
        ' ',
        reason.text,
        reason.time_s != null && showMoment(run.moment, reason.time_s),
      ),
    ),
  );
}

function verdictBox(run) {
  const metrics = run.data.metrics;
  if (!metrics) {
    return el(
      'div',
      { class: 'verdict none' },
      el('p', { class: 'grade' }, 'No verdict'),
      el('p', {}, 'What it rests on is missing in the folder.'),
    );
  }
  const { verdict, outcome } = metrics;
  const ended =
    outcome.name === 'finished'
      ? null
      : `The run ended: ${outcome.name}${outcome.detail ? `, ${outcome.detail}` : ''}.`;
  return el(
    'div',
    { class: `verdict ${verdict.grade.toLowerCase()}` },
    el(
      'p',
      { class: 'grade' },
      el('span', { 'aria-hidden': 'true', class: 'sign' }, gradeSigns[verdict.grade]),
      verdict.grade,
    ),
    el(
      'div',
      {},
      el('p', { class: 'sentence' }, sentences[verdict.grade]),
      ended && el('p', {}, ended),
      reasons(run, verdict),
    ),
  );
}

function keyFigures({ data }) {
  const figures = data.metrics?.figures;
  if (!figures) return null;
  const items = [
    ['Covered', percent(figures.coverage_ratio), `of ${area(figures.workable_m2)} workable`],
    ['Time', duration(figures.time_s), distance(figures.distance_m)],
    [
      'Energy',
      energy(figures.energy_wh),
      figures.energy_wh_per_ha == null ? '' : `${energy(figures.energy_wh_per_ha)} a hectare`,
    ],
    [
      'State of charge',
      percent(data.metrics.run.soc_end, 0),
      `left of ${percent(data.metrics.run.soc_start, 0)}`,
    ],
    ['Overlap', percent(figures.overlap_ratio), area(figures.overlap_m2)],
    ['Turns', `${figures.u_turns + figures.turns}`, `${figures.u_turns} of them U-turns`],
  ];
  return el(
    'dl',
    { class: 'key-figures' },
    items.map(([name, value, note]) =>
      el('div', {}, el('dt', {}, name), el('dd', {}, value), el('dd', { class: 'note' }, note)),
    ),
  );
}

export function missingNote(data) {
  if (!data.missing?.length) return null;
  return el(
    'div',
    { class: 'missing', role: 'note' },
    el('p', {}, el('strong', {}, 'This report is incomplete. ')),
    el(
      'ul',
      {},
      data.missing.map((what) => el('li', {}, what)),
    ),
  );
}

export function header(run) {
  const { data, pictures } = run;
  const closeUps = [...pictures]
    .filter(([name]) => name.startsWith('close_up'))
    .map(([, figure]) => figure);
  return el(
    'header',
    {},
    el('p', { class: 'kicker' }, 'Evaluation of a coverage plan, driven in physics'),
    el('h1', {}, data.scenario.name),
    el('p', { class: 'subtitle' }, subtitle(run)),
    verdictBox(run),
    missingNote(data),
    closeUps.length > 0 && el('div', { class: 'close-ups' }, closeUps),
    keyFigures(run),
  );
}
