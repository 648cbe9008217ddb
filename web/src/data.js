// The page's own data: a manifest, and arrays in base64 that it refers to.

const kTypes = { f32: Float32Array, u8: Uint8Array, u16: Uint16Array, u32: Uint32Array };

export function read_manifest() {
  return JSON.parse(document.getElementById('manifest').textContent);
}

function decode_base64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

// The array that a manifest entry {blob, type, count} refers to; empty where there is none.
export function read_array(reference) {
  if (!reference) return new Float32Array(0);
  const bytes = decode_base64(document.getElementById(`blob-${reference.blob}`).textContent);
  return new kTypes[reference.type](bytes.buffer, bytes.byteOffset, reference.count);
}
