// What the run rests on that nobody measured, and what the physics leaves out.
/* global NOT_MODELLED */
import { el, section, table } from './dom.js';

export function assumptions({ data }) {
  const { vehicle, metrics } = data;
  const notes = metrics?.notes ?? [];
  return section(
    'assumptions',
    'Assumed, and not modelled',
    notes.length > 0 && [
      el('h3', {}, 'Of this run'),
      el(
        'ul',
        {},
        notes.map((note) => el('li', {}, note)),
      ),
    ],
    el('h3', {}, 'Not modelled'),
    el('p', {}, NOT_MODELLED),
    data.assumptions.length > 0 && [
      el('h3', {}, 'Assumed of the vehicle'),
      el(
        'p',
        {},
        `${data.assumptions.length} numbers of ${vehicle.name} are assumptions of those who described it, not measurements.`,
      ),
      el(
        'details',
        { class: 'figures' },
        el('summary', {}, 'All of them, and why'),
        table(
          'Assumed numbers',
          [{ label: 'Key' }, { label: 'Value', number: true }, { label: 'Why' }],
          data.assumptions.map(({ key, value, why }) => [key, value, why]),
        ),
      ),
    ],
  );
}
