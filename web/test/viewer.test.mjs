// Opens a page of the viewer in a browser and uses it: node viewer.test.mjs PAGE.html [FOLDER for pictures].
// Exits with 77 and a message if there is no browser. CHROMIUM names another one than /usr/bin/chromium.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const kSkipped = 77;
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(kSkipped);
}

if (!existsSync(executablePath)) skip(`no browser at ${executablePath} (set CHROMIUM)`);
const { chromium } = await import('playwright-core').catch(() => skip('playwright-core is not installed (npm ci)'));

const [page_file, picture_folder] = process.argv.slice(2);
const address = pathToFileURL(resolve(page_file)).href;
const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--disable-gpu', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
         '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

// A freshly opened page that collects what must not happen: errors, and requests for other addresses.
async function open(options = {}) {
  const usual = { viewport: { width: 1000, height: 700 }, reducedMotion: 'reduce' };
  const context = await browser.newContext({ ...usual, ...options });
  const page = await context.newPage();
  page.faults = [];
  page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('request', (request) => request.url() !== address && page.faults.push(request.url()));
  await page.goto(address);
  await page.waitForSelector('html[data-ready]', { timeout: 60000 });
  await settle(page);
  return page;
}

// Waits two frames, after which everything requested is drawn.
const settle = (page) =>
  page.evaluate(async () => {
    for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
    await new Promise((done) => setTimeout(done, 50));
  });

async function picture(page, name) {
  await settle(page);
  const path = picture_folder && name ? join(picture_folder, `${name}.png`) : undefined;
  return createHash('sha256').update(await page.screenshot({ path })).digest('hex');
}

async function close(page) {
  assert.deepEqual(page.faults, []);
  await page.context().close();
}

const card = (page) => page.locator('#region').innerText();

const tests = {
  async 'draws, and shows title and figures'() {
    const page = await open();
    assert.equal(await page.locator('h1').innerText(), 'A sample <of the viewer>');
    const figures = await page.locator('#figures').innerText();
    assert.match(figures, /Faces\s+5120/);
    assert.match(figures, /Euler count\s+44 of 44/);
    await picture(page, 'light');
    await close(page);
  },

  async 'tells the figures of the region under the pointer'() {
    const page = await open();
    await page.mouse.move(370, 350);
    await settle(page);
    const text = await card(page);
    assert.match(text, /Region \d+/);
    assert.match(text, /Area\s+0\.\d+ \(\d\.\d\s%\)/);
    assert.match(text, /Neighbours\s+\d+, \d+/);
    assert.match(text, /Distance here\s+0\.\d+/);
    await picture(page, 'hover');
    await page.mouse.move(30, 400);
    await settle(page);
    assert.ok(await page.locator('#region').isHidden());
    await close(page);
  },

  async 'every switch changes the picture and back'() {
    const page = await open();
    await page.mouse.move(30, 400);
    const first = await picture(page);
    const boxes = await page.locator('#toggles label:not([hidden]) input').all();
    assert.equal(boxes.length, 8);
    for (const box of boxes) {
      const key = await box.getAttribute('id');
      const before = await box.isChecked();
      await box.setChecked(!before);
      assert.notEqual(await picture(page, key), first, key);
      await box.setChecked(before);
    }
    await page.evaluate(() => document.activeElement.blur());
    await page.mouse.move(30, 400);
    assert.equal(await picture(page), first);
    await close(page);
  },

  async 'the keyboard reaches the scenes, every switch and the picture'() {
    const page = await open();
    const reached = new Set();
    for (let i = 0; i < 14; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.name));
    }
    for (const id of ['canvas', 'scene', 'toggle-regions', 'toggle-smooth']) assert.ok(reached.has(id), id);
    await page.locator('#toggle-regions').focus();
    await page.keyboard.press('Space');
    assert.equal(await page.locator('#toggle-regions').isChecked(), false);
    await page.locator('#canvas').focus();
    const first = await picture(page);
    for (const [there, back] of [['ArrowLeft', 'ArrowRight'], ['ArrowUp', 'ArrowDown'], ['+', '0']]) {
      await page.keyboard.press(there);
      assert.notEqual(await picture(page), first, there);
      await page.keyboard.press(back);
    }
    await close(page);
  },

  async 'turns, zooms and follows the window'() {
    const page = await open();
    const first = await picture(page);
    await page.mouse.move(500, 350);
    await page.mouse.down();
    await page.mouse.move(600, 380, { steps: 4 });
    await page.mouse.up();
    const turned = await picture(page);
    assert.notEqual(turned, first);
    await page.mouse.wheel(0, -1500);
    assert.notEqual(await picture(page, 'zoom'), turned);
    await page.setViewportSize({ width: 500, height: 800 });
    await settle(page);
    const size = await page.locator('canvas').evaluate(({ width, height }) => [width, height]);
    assert.deepEqual(size, [500, 800]);
    await close(page);
  },

  async 'switches between scenes, and offers what each has'() {
    const page = await open();
    const first = await picture(page);
    await page.getByText('60 generators').click();
    assert.notEqual(await picture(page, 'second'), first);
    assert.match(await page.locator('#figures').innerText(), /Generators\s+60/);
    assert.equal(await page.locator('#toggle-added_generators').isVisible(), false);
    await page.getByText('A torus').click();
    assert.equal(await page.locator('#toggle-regions').isVisible(), false);
    assert.ok(await page.locator('#toggle-wireframe').isChecked());
    assert.match(await page.locator('#toggles').innerText(), /^Generators\s+2\s+Added generators\s+1\s+Wireframe/);
    const all = await picture(page);
    await page.locator('#toggle-added_generators').uncheck();
    assert.notEqual(await picture(page), all);
    await picture(page, 'third');
    await page.getByText('24 generators').click();
    assert.equal(await page.locator('#toggle-wireframe').isChecked(), false);
    assert.ok(await page.locator('#toggle-regions').isChecked());
    await close(page);
  },

  async 'follows the dark colour scheme'() {
    const page = await open({ colorScheme: 'dark' });
    const dark = await picture(page, 'dark');
    await page.emulateMedia({ colorScheme: 'light' });
    assert.notEqual(await picture(page), dark);
    await close(page);
  },

  async 'works by touch on a narrow screen'() {
    const viewport = { width: 390, height: 780 };
    const page = await open({ viewport, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    assert.equal(await page.locator('#toggles').isVisible(), false);
    await page.touchscreen.tap(195, 400);
    await settle(page);
    assert.match(await card(page), /Region \d+/);
    await picture(page, 'touch');
    await page.locator('#show summary').tap();
    assert.ok(await page.locator('#toggles').isVisible());
    await picture(page, 'touch-open');
    await close(page);
  },
};

let failures = 0;
for (const [name, run] of Object.entries(tests)) {
  try {
    await run();
    console.log(`ok    ${name}`);
  } catch (error) {
    ++failures;
    console.log(`FAILED ${name}\n${error.stack}`);
  }
}
await browser.close();
process.exit(failures ? 1 : 0);
