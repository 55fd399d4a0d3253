// What the tests of a page in a browser share: opening it, and what its pictures show.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';
import { after, before } from 'node:test';
import { chromium } from 'playwright-core';

export const address = pathToFileURL(process.env.PAGE).href;
export const alone = pathToFileURL(process.env.MOTION).href;
export const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
export const desktop = { width: 1280, height: 900 };

let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox'] });
});
after(async () => browser?.close());

/// Opens the page and collects its texts, its messages and its requests.
export async function open(options = {}, from = address) {
  const context = await browser.newContext({ viewport: desktop, ...options });
  const page = await context.newPage();
  const heard = [];
  page.on('console', (message) => heard.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => heard.push(`error: ${error}`));
  page.on('request', (request) => {
    if (request.url() !== from && !request.url().startsWith('data:')) heard.push(`request: ${request.url()}`);
  });
  await page.goto(from);
  return { page, heard, close: () => context.close() };
}

/// Gives the page another size, and waits until it is laid out and drawn at that size.
export async function resize(page, width, height) {
  await page.setViewportSize({ width, height });
  await page.waitForFunction((wanted) => innerWidth === wanted, width);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
}

/// Share of the pixels of a picture that are neither white nor as pale as a grid, and the number of its colours. Of a chart,
/// only the area within its axes.
export async function ink(png, part) {
  const page = await browser.newPage();
  const found = await page.evaluate(async ({ source, part }) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const [left, right, top, bottom] = part.map((share, i) => Math.round(share * (i < 2 ? image.width : image.height)));
    const bytes = context.getImageData(left, top, right - left, bottom - top).data;
    const pixels = new Uint32Array(bytes.buffer);
    const dark = pixels.filter((pixel, i) => Math.min(bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2]) < 215);
    return { share: dark.length / pixels.length, colours: new Set(pixels).size };
  }, { source: `data:image/png;base64,${png.toString('base64')}`, part });
  await page.close();
  return found;
}

/// Mean lightness of a screenshot, from 0 (black) to 255.
export async function lightnessOf(locator) {
  const png = await locator.screenshot();
  const page = await browser.newPage();
  const mean = await page.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const bytes = context.getImageData(0, 0, image.width, image.height).data;
    let sum = 0;
    for (let i = 0; i < bytes.length; i += 4) sum += (bytes[i] + bytes[i + 1] + bytes[i + 2]) / 3;
    return sum / (bytes.length / 4);
  }, `data:image/png;base64,${png.toString('base64')}`);
  await page.close();
  return mean;
}

export const whole = [0, 1, 0, 1];
export const within = [0.15, 0.95, 0.03, 0.75];

export async function assertDrawn(locator, what, part = whole) {
  const { share, colours } = await ink(await locator.screenshot(), part);
  assert.ok(share > 0.005 && colours > 8, `${what}: ${share} of it is drawn on, in ${colours} colours`);
}

/// Texts of a column of a table, from top to bottom.
export const column = (table, place) =>
  table.locator('tbody tr').evaluateAll((rows, at) => rows.map((row) => row.cells[at].textContent.trim()), place);

export const axisLabels = (panel) => panel.locator('.dygraph-axis-label-x').allTextContents();
