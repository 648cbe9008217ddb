import { Sphere, Vector3 } from 'three';
import { kThemes, kUnreachedFill } from './colours.js';
import { read_array, read_manifest } from './data.js';
import { make_mark_materials } from './marks.js';
import { make_surface_materials } from './materials.js';
import { format_number, make_scene_switch, make_toggles, show_failure, show_figures, show_region } from './panel.js';
import { Picker } from './picker.js';
import { Picture } from './picture.js';
import { Stage } from './stage.js';
import { kFirstLabel } from './surface.js';

const kToggles = [
  ['regions', 'Regions'],
  ['shading', 'Distance shading'],
  ['lines', 'Lines of equal distance'],
  ['bisectors', 'Bisectors'],
  ['generators', 'Generators'],
  ['added_generators', 'Added generators'],
  ['branch_points', 'Branch points'],
  ['wireframe', 'Wireframe'],
  ['smooth', 'Smooth shading'],
];
const narrow_screen = matchMedia('(max-width: 720px)');
const kPerScene = ['wireframe', 'smooth'];  // the others keep their state when the scene changes

// The smallest sphere around the origin of the page's coordinates that holds every scene.
function bounding_sphere(manifest) {
  let squared = 0;
  for (const entry of manifest.scenes) {
    const p = read_array(entry.positions);
    for (let i = 0; i < p.length; i += 3) squared = Math.max(squared, p[i] ** 2 + p[i + 1] ** 2 + p[i + 2] ** 2);
  }
  return new Sphere(new Vector3(), Math.sqrt(squared) || 1);
}

// Pixels at the right of the picture that the panel covers; 0 on a narrow screen, where the panel lies over the
// picture.
function covered_width() {
  return narrow_screen.matches ? 0 : innerWidth - document.querySelector('aside').offsetLeft;
}

class Viewer {
  constructor(manifest) {
    this.manifest = manifest;
    this.canvas = document.getElementById('canvas');
    this.stage = new Stage(this.canvas, bounding_sphere(manifest), manifest.up, covered_width);
    this.picker = new Picker(this.stage);
    this.materials = { ...make_surface_materials(), ...make_mark_materials() };
    this.pictures = manifest.scenes.map(() => null);
    this.on = { regions: true, shading: false, lines: false };
    for (const key of ['bisectors', 'generators', 'added_generators', 'branch_points']) this.on[key] = true;
    this.own = manifest.scenes.map(({ wireframe, smooth }) => ({ wireframe, smooth }));
    this.stage.before_draw = () => this.size_marks();
    this.stage.at_rest = () => this.pick();  // the surface has moved under the pointer
    this.inputs = make_toggles(kToggles, (key, value) => this.toggle(key, value));
    make_scene_switch(manifest.scenes, (i) => this.choose(i));
    this.listen();
    this.choose(0);
    this.follow_theme();
  }

  listen() {
    this.canvas.addEventListener('pointermove', (event) => event.buttons === 0 && this.point_at(event));
    this.canvas.addEventListener('pointerdown', (event) => (this.pressed = event));
    this.canvas.addEventListener('pointerup', (event) => {
      const start = this.pressed;
      if (start && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) < 6) this.point_at(event);
    });
    this.canvas.addEventListener('pointerleave', (event) => event.pointerType === 'mouse' && this.point_at(null));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.follow_theme());
  }

  choose(i) {
    if (this.picture) this.stage.scene.remove(this.picture.group);
    this.current = i;
    this.pictures[i] ??= new Picture(this.manifest.scenes[i], this.manifest.scale, this.materials);
    this.picture = this.pictures[i];
    this.stage.scene.add(this.picture.group);
    show_figures(this.manifest.scenes[i].figures);
    show_region(null);
    this.materials.outside.uniforms.hovered.value = -1;
    this.apply();
  }

  toggle(key, value) {
    (kPerScene.includes(key) ? this.own[this.current] : this.on)[key] = value;
    this.apply();
  }

  apply() {
    const on = { ...this.on, ...this.own[this.current] };
    for (const [key, { row, input, count }] of Object.entries(this.inputs)) {
      row.hidden = !this.picture.offers(key);
      input.checked = on[key] && !row.hidden;
      count.textContent = this.picture.count(key);
    }
    this.picture.apply(on);
    this.stage.request_draw();
  }

  point_at(event) {
    this.pointer = event && { x: event.offsetX, y: event.offsetY };
    this.pick();
  }

  // At most once a frame, because pointers may report much more often.
  pick() {
    if (this.picking) return;
    this.picking = true;
    requestAnimationFrame(() => {
      this.picking = false;
      this.show_hit(this.pointer ? this.picker.pick(this.picture.mesh, this.pointer.x, this.pointer.y) : null);
    });
  }

  show_hit(hit) {
    const uniforms = this.materials.outside.uniforms;
    const hovered = hit && this.picture.offers('regions') ? hit.code : -1;
    if (uniforms.hovered.value !== hovered) {
      uniforms.hovered.value = hovered;
      this.stage.request_draw();
    }
    show_region(hovered < 0 ? null : this.describe(hit));
  }

  describe({ code, distance }) {
    const label = code < kFirstLabel ? null : code - kFirstLabel;
    const cell = this.picture.entry.cells[label] ?? null;
    return {
      label,
      cell,
      colour: `rgb(${label === null ? kUnreachedFill : this.picture.fills[label]})`,
      share: cell && this.picture.total_area > 0 ? cell.area / this.picture.total_area : 0,
      distance: this.picture.offers('lines') ? this.format_distance(distance) : null,
    };
  }

  format_distance(distance) {
    return distance < 0 ? 'inf' : format_number(distance * this.manifest.scale);
  }

  size_marks() {
    for (const { uniforms } of Object.values(this.materials)) {
      if (uniforms.viewport_height) uniforms.viewport_height.value = this.stage.height;
      if (uniforms.pixel_ratio) uniforms.pixel_ratio.value = this.stage.renderer.getPixelRatio();
    }
  }

  follow_theme() {
    const theme = kThemes[matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'];
    this.stage.renderer.setClearColor(theme.page);
    this.materials.line.color.set(theme.line);
    this.materials.wire.uniforms.colour.value.set(theme.wire);
    this.materials.generator.uniforms.fill.value.set(theme.generator);
    this.materials.generator.uniforms.ring.value.set(theme.branch_point);
    this.materials.added_generator.uniforms.fill.value.set(theme.added_generator);
    this.materials.added_generator.uniforms.ring.value.set(theme.branch_point);
    this.materials.branch_point.uniforms.fill.value.set(theme.branch_point);
    this.materials.branch_point.uniforms.ring.value.set(theme.generator);
    this.stage.request_draw();
  }
}

function start() {
  const manifest = read_manifest();
  document.getElementById('title').textContent = manifest.title;
  if (narrow_screen.matches) document.querySelectorAll('details').forEach((box) => (box.open = false));
  try {
    new Viewer(manifest);
  } catch (error) {
    show_failure(`The surface can't be drawn: ${error.message}`);
    throw error;
  }
  document.documentElement.dataset.ready = 'true';
}

start();
