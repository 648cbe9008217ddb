// The page's own data: a manifest, and arrays that it refers to, deflated and in base64.

const kTypes = { f32: Float32Array, u8: Uint8Array, u16: Uint16Array, u32: Uint32Array };
const blobs = new Map();  // bytes, by id of the element

export function read_manifest() {
  return JSON.parse(document.getElementById('manifest').textContent);
}

// Unpacks the arrays of all elements whose id starts with `blob-`, which are empty then.
export async function load_arrays() {
  const load = async (element) => {
    const text = element.textContent;
    element.textContent = '';
    blobs.set(element.id, new Uint8Array(await unpack(text)));
  };
  await Promise.all(Array.from(document.querySelectorAll('[id^="blob-"]'), load));
}

// The bytes that are deflated and in base64.
export function unpack(text) {
  const unpacked = new Blob([fetch_base64(text)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(unpacked).arrayBuffer();
}

function fetch_base64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text), bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// Numbers that are stored as differences from the number `step` before, with the sign in the lowest bit: all lowest bytes
// first, then the next ones.
export function sum_steps(bytes, { count, step, unit }) {
  const sums = new Float32Array(count), before = new Array(step).fill(0), width = count ? bytes.length / count : 0;
  for (let i = 0; i < count; ++i) {
    let value = 0;
    for (let k = width - 1; k >= 0; --k) value = 256 * value + bytes[k * count + i];
    before[i % step] += value % 2 ? -(value + 1) / 2 : value / 2;
    sums[i] = before[i % step] * unit;
  }
  return sums;
}

// The array that a manifest entry {blob, type, count, unit, step} refers to, or that is given in its place; empty where
// there is none.
export function read_array(reference) {
  if (!reference) return new Float32Array(0);
  if (ArrayBuffer.isView(reference)) return reference;
  return decode(blobs.get(`blob-${reference.blob}`), reference);
}

// The numbers of a reference from its bytes.
export function decode(bytes, { type, count, unit, step }) {
  if (step) return sum_steps(bytes, { count, step, unit });
  const numbers = new kTypes[type](bytes.buffer, 0, count);
  return unit ? Float32Array.from(numbers, (value) => value * unit) : numbers;
}

// The length of that array.
export const count_of = (reference) => reference?.count ?? reference?.length ?? 0;
