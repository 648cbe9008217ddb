// Bundles the playground into one page: node build_playground.mjs PACKAGE OUTPUT MODEL ...
//
// PACKAGE is the npm package. The page holds the worker, the module and the models, deflated: it works from
// disk without a server.
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { bundle, fill_page, pack, read } from './bundle.mjs';

const [folder, output, ...models] = process.argv.slice(2);
const { version } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
const packed = (id, bytes) => `<script type="application/octet-stream" id="${id}">${pack(bytes)}</script>\n`;

const load = new URL('src/playground/load.js', import.meta.url).pathname;  // in place of the package's
// A page from a disk may start no module as a worker, and scripts can't await outside of functions, as the package does.
const in_function = (code) => `(async()=>{${code}})()`;
const worker = in_function(await bundle('src/playground/worker.js', {
  format: 'esm',
  target: 'es2022',
  alias: { gvd: resolve(folder, 'index.mjs') },
  plugins: [{ name: 'load', setup: (build) => build.onResolve({ filter: /^\.\/load\.mjs$/ }, () => ({ path: load })) }],
  define: { 'import.meta.url': '"file:///"' },  // where the module would look for its bytes, which it is given
}));
const data = [
  packed('worker', worker),
  packed('module', readFileSync(`${folder}/gvd.wasm`)),
  ...models.map((file) => packed(`model-${basename(file)}`, readFileSync(file))),
];

const page = read('src/page.html')
  .replace("script-src 'unsafe-inline'", "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:")
  .replace('<meta charset="utf-8">', `$&\n<meta name="generator" content="gvd ${version}">`)
  .replace('<aside>', () => `<aside>${read('src/playground/panel.html').replace('<!--gvd:version-->', version)}`)
  .replace('<div id="notes">', '$&\n<output id="play-message" class="card" hidden aria-live="polite"></output>')
  .replace('<!--gvd:title-->', 'Geodesic Voronoi diagrams in the browser')
  .replace('<!--gvd:data-->', () => data.join(''));
const style = `${await bundle('src/style.css')}\n${await bundle('src/playground/playground.css')}`;
writeFileSync(output, await fill_page(page, await bundle('src/playground/start.js'), style));
