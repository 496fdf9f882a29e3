// The report's page in a browser. HEADLAND_BINARY is the program; screenshots go to
// HEADLAND_SCREENSHOTS (default: dist/screenshots).
import assert from 'node:assert/strict';
import { cp, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { mkdtemp } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { launch, openPage, withBrowser, withWebGl, withoutWebGl } from './browser.js';
import { headland, makeInputs } from './inputs.js';
import { overflow, paleTexts, pixelsOf, untold } from './looks.js';

const here = dirname(fileURLToPath(import.meta.url));
const shots = process.env.HEADLAND_SCREENSHOTS ?? join(here, '../dist/screenshots');
const kDesktop = { width: 1440, height: 900 };
const kPhone = { width: 390, height: 844 };

let folder;
let inputs;
let shared;
before(async () => {
  folder = await mkdtemp(join(tmpdir(), 'headland-page-'));
  await mkdir(shots, { recursive: true });
  inputs = await makeInputs(folder);
  shared = await launch(withWebGl);
});
after(async () => {
  await shared?.close();
  await rm(folder, { recursive: true, force: true });
});

// Starting a browser takes longer than most tests.
const inBrowser = (use) => use(shared.browser);

// The 3D picture once it has stood still for three looks, which takes as long as frames under way
// do; undefined when it does not.
async function settled(page) {
  const looks = [];
  for (let look = 0; look < 15; look += 1) {
    looks.push(await page.evaluate(pixelsOf, 'canvas.world'));
    if (new Set(looks.slice(-3).map(({ print }) => print)).size === 1 && look > 1)
      return looks.at(-1);
    await page.waitForTimeout(400);
  }
  return undefined;
}

// No complaint in the console, and nothing asked for but the page itself (and what it holds).
function assertQuiet({ complaints, requests }) {
  assert.deepEqual(complaints, []);
  const away = requests
    .slice(1)
    .filter((url) => !url.startsWith('data:') && !url.startsWith('blob:'));
  assert.deepEqual(away, []);
}

async function assertLooks(page) {
  assert.equal(await page.evaluate(overflow), 0, 'wider than the window');
  assert.deepEqual(await page.evaluate(paleTexts), []);
  assert.deepEqual(await page.evaluate(untold), []);
}

// Scrolls through the page so that every chart is made, and back.
async function seeAll(page) {
  for (const part of await page.$$('main > *')) await part.scrollIntoViewIfNeeded();
  await page.waitForFunction(() =>
    [...document.querySelectorAll('.chart')].every((box) => box.firstElementChild),
  );
  await page.evaluate(() => window.scrollTo(0, 0));
}

// Copy of the run's folder, changed, and its report.
async function reportOfChanged(name, change) {
  const changed = join(folder, name);
  await cp(inputs.runFolder, changed, { recursive: true });
  await change(changed);
  await headland(['report', changed, '--quiet']);
  return join(changed, 'report.html');
}

describe('a run', () => {
  const report = () => join(inputs.runFolder, 'report.html');

  test('is quiet, fits and is told in words, wide and narrow', () =>
    inBrowser(async (browser) => {
      for (const [name, size] of [
        ['wide', kDesktop],
        ['narrow', kPhone],
      ]) {
        const opened = await openPage(browser, report(), size);
        await seeAll(opened.page);
        await assertLooks(opened.page);
        await opened.page.screenshot({ path: join(shots, `run_${name}.png`), fullPage: true });
        assertQuiet(opened);
        assert.equal(await opened.page.textContent('.verdict .grade'), '✕FAIL');
        const sections = await opened.page.$$eval('section', (all) => all.map(({ id }) => id));
        assert.deepEqual(sections, [
          'judged',
          'replay',
          'facts',
          'coverage',
          'moments',
          'energy',
          'time',
          'turns',
          'assumptions',
          'reproduce',
        ]);
        await opened.page.close();
      }
    }));

  test('links charts and map both ways', () =>
    inBrowser(async (browser) => {
      const { page } = await openPage(browser, report(), kDesktop);
      await (await page.$('.moments')).scrollIntoViewIfNeeded();
      const strip = await page.waitForSelector('.moments-charts canvas');
      await strip.scrollIntoViewIfNeeded();
      const row = () => page.$eval('.map', (map) => Number(map.dataset.row));
      const time = () => page.textContent('.moment-panel .moment-time');
      const box = await strip.boundingBox();
      const pointAt = (share) => page.mouse.move(box.x + 54 + share * (box.width - 70), box.y + 60);

      await pointAt(0.3);
      await page.waitForFunction(() => Number(document.querySelector('.map').dataset.row) > 0);
      const [early, earlyTime] = [await row(), await time()];
      await pointAt(0.7);
      await page.waitForFunction(
        (before) => Number(document.querySelector('.map').dataset.row) > before,
        early,
      );
      assert.notEqual(await time(), earlyTime);

      // The other way: along the field, which the track fills, the moment changes; the charts' pointer
      // moves with it.
      const before = {
        row: await row(),
        time: await time(),
        strip: await page.evaluate(pixelsOf, '.moments-charts canvas'),
      };
      await (await page.$('.map')).scrollIntoViewIfNeeded();
      const map = await (await page.$('.map')).boundingBox();
      await page.mouse.move(map.x + 0.25 * map.width, map.y + 0.5 * map.height);
      await page.waitForFunction(
        (was) => document.querySelector('.moment-panel .moment-time').textContent !== was,
        before.time,
      );
      assert.notEqual(await row(), before.row);
      await page.waitForTimeout(200);
      assert.notEqual(
        (await page.evaluate(pixelsOf, '.moments-charts canvas')).print,
        before.strip.print,
      );
      // The marker stands within reach of the pointer.
      const marker = await (await page.$('.machine')).boundingBox();
      const away = Math.hypot(
        marker.x + marker.width / 2 - (map.x + 0.25 * map.width),
        marker.y + marker.height / 2 - (map.y + 0.5 * map.height),
      );
      assert.ok(away < 30, `marker ${away} px away`);
    }));

  test('colours the way by every quantity', () =>
    inBrowser(async (browser) => {
      const opened = await openPage(browser, report(), kDesktop);
      const views = await opened.page.$$eval('.map-bar option', (all) =>
        all.map(({ value }) => value),
      );
      assert.equal(views.length, 10);
      const prints = new Set();
      for (const view of views) {
        await opened.page.selectOption('.map-bar select', view);
        await opened.page.waitForTimeout(120);
        prints.add((await opened.page.evaluate(pixelsOf, '.map canvas')).print);
      }
      assert.equal(prints.size, views.length);
      assertQuiet(opened);
    }));

  test('replays in 3D', () =>
    inBrowser(async (browser) => {
      const opened = await openPage(browser, report(), kDesktop);
      const { page } = opened;
      await page.click('button.start');
      await page.waitForSelector('canvas.world');
      await page.waitForTimeout(800);
      const begin = await page.evaluate(pixelsOf, 'canvas.world');
      assert.ok(begin.colours > 200, `${begin.colours} colours`);
      await page.waitForTimeout(800);
      const later = await page.evaluate(pixelsOf, 'canvas.world');
      assert.notEqual(later.print, begin.print, 'playing changes the picture');

      await page.click('button.play');
      const paused = await settled(page);
      assert.ok(paused, 'pausing holds it');

      await page.focus('.replay-controls input');
      await page.keyboard.press('End');
      const atEnd = await settled(page);
      assert.notEqual(atEnd.print, paused.print);
      await (await page.$('#replay')).screenshot({ path: join(shots, 'run_3d_field.png') });
      const box = await (await page.$('canvas.world')).boundingBox();
      await page.mouse.move(box.x + 300, box.y + 200);
      await page.mouse.down();
      await page.mouse.move(box.x + 420, box.y + 230, { steps: 4 });
      await page.mouse.up();
      await page.waitForTimeout(400);
      assert.notEqual(
        (await page.evaluate(pixelsOf, 'canvas.world')).print,
        atEnd.print,
        'dragging turns it',
      );
      await page.selectOption('.replay-choices label:nth-child(2) select', 'machine');
      await page.waitForTimeout(600);
      await (await page.$('#replay')).screenshot({ path: join(shots, 'run_3d_machine.png') });
      assertQuiet(opened);
    }));

  test('shows the picture where there is no WebGL', () =>
    withBrowser(withoutWebGl, async (browser) => {
      const opened = await openPage(browser, report(), kDesktop);
      await opened.page.click('button.start');
      await opened.page.waitForSelector('.stage[data-live=failed]');
      assert.match(
        await opened.page.textContent('#replay .note'),
        /needs WebGL.*picture stands in/,
      );
      assert.ok(await opened.page.isVisible('#replay .stage img'));
      assertQuiet(opened);
    }));

  test('prints', () =>
    inBrowser(async (browser) => {
      const { page } = await openPage(browser, report(), kDesktop);
      const file = join(shots, 'run.pdf');
      await page.pdf({ path: file, format: 'A4', preferCSSPageSize: true, printBackground: true });
      const pages = (await readFile(file, 'latin1')).match(/\/Type\s*\/Page\b/g).length;
      assert.ok(pages >= 5 && pages <= 16, `${pages} pages`);
    }));

  test('says its words without scripts', () =>
    inBrowser(async (browser) => {
      const page = await browser.newPage();
      const html = await readFile(report(), 'utf8');
      await page.setContent(html.replace(/<script[\s\S]*<\/script>/, ''));
      assert.match(await page.textContent('header'), /small field.*Verdict: FAIL/s);
      const alts = await page.$$eval('figure img', (all) => all.map((image) => image.alt));
      const closeUps = alts.filter((alt) => alt.includes('worked until then'));
      assert.equal(alts.length - closeUps.length, 3);
      assert.ok(closeUps.length >= 1 && closeUps.length <= 4, `${closeUps.length} close-ups`);
      assert.ok(alts.every((alt) => alt.length > 10));
    }));
});

describe('what is damaged is told', () => {
  const cases = {
    'a time series cut off': [
      async (changed) => {
        const text = await readFile(join(changed, 'run.csv'), 'utf8');
        await writeFile(join(changed, 'run.csv'), text.slice(0, text.length / 2));
      },
      /The time series ends after/,
    ],
    'a run without length': [
      async (changed) => {
        const text = await readFile(join(changed, 'run.csv'), 'utf8');
        await writeFile(join(changed, 'run.csv'), text.slice(0, text.indexOf('\n') + 1));
      },
      /The time series is missing/,
    ],
    'all but the scenario and the figures gone': [
      async (changed) => {
        for (const name of [
          'run.csv',
          'footprint.csv',
          'segments.csv',
          'path.geojson',
          'field.png',
          'view.png',
          'energy.png',
        ]) {
          await rm(join(changed, name));
        }
      },
      /The planned path is missing.*The picture field.png is missing/s,
    ],
    'no figures': [
      (changed) => writeFile(join(changed, 'metrics.json'), '{"outcome": '),
      /Totals, verdict and figures are missing/,
    ],
  };
  for (const [name, [change, told]] of Object.entries(cases)) {
    test(name, () =>
      inBrowser(async (browser) => {
        const file = await reportOfChanged(name.replaceAll(' ', '_'), change);
        for (const size of [kDesktop, kPhone]) {
          const opened = await openPage(browser, file, size);
          await seeAll(opened.page);
          assert.match(await opened.page.textContent('.missing'), told);
          await assertLooks(opened.page);
          assertQuiet(opened);
          await opened.page.close();
        }
      }),
    );
  }
});

const sets = {
  compare: ['ranks', 'figures', 'plans', 'convergence', 'reproduce'],
  tune: ['savings', 'plans', 'fits', 'runs', 'reproduce'],
};
for (const [kind, sections] of Object.entries(sets)) {
  test(`${kind}'s page is quiet, fits and is told in words`, () =>
    inBrowser(async (browser) => {
      for (const [name, size] of [
        ['wide', kDesktop],
        ['narrow', kPhone],
      ]) {
        const opened = await openPage(browser, join(inputs[`${kind}Folder`], 'report.html'), size);
        await seeAll(opened.page);
        await opened.page.screenshot({ path: join(shots, `${kind}_${name}.png`), fullPage: true });
        // What is folded up must fit as well.
        await opened.page.$$eval('details', (all) => all.forEach((one) => (one.open = true)));
        await assertLooks(opened.page);
        assertQuiet(opened);
        const ids = await opened.page.$$eval('section', (all) => all.map(({ id }) => id));
        assert.deepEqual(ids, sections);
        await opened.page.close();
      }
    }));
}

test('a tuning says what tune.json says', () =>
  inBrowser(async (browser) => {
    const tune = JSON.parse(await readFile(join(inputs.tuneFolder, 'tune.json'), 'utf8'));
    const { page } = await openPage(browser, join(inputs.tuneFolder, 'report.html'), kDesktop);
    // The method named first is the one that saves most over boustrophedon.
    const saved = tune.methods
      .filter(({ method }) => method !== 'boustrophedon' && method !== 'shuffled')
      .map(({ method, saves_over: over }) => [over.boustrophedon[0].mean_ratio, method])
      .sort((a, b) => b[0] - a[0]);
    assert.ok((await page.textContent('.verdict .sentence')).includes(saved[0][1]));
    // A bar with its interval for each method but the reference, and all figures in a table.
    const rows = await page.$$eval('#savings table', (all) =>
      all.map((one) => one.rows.length - 1),
    );
    assert.equal(rows[0], tune.methods.length - 1);
    const label = await page.getAttribute('#savings .chart', 'aria-label');
    for (const [, method] of saved) assert.ok(label.includes(method), method);
    // Every plan of every place is in a table.
    const places = new Set(tune.held_out_plans.map(({ block }) => block));
    const told = await page.$$eval('#plans .map-figures', (all) =>
      all.map((one) => one.querySelectorAll('tbody tr').length),
    );
    assert.equal(told.length, places.size);
    assert.equal(
      told.reduce((a, b) => a + b, 0),
      tune.held_out_plans.length,
    );
    assert.equal(await page.$$eval('figure img', (all) => all.length), 2);
    assert.match(await page.textContent('#reproduce'), /tune\.yaml.*small tuning/s);
  }));
