// The run replayed over the terrain. 3D begins when it is asked for; until then, and without WebGL,
// the picture stands in.
import { el, section } from './dom.js';
import { clock } from './format.js';
import { momentSlider } from './moment_panel.js';
import { createWorld } from './world.js';

const speeds = [1, 5, 20, 60];

// Runs the moment on by the screen's clock.
function createPlayer(moment) {
  const player = { playing: false, speed: 20, changed: () => {} };
  let last = 0;
  const step = (now) => {
    if (!player.playing) return;
    const next = (moment.time ?? 0) + ((now - last) / 1000) * player.speed;
    last = now;
    moment.set(next, 'player');
    if (next >= moment.end) player.pause();
    else requestAnimationFrame(step);
  };
  player.play = () => {
    if (moment.time == null || moment.time >= moment.end) moment.set(0, 'player');
    player.playing = true;
    last = performance.now();
    requestAnimationFrame(step);
    player.changed();
  };
  player.pause = () => {
    player.playing = false;
    player.changed();
  };
  return player;
}

const choose = (label, options, value, onchange) => {
  const select = el(
    'select',
    { onchange: () => onchange(select.value) },
    options.map(([key, text]) =>
      el('option', { value: key, selected: String(key) === String(value) }, text),
    ),
  );
  return el('label', {}, `${label} `, select);
};

function controls(run, world, player) {
  const { moment } = run;
  const heights = choose(
    'Heights',
    [1, 2, 3, 5].map((factor) => [factor, `${factor}×`]),
    world.heights,
    (value) => world.stretch(Number(value)),
  );
  // From near, the machine stands on the ground as it is.
  const look = (what) => {
    const factor = what === 'machine' ? 1 : world.usual;
    heights.querySelector('select').value = factor;
    world.stretch(factor);
    world.look(what);
  };
  const time = el('output', { class: 'moment-time' }, clock(moment.time ?? 0));
  moment.watch((now) => {
    time.textContent = clock(now);
  });
  const play = el(
    'button',
    {
      type: 'button',
      class: 'play',
      onclick: () => (player.playing ? player.pause() : player.play()),
    },
    'Play',
  );
  player.changed = () => {
    play.textContent = player.playing ? 'Pause' : 'Play';
  };
  return el(
    'div',
    { class: 'replay-controls' },
    el('div', { class: 'moment-bar' }, play, time, momentSlider(moment, 'replay')),
    el(
      'div',
      { class: 'replay-choices' },
      choose(
        'Speed',
        speeds.map((speed) => [speed, `${speed}×`]),
        player.speed,
        (value) => {
          player.speed = Number(value);
        },
      ),
      choose(
        'View',
        [
          ['field', 'whole field'],
          ['machine', 'follow the machine'],
        ],
        'field',
        look,
      ),
      heights,
    ),
  );
}

export function replay(run) {
  const { series, pictures } = run;
  const poster = pictures.get('view.png');
  if (series.count < 2) return poster ? section('replay', 'The run', poster) : null;
  const stage = el('div', { class: 'stage' });
  const note = el('p', { class: 'note' });
  const start = el(
    'button',
    { type: 'button', class: 'start' },
    el('span', { 'aria-hidden': 'true' }, '▶ '),
    'Replay in 3D',
  );

  start.addEventListener('click', async () => {
    start.disabled = true;
    const canvas = el('canvas', {
      class: 'world',
      role: 'img',
      'aria-label': 'The run replayed in 3D over the terrain: drag to turn, wheel or pinch to zoom',
    });
    try {
      const world = await createWorld(canvas, run);
      const player = createPlayer(run.moment);
      stage.replaceChildren(canvas, controls(run, world, player));
      stage.dataset.live = 'true';
      world.begin();
      note.textContent =
        'Drag to turn, drag with the right button or two fingers to move, wheel or pinch to zoom.';
      player.play();
    } catch (fault) {
      start.remove();
      stage.dataset.live = 'failed';
      note.textContent = `3D needs WebGL, which this browser does not give (${fault.message})${poster ? '; the picture stands in' : ''}.`;
    }
  });
  stage.append(...[poster, start].filter(Boolean));
  if (!poster) stage.classList.add('bare');
  const still = poster?.cloneNode(true);
  still?.classList.add('print-only');
  return section('replay', 'The run, replayed', stage, still, note);
}
