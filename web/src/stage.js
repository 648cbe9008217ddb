// Camera, controls and drawing. Draws only when something has changed.
import { PerspectiveCamera, Quaternion, Scene, Spherical, Vector2, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { fit_points } from './fit.js';

const kFieldOfView = 30;                                 // degrees
const kBorder = 0.06;                                    // of the free area, round the picture
const kWide = 1.1;                                       // of a picture, width by height
const kKeyTurn = Math.PI / 24;                           // per key press
const kKeyZoom = 1.15;
const kReach = 2.5;                                      // of the ground, in radii of everything
const kSlow = 100;                                       // milliseconds a frame, beyond which motion has no damping
const kShares = [1, 0.7, 0.5, 0.35];                     // of the pixels along each side while something moves
const kSlowPicture = 40;                                 // milliseconds that drawing may take, before fewer pixels are drawn
const kTimed = 4;                                        // of so many pictures that move, one is timed
const kRest = 150;                                       // milliseconds without motion, after which details are drawn

// The unit vector of 'x', 'y', 'z', '-x', '-y' or '-z'.
function axis_vector(name) {
  const vector = new Vector3();
  vector[name.at(-1)] = name.startsWith('-') ? -1 : 1;
  return vector;
}

function make_renderer(options) {
  try {
    return new WebGLRenderer(options);
  } catch {
    throw new Error('the browser has no WebGL 2 here. Turn on hardware acceleration in its settings, or use another one.');
  }
}

export class Stage {
  // `bounds` is the sphere round everything, `points` the positions that show_all fits into the view; `insets()` gives
  // the pixels at each side that panels cover: {left, right, top, bottom}; `first_view({up, ahead, side})` the direction to
  // the eye at the start, for three unit vectors.
  constructor(canvas, bounds, up, { points, insets, first_view }) {
    this.bounds = bounds;
    this.points = points;
    this.insets = insets;
    this.first_view = first_view;
    this.renderer = make_renderer({ canvas, antialias: true, alpha: true, powerPreference: 'high-performance' });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(kFieldOfView, 1, 0.01, 100);
    this.before_draw = () => {};  // called with whether the surface moves
    this.at_rest = () => {};
    this.scheduled = this.moving = this.held = false;
    this.level = 0;  // of kShares
    this.moved = 0;  // pictures that moved
    this.drawn = Promise.resolve();  // kept when what was asked for last has been drawn
    this.set_up(up);
    canvas.addEventListener('keydown', (event) => this.on_key(event));
  }

  // The axis that points up from now on; everything is to be shown anew.
  set_up(axis) {
    const turned = (x, y, z) => new Vector3(x, y, z).applyQuaternion(this.from_y_up);
    this.camera.up.copy(axis_vector(axis));
    this.to_y_up = new Quaternion().setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0));
    this.from_y_up = this.to_y_up.clone().invert();
    const axes = { up: this.camera.up.toArray(), ahead: turned(0, 0, 1).toArray(), side: turned(1, 0, 0).toArray() };
    this.back = new Vector3(...this.first_view(axes));
    this.controls?.dispose();
    this.make_controls(this.renderer.domElement);
  }

  // To be called once there is something to see: from now on the canvas is never without it.
  start() {
    this.resize();
    this.show_all();
    this.moving = false;
    this.draw();
    new ResizeObserver(() => this.resize() && this.draw()).observe(this.renderer.domElement);
  }

  make_controls(canvas) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.controls.dampingFactor = 0.12;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.02 * this.bounds.radius;
    this.controls.maxDistance = 20 * this.bounds.radius;
    this.controls.addEventListener('change', () => this.move());
    this.controls.addEventListener('start', () => this.hold(true));
    this.controls.addEventListener('end', () => this.hold(false));
  }

  // Places the camera so that the whole picture fills the area that no panel covers.
  show_all() {
    const half = Math.tan((kFieldOfView * Math.PI) / 360), insets = this.insets();
    const { left, right, top, bottom } = insets;
    this.centre(insets);
    const free = (1 - 2 * kBorder) / this.height;
    const { back } = this;
    const side = new Vector3().crossVectors(this.camera.up, back).normalize();
    const above = new Vector3().crossVectors(back, side);
    const axes = { right: side.toArray(), up: above.toArray(), back: back.toArray() };
    const wide = half * free * (this.width - left - right), high = half * free * (this.height - top - bottom);
    const { x, y, distance } = fit_points(this.points, axes, wide, high);
    this.controls.target.set(0, 0, 0).addScaledVector(side, x).addScaledVector(above, y);
    this.camera.position.copy(this.controls.target).addScaledVector(back, distance || this.bounds.radius);
    this.controls.update();
    this.request_draw();
  }

  // Whether the picture is wider than high at the start.
  is_wide() {
    const side = new Vector3().crossVectors(this.camera.up, this.back).normalize(), above = new Vector3().crossVectors(this.back, side);
    const length = (axis) => {
      const range = [Infinity, -Infinity], p = this.points;
      for (let i = 0; i < p.length; i += 3) {
        const at = p[i] * axis.x + p[i + 1] * axis.y + p[i + 2] * axis.z;
        if (at < range[0]) range[0] = at;
        if (at > range[1]) range[1] = at;
      }
      return range[1] - range[0];
    };
    return length(side) > kWide * length(above);
  }

  // As at the start: everything in view, and at rest.
  reset() {
    const damped = this.controls.enableDamping;
    this.controls.enableDamping = false;  // ends the motion that is left of the last drag
    this.controls.update();
    this.controls.enableDamping = damped;
    this.show_all();
  }

  // Fits the drawing to the canvas. Returns whether its size has changed, which leaves it blank until it is drawn.
  resize() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    const ratio = Math.min(devicePixelRatio, 2.5);
    const same = this.width === width && this.height === height && this.ratio === ratio;
    if (!width || !height || same) return false;
    [this.width, this.height] = [width, height];
    this.ratio = ratio;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.centre(this.insets());
    return true;
  }

  // Moves the middle of the picture into that of the area inside the insets.
  centre({ left, right, top, bottom }) {
    const { width, height } = this;
    this.camera.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
  }

  on_key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const moves = {
      ArrowLeft: () => this.turn(-kKeyTurn, 0),
      ArrowRight: () => this.turn(kKeyTurn, 0),
      ArrowUp: () => this.turn(0, -kKeyTurn),
      ArrowDown: () => this.turn(0, kKeyTurn),
      '+': () => this.zoom(1 / kKeyZoom),
      '=': () => this.zoom(1 / kKeyZoom),
      '-': () => this.zoom(kKeyZoom),
      0: () => this.show_all(),
    };
    if (!moves[event.key]) return;
    event.preventDefault();
    moves[event.key]();
  }

  turn(sideways, upwards) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const spherical = new Spherical().setFromVector3(offset.applyQuaternion(this.to_y_up));
    spherical.theta += sideways;
    spherical.phi += upwards;
    offset.setFromSpherical(spherical.makeSafe()).applyQuaternion(this.from_y_up);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.move();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.move();
  }

  // Draws with less detail, until the camera has rested for a while and no pointer holds it.
  move() {
    this.moving = true;
    this.request_draw();
  }

  // Whether what moves may go on at any time.
  hold(held) {
    this.held = held;
    this.wait_for_rest();
  }

  wait_for_rest() {
    clearTimeout(this.rest_timer);
    if (!this.moving || this.held) return;
    this.rest_timer = setTimeout(() => {
      this.moving = false;
      this.request_draw();
    }, kRest);
  }

  request_draw() {
    if (this.scheduled) return;
    this.scheduled = true;
    this.drawn = new Promise((done) => requestAnimationFrame(() => {
      this.scheduled = false;
      this.controls.update();  // asks for the next frame while the damped motion lasts
      this.choose_pixels();
      if (this.moving && this.moved++ % kTimed === 0) this.draw_timed();
      else this.draw();
      this.judge_speed(performance.now());
      done();
    }));
  }

  // Whether the picture is drawn in haste.
  get quick() {
    return this.moving && this.level > 0;
  }

  // All pixels at rest. While something moves, as many as the last pictures have left time for, and simpler panels.
  choose_pixels() {
    const share = this.moving ? kShares[this.level] : 1;
    document.documentElement.toggleAttribute('data-quick', this.quick);
    if (this.renderer.getPixelRatio() !== share * this.ratio) this.renderer.setPixelRatio(share * this.ratio);
  }

  // Draws, and waits until the graphics card has done so: pictures that take it long give the next ones fewer pixels. What
  // it had to do before does not count, nor what the page does itself.
  draw_timed() {
    const gl = this.renderer.getContext(), pixel = new Uint8Array(4);
    const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    wait();
    this.draw();
    const begun = performance.now();
    wait();
    const time = performance.now() - begun;
    if (time > kSlowPicture) this.level = Math.min(this.level + 1, kShares.length - 1);
    else if (time < kSlowPicture / 4) this.level = Math.max(this.level - 1, 0);
  }

  // Damped motion takes some fifty frames: where three in a row are slow, it would go on for seconds.
  judge_speed(now) {
    const slow = this.moving && this.scheduled && now - this.last_frame > kSlow;
    this.slow_frames = slow ? (this.slow_frames ?? 0) + 1 : 0;
    if (this.slow_frames >= 3) this.controls.enableDamping = false;
    this.last_frame = now;
  }

  draw() {
    this.fit_depth();
    this.before_draw(this.moving);
    this.renderer.render(this.scene, this.camera);
    this.wait_for_rest();
    if (!this.moving && !this.scheduled) this.at_rest();
  }

  // CSS pixels of a unit of the page's coordinates where the camera looks.
  pixels_per_unit() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    return (0.5 * this.height) / (Math.tan((kFieldOfView * Math.PI) / 360) * distance);
  }

  // A text that is the same exactly where the camera sees the same.
  view_key() {
    const { position, quaternion, view } = this.camera;
    return [...position, ...quaternion, view.offsetX, view.offsetY, this.width, this.height].join(' ');
  }

  // Depths range over the bounding sphere only: lines stay apart from the surface only if depths are precise.
  fit_depth() {
    const distance = this.camera.position.distanceTo(this.bounds.center), radius = this.bounds.radius;
    this.camera.near = Math.max(distance - kReach * radius, 0.002 * radius);
    this.camera.far = distance + kReach * radius;
    this.camera.updateProjectionMatrix();
  }

  // The picture alone, without the room for panels, `ratio` times as large as on the page: a canvas with a clear ground.
  // `turn`: of the camera, in radians. `end_pictures` has to follow the last one.
  take_picture(ratio, turn = 0) {
    const { renderer, camera, controls } = this, { x: width, y: height } = renderer.getSize(new Vector2());
    const offset = camera.position.clone().sub(controls.target).applyAxisAngle(camera.up, turn);
    const eye = camera.position.clone();
    renderer.setPixelRatio(ratio);
    this.centre({ left: 0, right: 0, top: 0, bottom: 0 });
    this.moving = false;
    camera.position.copy(controls.target).add(offset);
    camera.lookAt(controls.target);
    this.draw();
    camera.position.copy(eye);
    camera.lookAt(controls.target);
    const picture = Object.assign(document.createElement('canvas'), { width: width * ratio, height: height * ratio });
    picture.getContext('2d').drawImage(renderer.domElement, 0, 0);
    return picture;
  }

  end_pictures() {
    this.renderer.setPixelRatio(this.ratio);
    this.centre(this.insets());
    this.draw();
  }
}
