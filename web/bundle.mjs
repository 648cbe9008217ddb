// What both pages are built with: bundles of src/, and the page filled with them.
import { readFileSync } from 'node:fs';
import { deflateSync } from 'node:zlib';
import { build } from 'esbuild';

export const read = (path) => readFileSync(new URL(path, import.meta.url), 'utf8');
export const pack = (bytes) => deflateSync(bytes, { level: 9 }).toString('base64');

export async function bundle(entry, options = {}) {
  const result = await build({
    entryPoints: [new URL(entry, import.meta.url).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2021',
    charset: 'utf8',
    legalComments: 'none',
    ...options,
  });
  return result.outputFiles[0].text;
}

// The page with its style and program, and the licence of what the program contains.
export async function fill_page(page, program, style) {
  const licence = read('node_modules/three/LICENSE').trim(), { version } = JSON.parse(read('node_modules/three/package.json'));
  const notice = `\nThis page contains three.js ${version}, https://threejs.org\n\n${licence}\n`;
  const loader = await bundle('src/loader.js');
  // Strings that would end the element or the comment early, or be mistaken for the mark of the data.
  for (const mark of ['</script', '<!--', '-->']) {
    if (loader.includes(mark) || notice.includes(mark)) throw new Error(`the bundle contains ${mark}`);
  }
  return page
    .replace('/*style*/', () => style.trim())
    .replace('/*licence*/', () => notice)
    .replace('/*program*/', () => pack(program))
    .replace('/*loader*/', () => loader.trim());
}
