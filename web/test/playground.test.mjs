// Uses the playground from disk in Chromium: node playground.test.mjs PAGE DATA. Exits with 77 and a message without a browser.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
if (!existsSync(executablePath)) {
  console.log(`skipped: no browser at ${executablePath} (set CHROMIUM)`);
  process.exit(77);
}
const { chromium } = await import('playwright-core');
const [page_file, data] = process.argv.slice(2), address = pathToFileURL(resolve(page_file)).href;
const launch = (...more) => chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...more] });
const browser = await launch();

const failures = [];
async function open(link = '', { from = browser, ...options } = {}) {
  const page = await from.newPage({ viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
  page.on('pageerror', (error) => failures.push(error.message));
  await page.goto(address + link);
  await page.waitForSelector(':root[data-ready="true"]', { state: 'attached', timeout: 120000 });
  return page;
}

// Waits until nothing is computed, after what was done has begun.
async function idle(page) {
  await page.waitForTimeout(200);
  await page.waitForSelector(':root[data-computing="false"]', { state: 'attached', timeout: 120000 });
}
const count = async (page) => Number(await page.textContent('#play-count-text'));
const message = (page) => page.textContent('#play-message');
const dots = (page) => page.evaluate(() => document.querySelector('#toggles').innerText);
const shell = (page) => page.textContent('#play-shell');

async function save(page, format) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.selectOption('#play-save', format)]);
  return readFileSync(await download.path(), 'utf8');
}

// Of the page's address: generators, and the camera as it was when they changed last.
function state(page) {
  const fields = new URLSearchParams(new URL(page.url()).hash.slice(1));
  return { points: fields.get('g')?.split('~'), camera: fields.get('camera') };
}

// Fingers that move together from a list of points by a number of steps.
async function touch(page, fingers, [right, down] = [0, 0], spread = 0) {
  const session = await page.context().newCDPSession(page), steps = 6;
  const send = (type, touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
  const at = (share) => fingers.map(([x, y], id) => ({ id, x: x + share * (right + (id ? spread : 0)), y: y + share * down }));
  await send('touchStart', at(0));
  for (let i = 1; i <= steps; ++i) await send('touchMove', at(i / steps));
  await send('touchEnd', []);
}

const tests = {
  async 'begins with 30 farthest generators, in the shell as in the page'() {
    const page = await open();
    assert.equal(await count(page), 30);
    assert.equal(await shell(page), 'gvd-segment figure.obj -n 30 -o regions.ply');
    assert.match(await save(page, 'ply'), /^ply\n/);
    await page.close();
  },

  async 'opens a model without a link that does not fit it'() {
    const page = await open('#model=torus.ply&g=999999_0.2_0.2');
    assert.equal(await count(page), 30);
    assert.match(await message(page), /no face 999999/);
    assert.equal(new URL(page.url()).hash.includes('999999'), false);
    await page.close();
  },

  async 'saves what the commands write'() {
    const page = await open('#model=torus.ply&n=5');
    const regions = JSON.parse(await save(page, 'json'));
    assert.ok(regions.face_labels.length === 1600 && regions.face_labels.every((label) => label >= 0));
    await page.selectOption('#play-show', 'distances');
    await idle(page);
    assert.equal(JSON.parse(await save(page, 'json')).schema, 'gvd-distance/1');
    assert.match(await save(page, 'obj'), /^f /m);
    await page.selectOption('#play-show', 'remesh');
    await idle(page);
    assert.match(await message(page), /^A manifold with the topology of the surface; at most [\d.]+ % of the diagonal/);
    await page.close();
  },

  async 'adds, selects and removes generators, with undo and redo'() {
    const page = await open('#model=torus.ply&n=3');
    assert.equal(await count(page), 3);
    const [x, y] = [240, 400];
    await page.mouse.click(x, y);
    await idle(page);
    assert.equal(await count(page), 4);
    assert.match(await shell(page), /--generators generators.csv/);
    await page.keyboard.press('Control+z');
    await idle(page);
    assert.equal(await count(page), 3);
    await page.click('#play-redo');
    await idle(page);
    assert.equal(await count(page), 4);
    await page.mouse.click(x, y);
    await idle(page);
    assert.equal(await count(page), 4, 'a click on a generator selects it');
    await page.keyboard.press('Delete');
    await idle(page);
    assert.equal(await count(page), 3);
    await page.close();
  },

  async 'a dragged generator takes its region along'() {
    const page = await open('#model=torus.ply&n=3');
    await page.mouse.click(240, 400);
    await idle(page);
    const before = await save(page, 'csv');
    await page.mouse.move(240, 400);
    await page.mouse.down();
    for (let i = 1; i <= 5; ++i) await page.mouse.move(240 - 4 * i, 400);
    await page.mouse.up();
    await idle(page);
    const after = await save(page, 'csv');
    const rows = (text) => text.trim().split('\n');
    assert.equal(rows(after).length, rows(before).length);
    assert.deepEqual(rows(after).slice(0, -1), rows(before).slice(0, -1), 'the others stay');
    assert.notEqual(rows(after).at(-1), rows(before).at(-1));
    await page.close();
  },

  async 'a key ends the drag of a generator, and the surface turns again'() {
    const page = await open('#model=torus.ply&n=3');
    await page.mouse.click(240, 400);
    await idle(page);
    const { camera } = state(page);
    await page.mouse.move(240, 400);
    await page.mouse.down();
    await page.mouse.move(210, 400, { steps: 4 });
    await page.keyboard.press('Control+z');
    await page.mouse.move(200, 400, { steps: 4 });
    await page.mouse.up();
    await idle(page);
    assert.equal(await count(page), 3);
    await page.mouse.move(600, 500);
    await page.mouse.down();
    await page.mouse.move(650, 520, { steps: 4 });
    await page.mouse.up();
    await page.click('#play-redo');
    await idle(page);
    assert.notEqual(state(page).camera, camera);
    await page.close();
  },

  async 'works by touch on a phone'() {
    const page = await open('#model=torus.ply&n=3', { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    const [x, y] = [195, 265];
    await page.touchscreen.tap(x, y);
    await idle(page);
    const added = state(page);
    assert.equal(added.points.length, 4, 'a tap adds one');
    await touch(page, [[x + 10, y + 8]], [-50, 15]);
    await idle(page);
    const dragged = state(page);
    assert.deepEqual(dragged.points.slice(0, 3), added.points.slice(0, 3), 'the others stay');
    assert.notEqual(dragged.points[3], added.points[3], 'a finger near a generator drags it');
    assert.equal(dragged.camera, added.camera, 'and does not turn the surface');
    await touch(page, [[300, 420]], [-30, 25]);
    await touch(page, [[x, 600], [x + 40, 600]], [0, 0], 60);
    await idle(page);
    assert.deepEqual(state(page).points, dragged.points, 'turning and pinching leave the generators');
    await page.touchscreen.tap(260, 350);
    await idle(page);
    const last = state(page);
    assert.equal(last.points.length, 5);
    assert.notEqual(last.camera, dragged.camera, 'a finger beside generators has turned the surface');
    const distance = ({ camera }) => Math.hypot(...[0, 1, 2].map((k) => camera.split('_')[k] - camera.split('_')[k + 3]));
    assert.ok(distance(last) < 0.8 * distance(dragged), 'two fingers have brought it nearer');
    await page.close();
  },

  async 'works by keyboard alone'() {
    const page = await open('#model=torus.ply&n=3');
    await page.locator('#canvas').focus();
    await page.mouse.click(240, 400);
    await idle(page);
    const { points, camera } = state(page);
    await page.keyboard.press('n');
    for (let i = 0; i < 4 && !(await page.textContent('#pinned')).includes('Region 3'); ++i) await page.keyboard.press('Shift+N');
    await page.keyboard.press('Shift+ArrowRight');
    await idle(page);
    const moved = state(page);
    assert.deepEqual(moved.points.slice(0, 3), points.slice(0, 3));
    assert.notEqual(moved.points[3], points[3]);
    assert.equal(moved.camera, camera, 'the surface has not turned');
    await page.keyboard.press('Delete');
    await idle(page);
    assert.deepEqual(state(page).points, points.slice(0, 3));
    await page.close();
  },

  async 'after any changes, the result is that of a new page'() {
    const page = await open('#model=figure.obj&n=12');
    await page.evaluate(() => {
      const root = document.documentElement;
      new MutationObserver(() => (window.hasty ||= root.hasAttribute('data-quick'))).observe(root, { attributeFilter: ['data-quick'] });
    });
    const drag = async (from, to) => {
      await page.mouse.move(...from);
      await page.mouse.down();
      for (let i = 1; i <= 10; ++i) {
        await page.mouse.move(...from.map((x, k) => x + (i / 10) * (to[k] - x)));
        await page.waitForTimeout(50);
      }
      await page.mouse.up();
      await idle(page);
    };
    await page.mouse.click(640, 250);
    await idle(page);
    await drag([640, 250], [680, 270]);
    await page.mouse.click(440, 400);
    await idle(page);
    await page.mouse.click(680, 270);  // selects it
    await page.keyboard.press('Delete');
    await idle(page);
    await page.keyboard.press('Control+z');
    await idle(page);
    await drag([680, 270], [650, 290]);
    assert.equal(await count(page), 14);
    await page.waitForSelector(':root:not([data-quick])', { state: 'attached' });
    const [width, all, hasty] = await page.evaluate(() => [canvas.width, canvas.clientWidth, window.hasty]);
    assert.ok(hasty, 'without a graphics card, pictures that move are drawn in haste');
    assert.equal(width, all, 'and the last one with all pixels');
    const other = await open(new URL(page.url()).hash);
    assert.equal(await save(other, 'json'), await save(page, 'json'));
    await Promise.all([page.close(), other.close()]);
  },

  async 'shows equal regions, distances, a coarse mesh, a path and a relaxation'() {
    const page = await open('#model=torus.ply&n=12');
    await page.selectOption('#play-show', 'equal');
    await idle(page);
    assert.match(await shell(page), /--balance area/);
    await page.selectOption('#play-show', 'distances');
    await idle(page);
    assert.match(await dots(page), /Isolines/);
    await page.selectOption('#play-show', 'remesh');
    await idle(page);
    assert.match(await page.innerText('#figures'), /Triangles|Faces/);
    assert.match(await save(page, 'obj'), /^v /m);
    await page.selectOption('#play-show', 'diagram');
    await idle(page);
    await page.check('#play-path');
    await page.mouse.click(240, 400);
    await page.mouse.click(760, 420);
    await idle(page);
    assert.match(await message(page), /Length of the path: [\d.]+/);
    await page.uncheck('#play-path');
    const before = await save(page, 'csv');
    await page.click('#play-relax');
    await idle(page);
    assert.notEqual(await save(page, 'csv'), before);
    assert.equal(await count(page), 12);
    await page.close();
  },

  async 'opens files, and refuses others in one line'() {
    const page = await open();
    await page.setInputFiles('#play-file', join(data, 'plate.stl'));
    await idle(page);
    assert.equal(await page.textContent('#title'), 'plate.stl');
    await page.setInputFiles('#play-file', join(data, 'README.md'));
    await idle(page);
    assert.match(await message(page), /README.md: neither the name nor the content/);
    assert.equal(await page.textContent('#title'), 'plate.stl', 'what was there stays');
    await page.close();
  },

  async 'a mesh that memory does not hold is refused in one line, and the page goes on'() {
    const kMemory = 1500, kSide = 400;  // of 64 KiB each; the first mesh takes less, a torus of 2 * kSide^2 faces more
    const small = await launch(`--js-flags=--wasm-max-mem-pages=${kMemory}`), page = await open('', { from: small });
    const lines = ['OFF', `${kSide ** 2} ${2 * kSide ** 2} 0`], id = (i, j) => (i % kSide) * kSide + (j % kSide), turn = (2 * Math.PI) / kSide;
    for (let i = 0; i < kSide; ++i) for (let j = 0; j < kSide; ++j) {
      const r = 2 + Math.cos(turn * j);
      lines.push([r * Math.cos(turn * i), r * Math.sin(turn * i), Math.sin(turn * j)].join(' '));
    }
    for (let i = 0; i < kSide; ++i) for (let j = 0; j < kSide; ++j) {
      const [a, b, c, d] = [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)];
      lines.push(`3 ${a} ${b} ${c}`, `3 ${a} ${c} ${d}`);
    }
    await page.setInputFiles('#play-file', { name: 'large.off', mimeType: 'text/plain', buffer: Buffer.from(lines.join('\n')) });
    await page.waitForSelector('#play-message:not([hidden])', { timeout: 120000 });
    assert.match(await message(page), /^the memory of the page is full; use a smaller mesh[^\n]*$/);
    assert.equal(await page.textContent('#title'), 'figure.obj');
    await page.mouse.click(640, 250);
    await idle(page);
    assert.equal(await count(page), 31);
    await small.close();
  },

  async 'a link brings the state back'() {
    const page = await open('#model=torus.ply&n=4');
    await page.mouse.click(240, 400);
    await idle(page);
    const other = await open(new URL(page.url()).hash);
    assert.equal(await count(other), 5);
    assert.equal(await save(other, 'csv'), await save(page, 'csv'));
    await Promise.all([page.close(), other.close()]);
  },
};

for (const [name, test] of Object.entries(tests)) {
  try {
    await test();
    console.log(`ok ${name}`);
  } catch (error) {
    failures.push(`${name}: ${error.stack}`);
  }
}
await browser.close();
for (const failure of failures) console.error(`not ok ${failure}`);
process.exit(failures.length ? 1 : 0);
