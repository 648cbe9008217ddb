// Camera, controls and drawing. Draws only when something has changed.
import { PerspectiveCamera, Quaternion, Scene, Spherical, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const kFieldOfView = 30;                                 // degrees
const kFirstView = new Vector3(0.62, 0.42, 1);           // from the centre to the eye, where y is up
const kKeyTurn = Math.PI / 24;                           // per key press
const kKeyZoom = 1.15;

// The unit vector of 'x', 'y', 'z', '-x', '-y' or '-z'.
function axis_vector(name) {
  const vector = new Vector3();
  vector[name.at(-1)] = name.startsWith('-') ? -1 : 1;
  return vector;
}

export class Stage {
  // `bounds` is the sphere round everything; `margin()` gives the pixels at the right that a panel covers.
  constructor(canvas, bounds, up, margin) {
    this.bounds = bounds;
    this.margin = margin;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(kFieldOfView, 1, 0.01, 100);
    this.camera.up.copy(axis_vector(up));
    this.to_y_up = new Quaternion().setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0));
    this.from_y_up = this.to_y_up.clone().invert();
    this.before_draw = () => {};
    this.at_rest = () => {};
    this.scheduled = false;
    this.make_controls(canvas);
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener('keydown', (event) => this.on_key(event));
    this.resize();
  }

  make_controls(canvas) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.controls.dampingFactor = 0.12;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.02 * this.bounds.radius;
    this.controls.maxDistance = 20 * this.bounds.radius;
    this.controls.addEventListener('change', () => this.request_draw());
    this.controls.addEventListener('start', () => this.request_draw());
  }

  // Places the camera so that the bounding sphere fits into the area that no panel covers.
  show_all() {
    const half = (kFieldOfView * Math.PI) / 360;
    const narrow = Math.min(half, Math.atan((Math.tan(half) * (this.width - this.margin())) / this.height));
    const direction = kFirstView.clone().normalize().applyQuaternion(this.from_y_up);
    this.controls.target.copy(this.bounds.center);
    const distance = (1.1 * this.bounds.radius) / Math.sin(narrow);
    this.camera.position.copy(this.bounds.center).addScaledVector(direction, distance);
    this.controls.update();
    this.request_draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2.5));
    this.renderer.setSize(width, height, false);
    const fresh = this.width === undefined;
    [this.width, this.height] = [width, height];
    this.camera.aspect = width / height;
    this.look_at_window();
    if (fresh) this.show_all();
    this.request_draw();
  }

  // Restricts drawing to a rectangle of the picture, by default the whole. Its middle is that of the uncovered area.
  look_at_window(x = 0, y = 0, width = this.width, height = this.height) {
    this.camera.setViewOffset(this.width, this.height, x + this.margin() / 2, y, width, height);
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
    this.request_draw();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.request_draw();
  }

  request_draw() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      this.controls.update();  // asks for the next frame while the damped motion lasts
      this.fit_depth();
      this.before_draw();
      this.renderer.render(this.scene, this.camera);
      if (!this.scheduled) this.at_rest();
    });
  }

  // Depths range over the bounding sphere only: lines stay apart from the surface only if depths are precise.
  fit_depth() {
    const distance = this.camera.position.distanceTo(this.bounds.center), radius = this.bounds.radius;
    this.camera.near = Math.max(distance - 1.05 * radius, 0.002 * radius);
    this.camera.far = distance + 1.05 * radius;
    this.camera.updateProjectionMatrix();
  }
}
