// Bundles src/ into the page that --view writes: node build.mjs [OUTPUT].
import { writeFileSync } from 'node:fs';
import { bundle, fill_page, read } from './bundle.mjs';

const page = await fill_page(read('src/page.html'), await bundle('src/view.js'), await bundle('src/style.css'));
for (const mark of ['<!--gvd:title-->', '<!--gvd:data-->']) {
  if (page.split(mark).length !== 2) throw new Error(`the page must contain ${mark} once`);
}
writeFileSync(process.argv[2] ?? 'viewer.html', page);
