// Bundles src/ into one page: node build.mjs [OUTPUT].
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { build } from 'esbuild';

const read = (path) => readFileSync(new URL(path, import.meta.url), 'utf8');

async function bundle(entry) {
  const result = await build({
    entryPoints: [new URL(entry, import.meta.url).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2021',
    charset: 'utf8',
    legalComments: 'none',
  });
  return result.outputFiles[0].text;
}

const licence = read('node_modules/three/LICENSE').trim();
const version = JSON.parse(read('node_modules/three/package.json')).version;
const notice = `\nThis page contains three.js ${version}, https://threejs.org\n\n${licence}\n`;
const program = deflateSync(await bundle('src/main.js'), { level: 9 }).toString('base64');
const loader = await bundle('src/loader.js');
const style = await bundle('src/style.css');

// Strings that would end the element or the comment early, or be mistaken for the mark of the data.
for (const mark of ['</script', '<!--', '-->']) {
  if (loader.includes(mark) || notice.includes(mark)) throw new Error(`the bundle contains ${mark}`);
}

const page = read('src/page.html')
  .replace('/*style*/', () => style.trim())
  .replace('/*licence*/', () => notice)
  .replace('/*program*/', () => program)
  .replace('/*loader*/', () => loader.trim());
for (const mark of ['<!--gvd:title-->', '<!--gvd:data-->']) {
  if (page.split(mark).length !== 2) throw new Error(`the page must contain ${mark} once`);
}
writeFileSync(process.argv[2] ?? 'viewer.html', page);
