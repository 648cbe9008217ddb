// Saves a canvas as a PNG file.

// A name that every file system takes.
export function file_name(title) {
  const name = title.replace(/[^\p{L}\p{N}._-]+/gu, '-').replace(/^[-.]+|[-.]+$/g, '');
  return `${name || 'picture'}.png`;
}

export function save_canvas(canvas, title) {
  canvas.toBlob((blob) => {
    const address = URL.createObjectURL(blob);
    const link = Object.assign(document.createElement('a'), { href: address, download: file_name(title) });
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
  }, 'image/png');
}
