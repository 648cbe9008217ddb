// Finds what is under the pointer. The graphics card draws a single pixel, so the window's size does not matter.
import { NearestFilter, RGBAIntegerFormat, Scene, UnsignedIntType, WebGLRenderTarget } from 'three';
import { make_pick_material } from './materials.js';

export class Picker {
  constructor(stage) {
    this.stage = stage;
    this.scene = new Scene();
    this.scene.overrideMaterial = make_pick_material();
    this.pixel = new Uint32Array(4);
    this.target = new WebGLRenderTarget(1, 1, {
      format: RGBAIntegerFormat,
      type: UnsignedIntType,
      internalFormat: 'RGBA32UI',
      minFilter: NearestFilter,
      magFilter: NearestFilter,
    });
  }

  // The surface at a point of the canvas, in CSS pixels: {code, distance}, or null where there is no surface.
  pick(surface, x, y) {
    const { renderer, camera } = this.stage;
    const parent = surface.parent;
    this.stage.look_at_window(Math.floor(x), Math.floor(y), 1, 1);
    this.scene.add(surface);
    renderer.setRenderTarget(this.target);
    renderer.render(this.scene, camera);
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, this.pixel);
    renderer.setRenderTarget(null);
    this.stage.look_at_window();
    parent.add(surface);
    if (this.pixel[0] !== 1) return null;
    return { code: this.pixel[1], distance: new Float32Array(this.pixel.buffer, 8, 1)[0] };
  }
}
