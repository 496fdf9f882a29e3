// The page of a comparison: who is better, by how much, and whether that is chance.
import { el, section } from './dom.js';
import { compareFigures } from './compare_figures.js';
import { convergence } from './convergence.js';
import { missingNote } from './header.js';
import { placesOf, placeWord } from './places.js';
import { ranks } from './ranks.js';

const budgets = { evaluations: 'equal evaluations for all', seconds: 'equal seconds for all' };

function subtitle({ comparison }) {
  const { planners, repeats, seed, equal_budget: budget, cost } = comparison;
  const places = placesOf(comparison).length;
  return [
    `${planners.length} planners on ${places} ${placeWord(comparison, places)}`,
    `${repeats} runs each`,
    budgets[budget] ?? 'each planner with an end of its own',
    `cost: ${cost?.objective ?? 'length'}`,
    `seed ${seed}`,
  ].join(' · ');
}

// The planner with the least average rank, in one sentence.
function verdict({ ranks: found }) {
  const averages = Object.entries(found?.average_rank ?? {}).filter(([, rank]) => rank != null);
  if (averages.length < 2) return null;
  averages.sort((a, b) => a[1] - b[1]);
  const [best, second] = averages;
  const p = found.friedman?.iman_davenport_p;
  const chance =
    p == null
      ? 'There are too few blocks to tell that from chance.'
      : p < found.alpha
        ? `That the planners do not differ at all is unlikely (p ${p < 0.001 ? 'below 0.001' : p.toFixed(3)}).`
        : `The differences may be chance (p ${p.toFixed(3)}).`;
  return el(
    'div',
    { class: 'verdict plain' },
    el('p', { class: 'grade' }, best[0]),
    el(
      'div',
      {},
      el(
        'p',
        { class: 'sentence' },
        `ranks best by ${found.figure}: ${best[1].toFixed(2)} on average, before ${second[0]} with ${second[1].toFixed(2)}.`,
      ),
      el('p', {}, chance),
    ),
  );
}

function reproduce({ comparison }, version) {
  return section(
    'reproduce',
    'How to reproduce this',
    el(
      'p',
      {},
      `headland ${version} made this comparison with seed ${comparison.seed}, from the file ${comparison.name} was read from:`,
    ),
    el('pre', {}, el('code', {}, `headland compare SPEC.yaml --seed ${comparison.seed} -o DIR`)),
    el(
      'p',
      { class: 'note' },
      'This page holds everything it shows and loads nothing. Charts: Apache ECharts; typeface: Inter.',
    ),
  );
}

export function comparePage(data, pictures) {
  const { compare, version } = data;
  return [
    el(
      'header',
      {},
      el('p', { class: 'kicker' }, 'Comparison of coverage planners'),
      el('h1', {}, compare.comparison.name ?? 'Comparison'),
      el('p', { class: 'subtitle' }, subtitle(compare)),
      verdict(compare),
      missingNote(data),
    ),
    ranks(compare),
    compareFigures(compare),
    pictures.size > 0 && section('plans', 'Best plans', [...pictures.values()]),
    convergence(compare),
    reproduce(compare, version),
  ];
}
