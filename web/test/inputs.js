// The folders that the page's tests report on, made by the program itself.
import { execFile } from 'node:child_process';
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';

const run = promisify(execFile);

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

// A run and a comparison below `folder`, with their reports.
export async function makeInputs(folder) {
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, 'small.yaml'), scenario);
  await writeFile(join(folder, 'compare.yaml'), comparison);
  const runFolder = join(folder, 'run');
  const compareFolder = join(folder, 'compare');
  await headland(['evaluate', join(folder, 'small.yaml'), '-o', runFolder, '--quiet']);
  await headland(['compare', join(folder, 'compare.yaml'), '-o', compareFolder, '--quiet']);
  await headland(['report', compareFolder, '--quiet']);
  return { runFolder, compareFolder };
}
