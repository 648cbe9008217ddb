// The mark of the region or face under the pointer: a canvas of its own over the picture, so that the surface is not drawn again.

const kLight = [255, 255, 255, 84];  // of the region
const kEdge = [20, 24, 30, 230];     // of its border
const kRing = 7;                     // radius of the ring round a vertex, CSS pixels

export class HoverMark {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.marked = -1;
  }

  // Marks the pixels of `map` (an IdMap) that have `code`, none where it is negative; or the vertex at `place`.
  show(map, code, place = null) {
    const key = place ? `${place.x} ${place.y}` : code;
    if (key === this.marked) return;
    this.clear();
    if (code < 0) return;
    this.marked = key;
    [this.canvas.width, this.canvas.height] = [map.width, map.height];
    if (place) this.ring(place);
    else this.fill(map, code);
  }

  ring({ x, y }) {
    for (const [width, [red, green, blue]] of [[5, kLight], [2.5, kEdge]]) {
      this.context.lineWidth = width;
      this.context.strokeStyle = `rgb(${red}, ${green}, ${blue})`;
      this.context.beginPath();
      this.context.arc(x, y, kRing, 0, 2 * Math.PI);
      this.context.stroke();
    }
  }

  fill(map, code) {
    const { width, height } = map;
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
    if (this.marked === -1) return;
    this.marked = -1;
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
  }
}
