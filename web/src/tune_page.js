// The page of a tuning: what weights are worth that driving has told.
import { el, section } from './dom.js';
import { missingNote } from './header.js';
import { fits } from './tune_fits.js';
import { plans } from './tune_plans.js';
import {
  boustrophedon,
  energySaving,
  isControl,
  ratioText,
  pText,
  savings,
} from './tune_savings.js';

const count = (number, one) => `${number} ${one}${number === 1 ? '' : 's'}`;

function subtitle({ planner, vehicle, seed, held_out: heldOut, held_out_plans: driven }) {
  const places = new Set(driven.map(({ block }) => block)).size;
  return [
    `planner ${planner}`,
    vehicle,
    `proven by ${count(heldOut.runs, 'drive')} at ${count(places, 'place')} it was not tuned on`,
    `seed ${seed}`,
  ]
    .filter(Boolean)
    .join(' · ');
}

function chance({ blocks, p, least_p: least }) {
  if (blocks < 2) return 'One place tells nothing of chance.';
  if (p < 0.05) return `That this is chance is unlikely (p ${pText(p)}).`;
  if (least >= 0.05) return `So few places cannot tell it from chance (p ${pText(p)}).`;
  return `It may be chance (p ${pText(p)}).`;
}

function controlWords(control) {
  if (!control) return null;
  const { fitted, fits, as_good: asGood, p } = control;
  const words = `The control: of ${count(fits, 'fit')} to shuffled energies, ${asGood} ${asGood === 1 ? 'makes' : 'make'} plans as good as those of ${fitted} (p ${pText(p)})`;
  if (p <= 0.05) return `${words}: what fitting found is in the energies.`;
  return `${words}: what fitted weights save cannot be told from chance.`;
}

// The method that saves most over boustrophedon, in one sentence.
function verdict({ methods, control }) {
  const found = methods
    .filter(({ method }) => method !== boustrophedon && !isControl(method))
    .map((figures) => ({ figures, saving: energySaving(figures, boustrophedon) }))
    .filter(({ saving }) => saving?.mean_ratio != null);
  if (!found.length) return null;
  found.sort((a, b) => b.saving.mean_ratio - a.saving.mean_ratio);
  const [{ figures, saving }] = found;
  const spread = saving.ci95_ratio == null ? '' : ` ± ${ratioText(saving.ci95_ratio)}`;
  const sentence =
    saving.mean_ratio > 0
      ? `Plans by ${figures.method} take ${ratioText(saving.mean_ratio)}${spread} less energy than boustrophedon, driven in physics; less at ${saving.wins} of ${count(saving.blocks, 'place')}.`
      : `No plans take less energy than boustrophedon, driven in physics; those by ${figures.method} come nearest (${ratioText(saving.mean_ratio)}${spread}).`;
  return el(
    'div',
    { class: 'verdict plain' },
    el(
      'p',
      { class: 'grade' },
      saving.mean_ratio > 0 ? ratioText(saving.mean_ratio) : 'None saved',
    ),
    el(
      'div',
      {},
      el('p', { class: 'sentence' }, sentence),
      el('p', {}, [chance(saving), controlWords(control)].filter(Boolean).join(' ')),
    ),
  );
}

function leftOut(tune) {
  const sets = [
    ['training', tune.training],
    ['search', tune.search],
    ['held out', tune.held_out],
  ].filter(([, set]) => set?.runs > 0);
  const lines = sets.map(([name, { runs, without_figures: without, why }]) =>
    el(
      'li',
      {},
      `${name}: ${count(runs, 'run')}, ${without} without figures`,
      why?.length > 0 &&
        el(
          'ul',
          {},
          why.map((one) => el('li', {}, one)),
          without > why.length && el('li', {}, `and ${without - why.length} more`),
        ),
    ),
  );
  return section(
    'runs',
    'What was driven and what was left out',
    el(
      'ul',
      {},
      lines,
      (tune.notes ?? []).map((note) => el('li', {}, note)),
    ),
  );
}

function reproduce({ spec, seed, best }, version) {
  return section(
    'reproduce',
    'How to use and to reproduce this',
    best
      ? el(
          'p',
          {},
          `weights.yaml beside this page holds the weights that did best on training fields, ${best}:`,
        )
      : null,
    best &&
      el(
        'pre',
        {},
        el('code', {}, 'headland plan SCENARIO.yaml --weights weights.yaml -o out/planned'),
      ),
    el(
      'p',
      {},
      `headland ${version} made this tuning with seed ${seed}; the same version gives the same numbers:`,
    ),
    el('pre', {}, el('code', {}, `headland tune ${spec?.file ?? 'SPEC.yaml'} -o out/tune`)),
    spec &&
      el(
        'details',
        { class: 'figures' },
        el('summary', {}, `The file ${spec.file}`),
        el('pre', { class: 'scenario' }, el('code', {}, spec.text)),
      ),
    el(
      'p',
      { class: 'note' },
      'This page holds everything it shows and loads nothing. Charts: Apache ECharts; typeface: Inter.',
    ),
  );
}

export function tunePage(data, pictures) {
  const { tune, version } = data;
  return [
    el(
      'header',
      {},
      el('p', { class: 'kicker' }, 'Weights of a planner, tuned to driven energy'),
      el('h1', {}, tune.name || 'Tuning'),
      el('p', { class: 'subtitle' }, subtitle(tune)),
      verdict(tune),
      missingNote(data),
    ),
    savings(tune),
    plans(tune, pictures),
    fits(tune),
    leftOut(tune),
    reproduce(tune, version),
  ];
}
