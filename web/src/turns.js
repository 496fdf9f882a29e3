// Every turn with what it cost, the dearest first.
import { el, section, table } from './dom.js';
import { distance, duration, energy, power } from './format.js';
import { showMoment } from './show_moment.js';

const kShown = 12;
const columns = [
  { label: 'Turn' },
  { label: 'Begins', number: true },
  { label: 'Energy', number: true },
  { label: 'Time', number: true },
  { label: 'Way', number: true },
  { label: 'Reverses', number: true },
  { label: 'Peak power', number: true },
  { label: 'Ground scuffed', number: true },
];

const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
};

export function turns({ data, moment }) {
  const all = data.movements.filter(({ kind }) => kind === 'turn' || kind === 'U-turn');
  if (!all.length) return null;
  const count = { turn: 0, 'U-turn': 0 };
  const rows = all
    .map((turn) => ({ ...turn, number: ++count[turn.kind] }))
    .sort((a, b) => (b.energy_wh ?? 0) - (a.energy_wh ?? 0))
    .map((turn) => [
      `${turn.kind} ${turn.number}`,
      showMoment(moment, turn.start_time_s, duration(turn.start_time_s)),
      energy(turn.energy_wh),
      duration(turn.duration_s),
      distance(turn.distance_m),
      String(turn.reverses),
      power(turn.peak_power_w),
      `${(turn.scuffed_m2 ?? NaN).toFixed(2)} m²`,
    ]);
  const rest = rows.slice(kShown);
  const energies = all.map(({ energy_wh }) => energy_wh ?? 0);
  return section(
    'turns',
    'Turns and what they cost',
    el(
      'p',
      { class: 'lead' },
      `${all.length} turns took ${energy(energies.reduce((a, b) => a + b, 0))}; `,
      `half of them cost ${energy(median(energies))} or less, the dearest ${energy(Math.max(...energies))}.`,
    ),
    table(
      rest.length ? `The ${kShown} dearest turns` : 'All turns, the dearest first',
      columns,
      rows.slice(0, kShown),
    ),
    rest.length > 0 &&
      el(
        'details',
        { class: 'figures' },
        el('summary', {}, `The other ${rest.length} turns`),
        table('The other turns', columns, rest),
      ),
  );
}
