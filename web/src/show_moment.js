// A button that takes the whole page to a moment and scrolls to the map.
import { el } from './dom.js';
import { clock } from './format.js';

export function showMoment(moment, time, label = `at ${clock(time)}`) {
  return el(
    'button',
    {
      class: 'link',
      type: 'button',
      title: 'Show on the map and in the charts',
      onclick: () => {
        moment.set(time, 'link');
        document.getElementById('moments')?.scrollIntoView({ behavior: 'smooth' });
      },
    },
    label,
  );
}
