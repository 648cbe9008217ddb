// Opens a page of the viewer in a browser and uses it: node viewer.test.mjs PAGE.html [FOLDER for pictures].
// Exits with 77 and a message if there is no browser. CHROMIUM names another one than /usr/bin/chromium.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';

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

// In the page: counts the triangles' corners of every drawing, and tells what part of the canvas is not background.
function watch() {
  const proto = WebGL2RenderingContext.prototype;
  window.drawn = [];
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
    const draw = proto[name];
    proto[name] = function (mode, first, count, ...rest) {
      window.drawn.push(name.startsWith('drawElements') ? first : count);
      return draw.call(this, mode, first, count, ...rest);
    };
  }
  window.covered = () => {
    const source = document.getElementById('canvas'), copy = document.createElement('canvas');
    [copy.width, copy.height] = [source.width, source.height];
    const context = copy.getContext('2d', { willReadFrequently: true });
    context.drawImage(source, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let [other, below, left, right, top, bottom] = [0, 0, copy.width, 0, copy.height, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i] === data[0] && data[i + 1] === data[1] && data[i + 2] === data[2] && data[i + 3] === data[3]) continue;
      ++other;
      const x = (i / 4) % copy.width, y = Math.floor(i / 4 / copy.width);
      [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
      below += 2 * y > copy.height;
    }
    const share = other / (copy.width * copy.height);
    return { share, width: (right - left) / copy.width, tall: (bottom - top) / (right - left), below: below / other };
  };
  // In the task that says the page is ready, nothing but the first drawing has happened.
  const ready = { attributes: true, subtree: true, attributeFilter: ['data-ready'] };
  new MutationObserver(() => (window.first ??= window.covered())).observe(document, ready);
}

// A freshly opened page that collects what must not happen: errors, and requests for other addresses.
async function open({ page_address = address, ...options } = {}) {
  const usual = { viewport: { width: 1000, height: 700 }, reducedMotion: 'reduce' };
  const context = await browser.newContext({ ...usual, ...options });
  const page = await context.newPage();
  page.faults = [];
  page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('request', (request) => {
    if (request.url() !== page_address && !request.url().startsWith('blob:')) page.faults.push(request.url());
  });
  await page.addInitScript(watch);
  await page.goto(page_address);
  await page.waitForSelector('html[data-ready]', { timeout: 60000 });
  await settle(page);
  return page;
}

// Waits until the surface rests, its shade is made and everything requested is drawn.
const settle = (page) =>
  page.evaluate(async () => {
    for (const pause of [0, 250, 50]) {
      await new Promise((done) => setTimeout(done, pause));
      while ('shading' in document.documentElement.dataset) await new Promise((done) => setTimeout(done, 20));
      for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
    }
  });

// A hash of the picture without the panels at its right, whose corners a browser does not always draw alike.
async function picture(page, name) {
  await settle(page);
  if (picture_folder && name) await page.screenshot({ path: join(picture_folder, `${name}.png`) });
  const { width, height } = page.viewportSize(), clip = { x: 0, y: 0, width: Math.min(width, 690), height };
  return createHash('sha256').update(await page.screenshot({ clip })).digest('hex');
}

// The picture with its panels as PNG in base64, with the pointer where `at` says and no focus.
async function shot(page, at) {
  await page.evaluate(() => document.activeElement.blur());
  if (at) await page.mouse.move(...at);
  await settle(page);
  return (await page.screenshot()).toString('base64');
}

// In the page: the number of pixels in which two pictures differ, by more than `least` levels of red or green.
async function count_differing([first, second, least = 0]) {
  const [one, two] = await Promise.all(
    [first, second].map(async (source) => {
      const image = new Image();
      image.src = `data:image/png;base64,${source}`;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, Math.min(image.width, image.width - 290), image.height).data;
    }),
  );
  let count = 0;
  for (let i = 0; i < one.length; i += 4) {
    count += Math.abs(one[i] - two[i]) > least || Math.abs(one[i + 1] - two[i + 1]) > least;
  }
  return count;
}

// In the page: the middles of the areas, left of the panels and above the legend, with nearly the last colour of the ramp.
async function find_bright_spots(source) {
  const image = new Image();
  image.src = `data:image/png;base64,${source}`;
  await image.decode();
  const canvas = Object.assign(document.createElement('canvas'), { width: image.width - 290, height: image.height - 130 });
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  const { data, width } = context.getImageData(0, 0, canvas.width, canvas.height), groups = [];
  for (let i = 0; i < data.length; i += 4) {
    if (!(data[i] > 1.8 * data[i + 2] && data[i + 1] > 1.8 * data[i + 2] && data[i] > 0.7 * data[i + 1])) continue;
    const x = (i / 4) % width, y = Math.floor(i / 4 / width);
    const near = groups.find((group) => Math.hypot(group.x / group.n - x, group.y / group.n - y) < 30);
    if (near) [near.x, near.y, near.n] = [near.x + x, near.y + y, near.n + 1];
    else groups.push({ x, y, n: 1 });
  }
  return groups.filter(({ n }) => n > 8).map(({ x, y, n }) => [x / n, y / n]);
}

// A page with one scene in place of the sample's; returns its address. `points` are generators.
// `iterations`: of further scenes without a name, beside that of the first.
function write_page(name, { positions, faces, points = [], texture = [], up = 'y', iterations = [] }) {
  const arrays = [Float32Array.from(positions), Uint32Array.from(faces), Float32Array.from(points), Float32Array.from(texture)];
  const blobs = arrays.map((array, k) => {
    const text = deflateSync(Buffer.from(array.buffer)).toString('base64');
    return `<script type="application/octet-stream" id="blob-${k}">${text}</script>`;
  });
  const scene = { name, wireframe: false, smooth: true, cells: [], figures: [] };
  scene.positions = { blob: 0, type: 'f32', count: arrays[0].length };
  scene.faces = { blob: 1, type: 'u32', count: arrays[1].length };
  if (texture.length) scene.texture = { blob: 3, type: 'f32', count: texture.length };
  if (points.length) scene.generators = { blob: 2, type: 'f32', count: points.length };
  const manifest = { schema: 'gvd-view/1', title: name, up, scale: 1, origin: [0, 0, 0], scenes: [scene] };
  if (iterations.length) scene.iteration = iterations.shift();
  for (const iteration of iterations) {
    manifest.scenes.push({ ...scene, name: '', iteration, figures: [['Energy', String(iteration)]] });
  }
  const page = readFileSync(page_file, 'utf8'), kData = '<script type="application/';
  const tail = page.slice(page.indexOf('</script>', page.lastIndexOf(kData)) + 9);
  const data = `${kData}json" id="manifest">${JSON.stringify(manifest)}</script>${blobs.join('')}`;
  const file = resolve(picture_folder ?? '.', `${name}.html`);
  writeFileSync(file, page.slice(0, page.indexOf(kData)) + data + tail);
  return pathToFileURL(file).href;
}

// A torus of 2 n m faces.
function make_torus(n, m) {
  const positions = [], faces = [];
  for (let i = 0; i < n * m; ++i) {
    const a = (2 * Math.PI * Math.floor(i / m)) / n, b = (2 * Math.PI * (i % m)) / m, r = 0.7 + 0.25 * Math.cos(b);
    positions.push(r * Math.cos(a), 0.25 * Math.sin(b), r * Math.sin(a));
    const u = (i + m) % (n * m), v = i % m === m - 1 ? i - m + 1 : i + 1, w = (v + m) % (n * m);
    faces.push(i, w, u, i, v, w);
  }
  return { positions, faces };
}

// A page with a torus and a dot at one of `step` vertices; returns its address.
function write_dots(step) {
  const torus = make_torus(200, 80), points = torus.positions.filter((_, i) => Math.floor(i / 3) % step === 0);
  return write_page(`dots-${step}`, { ...torus, points });
}

// A long cone with its tip in the direction of an axis ('x', '-x', 'y', ...).
function make_cone(axis) {
  const k = 'xyz'.indexOf(axis.at(-1)), sign = axis.startsWith('-') ? -1 : 1, positions = [], faces = [];
  const add = (along, side, across) => {
    const p = [0, 0, 0];
    [p[k], p[(k + 1) % 3], p[(k + 2) % 3]] = [sign * along, side, sign * across];
    positions.push(...p);
  };
  add(1, 0, 0);
  for (let i = 0; i < 24; ++i) add(-1, 0.3 * Math.cos((Math.PI * i) / 12), 0.3 * Math.sin((Math.PI * i) / 12));
  for (let i = 0; i < 24; ++i) faces.push(0, 1 + i, 1 + ((i + 1) % 24));
  return { positions, faces };
}

// What part of the canvas is not background, in the frame of a new drawing: its content is gone when that is shown.
const redraw = (page) =>
  page.evaluate(() => new Promise((done) => {
    const canvas = document.getElementById('canvas');
    for (const key of ['ArrowLeft', 'ArrowRight']) canvas.dispatchEvent(new KeyboardEvent('keydown', { key }));
    requestAnimationFrame(() => done(window.covered()));
  }));

async function close(page) {
  assert.deepEqual(page.faults, []);
  await page.context().close();
}

// The number of pixels that the generators' dots change by more than `least` levels.
async function count_dot_pixels(page, least = 0) {
  const dots = page.locator('#toggle-generators'), on = await shot(page);
  await dots.uncheck();
  const off = await shot(page);
  await dots.check();
  return page.evaluate(count_differing, [on, off, least]);
}

const kBeside = [30, 400];  // beside the surface

// What the panels at the right and the choice of the scene show: texts, open panels, order and position of the table.
const panels_shown = (page) =>
  page.evaluate(() => ({
    text: document.querySelector('aside').innerText,
    open: [...document.querySelectorAll('aside > details')].map((box) => box.open),
    scene: document.querySelector('#scenes :checked').value,
    sorted: [...document.querySelectorAll('th[data-key]')].map((cell) => cell.getAttribute('aria-sort')),
    scrolled: document.getElementById('region-rows').scrollTop,
  }));
const settle_frame = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const offered = (page) => page.locator('#colour option:not([hidden])').evaluateAll((all) => all.map(({ value }) => value));
const draws = (page) => page.evaluate(() => window.drawn.splice(0));
const card = (page) => page.locator('#region').innerText();

const tests = {
  async 'draws, and shows title and figures'() {
    const page = await open();
    assert.equal(await page.locator('h1').innerText(), 'A sample <of the viewer>');
    const figures = await page.locator('#figures').innerText();
    assert.match(figures, /Faces\s+5,120/);
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
    assert.match(text, /Energy\s+0\.\d+/);
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
    assert.equal(boxes.length, 7);
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
    for (let i = 0; i < 16; ++i) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.name));
    }
    for (const id of ['canvas', 'scene', 'save', 'reset', 'colour', 'toggle-lines', 'toggle-smooth', 'up']) assert.ok(reached.has(id), id);
    await page.locator('#toggle-bisectors').focus();
    await page.keyboard.press('Space');
    assert.equal(await page.locator('#toggle-bisectors').isChecked(), false);
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
    const size = await page.locator('#canvas').evaluate(({ width, height }) => [width, height]);
    assert.deepEqual(size, [500, 800]);
    assert.equal(await page.locator('#toggles').isVisible(), false);
    await page.setViewportSize({ width: 1000, height: 700 });
    await settle(page);
    assert.ok(await page.locator('#toggles').isVisible());
    await close(page);
  },

  async 'panels are as before when the window has been narrow'() {
    const page = await open();
    await page.locator('#show summary').click();
    await page.locator('#regions summary').click();
    await settle(page);  // the table fills its rows
    const panels = await panels_shown(page);
    for (const width of [700, 1000]) {
      await page.setViewportSize({ width, height: 700 });
      await settle(page);
      assert.equal(await page.locator('#figures table').isVisible(), width === 1000);
    }
    assert.deepEqual(await panels_shown(page), panels);
    await close(page);
  },

  async 'shows distances from another surface, in the middle of a face too'() {
    const page = await open();
    await page.getByText('A remesh').click();
    assert.equal(await page.locator('#colour').inputValue(), 'plain');
    assert.deepEqual(await offered(page), ['surface_distance', 'quality', 'angle', 'plain']);
    await page.selectOption('#colour', 'surface_distance');
    assert.match(await page.locator('#legend').innerText(), /Distance from the other sphere, % of the diagonal\s+0\s+2\s+4/);
    await page.locator('#toggle-wireframe').uncheck();
    const spots = await page.evaluate(find_bright_spots, await shot(page, kBeside));
    assert.ok(spots.length >= 4, `${spots.length} spots`);
    for (const [x, y] of spots) {
      await page.mouse.move(x, y);
      await settle(page);
      const [, percent, units] = (await card(page)).match(/Face \d+\s+Distance here\s+([\d.]+)\s%\s\(([\d.]+)\)/);
      assert.ok(Number(percent) > 3.5, `${percent} % at ${x}, ${y}`);
      assert.ok(Math.abs(Number(units) - 0.04 * Number(percent)) < 0.001, units);
    }
    assert.match(await card(page), /Largest in face\s+5\s%\s\(0.2\)\s+Quality Q\s+1.000\s+Smallest angle\s+60.0°\s+Vertices\s+\d+, \d+, \d+/);
    await picture(page, 'remesh');
    await close(page);
  },

  async 'tells of the vertex that the pointer is near'() {
    const page = await open();
    await page.getByText('A remesh').click();
    await page.locator('#toggle-generators').check();
    const marked = () => page.locator('#mark').evaluate((canvas) => canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.some((v) => v));
    let text = '';
    for (let y = 150; y < 600 && !text.includes('Vertex'); y += 6) {
      for (let x = 150; x < 600 && !text.includes('Vertex'); x += 12) {
        await page.mouse.move(x, y);
        await settle_frame(page);
        text = (await page.locator('#region').isVisible()) ? await card(page) : '';
      }
    }
    const [, vertex, generator] = text.match(/Vertex (\d+)\s+Distance\s+0\s+Valence\s+5\s+Generator\s+(\d+)\s+Distance from it\s+0/);
    assert.equal(vertex, generator);
    assert.ok(await marked());
    await picture(page, 'vertex');
    await close(page);
  },

  async 'draws the other surface with the remesh'() {
    const page = await open();
    const hints_at_pinning = () => page.locator('#hint span').evaluate((part) => part.textContent.includes('pin'));
    assert.ok(await hints_at_pinning());
    await page.getByText('A remesh').click();
    assert.ok(!(await hints_at_pinning()));
    assert.match(await page.locator('#toggles').innerText(), /The other sphere/);
    const before = await picture(page);
    await page.locator('#toggle-overlay').check();
    assert.notEqual(await picture(page), before);
    await page.getByText('A torus').click();
    assert.ok(await page.locator('#toggle-overlay').isHidden());
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
    assert.equal(await page.locator('#colour').inputValue(), 'plain');
    assert.deepEqual(await offered(page), ['quality', 'angle', 'plain']);
    assert.ok(await page.locator('#regions').isHidden());
    assert.ok(await page.locator('#toggle-wireframe').isChecked());
    assert.match(await page.locator('#toggles').innerText(), /Generators\s+2\s+Added generators\s+1\s+Wireframe/);
    const all = await picture(page);
    for (const key of ['generators', 'borders']) {
      await page.locator(`#toggle-${key}`).uncheck();
      assert.notEqual(await picture(page), all, key);
      await page.locator(`#toggle-${key}`).check();
    }
    await picture(page, 'third');
    await page.getByText('24 generators').click();
    assert.equal(await page.locator('#toggle-wireframe').isChecked(), false);
    assert.equal(await page.locator('#colour').inputValue(), 'regions');
    await close(page);
  },

  async 'has a slider over the iterations, in their order'() {
    const torus = make_torus(12, 8);
    const page = await open({ page_address: write_page('iterations', { ...torus, iterations: [30, 0, 20, 10] }) });
    const slider = page.getByRole('slider', { name: 'Iteration' }), text = page.locator('#iterations output');
    assert.ok(await page.locator('#scenes').isHidden());
    assert.equal(await text.innerText(), 'Iteration 30 of 30');
    await slider.focus();
    for (const iteration of [20, 10, 0]) {
      await page.keyboard.press('ArrowLeft');
      assert.equal(await text.innerText(), `Iteration ${iteration} of 30`);
      assert.match(await page.locator('#figures').innerText(), new RegExp(`Energy\\s+${iteration}`));
    }
    await page.locator('#reset').click();
    assert.equal(await text.innerText(), 'Iteration 30 of 30');
    await close(page);
  },

  async 'follows the dark colour scheme'() {
    const page = await open({ colorScheme: 'dark' });
    const dark = await picture(page, 'dark');
    await page.emulateMedia({ colorScheme: 'light' });
    assert.notEqual(await picture(page), dark);
    await close(page);
  },

  async 'colours by area, distance, energy, quality and angle, with a legend'() {
    const page = await open();
    assert.deepEqual(await offered(page), ['regions', 'area', 'energy', 'distance', 'quality', 'angle', 'plain']);
    assert.ok(await page.locator('#legend').isHidden());
    const seen = new Set([await picture(page)]);
    const kTitles = { area: 'Area', energy: 'Energy', distance: 'Distance', quality: 'Quality', angle: 'Smallest angle' };
    for (const [key, title] of Object.entries(kTitles)) {
      await page.selectOption('#colour', key);
      const text = await page.locator('#legend').innerText();
      assert.ok(text.startsWith(title), text);
      const ticks = text.split('\n').slice(1).join(' ').replace(/[≤≥]/g, '').trim().split(/\s+/).map(Number), [low] = ticks;
      assert.ok(ticks.length > 1 && ticks.every((tick, i) => i === 0 || tick > ticks[i - 1]), text);
      if (key === 'quality') assert.ok(low > 0.5, text);
      if (key === 'angle') assert.ok(low > 30, text);
      seen.add(await picture(page, key));
    }
    await page.selectOption('#colour', 'plain');
    assert.ok(await page.locator('#legend').isHidden());
    seen.add(await picture(page));
    assert.equal(seen.size, 7);
    await close(page);
  },

  async 'a click pins a region, another one frees it'() {
    const page = await open();
    const pinned = page.locator('#pinned');
    await page.mouse.click(370, 350);
    await settle(page);
    const name = (await pinned.innerText()).match(/Region \d+/)[0];
    await page.mouse.move(480, 200);
    await settle(page);
    assert.ok((await pinned.innerText()).includes(name));
    assert.ok(!(await card(page)).includes(name));
    await picture(page, 'pinned');
    await page.mouse.click(370, 350);
    assert.ok(await pinned.isHidden());
    await page.mouse.click(370, 350);
    await page.locator('#unpin').click();
    assert.ok(await pinned.isHidden());
    await close(page);
  },

  async 'the table of regions sorts and pins'() {
    const page = await open();
    await page.locator('#regions summary').click();
    const table = await settle(page).then(() => page.locator('#region-rows').boundingBox());
    assert.ok(table.y + table.height <= 700, `the table ends at ${table.y + table.height}`);
    const column = (n) => page.locator(`#region-rows tbody tr:not([aria-hidden]) td:nth-child(${n})`).allInnerTexts();
    assert.deepEqual((await column(1)).slice(0, 3).map(Number), [0, 1, 2]);
    await page.locator('th[data-key=area] button').click();
    const areas = (await column(2)).map(Number);
    assert.ok(areas.length > 8);
    assert.deepEqual(areas, areas.slice().sort((a, b) => b - a));
    const [first] = await column(1);
    await page.locator('#region-rows tbody tr:not([aria-hidden])').first().click();
    assert.ok((await page.locator('#pinned').innerText()).includes(`Region ${first.trim()}`));
    await page.locator('#region-rows').evaluate((box) => (box.scrollTop = 1e6));
    await settle(page);
    assert.equal(Math.min(...(await column(2)).map(Number)), Number((await column(2)).at(-1)));
    await picture(page, 'table');
    await close(page);
  },

  async 'saves the picture as PNG, with at least twice the pixels'() {
    const page = await open();
    await page.selectOption('#colour', 'distance');
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#save').click()]);
    assert.equal(download.suggestedFilename(), 'A-sample-of-the-viewer.png');
    const bytes = readFileSync(await download.path());
    assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [2000, 1400]);
    assert.ok(bytes.length > 50000, `${bytes.length} bytes`);
    if (picture_folder) writeFileSync(join(picture_folder, 'saved.png'), bytes);
    await close(page);
  },

  async 'exports clear pictures of print size, curves as SVG, and a turntable'() {
    const page = await open();
    await page.locator('#saving > summary').click();
    const save = async (id) => {
      const [download] = await Promise.all([page.waitForEvent('download', { timeout: 120000 }), page.locator(id).click()]);
      const name = download.suggestedFilename(), bytes = readFileSync(await download.path());
      if (picture_folder) writeFileSync(join(picture_folder, name), bytes);
      return { name, bytes };
    };
    const alphas = (source) => page.evaluate(async (address) => {
      const image = Object.assign(new Image(), { src: address });
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height }), context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const at = (x, y) => context.getImageData(Math.floor(x * image.width), Math.floor(y * image.height), 1, 1).data[3];
      return { size: [image.width, image.height], corner: at(0.01, 0.01), middle: at(0.5, 0.5) };
    }, source);
    const png = await save('#save-png'), of_png = await alphas(`data:image/png;base64,${png.bytes.toString('base64')}`);
    assert.deepEqual(of_png, { size: [4000, 2800], corner: 0, middle: 255 });
    await page.locator('#clear-ground').uncheck();
    await page.selectOption('#picture-size', '2');
    const filled = await save('#save-png');
    assert.deepEqual(await alphas(`data:image/png;base64,${filled.bytes.toString('base64')}`), { size: [2000, 1400], corner: 255, middle: 255 });
    const svg = (await save('#save-svg')).bytes.toString();
    assert.match(svg, /<path id="bisectors" d="M[^"]{2000,}" stroke="#/);
    const all = Number(await page.locator('label:has(#toggle-generators) small').innerText()), dots = svg.match(/<g id="generators".*/)[0].match(/<circle/g).length;
    assert.ok(dots > 0.2 * all && dots < 0.8 * all, `${dots} of ${all} generators in front`);
    const film = await save('#save-film');
    assert.deepEqual([film.name, film.bytes.toString('latin1', 8, 16), film.bytes.toString('latin1').split('ANMF').length], ['A-sample-of-the-viewer.webp', 'WEBPVP8X', 91]);
    const first = await alphas(`data:image/webp;base64,${film.bytes.toString('base64')}`);
    assert.deepEqual([first.size, first.corner], [[640, 448], 255]);
    await close(page);
  },

  async 'shade darkens hollows and the ground, and another axis can point up'() {
    const page = await open({ page_address: write_page('dent', { ...make_torus(60, 24) }) }), shaded = await shot(page, kBeside);
    const pixel = (source, at) => page.evaluate(async ([address, [x, y]]) => {
      const image = Object.assign(new Image(), { src: address });
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height }), context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(x, y, 1, 1).data[1];
    }, [`data:image/png;base64,${source}`, at]);
    await page.locator('#toggle-shadow').uncheck();
    const bare = await shot(page, kBeside);
    const hollow = [355, 268], ground = [355, 492];  // the inner side of the ring, and the ground before it
    for (const at of [hollow, ground]) {
      const [dark, light] = [await pixel(shaded, at), await pixel(bare, at)];
      assert.ok(dark < light - 8, `${at}: ${dark} of ${light}`);
    }
    const flat = (await redraw(page)).tall;
    await page.selectOption('#up', 'z');
    const { tall } = await redraw(page);
    assert.ok(tall > 1.3 * flat, `${tall}, and ${flat} before`);
    await page.locator('#toggle-shadow').check();
    await picture(page, 'up-z');
    await close(page);
  },

  async 'figures are explained by a click'() {
    const page = await open();
    const words = page.getByText('no bisector is missing');
    assert.equal(await words.isVisible(), false);
    await page.getByText('Euler count').click();
    assert.ok(await words.isVisible());
    const text = await words.boundingBox(), panel = await page.locator('#figures').boundingBox();
    assert.ok(text.width > 0.8 * panel.width, `text of ${text.width} pixels in a panel of ${panel.width}`);
    await picture(page, 'words');
    await page.getByText('Euler count').click();
    assert.equal(await words.isVisible(), false);
    await close(page);
  },

  async 'reset brings back how the page opened'() {
    const page = await open(), first = await shot(page, kBeside), panels = await panels_shown(page);
    await page.getByText('60 generators').click();
    await page.locator('#canvas').focus();
    await page.keyboard.press('ArrowLeft');
    await page.selectOption('#colour', 'area');
    await page.locator('#toggle-bisectors').uncheck();
    await page.locator('#figures > summary').click();
    await page.locator('#regions summary').click();
    await page.locator('th[data-key=area] button').click();
    await page.locator('#region-rows').evaluate((box) => (box.scrollTop = 300));
    await page.mouse.click(370, 350);
    assert.ok((await page.evaluate(count_differing, [first, await shot(page, kBeside)])) > 10000);
    await page.locator('#reset').click();
    const last = await shot(page, kBeside);
    assert.ok((await page.evaluate(count_differing, [first, last])) < 20);  // the last bits of the camera
    assert.equal(await page.locator('#colour').inputValue(), 'regions');
    assert.deepEqual(await panels_shown(page), panels);
    await close(page);
  },

  async 'reset ends the motion that is left of a drag'() {
    const viewport = { width: 900, height: 500 };
    const page = await open({ reducedMotion: 'no-preference', viewport }), first = await shot(page, kBeside);
    await page.evaluate(() => {  // in one task, so that no frame comes between the drag and the reset
      const canvas = document.getElementById('canvas');
      canvas.setPointerCapture = canvas.releasePointerCapture = () => {};  // refused without a real pointer
      for (const [type, x, buttons] of [['pointerdown', 300, 1], ['pointermove', 330, 1], ['pointerup', 330, 0]]) {
        canvas.dispatchEvent(new PointerEvent(type, { bubbles: true, pointerType: 'touch', clientX: x, clientY: x - 60, buttons }));
      }
      document.getElementById('reset').click();
    });
    assert.ok((await page.evaluate(count_differing, [first, await shot(page, kBeside)])) < 20);
    await close(page);
  },

  async 'Escape frees the pinned region wherever the focus is'() {
    const page = await open(), pinned = page.locator('#pinned');
    for (const focused of ['#canvas', '#toggle-bisectors', '#save']) {
      await page.mouse.click(370, 350);
      assert.ok(await pinned.isVisible());
      await page.locator(focused).focus();
      await page.keyboard.press('Escape');
      assert.ok(await pinned.isHidden(), focused);
    }
    await close(page);
  },

  async 'a row of the table keeps the focus when it pins its region, and when the table scrolls'() {
    const page = await open();
    await page.getByText('60 generators').click();
    await page.locator('#regions summary').click();
    const focused = () => page.evaluate(() => document.activeElement.closest('tr')?.innerText.split(/\s/)[0]);
    await page.locator('#region-rows tbody tr:not([aria-hidden]) button').nth(2).focus();
    await page.keyboard.press('Enter');
    assert.ok((await page.locator('#pinned').innerText()).includes('Region 2'));
    assert.equal(await focused(), '2');
    for (let label = 3; label < 40; ++label) {
      await page.keyboard.press('Tab');
      await settle_frame(page);
      assert.equal(await focused(), String(label));
    }
    await page.locator('#region-rows').evaluate((box) => (box.scrollTop = 0));
    await settle(page);
    assert.equal(await page.evaluate(() => document.activeElement.id), 'region-rows');
    await close(page);
  },

  async 'hovering draws nothing but the mark'() {
    const page = await open();
    await page.mouse.move(370, 350);
    await settle(page);
    const before = await card(page);
    await draws(page);
    for (const [x, y] of [[300, 300], [420, 250], [350, 450], [30, 400], [370, 350]]) {
      await page.mouse.move(x, y);
      await settle(page);
    }
    assert.deepEqual(await draws(page), []);
    assert.equal(await card(page), before);
    const marked = await page.locator('#mark').evaluate((canvas) => {
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((value, i) => i % 4 === 3 && value > 0).length;
    });
    assert.ok(marked > 1000, `${marked} pixels`);
    await close(page);
  },

  async 'is never blank: neither at the first frame nor when the window changes'() {
    const page = await open();
    const first = await page.evaluate(() => window.first);
    assert.ok(first.share > 0.15, `${first.share} of the first frame`);
    await page.evaluate(() => {
      // An observer made after the page's own runs after it, in the same frame.
      new ResizeObserver(() => (window.after ??= []).push(window.covered().share)).observe(document.getElementById('canvas'));
    });
    for (const width of [900, 800, 1100]) {
      await page.setViewportSize({ width, height: 700 });
      await settle(page);
    }
    const shares = await page.evaluate(() => window.after);
    assert.ok(shares.length >= 3);
    assert.ok(Math.min(...shares.slice(1)) > 0.1, shares.join(' '));
    await close(page);
  },

  async 'dots are as large as the picture makes them'() {
    const page = await open({ page_address: write_dots(400) });
    const near = await count_dot_pixels(page);
    await page.setViewportSize({ width: 740, height: 490 });
    await page.locator('#reset').click();
    const far = await count_dot_pixels(page);
    assert.ok(far > 0 && far < 0.7 * near, `${near} and ${far} pixels`);
    await close(page);
  },

  async 'dots fade where they are dense'() {
    const shares = [];
    for (const step of [400, 1]) {
      const page = await open({ page_address: write_dots(step) });
      shares.push((await count_dot_pixels(page, 40)) / (1000 * 700));
      await close(page);
    }
    const [few, many] = shares;
    assert.ok(few > 0.0005, `${few} of the picture with few dots`);
    assert.ok(many < 0.01, `${many} of the picture with 400 times as many`);
  },

  async 'the axis that the manifest names points up'() {
    for (const up of ['x', 'y', 'z', '-x', '-y', '-z']) {
      const page = await open({ page_address: write_page('cone', { ...make_cone(up), up }) });
      const { tall, below } = await page.evaluate(() => window.first);
      assert.ok(tall > 1.5, `${up}: ${tall} times as high as wide`);
      assert.ok(below > 0.6, `${up}: ${below} of it in the lower half`);
      await close(page);
    }
  },

  async 'a checkerboard shows texture coordinates: half of it is dark, and all within one square'() {
    const quad = { positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], faces: [0, 1, 2, 0, 2, 3] };
    const corners = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0];
    const changed = async (name, texture) => {
      const page = await open({ page_address: write_page(name, { ...quad, texture }) }), before = await shot(page, kBeside);
      await page.locator('#toggle-checker').check();
      const share = (await page.evaluate(count_differing, [before, await shot(page), 8])) / (1000 * 700);
      await picture(page, name);
      await close(page);
      return share;
    };
    const half = (await changed('one-square', corners.map((_, i) => (i % 3 ? 0.03 : 0.1)))) / 2, share = await changed('checker', corners);
    assert.ok(half > 0.05 && Math.abs(share - half) < 0.1 * half, `${share} of the page, and a half is ${half}`);
  },

  async 'large meshes turn with fewer triangles, and rest with all'() {
    const torus = make_torus(1000, 200), page = await open({ page_address: write_page('large', torus) });
    const most = (list) => Math.max(...list);
    await page.mouse.move(370, 350);
    await settle(page);
    await draws(page);
    await page.mouse.down();
    for (let i = 1; i < 5; ++i) await page.mouse.move(370 + 8 * i, 350);
    await settle(page);
    const turning = most(await draws(page));
    await page.mouse.up();
    await settle(page);
    await settle(page);
    const rest = most(await draws(page));
    assert.equal(rest, torus.faces.length);
    assert.ok(turning < rest / 2, `${turning} corners of ${rest}`);
    await close(page);
  },

  async 'leaves a phone on its side to the picture'() {
    const page = await open({ viewport: { width: 780, height: 390 }, hasTouch: true, isMobile: true });
    assert.equal(await page.locator('#toggles').isVisible(), false);
    const { width, height } = await page.locator('aside').boundingBox();
    assert.ok(height < 60 && width > 700, `panels of ${width} x ${height}`);
    const { tall, width: share } = await page.evaluate(() => window.first);
    assert.ok(share * 780 * tall > 0.6 * 390);
    await picture(page, 'touch-side');
    await close(page);
  },

  async 'shows the card of a pinned region above the buttons, on the narrowest phone too'() {
    for (const width of [280, 320, 390]) {
      const page = await open({ viewport: { width, height: 568 }, hasTouch: true, isMobile: true });
      await page.touchscreen.tap(width / 2, 280);
      await settle(page);
      const card = await page.locator('#pinned').boundingBox(), buttons = await page.locator('aside').boundingBox();
      assert.ok(card.y + card.height <= buttons.y, `${width}: the card ends at ${card.y + card.height}, of ${buttons.y}`);
      await close(page);
    }
  },

  async 'opens a panel below a wide picture on an upright phone, and gives the picture the room of a closed one'() {
    const wide = make_torus(60, 24), page = await open({ page_address: write_page('wide', wide), viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    assert.ok(await page.locator('#toggles').isVisible());
    const before = await page.evaluate(() => window.first.below);
    assert.ok(before < 0.2, `${before} of it in the lower half`);
    await page.locator('#show > summary').tap();
    await page.locator('#toggle-shadow').evaluate((box) => box.click());
    await settle(page);
    const { below } = await redraw(page);
    assert.ok(below > before + 0.1, `${before}, then ${below}`);
    await picture(page, 'touch-wide');
    await close(page);
  },

  async 'works by touch on a narrow screen, and uses all of its width'() {
    const viewport = { width: 390, height: 780 };
    const page = await open({ viewport, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    const first = await page.evaluate(() => window.first);
    assert.ok(first.width > 0.7, `${first.width} of the width`);
    assert.equal(await page.locator('#toggles').isVisible(), false);
    await page.touchscreen.tap(195, 400);
    await settle(page);
    assert.match(await page.locator('#pinned').innerText(), /Region \d+/);
    await picture(page, 'touch');
    await page.locator('#show summary').tap();
    assert.ok(await page.locator('#toggles').isVisible());
    await picture(page, 'touch-open');
    await page.locator('#figures > summary').tap();
    await settle(page);
    assert.equal(await page.locator('#toggles').isVisible(), false);
    await page.locator('#figures > summary').tap();
    await page.getByText('A remesh').tap();
    await page.touchscreen.tap(195, 360);
    await settle(page);
    assert.match(await card(page), /Face \d+/);
    await page.touchscreen.tap(195, 110);
    await settle(page);
    assert.ok(await page.locator('#region').isHidden());
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
