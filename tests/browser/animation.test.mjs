// The page of one trajectory, in a browser.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { address, alone, axe, open, resize, assertDrawn } from './browser.mjs';

/// Opens the page at its animation. `reduced`: the reader asks for less motion.
async function openMotion(reduced, from = address) {
  const opened = await open({ reducedMotion: reduced ? 'reduce' : 'no-preference' }, from);
  const { page } = opened;
  const stage = page.locator('.stage');
  await stage.scrollIntoViewIfNeeded();
  await stage.evaluate((element) => element.scrollIntoView({ block: 'center' }));
  const time = page.locator('.controls input[type=range]');
  return { ...opened, stage, time, at: async () => Number(await time.inputValue()),
    button: page.locator('.controls button') };
}

/// Whether two pictures of the same place differ.
const differ = async (locator, act) => {
  const before = await locator.screenshot();
  await act();
  return !before.equals(await locator.screenshot());
};

describe('the animation', () => {
  it('starts by itself, advances, pauses, and goes on where it was', async () => {
    const { page, heard, at, button, close } = await openMotion(false);
    await page.waitForFunction(() => Number(document.querySelector('.controls input').value) > 3);
    assert.equal(await button.textContent(), 'Pause');
    await button.click();
    const paused = await at();
    await page.waitForTimeout(200);
    assert.equal(await at(), paused);
    await button.click();
    await page.waitForFunction((from) => Number(document.querySelector('.controls input').value) > from, paused);
    assert.deepEqual(heard, []);
    await close();
  });

  it('moves nothing by itself for a reader who asks for less motion, but plays if it is told to', async () => {
    const { page, stage, at, button, close } = await openMotion(true);
    assert.equal(await differ(stage, () => page.waitForTimeout(500)), false);
    assert.equal(await at(), 0);
    await button.click();
    await page.waitForFunction(() => Number(document.querySelector('.controls input').value) > 0);
    await close();
  });

  it('is moved by its slider and by keys, and reads its values', async () => {
    const { page, stage, time, at, button, close } = await openMotion(true);
    const last = Number(await time.getAttribute('max'));
    assert.ok(last > 100);
    assert.ok(await differ(stage, () => time.fill(String(Math.round(last / 3)))));
    assert.match(await page.locator('.motions .readout').textContent(), /period [0-9.]+ \([0-9.]+ s\).*tilt.*slip.*floor/);
    assert.match(await time.getAttribute('aria-valuetext'), /^period/);
    await stage.focus();
    await page.keyboard.press('End');
    assert.equal(await at(), last);
    await page.keyboard.press('ArrowLeft');
    assert.equal(await at(), last - 1);
    await page.keyboard.press('Home');
    assert.equal(await at(), 0);
    await page.keyboard.press('ArrowRight');
    assert.equal(await at(), 1);
    await page.keyboard.press('Space');
    await page.waitForFunction(() => Number(document.querySelector('.controls input').value) > 1);
    await page.keyboard.press('Space');
    assert.equal(await button.textContent(), 'Play');
    await time.focus();
    const before = await at();
    await page.keyboard.press('ArrowRight');
    assert.equal(await at(), before + 1);
    await close();
  });

  it('draws block, history and portrait, of each response that can be chosen', async () => {
    const { page, stage, close } = await openMotion(true);
    const choice = page.locator('.controls').getByLabel('Response');
    const names = await choice.locator('option').allTextContents();
    assert.ok(names.length >= 2);
    for (const name of names) {
      await choice.selectOption({ label: name });
      await page.locator('.controls input').fill('40');
      for (const canvas of await stage.locator('canvas').all()) await assertDrawn(canvas, name);
    }
    await close();
  });

  it('enlarges tilt and slip if it is told to, and is faster at a higher speed', async () => {
    const { page, stage, time, at, button, close } = await openMotion(true);
    await time.fill('30');
    assert.ok(await differ(stage.locator('canvas').first(), () => page.locator('.controls').getByLabel('Tilt and slip').selectOption('10')));
    const rates = [];
    for (const speed of ['0.02', '1']) {
      await page.locator('.controls').getByLabel('Speed').selectOption(speed);
      await time.fill('0');
      const start = performance.now();
      await button.click();
      await page.waitForFunction(() => Number(document.querySelector('.controls input').value) > 0);
      await button.click();
      rates.push((await at()) / (performance.now() - start));
    }
    assert.ok(rates[1] > 5 * rates[0], `${rates}`);
    await close();
  });

  it('fits a phone', async () => {
    const { page, stage, close } = await openMotion(true);
    await resize(page, 390, 844);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 390, `${width} px wide`);
    for (const canvas of await stage.locator('canvas').all()) {
      assert.ok((await canvas.boundingBox()).width > 330);
      await assertDrawn(canvas, 'a part of the animation on a phone');
    }
    await close();
  });

  it('has a page of its own, with the same policy', async () => {
    const { page, heard, at, close } = await openMotion(false, alone);
    await page.waitForFunction(() => Number(document.querySelector('.controls input').value) > 0);
    assert.ok((await at()) > 0);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { preload: false }));
    assert.deepEqual(violations.map((found) => `${found.id}: ${found.nodes.map((node) => node.html).join(' | ')}`), []);
    assert.deepEqual(heard, []);
    await close();
  });
});
