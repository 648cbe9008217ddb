// Saves files.

// A name that every file system takes.
export function file_name(title, ending = 'png') {
  const name = title.replace(/[^\p{L}\p{N}._-]+/gu, '-').replace(/^[-.]+|[-.]+$/g, '');
  return `${name || 'picture'}.${ending}`;
}

export function save_blob(blob, name) {
  const address = URL.createObjectURL(blob);
  Object.assign(document.createElement('a'), { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
}

export const encode_canvas = (canvas, type, quality) => new Promise((done) => canvas.toBlob(done, type, quality));

// Puts a colour behind what a canvas shows.
export function fill_behind(canvas, colour) {
  const context = canvas.getContext('2d');
  context.resetTransform();
  context.globalCompositeOperation = 'destination-over';
  context.fillStyle = colour;
  context.fillRect(0, 0, canvas.width, canvas.height);
}
