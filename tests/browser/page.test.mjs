// report.html in Chromium, opened from disk.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { axe, desktop, open, resize, within, assertDrawn, lightnessOf, column, axisLabels } from './browser.mjs';

describe('the page', () => {
  it('says nothing on the console, asks for nothing and runs no script of a title', async () => {
    const { page, heard, close } = await open();
    await page.waitForTimeout(200);
    assert.deepEqual(heard, []);
    assert.match(await page.title(), /^<script>document\.title/);
    await close();
  });

  it('is refused what its policy forbids', async () => {
    const { page, heard, close } = await open();
    await page.evaluate(() => {
      const script = document.createElement('script');
      script.textContent = 'window.intruder = true';
      document.body.append(script);
      new Image().src = 'https://example.invalid/pixel.png';
    });
    assert.equal(await page.evaluate(() => window.intruder), undefined);
    const refused = () => heard.some((text) => text.includes('Content Security Policy'));
    for (let tries = 0; tries < 100 && !refused(); ++tries) await page.waitForTimeout(100);
    assert.ok(refused(), heard.join('\n'));
    await close();
  });

  it('draws every chart', async () => {
    const { page, close } = await open();
    const panels = page.locator('.panel');
    assert.ok((await panels.count()) >= 4);
    for (let i = 0; i < (await panels.count()); ++i) await assertDrawn(panels.nth(i).locator('.plot'), `chart ${i}`, within);
    await close();
  });

  it('draws every chart within its panel, also when the window changes', async () => {
    const { page, close } = await open();
    for (const width of [1280, 700, 1100]) {
      await resize(page, width, 900);
      for (const panel of await page.locator('.panel').all()) {
        const [outer, inner] = [await panel.boundingBox(), await panel.locator('canvas').first().boundingBox()];
        const [above, foot] = [await panel.locator('.plot').boundingBox(), await panel.locator('.foot').boundingBox()];
        assert.ok(inner.x >= outer.x - 1 && inner.x + inner.width <= outer.x + outer.width + 1, `${width} px`);
        assert.ok(inner.width > 0.9 * outer.width && above.y + above.height <= foot.y + 1, `${width} px`);
      }
    }
    await close();
  });

  it('answers before anything else, with overturning first', async () => {
    for (const viewport of [desktop, { width: 390, height: 844 }]) {
      const { page, close } = await open({ viewport });
      const answer = page.locator('#answer');
      assert.equal(await answer.locator('dt').first().textContent(), 'Overturning');
      const box = await answer.locator('dd').first().boundingBox();
      assert.ok(box.y + box.height < viewport.height, 'the first answer is on the first screen');
      const drawings = await answer.locator('svg.mode').all();
      assert.ok(drawings.length >= 2);
      for (const drawing of drawings) await assertDrawn(drawing, 'a drawing of a response');
      await close();
    }
  });

  it('shows its checks without scrolling inside, on a desktop and on a phone', async () => {
    for (const viewport of [desktop, { width: 390, height: 844 }]) {
      const { page, close } = await open({ viewport });
      const checks = page.locator('#trust .checks li');
      assert.ok((await checks.count()) > 8);
      assert.equal(await page.locator('#trust .scroll').count(), 0);
      for (const check of await checks.all()) {
        const box = await check.boundingBox();
        assert.ok(box.x >= 0 && box.x + box.width <= viewport.width);
        assert.ok(await check.evaluate((item) => [...item.children].every((part) => part.scrollWidth <= part.clientWidth + 1
          || getComputedStyle(part).display === 'inline')));
      }
      await close();
    }
  });

  it('has the question, the answer and one figure at its top', async () => {
    const { page, close } = await open();
    const tops = [];
    for (const part of ['.asked', '#answer dl', '#answer figure', '.cards', 'figure:not(#answer figure)']) {
      tops.push((await page.locator(part).first().boundingBox()).y);
    }
    assert.deepEqual(tops, [...tops].sort((a, b) => a - b));
    assert.equal(await page.locator('#answer figure').count(), 1);
    assert.equal(await page.locator('.card').count(), 2);
    for (const card of await page.locator('.card').all()) {
      const box = await card.boundingBox();
      assert.ok(box.width > 200 && box.height > 80);
    }
    await close();
  });

  it('says of a table that is too wide that it goes on, and reaches every column', async () => {
    const { page, close } = await open({ viewport: { width: 390, height: 844 } });
    const wide = page.locator('.scroll.wide');
    assert.ok((await wide.count()) > 0);
    for (const place of await page.locator('.scroll').all()) {
      if (!(await place.isVisible())) continue;
      const [hinted, goesOn] = await place.evaluate((one) =>
        [getComputedStyle(one, '::before').content.includes('scroll'), one.scrollWidth > one.clientWidth + 1]);
      assert.equal(hinted, goesOn);
      const end = await place.evaluate((one) => {
        one.scrollLeft = one.scrollWidth;
        const heads = one.querySelectorAll('thead th');
        return heads[heads.length - 1].getBoundingClientRect().right - one.getBoundingClientRect().right;
      });
      assert.ok(end <= 1, `${end} px of the last column are out of reach`);
    }
    await close();
  });

  it('zooms by button, by dragging and by keys, and comes back', async () => {
    const { page, close } = await open();
    const panel = page.locator('.panel').first();
    const home = await axisLabels(panel);
    await panel.getByRole('button', { name: 'Zoom in' }).click();
    assert.notDeepEqual(await axisLabels(panel), home);
    await panel.getByRole('button', { name: 'Show all' }).click();
    assert.deepEqual(await axisLabels(panel), home);
    const box = await panel.locator('.plot').boundingBox();
    await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.5 * box.height, { steps: 5 });
    await page.mouse.up();
    await page.waitForTimeout(100);
    assert.notDeepEqual(await axisLabels(panel), home);
    await assertDrawn(panel.locator('.plot'), 'a zoomed chart', within);
    await panel.locator('.plot').dblclick({ position: { x: 200, y: 100 } });
    assert.deepEqual(await axisLabels(panel), home);
    await panel.locator('.frame').focus();
    await page.keyboard.press('+');
    assert.notDeepEqual(await axisLabels(panel), home);
    await page.keyboard.press('0');
    assert.deepEqual(await axisLabels(panel), home);
    await close();
  });

  it('tells under the pointer and by keys what the table says', async () => {
    const { page, close } = await open();
    const figure = page.locator('#mode_probabilities');
    const panel = figure.locator('.panel').first();
    await panel.locator('.plot').hover({ position: { x: 360, y: 120 } });
    const pointed = await panel.locator('.readout').textContent();
    const place = pointed.match(/^Ah = ([0-9.]+)/)?.[1];
    assert.ok(place, pointed);
    const row = (await column(figure.locator('table'), 1)).indexOf(place);
    const cell = (await column(figure.locator('table'), 4))[row];
    const [estimate, low, high] = cell.match(/[0-9.]+/g).map((text) => Number(text) / 100);
    const told = pointed.match(/\(1,1\): ([0-9.]+) \[([0-9.]+), ([0-9.]+)\]/).slice(1).map(Number);
    [estimate, low, high].forEach((number, i) => assert.ok(Math.abs(number - told[i]) < 0.0006, `${cell} / ${pointed}`));
    await panel.locator('.frame').focus();
    await page.keyboard.press('Home');
    assert.match(await panel.locator('.readout').textContent(), /^Ah = 1/);
    await page.keyboard.press('ArrowRight');
    assert.match(await panel.locator('.readout').textContent(), /^Ah = 2/);
    await close();
  });

  it('hides what its legend is asked to hide', async () => {
    const { page, close } = await open();
    const figure = page.locator('#mode_bands');
    const plot = figure.locator('.plot').first();
    const before = await plot.screenshot();
    await figure.getByRole('button', { name: '(1,1)', exact: true }).click();
    assert.notDeepEqual(await plot.screenshot(), before);
    await figure.getByRole('button', { name: '(1,1)', exact: true }).click();
    assert.deepEqual(await plot.screenshot(), before);
    await close();
  });

  it('sorts its tables by any column, up and down, by mouse and by keys', async () => {
    const { page, close } = await open();
    const table = page.locator('#mode_probabilities table');
    const head = table.getByRole('columnheader', { name: '(1,1)' });
    await head.getByRole('button').click();
    const numbers = async () => (await column(table, 4)).map((text) => (text.startsWith('<') ? 0 : Number.parseFloat(text)));
    const up = await numbers();
    assert.equal(await head.getAttribute('aria-sort'), 'ascending');
    assert.deepEqual(up, [...up].sort((a, b) => a - b));
    assert.ok(up[0] < up.at(-1));
    await head.getByRole('button').press('Enter');
    assert.equal(await head.getAttribute('aria-sort'), 'descending');
    assert.deepEqual(await numbers(), up.reverse());
    await close();
  });

  it('has a table with its numbers under every chart', async () => {
    const { page, close } = await open();
    for (const figure of await page.locator('figure:has(.charts):not(#mode_bands)').all()) {
      assert.ok((await figure.locator('table caption').count()) >= 1);
      assert.ok((await figure.locator('tbody tr').count()) >= 2);
    }
    await close();
  });

  it('is found accessible, light and dark', async () => {
    const small = { width: 375, height: 700 };
    for (const look of [{ viewport: desktop }, { viewport: small }, { viewport: desktop, colorScheme: 'dark' }]) {
      const { page, close } = await open(look);
      await page.evaluate(axe);
      const { violations, passes } = await page.evaluate(() => window.axe.run(document, { preload: false }));
      assert.ok(passes.length > 20);
      assert.deepEqual(
        violations.map((found) => `${found.id}: ${found.nodes.map((node) => node.html).join(' | ')}`), []);
      await close();
    }
  });

  it('is dark where its reader wants it, charts included, but not on paper', async () => {
    const { page, close } = await open({ colorScheme: 'dark' });
    const behind = (selector) => page.locator(selector).first().evaluate((element) => getComputedStyle(element).backgroundColor);
    assert.equal(await behind('html'), 'rgb(21, 24, 28)');
    for (const frame of await page.locator('#mode_probabilities .frame, #non_recurrence .frame').all()) {
      assert.ok((await lightnessOf(frame)) < 90);
    }
    await assertDrawn(page.locator('.plot').first(), 'a chart on a dark page', within);
    await page.emulateMedia({ media: 'print' });
    assert.equal(await behind('html'), 'rgb(255, 255, 255)');
    await close();
  });

  it('shows by when equal runs have diverged, on a logarithmic axis that zooms and moves', async () => {
    const { page, close } = await open();
    const figure = page.locator('#divergence_times');
    const panel = figure.locator('.panel');
    await assertDrawn(panel.locator('.plot'), 'parting times', within);
    const frame = panel.locator('.frame');
    await frame.focus();
    await page.keyboard.press('End');
    const table = figure.locator('table');
    const last = (await table.locator('tbody tr').last().locator('th, td').allTextContents()).map(Number);
    assert.match(await panel.locator('.readout').textContent(), new RegExp(`= ${last[0]}.*: ${last[1]}`));
    const heads = await table.locator('thead th').allTextContents();
    for (const name of await figure.locator('.legend button').allTextContents()) assert.ok(heads.includes(name), name);
    for (let at = 1; at < last.length; ++at) {
      const levels = (await column(table, at)).map(Number);
      assert.ok(levels.every((level, i) => i === 0 || level >= levels[i - 1]), `${levels}`);
    }
    const home = await axisLabels(panel);
    for (const name of ['Zoom in', 'Right', 'Left']) {
      await panel.getByRole('button', { name }).click();
      assert.notDeepEqual(await axisLabels(panel), home, name);
    }
    await panel.getByRole('button', { name: 'Zoom out' }).click();
    assert.deepEqual(await axisLabels(panel), home);
    await close();
  });

  it('fits a narrow screen', async () => {
    const { page, close } = await open({ viewport: { width: 375, height: 700 } });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= 375, `${width} px wide`);
    await assertDrawn(page.locator('.plot').first(), 'a narrow chart');
    await close();
  });

  it('shows pictures and tables without scripts, and no buttons', async () => {
    const { page, heard, close } = await open({ javaScriptEnabled: false });
    const pictures = page.locator('figure img');
    assert.equal(await pictures.count(), await page.locator('figure').count());
    for (let i = 0; i < (await pictures.count()); ++i) {
      await assertDrawn(pictures.nth(i), `picture ${i}`);
      assert.ok((await pictures.nth(i).getAttribute('alt')).length > 30);
    }
    assert.equal(await page.locator('button').count(), 0);
    for (const still of await page.locator('.still svg').all()) await assertDrawn(still, 'a motion as a drawing');
    assert.ok((await page.locator('.still:visible').count()) >= 1);
    assert.ok((await page.locator('td:visible').count()) > 50);
    assert.deepEqual(heard.filter((text) => !text.includes('script')), []);
    await close();
  });

  it('prints pictures in place of charts, and its tables whole', async () => {
    const { page, close } = await open();
    await page.emulateMedia({ media: 'print' });
    for (const selector of ['.charts', '.tools', '.more', '.stage', '.controls']) {
      for (const element of await page.locator(selector).all()) assert.equal(await element.isVisible(), false, selector);
    }
    for (const picture of await page.locator('figure img, .still svg').all()) assert.ok(await picture.isVisible());
    for (const box of await page.locator('.scroll').all()) {
      assert.ok(await box.evaluate((element) => element.scrollHeight <= element.clientHeight + 1));
    }
    const pages = (await page.pdf({ format: 'A4' })).toString('latin1').match(/\/Type\s*\/Page\b/g).length;
    assert.ok(pages >= 2 && pages <= 12, `${pages} pages`);
    await close();
  });
});

describe('the tests', () => {
  it('take an empty chart for what it is', async () => {
    const { page, close } = await open();
    const plots = page.locator('.plot');
    for (let i = 0; i < (await plots.count()); ++i) {
      await plots.nth(i).locator('canvas').evaluateAll((layers) => {
        for (const layer of layers) layer.getContext('2d').clearRect(0, 0, layer.width, layer.height);
      });
      await assert.rejects(assertDrawn(plots.nth(i), 'an empty chart', within));
    }
    await close();
  });
});
