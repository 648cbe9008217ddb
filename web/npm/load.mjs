// The bytes of the module, in Node.js and in browsers. A page in one file has them inside instead (web/build_playground.mjs).
const url = new URL('gvd.wasm', import.meta.url);

async function fetchBytes() {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

const isFile = url.protocol === 'file:' && typeof process === 'object';
export default isFile ? await (await import('node:fs/promises')).readFile(url) : await fetchBytes();
