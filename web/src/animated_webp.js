// An animated WebP file of still ones.
// Source: WebP Container Specification, Google; a browser encodes the stills.

const kAnimated = 0x02, kAlpha = 0x10, kReplace = 0x02;  // flags of the file and of a frame
const kFrameParts = ['ALPH', 'VP8 ', 'VP8L'];

const text = (name) => [...name].map((letter) => letter.charCodeAt(0));
const little = (value, bytes) => Array.from({ length: bytes }, (_, i) => Math.floor(value / 256 ** i) & 255);

function join(parts) {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  parts.reduce((at, part) => (all.set(part, at), at + part.length), 0);
  return all;
}

function chunk(name, ...parts) {
  const content = join(parts);
  return join([text(name), little(content.length, 4), content, new Uint8Array(content.length % 2)]);
}

// The chunks of a still picture that a frame takes over, with their heads.
function frame_chunks(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset), kept = [];
  for (let at = 12; at + 8 <= bytes.length; ) {
    const size = view.getUint32(at + 4, true), end = at + 8 + size + (size % 2);
    if (kFrameParts.includes(String.fromCharCode(...bytes.subarray(at, at + 4)))) kept.push(bytes.subarray(at, end));
    at = end;
  }
  return join(kept);
}

// `stills`: WebP files of the same size, Uint8Array each; `pause`: milliseconds that each is shown. The film has no end.
export function animate_webp(stills, { width, height, pause }) {
  const size = [...little(width - 1, 3), ...little(height - 1, 3)];
  const frames = stills.map((bytes) => chunk('ANMF', little(0, 6), size, little(pause, 3), [kReplace], frame_chunks(bytes)));
  const head = [chunk('VP8X', [kAnimated | kAlpha], little(0, 3), size), chunk('ANIM', little(0, 4), little(0, 2))];
  return chunk('RIFF', text('WEBP'), ...head, ...frames);
}
