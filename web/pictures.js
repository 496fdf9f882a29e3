// Pictures of a run's page for the documentation: node pictures.js REPORT.html FOLDER writes
// report.png (its top), report_moments.png and report_replay.png.
import { join } from 'node:path';
import { openPage, withBrowser, withWebGl } from './test/browser.js';

const [report, folder] = process.argv.slice(2);
const kSettled = 1500; // ms until charts, map and scene stand still

await withBrowser(withWebGl, async (browser) => {
  const { page } = await openPage(browser, report, { width: 1280, height: 1240 });
  await page.waitForTimeout(kSettled);
  await page.screenshot({ path: join(folder, 'report.png') });

  const slide = (selector, share) =>
    page.$eval(
      selector,
      (input, at) => {
        input.value = at * Number(input.max);
        input.dispatchEvent(new Event('input'));
      },
      share,
    );
  const moments = await page.$('.moments');
  await moments.scrollIntoViewIfNeeded();
  await page.waitForSelector('.moments-charts canvas');
  await page.selectOption('.map-bar select', 'energy_wh_per_m');
  await page.waitForTimeout(kSettled);
  await slide('.moment-panel input', 0.62);
  await page.waitForTimeout(kSettled);
  // From its top, where the map stands beside the first charts.
  await page.evaluate(() => document.querySelector('#moments').scrollIntoView());
  await page.waitForTimeout(kSettled);
  await page.screenshot({ path: join(folder, 'report_moments.png') });

  await page.click('button.start');
  await page.waitForSelector('canvas.world');
  await page.click('button.play');
  await slide('.replay-controls input', 0.62);
  await page.waitForTimeout(kSettled);
  await (await page.$('canvas.world')).screenshot({ path: join(folder, 'report_replay.png') });
});
