// What each pixel of the canvas shows. The graphics card draws it once after the camera has moved, so looking under the
// pointer draws nothing.
import { NearestFilter, RGBAIntegerFormat, Scene, UnsignedIntType, WebGLRenderTarget } from 'three';
import { make_pick_material } from './materials.js';

export class IdMap {
  constructor(stage) {
    this.stage = stage;
    this.scene = new Scene();
    this.scene.overrideMaterial = make_pick_material();
    this.fresh = false;
    this.target = new WebGLRenderTarget(1, 1, {
      format: RGBAIntegerFormat,
      type: UnsignedIntType,
      internalFormat: 'RGBA32UI',
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
  }

  // To be called when the camera, the size or the surface has changed.
  invalidate() {
    this.fresh = false;
  }

  // Draws the surface's codes and distances, one pixel for each CSS pixel of the canvas. Where the faces of the triangles
  // are given, each pixel has its face in place of the code.
  update(surface, faces = null) {
    if (this.fresh) return;
    const { renderer, camera, width, height } = this.stage;
    const parent = surface.parent;
    this.target.setSize(width, height);
    this.scene.add(surface);
    renderer.setRenderTarget(this.target);
    renderer.render(this.scene, camera);
    const pixels = new Uint32Array(4 * width * height);
    renderer.readRenderTargetPixels(this.target, 0, 0, width, height, pixels);
    renderer.setRenderTarget(null);
    parent.add(surface);
    if (faces) for (let i = 0; i < pixels.length; i += 4) pixels[i + 1] = faces[pixels[i + 3]];
    [this.width, this.height, this.pixels, this.fresh] = [width, height, pixels, true];
  }

  index(x, y) {
    return 4 * (this.width * (this.height - 1 - y) + x);
  }

  // The code at a pixel, which must be in the canvas; -1 where there is no surface.
  code(x, y) {
    const at = this.index(x, y);
    return this.pixels[at] !== 0 ? this.pixels[at + 1] : -1;
  }

  // The largest distance of the surface from the eye's plane at a point of the canvas and the pixels round it.
  depth(x, y) {
    const depths = new Float32Array(this.pixels.buffer), { width, height } = this;
    let most = 0;
    for (let i = Math.max(0, Math.floor(x) - 1); i <= Math.min(width - 1, Math.floor(x) + 1); ++i) {
      for (let j = Math.max(0, Math.floor(y) - 1); j <= Math.min(height - 1, Math.floor(y) + 1); ++j) {
        most = Math.max(most, depths[this.index(i, j)] || Infinity);  // beside the surface nothing is hidden
      }
    }
    return most;
  }

  // The surface at a point of the canvas in CSS pixels: {code, distance}, or null where there is none.
  at(x, y) {
    [x, y] = [Math.floor(x), Math.floor(y)];
    if (x < 0 || y < 0 || x >= this.width || y >= this.height || this.code(x, y) < 0) return null;
    return { code: this.code(x, y), distance: new Float32Array(this.pixels.buffer, 4 * this.index(x, y) + 8, 1)[0] };
  }
}
