// Takes pictures of pages of the viewer: node make_pictures.mjs PAGE_FOLDER PICTURE_FOLDER [LIST]. LIST is a module like
// pictures.mjs, which has the pictures of the documents; those whose page is not there are left out of another list.
// CHROMIUM names another browser than /usr/bin/chromium. The same browser makes the same bytes.
import { existsSync, mkdirSync, statSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const kLargest = 120000;  // bytes of one picture
const kQuality = 0.86;    // of the WebP encoder
const kBare = 'header, aside, #notes, #hint { display: none !important } canvas:focus-visible { outline: none !important }';
const kArrows = { left: 'ArrowLeft', right: 'ArrowRight', up: 'ArrowUp', down: 'ArrowDown' };

const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const [page_folder, picture_folder, list] = process.argv.slice(2);
if (!picture_folder) throw new Error('usage: node make_pictures.mjs PAGE_FOLDER PICTURE_FOLDER [LIST]');
const { kPictures, kWidth } = await import(
  list ? pathToFileURL(resolve(list)).href : new URL('pictures.mjs', import.meta.url).href
);
const has_page = ({ page }) => !list || existsSync(join(page_folder, `${page}.html`));
if (!existsSync(executablePath)) throw new Error(`no browser at ${executablePath} (set CHROMIUM)`);

const browser = await chromium.launch({
  executablePath,
  args: ['--no-sandbox', '--disable-gpu', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
         '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

// Waits until the surface rests, its shade is made and everything requested is drawn.
const settle = (page) =>
  page.evaluate(async () => {
    for (const pause of [0, 250, 50]) {
      await new Promise((done) => setTimeout(done, pause));
      while ('shading' in document.documentElement.dataset) await new Promise((done) => setTimeout(done, 20));
      for (let i = 0; i < 2; ++i) await new Promise(requestAnimationFrame);
    }
  });

// In the page: chooses an entry of a list, which a closed panel may hide.
function choose(select, value) {
  select.value = value;
  select.dispatchEvent(new Event('change'));
}

async function press(page, key, times) {
  await page.locator('#canvas').focus();
  for (let i = 0; i < times; ++i) await page.keyboard.press(key);
}

// Turns and zooms the surface and sets the switches as the picture asks for, with the page's own keys and switches.
async function arrange(page, { scene, turn = {}, zoom = 0, pan, show = {}, colour, hover, whole_page }) {
  if (scene) await page.getByText(scene, { exact: true }).click();
  if (colour) await page.locator('#colour').evaluate(choose, colour);
  for (const [key, on] of Object.entries(show)) {
    await page.locator(`#toggle-${key}`).evaluate((box, wanted) => box.checked === wanted || box.click(), on);
  }
  if (!whole_page) {
    await page.addStyleTag({ content: kBare });
    await press(page, '0', 1);  // into the room that the panels leave
  }
  for (const [side, times] of Object.entries(turn)) await press(page, kArrows[side], times);
  await press(page, zoom < 0 ? '-' : '+', Math.abs(zoom));
  if (pan) {
    await page.mouse.move(...pan.from);
    await page.mouse.down({ button: 'right' });
    await page.mouse.move(...pan.to, { steps: 4 });
    await page.mouse.up({ button: 'right' });
    await page.locator('#canvas').dispatchEvent('pointerleave', { pointerType: 'mouse' });  // no region is highlighted
  }
  if (hover) await page.mouse.move(...hover);
}

async function screenshot(picture) {
  const [width, height] = picture.size;
  const deviceScaleFactor = kWidth / Math.min(width, kWidth);
  const page = await browser.newPage({ viewport: { width, height }, deviceScaleFactor, reducedMotion: 'reduce' });
  await page.goto(pathToFileURL(resolve(page_folder, `${picture.page}.html`)).href);
  await page.waitForSelector('html[data-ready]', { timeout: 60000 });
  await arrange(page, picture);
  await page.evaluate(() => document.activeElement.blur());
  await settle(page);
  const png = await page.screenshot();
  await page.close();
  return png;
}

// The browser encodes WebP itself, so no program for pictures is needed.
async function encode_webp(png) {
  const page = await browser.newPage();
  const encoded = await page.evaluate(
    async ([source, quality]) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
      canvas.getContext('2d').drawImage(image, 0, 0);
      return canvas.toDataURL('image/webp', quality);
    },
    [`data:image/png;base64,${png.toString('base64')}`, kQuality],
  );
  await page.close();
  return Buffer.from(encoded.slice(encoded.indexOf(',') + 1), 'base64');
}

mkdirSync(picture_folder, { recursive: true });
for (const picture of kPictures.filter(has_page)) {
  const png = await screenshot(picture);
  if (process.env.KEEP_PNG) writeFileSync(join(process.env.KEEP_PNG, `${picture.name}.png`), png);
  const file = join(picture_folder, `${picture.name}.webp`);
  writeFileSync(file, await encode_webp(png));
  const { size } = statSync(file);
  console.log(`  ${file}  ${size} bytes`);
  if (size > kLargest) throw new Error(`${file} has more than ${kLargest} bytes`);
}
await browser.close();
