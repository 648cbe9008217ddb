// Pages as users open them, in Chromium and Firefox, from disk and over HTTP: node pages.test.mjs FOLDER PAGE.html ...
//
// FOLDER is served at 127.0.0.1; the pages lie in it. In the playground, a generator is dragged by the mouse.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { basename, join, relative, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { kNoDrawing, launch_chromium, launchers } from './browsers.mjs';

const [folder, ...pages] = process.argv.slice(2).map((path) => resolve(path));
const kViewport = { width: 1280, height: 800 };
const kPanels = 300;  // pixels at the right that the panels cover
const kPatience = 60000;
const kColourful = 15;  // between the channels of a pixel; those of the ground differ by less than 6
const kLeastDrawn = 0.03;  // of the picture; an empty canvas has no colourful pixel
const kPictures = process.env.GVD_PICTURES;  // a folder for what the pages look like

async function serve() {
  const asked = new Set();
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://127.0.0.1').pathname);
    asked.add(path);
    const file = pages.find((page) => `/${relative(folder, page)}` === path);
    response.writeHead(file ? 200 : 404, { 'Content-Type': 'text/html' }).end(file && readFileSync(file));
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const address = (file) => `http://127.0.0.1:${server.address().port}/${relative(folder, file).split('/').map(encodeURIComponent).join('/')}`;
  return { asked, address, close: () => server.close() };
}

// A page that notes what must not happen.
async function open(browser, address) {
  const context = await browser.newContext({ viewport: kViewport });
  const page = await context.newPage();
  page.faults = [];
  page.on('console', (message) => message.type() === 'error' && page.faults.push(message.text()));
  page.on('pageerror', (error) => page.faults.push(String(error)));
  await page.addInitScript(() => {
    window.violations = [];
    addEventListener('securitypolicyviolation', (event) => window.violations.push(`${event.violatedDirective}: ${event.blockedURI} ${event.sample}`));
  });
  await page.goto(address);
  return page;
}

// Closes a page on which nothing that must not happen has happened.
async function close(page) {
  const violations = await page.evaluate(() => window.violations);
  assert.deepEqual(violations, [], 'the page breaks its own security policy');
  assert.deepEqual(page.faults, [], 'an error in the console');
  await page.context().close();
}

async function wait_until_ready(page) {
  await page.waitForSelector(':root[data-ready], #failure:not([hidden])', { state: 'attached', timeout: kPatience });
  const failure = await page.evaluate(() => (failure.hidden ? '' : failure.textContent));
  assert.equal(failure, '');
  await settle(page);
}

// Waits until nothing is computed or shaded, and what was asked for is drawn.
const settle = (page) =>
  page.evaluate(async () => {
    const root = document.documentElement, busy = () => root.dataset.computing === 'true' || 'shading' in root.dataset || 'quick' in root.dataset;
    for (const pause of [250, 100]) {
      await new Promise((done) => setTimeout(done, pause));
      while (busy()) await new Promise((done) => setTimeout(done, 20));
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    }
  });

// The pixels left of the panels, of what the browser shows.
async function see(page, name) {
  const options = kPictures && name ? { path: join(kPictures, `${name}.png`) } : {};
  const source = (await page.screenshot(options)).toString('base64');
  return page.evaluate(async ([source, panels, least]) => {
    const image = new Image();
    image.src = `data:image/png;base64,${source}`;
    await image.decode();
    const width = image.width - panels, { height } = image, canvas = Object.assign(document.createElement('canvas'), { width, height });
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    window.seen = [...(window.seen ?? []), data].slice(-2);
    let colourful = 0;
    for (let i = 0; i < data.length; i += 4) colourful += Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > least;
    return colourful / (width * height);
  }, [source, kPanels, kColourful]);
}

// How many pixels differ between the last two pictures seen.
const count_changed = (page) =>
  page.evaluate(() => {
    const [before, after] = window.seen;
    let changed = 0;
    for (let i = 0; i < after.length; i += 4) changed += [0, 1, 2].some((k) => Math.abs(before[i + k] - after[i + k]) > 8);
    return changed;
  });

const options = (page, id) => page.evaluate((id) => [...document.getElementById(id).options].map(({ text }) => text), id);
const rows = (page, id) => page.evaluate((id) => [...document.querySelectorAll(`#${id} tbody tr`)].map((row) => row.textContent), id);

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let i = 1; i <= 8; ++i) await page.mouse.move(...from.map((x, k) => x + (i / 8) * (to[k] - x)));
  await page.mouse.up();
  await settle(page);
}

async function expect_drawn(page, name, what) {
  const share = await see(page, name);
  assert.ok(share > kLeastDrawn, `${what} is drawn: ${(100 * share).toFixed(1)} % are colourful`);
}

// Every scene of a page is drawn, a drag turns the surface, and the figures are there.
async function use_viewer(page, { name, briefly }) {
  await wait_until_ready(page);
  assert.ok((await options(page, 'colour')).length >= 1, 'the menu of colours is filled');
  assert.ok((await rows(page, 'figures')).length >= 3, 'the figures are there');
  await expect_drawn(page, name, 'the first scene');
  if (briefly) return;
  const scenes = page.locator('#scenes:not([hidden]) label');
  for (let i = 1; i < (await scenes.count()); ++i) {
    await scenes.nth(i).click();
    await settle(page);
    await expect_drawn(page, `${name}-${i}`, `scene ${i}`);
  }
  await see(page);
  await drag(page, [500, 700], [620, 660]);
  await see(page);
  assert.ok((await count_changed(page)) > 5000, 'a drag turns the surface');
}

// The generators in the page's address.
const generators = async (page) => new URLSearchParams((await page.evaluate(() => location.hash)).slice(1)).get('g')?.split('~') ?? [];

// The diagram as the panels describe it.
const describe = async (page) => ({ figures: await rows(page, 'figures'), regions: await rows(page, 'region-rows') });

async function use_playground(page, { name, briefly, browser }) {
  await wait_until_ready(page);
  assert.deepEqual(await options(page, 'play-model'), ['Figure', 'Torus', 'Half sphere', 'Your own file …', '']);
  assert.equal((await options(page, 'play-show')).length, 4);
  assert.ok((await options(page, 'play-save')).length >= 5);
  await expect_drawn(page, name, 'the surface');

  await page.selectOption('#play-model', 'torus.ply');
  await settle(page);
  const [from, to] = [[240, 400], [200, 330]];
  await page.mouse.click(...from);  // adds a generator
  await settle(page);
  const before = { generators: await generators(page), ...(await describe(page)) };
  assert.equal(before.generators.length, 31);
  await see(page, `${name}-before`);
  await drag(page, from, to);
  const after = { generators: await generators(page), ...(await describe(page)) };
  await see(page, `${name}-after`);
  assert.deepEqual(after.generators.slice(0, -1), before.generators.slice(0, -1), 'the others stay');
  assert.notEqual(after.generators.at(-1), before.generators.at(-1), 'the one under the mouse has moved');
  assert.notDeepEqual(after.figures, before.figures, 'the diagram is another one');
  assert.notDeepEqual(after.regions, before.regions, 'the cells are others');
  assert.ok((await count_changed(page)) > 2000, 'and so is the picture');

  await page.keyboard.press('Escape');
  await page.mouse.click(...to);  // selects what is there: where nothing is, one would be added
  await settle(page);
  assert.match(await page.textContent('#pinned'), /Region 30/, 'the generator is where the mouse has left it');
  assert.equal((await generators(page)).length, 31);
  if (briefly) return;

  await page.keyboard.press('Escape');
  const fresh = await open(browser, await page.evaluate(() => location.href));
  await wait_until_ready(fresh);
  assert.deepEqual(await describe(fresh), { figures: after.figures, regions: after.regions }, 'a new page of the same link has the same diagram');
  await close(fresh);

  for (const show of ['equal', 'distances', 'remesh']) {
    await page.selectOption('#play-show', show);
    await settle(page);
    assert.notDeepEqual(await rows(page, 'figures'), after.figures, show);
    await see(page, `${name}-${show}`);
    assert.ok((await count_changed(page)) > 5000, `${show} is drawn`);
  }
}

// The page of a cohort: its pictures are there, and each leads to a page that works.
async function use_cohort(page, { name }) {
  const pictures = page.locator('figure img');
  assert.ok((await pictures.count()) >= 3);
  assert.deepEqual(await page.evaluate(() => [...document.images].filter((image) => !image.complete || !image.naturalWidth).length), 0);
  await see(page, name);
  await pictures.first().click();
  await wait_until_ready(page);
  await expect_drawn(page, `${name}-result`, 'a result');
}

const kKinds = { 'index.html': use_playground, 'playground.html': use_playground, 'cohort.html': use_cohort };
const use_of = (file) => kKinds[basename(file)] ?? use_viewer;
const listed = pages.filter((page) => basename(page) !== 'page.html');  // those of a cohort are reached through its own
const one_of_each = listed.filter((file, i) => i === listed.findIndex((other) => use_of(other) === use_of(file)));

let failures = 0;
function fail(text) {
  ++failures;
  console.log(`FAILED ${text}`);
}

// From disk all of each page is used, and over HTTP, from one page of each kind, what a server can change.
async function use_pages(name, launch, server) {
  const browser = await launch();
  for (const [place, files, address, briefly] of [['disk', listed, (file) => pathToFileURL(file).href, false],
                                                  ['HTTP', one_of_each, server.address, true]]) {
    for (const file of files) {
      const begin = Date.now(), what = `${relative(folder, file)} from ${place} in ${name} ${browser.version()}`;
      const page = await open(browser, address(file));
      try {
        await use_of(file)(page, { name: `${name}-${place}-${basename(file, '.html')}`, briefly, browser });
        await close(page);
        console.log(`ok     ${what} (${((Date.now() - begin) / 1000).toFixed(1)} s)`);
      } catch (error) {
        fail([what, error.stack, ...page.faults].join('\n'));
        await page.context().close();
      }
    }
  }
  await browser.close();
}

// Where a browser can't draw, the page says what to do.
async function open_without_drawing(file) {
  const browser = await launch_chromium(kNoDrawing);
  const page = await open(browser, pathToFileURL(file).href);
  try {
    await page.waitForSelector('#failure:not([hidden])', { timeout: kPatience });
    assert.match(await page.textContent('#failure'), /can't (be drawn|compute): the browser has no WebGL 2 here\. Turn on hardware acceleration/);
    console.log('ok     a browser without WebGL');
  } catch (error) {
    fail(`a browser without WebGL\n${error.stack}`);
  }
  await browser.close();
}

const server = await serve();
await Promise.all(Object.entries(launchers).map(([name, launch]) => use_pages(name, launch, server)));
await open_without_drawing(listed.find((file) => basename(file) !== 'cohort.html'));
server.close();
const known = new Set(pages.map((page) => `/${relative(folder, page)}`));
const others = [...server.asked].filter((path) => !known.has(path));
if (others.length) fail(`the pages ask for ${others.join(', ')}`);
process.exit(failures ? 1 : 0);
