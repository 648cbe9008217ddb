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

// The manifest of an answer {manifest, blobs}. Each of its arrays has the name of its content as `blob`.
export function with_arrays({ manifest, blobs }) {
  return JSON.parse(manifest, (_, value) => {
    if (value === null || typeof value !== 'object' || value.blob === undefined) return value;
    const bytes = blobs[value.blob];
    return Object.assign(decode(bytes, value), { blob: name_of(bytes) });
  });
}
