// Scenes of the worker as the viewer reads them: with their arrays in place of the references.
//
// A page names its arrays by number. Here the name tells the content, so that what was made of a mesh is found again
// when only its regions change.
import { decode } from '../data.js';

// A hash of the bytes and their number (FNV-1a).
function name_of(bytes) {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return `${bytes.length}-${hash >>> 0}`;
}

let last = new Map();  // the arrays of the last mesh, by name

// The manifest of an answer {manifest, blobs}. The arrays of its meshes have the name of their content as `blob`, and are
// those of the answer before where they are the same.
export function with_arrays({ manifest, blobs }) {
  const now = new Map();
  const found = JSON.parse(manifest, (key, value) => {
    if (value === null || typeof value !== 'object' || value.blob === undefined) return value;
    const bytes = blobs[value.blob];
    if (key !== 'positions' && key !== 'faces') return decode(bytes, value);
    const name = name_of(bytes), array = last.get(name) ?? Object.assign(decode(bytes, value), { blob: name });
    now.set(name, array);
    return array;
  });
  last = now;
  return found;
}
