// What the page of a long run costs: `node bench/report_bench.js [--json] [DIR...]`. Without folders
// it drives a run of more than 10 h first (a battery that lasts so long, a field of 5.7 ha); with them it
// takes the runs in there. HEADLAND_BINARY is the program (default: ../build/headland).
import { execFile } from 'node:child_process';
import { cp, mkdtemp, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { openPage, withBrowser, withWebGl } from '../test/browser.js';

const here = dirname(fileURLToPath(import.meta.url));
const headland = process.env.HEADLAND_BINARY ?? join(here, '../../build/headland');
const run = promisify(execFile);

async function driveTenHours(folder) {
  const vehicle = join(folder, 'lasting_transplanter');
  await cp(join(here, '../../vehicle_models/transplanter'), vehicle, { recursive: true });
  const drive = join(vehicle, 'drive.yaml');
  const text = await readFile(drive, 'utf8');
  await writeFile(drive, text.replace(/capacity_ah: \{value: 150/, 'capacity_ah: {value: 1500'));
  const scenario = join(folder, 'ten_hours.yaml');
  await writeFile(
    scenario,
    `field: {boundary: [[0, 0], [280, 0], [280, 202], [0, 202]]}
terrain: {generator: rolling, micro_relief: {rms_m: 0.015, correlation_m: 1.5}}
vehicle: ${vehicle}
`,
  );
  const out = join(folder, 'ten_hours');
  await run(headland, ['evaluate', scenario, '-o', out, '--quiet']).catch((fault) => {
    if (fault.code !== 1) throw fault;
  });
  return out;
}

async function measure(folder, browser) {
  const metrics = JSON.parse(await readFile(join(folder, 'metrics.json'), 'utf8'));
  const rows = (await readFile(join(folder, 'run.csv'), 'latin1')).split('\n').length - 2;
  const page = join(await mkdtemp(join(tmpdir(), 'headland-page-')), 'report.html');
  const begin = performance.now();
  await run(headland, ['report', folder, '-o', page, '--quiet']);
  const report_s = (performance.now() - begin) / 1000;
  const opened = await openPage(browser, page);
  const bytes = (await stat(page)).size;
  await rm(dirname(page), { recursive: true });
  return {
    folder,
    driven_h: metrics.run.duration_s / 3600,
    rows,
    report_s,
    page_mb: bytes / 1e6,
    open_s: opened.seconds,
  };
}

const args = process.argv.slice(2);
const scratch = await mkdtemp(join(tmpdir(), 'headland-bench-'));
try {
  const given = args.filter((arg) => arg !== '--json');
  const folders = given.length ? given : [await driveTenHours(scratch)];
  const figures = await withBrowser(withWebGl, async (browser) => {
    await (await browser.newPage()).goto('about:blank'); // starts the browser's parts
    const all = [];
    for (const folder of folders) all.push(await measure(folder, browser));
    return all;
  });
  if (args.includes('--json')) {
    console.log(JSON.stringify(figures, null, 1));
  } else {
    console.log('   driven      rows    report      page     opens');
    for (const { driven_h, rows, report_s, page_mb, open_s } of figures) {
      console.log(
        `${driven_h.toFixed(1).padStart(7)} h ${String(rows).padStart(9)} ${report_s.toFixed(2).padStart(7)} s ` +
          `${page_mb.toFixed(1).padStart(6)} MB ${open_s.toFixed(2).padStart(7)} s`,
      );
    }
  }
} finally {
  await rm(scratch, { recursive: true, force: true });
}
