// The mark of the region under the pointer: a canvas of its own over the picture, so that the surface is not drawn again.

const kLight = [255, 255, 255, 84];  // of the region
const kEdge = [20, 24, 30, 230];     // of its border

export class HoverMark {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.marked = -1;
  }

  // Marks the pixels of `map` (an IdMap) that have `code`; none where it is negative.
  show(map, code) {
    if (code === this.marked) return;
    this.clear();
    if (code < 0) return;
    this.marked = code;
    const { width, height } = map;
    [this.canvas.width, this.canvas.height] = [width, height];
    const image = this.context.createImageData(width, height);
    for (let y = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x) {
        if (map.code(x, y) !== code) continue;
        const inside =
          x > 0 && y > 0 && x + 1 < width && y + 1 < height && map.code(x - 1, y) === code &&
          map.code(x + 1, y) === code && map.code(x, y - 1) === code && map.code(x, y + 1) === code;
        image.data.set(inside ? kLight : kEdge, 4 * (width * y + x));
      }
    }
    this.context.putImageData(image, 0, 0);
  }

  clear() {
    if (this.marked < 0) return;
    this.marked = -1;
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
  }
}
