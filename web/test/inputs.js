// The folders that the page's tests report on, made by the program itself.
import { execFile } from 'node:child_process';
import { copyFile, mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';

const run = promisify(execFile);
const here = dirname(fileURLToPath(import.meta.url));

// 1 is a run whose verdict is FAIL: a result like any other.
export const headland = (args) =>
  run(process.env.HEADLAND_BINARY ?? '../build/headland', args).catch((fault) => {
    if (fault.code !== 1) throw fault;
  });

const scenario = `name: small field
field:
  boundary: [[0, 0], [46, 0], [46, 30], [0, 30]]
  obstacles:
    - {kind: tree, at: [23, 16], radius_m: 0.3, height_m: 4}
terrain: {generator: rolling, amplitude_m: 0.8, wavelength_m: 40}
vehicle: transplanter
coverage: {cell_m: 0.5}
verdict: {overlap_ratio_max: {warn: 0.001, fail: 0.9}}
`;

const comparison = `name: small comparison
repeats: 2
maps:
  - {name: made up, generator: {columns: 6, rows: 6}, count: 5}
planners:
  - {name: grid_boustrophedon, label: boustrophedon}
  - {name: grid_local_search, label: local search}
stop: {evaluations: 2000}
`;

// Costs are made up (tests/evaluate/made_up_costs.h): measuring them takes minutes.
const tuning = `name: small tuning
vehicle: transplanter
costs: costs.yaml
planner: {name: grid_local_search, stop: {iterations: 3}}
plans: {planners: [grid_boustrophedon, grid_local_search], variations: 6, iterations: 3}
bootstrap: 100
shuffles: 1
simulation: {rate_hz: 60, record_hz: 1}
coverage: {cell_m: 1}
training:
  fields: {square: {grid_map: square.txt}, island: {grid_map: island.txt}}
  terrains: &hill
    hill: {generator: rolling, amplitude_m: 0.5, wavelength_m: 30, cell_m: 1}
held_out:
  fields: {hook: {grid_map: hook.txt}, step: {grid_map: step.txt}}
  terrains: *hill
`;
const maps = {
  square: '....\n....\n....\n',
  island: '.....\n..#..\n.....\n',
  hook: '....\n.#..\n....\n',
  step: '#....\n.....\n.....\n',
};

// A run, a comparison and a tuning below `folder`, with their reports.
export async function makeInputs(folder) {
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, 'small.yaml'), scenario);
  await writeFile(join(folder, 'compare.yaml'), comparison);
  const runFolder = join(folder, 'run');
  const compareFolder = join(folder, 'compare');
  await headland(['evaluate', join(folder, 'small.yaml'), '-o', runFolder, '--quiet']);
  await headland(['compare', join(folder, 'compare.yaml'), '-o', compareFolder, '--quiet']);
  await headland(['report', compareFolder, '--quiet']);
  await writeFile(join(folder, 'tune.yaml'), tuning);
  await copyFile(join(here, 'made_up_costs.yaml'), join(folder, 'costs.yaml'));
  for (const [name, map] of Object.entries(maps)) await writeFile(join(folder, `${name}.txt`), map);
  const tuneFolder = join(folder, 'tune');
  await headland(['tune', join(folder, 'tune.yaml'), '-o', tuneFolder, '--quiet']);
  await headland(['report', tuneFolder, '--quiet']);
  return { runFolder, compareFolder, tuneFolder };
}
