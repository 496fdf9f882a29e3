// Debian's Chromium without a display, as the page's tests and pictures use it.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const flags = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--hide-scrollbars',
  '--force-color-profile=srgb',
];
export const withWebGl = [
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];
export const withoutWebGl = ['--disable-gpu', '--disable-3d-apis'];

// A browser in a profile of its own, and how to end both.
export async function launch(gl) {
  const profile = await mkdtemp(join(tmpdir(), 'headland-chromium-'));
  const browser = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    args: [...flags, ...gl],
    viewport: { width: 1440, height: 900 },
  });
  const close = async () => {
    await browser.close();
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  return { browser, close };
}

export async function withBrowser(gl, use) {
  const { browser, close } = await launch(gl);
  try {
    return await use(browser);
  } finally {
    await close();
  }
}

// Opens a file and notes whatever it says or asks for; resolves when the page has made itself.
export async function openPage(browser, file, size = { width: 1440, height: 900 }) {
  const page = await browser.newPage();
  await page.setViewportSize(size);
  const complaints = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (fault) => complaints.push(String(fault)));
  page.on('request', (request) => requests.push(request.url()));
  const begin = Date.now();
  await page.goto(pathToFileURL(file).href, { waitUntil: 'load' });
  await page.waitForSelector('html[data-ready]', { timeout: 60000 });
  return { page, complaints, requests, seconds: (Date.now() - begin) / 1000 };
}
