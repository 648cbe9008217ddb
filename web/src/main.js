import { Sphere, Vector3 } from 'three';
import { kThemes, kUnreachedFill } from './colours.js';
import { load_arrays, read_array, read_manifest } from './data.js';
import { describe_element, locate } from './element_card.js';
import { choose_first_view } from './first_view.js';
import { HoverMark } from './hover_mark.js';
import { IdMap } from './id_map.js';
import { arrange_panels, covered, open_first_panels } from './layout.js';
import { show_legend } from './legend.js';
import { bisector_width, make_mark_materials } from './marks.js';
import { make_overlay_material, make_surface_materials } from './materials.js';
import * as panel from './panel.js';
import { Picture } from './picture.js';
import { Pictures } from './pictures.js';
import { RegionTable } from './region_table.js';
import { Shading } from './shading.js';
import { Stage } from './stage.js';
import { kFirstLabel } from './surface.js';

// What the surface can be coloured by: key, name, and title of the legend.
const kColourings = [
  ['regions', 'Region'],
  ['area', 'Area', 'Area of the region'],
  ['energy', 'Energy', 'Energy of the region'],
  ['distance', 'Distance', 'Distance from the generator'],
  ['surface_distance', 'Surface distance'],  // the scene names the surface in the title
  ['quality', 'Quality', 'Quality of the triangle'],
  ['angle', 'Smallest angle', 'Smallest angle of the triangle, degrees'],
  ['plain', 'Nothing'],
];
const kToggles = [
  ['lines', 'Lines of equal distance'],
  ['bisectors', 'Bisectors'],
  ['borders', 'Borders of given regions'],
  ['isolines', 'Isolines'],
  ['paths', 'Paths'],
  ['generators', 'Generators'],
  ['added_generators', 'Added generators'],
  ['branch_points', 'Branch points'],
  ['wireframe', 'Wireframe'],
  ['checker', 'Checkerboard'],
  ['smooth', 'Smooth shading'],
  ['shadow', 'Shade and shadow'],
  ['overlay', 'Other surface'],  // the scene names it
];
// What a scene is coloured by where it does not offer what was chosen, the first that it offers.
const kUsual = ['regions', 'distance', 'plain'];
const kMarks = ['bisectors', 'borders', 'isolines', 'paths', 'generators', 'added_generators', 'branch_points'];
const dark_scheme = matchMedia('(prefers-color-scheme: dark)');

// The positions of all scenes, three coordinates each; scenes with the same mesh count once.
function all_positions(manifest) {
  const all_references = manifest.scenes.flatMap(({ positions, overlay }) => (overlay ? [positions, overlay.positions] : [positions]));
  const references = new Map(all_references.map((positions) => [positions.blob, positions]));
  const arrays = [...references.values()].map(read_array);
  const all = new Float32Array(arrays.reduce((sum, array) => sum + array.length, 0));
  arrays.reduce((at, array) => (all.set(array, at), at + array.length), 0);
  return all;
}

// The smallest sphere around the origin of the page's coordinates that holds all points.
function bounding_sphere(p) {
  let squared = 0;
  for (let i = 0; i < p.length; i += 3) squared = Math.max(squared, p[i] ** 2 + p[i + 1] ** 2 + p[i + 2] ** 2);
  return new Sphere(new Vector3(), Math.sqrt(squared) || 1);
}

export class Viewer {
  constructor(manifest) {
    this.manifest = manifest;
    this.canvas = panel.by_id('canvas');
    const points = all_positions(manifest);
    const first_view = (axes) => choose_first_view(...['positions', 'faces'].map((name) => read_array(this.manifest.scenes[0][name])), axes);
    this.stage = new Stage(this.canvas, bounding_sphere(points), manifest.up, { points, insets: covered, first_view });
    this.id_map = new IdMap(this.stage);
    this.shading = new Shading(this.stage);
    this.shadings = 0;  // that are being made
    this.hover_mark = new HoverMark(panel.by_id('mark'));
    this.materials = { ...make_surface_materials(), ...make_mark_materials(), overlay: make_overlay_material() };
    this.pictures = manifest.scenes.map(() => null);
    this.table = new RegionTable((label) => this.pin(label));
    this.set_defaults();
    this.stage.before_draw = (moving) => this.prepare(moving);
    this.stage.at_rest = () => this.pick();  // the surface has moved under the pointer
    panel.by_id('up').value = manifest.up;
    this.inputs = panel.make_toggles(kToggles, (key, value) => this.toggle(key, value));
    this.colours = panel.make_colour_choice(kColourings, (key) => this.colour_by(key));
    this.mark_scene = panel.make_scene_switch(manifest.scenes, (i) => this.choose(i));
    this.mark_iteration = panel.make_iteration_slider(manifest.scenes, (i) => this.choose(i));
    this.listen();
    this.pictures_of = new Pictures(this);
    this.choose(0);
    open_first_panels(this.stage.is_wide());
    this.follow_theme();
    this.stage.start();
    this.shown = true;
    setTimeout(() => this.shade(), 100);
  }

  // Scenes of another mesh in place of those of the page, all of it in view.
  show_other(manifest) {
    const points = all_positions(manifest);
    this.picture.dispose();
    this.manifest = manifest;
    this.pictures = manifest.scenes.map(() => null);
    Object.assign(this.stage, { points, bounds: bounding_sphere(points) });
    this.own = this.own_switches();
    this.pinned = null;
    this.set_up_axis(manifest.up);
    this.choose(0);
  }

  // Makes the shade of the picture, if it is wanted and not there. Until then the page is marked as busy.
  async shade() {
    const { picture } = this, busy = document.documentElement;
    if (!this.stage.moving) picture.need_coarse();
    if (!this.on.shadow) return;
    busy.toggleAttribute('data-shading', ++this.shadings > 0);
    picture.set_shading(await this.shading.of(picture));
    busy.toggleAttribute('data-shading', --this.shadings > 0);
    if (picture !== this.picture) return;
    this.apply();
    this.stage.request_draw();
  }

  set_defaults() {
    this.on = { lines: false, shadow: true };
    for (const key of kMarks) this.on[key] = true;
    this.own = this.own_switches();
    this.wanted = 'regions';
    this.pinned = null;
  }

  // The switches of which each scene has its own.
  own_switches() {
    return this.manifest.scenes.map((scene) => ({
      wireframe: scene.wireframe,
      smooth: scene.smooth,
      overlay: false,
      ...(scene.vertex_generators && { generators: false }),  // dots on all vertices would hide the colours
    }));
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener('pointermove', (event) => event.buttons === 0 && this.point_at(event));
    canvas.addEventListener('pointerdown', (event) => (this.pressed = event.isPrimary ? event : null));  // two fingers never click
    for (const type of ['pointerdown', 'wheel']) canvas.addEventListener(type, () => document.body.classList.add('used'));
    canvas.addEventListener('pointerup', (event) => this.release(event));
    canvas.addEventListener('pointerleave', ({ pointerType }) => pointerType === 'mouse' && this.point_at(null));
    document.addEventListener('keydown', (event) => event.key === 'Escape' && this.pin(null));
    dark_scheme.addEventListener('change', () => this.follow_theme());
    document.querySelector('aside').addEventListener('toggle', () => this.make_room(), true);
    panel.by_id('unpin').addEventListener('click', () => this.pin(null));
    panel.by_id('up').addEventListener('change', ({ target }) => this.set_up(target.value));
    panel.by_id('reset').addEventListener('click', () => this.reset());
  }

  // A click or tap pins the region under it, a second one frees it. Where there are no regions, a tap shows the face, and
  // a click the shortest path from there, if the page has paths.
  release(event) {
    const start = this.pressed;
    this.pressed = null;
    const moved = !start || Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) >= 6;
    const regions = this.picture.offers('regions');
    if (event.pointerType !== 'mouse') this.point_at(regions || moved ? null : event);
    if (moved || event.button !== 0) return;
    if (this.picture.vertex_paths) this.show_path({ x: event.offsetX, y: event.offsetY });
    if (!regions) return;
    this.id_map.update(this.picture.mesh);
    const hit = this.id_map.at(event.offsetX, event.offsetY);
    const label = hit && hit.code - kFirstLabel;
    this.pin(label === null || label < 0 || label === this.pinned ? null : label);
  }

  show_path(pointer) {
    const { mesh, surface } = this.picture;
    this.id_map.update(mesh, surface.triangles.parents);
    const hit = this.id_map.at(pointer.x, pointer.y);
    this.pin(null);
    if (!hit) return;
    const { face, bary } = locate(this.stage, surface, hit.code, pointer);
    panel.show_card('pinned', this.picture.show_path(face, bary));
  }

  choose(i) {
    if (this.picture) this.stage.scene.remove(this.picture.group);
    const is_iteration = (scene) => Number.isInteger(this.manifest.scenes[scene]?.iteration);
    if (!is_iteration(i) || !is_iteration(this.current)) this.pinned = null;
    this.current = i;
    this.mark_scene(i);
    this.mark_iteration(i);
    this.pictures[i] ??= new Picture(this.manifest.scenes[i], this.manifest.scale, this.materials);
    this.picture = this.pictures[i];
    this.stage.scene.add(this.picture.group);
    this.apply();
    if (this.shown) this.shade();
  }

  // Moves the picture into what panels leave of the screen.
  make_room() {
    this.stage.centre(covered());
    this.stage.request_draw();
  }

  set_up_axis(axis) {
    panel.by_id('up').value = axis;
    this.stage.set_up(axis);
    this.stage.show_all();
  }

  set_up(axis) {
    this.set_up_axis(axis);
    this.shade();
  }

  toggle(key, value) {
    const own = this.own[this.current];  // the others keep their state when the scene changes
    (key in own ? own : this.on)[key] = value;
    this.apply();
    if (key === 'shadow') this.shade();
  }

  colour_by(key) {
    this.wanted = key;
    this.apply();
  }

  apply() {
    const on = { ...this.on, ...this.own[this.current] }, { picture } = this;
    this.colour = [this.wanted, ...kUsual].find((key) => picture.offers(key));
    picture.apply(on, this.colour);
    this.set_wire_colour();
    this.show_panels(on);
    if (!picture.path) this.pin(this.pinned);
  }

  // What the panels have of the picture.
  show_panels(on) {
    const { picture } = this;
    panel.show_figures(picture.entry.figures);
    for (const [key, { row, input, count }] of Object.entries(this.inputs)) {
      row.hidden = !picture.offers(key);
      input.checked = on[key] && !row.hidden;
      count.textContent = picture.count(key);
    }
    for (const [key, option] of Object.entries(this.colours)) option.hidden = option.disabled = !picture.offers(key);
    this.inputs.generators.text.textContent = picture.vertex_paths ? 'Sources' : 'Generators';
    this.inputs.paths.text.textContent = picture.entry.cells.length ? 'Curves' : 'Paths';
    if (picture.entry.overlay) this.inputs.overlay.text.textContent = picture.entry.overlay.name;
    panel.by_id('colour').value = this.colour;
    document.querySelector('#hint span').textContent = this.click_hint();
    show_legend(this.legend_title(), picture.range(this.colour), picture.exceeds(this.colour));
    this.table.show(picture.offers('regions') ? picture.entry.cells : [], (label) => this.css_colour(label));
  }

  // What a click does, behind what else the pointer does.
  click_hint() {
    if (this.picture.vertex_paths) return ', click a point for its shortest path';
    return this.picture.offers('regions') ? ', click to pin a region' : '';
  }

  legend_title() {
    if (this.colour === 'distance' && this.picture.vertex_paths) return 'Distance from the nearest source';
    if (this.colour === 'surface_distance') return `Distance from ${this.picture.distance.other}, % of the diagonal`;
    return kColourings.find(([key]) => key === this.colour)[2];
  }

  css_colour(label) {
    return `rgb(${label === null ? kUnreachedFill : this.picture.colour_of(label, this.colour)})`;
  }

  pin(label) {
    this.pinned = label;
    this.picture.clear_path();
    this.materials.outside.uniforms.pinned.value = label === null ? -1 : label + kFirstLabel;
    panel.show_region('pinned', label === null ? null : this.describe({ code: label + kFirstLabel, distance: null }));
    this.table.mark(label);
    this.stage.request_draw();
  }

  point_at(event) {
    this.pointer = event && { x: event.offsetX, y: event.offsetY };
    this.pick();
  }

  // At most once a frame, because pointers may report much more often; not while the surface moves.
  pick() {
    if (this.picking) return;
    this.picking = true;
    requestAnimationFrame(() => {
      this.picking = false;
      if (!this.pointer || this.stage.moving) return this.show_hit(null);
      const { mesh, surface } = this.picture, regions = this.picture.offers('regions');
      this.id_map.update(mesh, regions ? null : surface.triangles.parents);
      this.show_hit(this.id_map.at(this.pointer.x, this.pointer.y));
    });
  }

  // The face or vertex under the pointer, where there are no regions.
  show_element(face) {
    const found = locate(this.stage, this.picture.surface, face, this.pointer);
    this.hover_mark.show(this.id_map, face, found.place);
    panel.show_card('region', describe_element(this.picture, found));
  }

  show_hit(hit) {
    if (hit && !this.picture.offers('regions')) return this.show_element(hit.code);
    const code = hit ? hit.code : -1;
    this.hover_mark.show(this.id_map, code);
    const pinned = this.pinned !== null && code === this.pinned + kFirstLabel;
    panel.show_region('region', code < 0 || pinned ? null : this.describe(hit));
  }

  describe({ code, distance }) {
    const label = code < kFirstLabel ? null : code - kFirstLabel;
    const cell = this.picture.entry.cells[label] ?? null;
    return {
      label,
      cell,
      colour: this.css_colour(label),
      share: cell && this.picture.total_area > 0 ? cell.area / this.picture.total_area : 0,
      distance: distance !== null && this.picture.offers('lines') ? this.format_distance(distance) : null,
    };
  }

  format_distance(distance) {
    return distance < 0 ? 'inf' : panel.format_number(distance * this.manifest.scale);
  }

  // Before each drawing. Where the view has changed, what is under the pointer is unknown.
  prepare(moving) {
    const view = `${this.current} ${this.stage.view_key()}`;
    if (this.view !== view) {
      this.view = view;
      this.id_map.invalidate();
      this.hover_mark.clear();
    }
    this.picture.set_detail(!moving, this.stage.quick);
    this.materials.line.uniforms.width.value = bisector_width(this.picture.spacing * this.stage.pixels_per_unit());
    for (const { uniforms } of Object.values(this.materials)) {
      if (uniforms.viewport_height) uniforms.viewport_height.value = this.stage.height;
      if (uniforms.pixel_ratio) uniforms.pixel_ratio.value = this.stage.renderer.getPixelRatio();
    }
  }

  reset() {
    document.body.classList.remove('used');
    this.set_defaults();
    this.table.reset();
    this.set_up(this.manifest.up);
    this.choose(0);
    open_first_panels(this.stage.is_wide());
    this.stage.reset();
  }

  // Most distances are small, and have dark colours.
  set_wire_colour() {
    const theme = kThemes[dark_scheme.matches ? 'dark' : 'light'];
    this.materials.wire.uniforms.colour.value.set(this.colour === 'surface_distance' ? theme.light_wire : theme.wire);
  }

  follow_theme() {
    const theme = kThemes[dark_scheme.matches ? 'dark' : 'light'];
    this.stage.renderer.setClearColor(theme.page, 0);
    this.materials.line.uniforms.colour.value.set(theme.line);
    this.materials.border.uniforms.colour.value.set(theme.line);
    this.materials.isoline.uniforms.colour.value.set(theme.isoline);
    this.materials.path.uniforms.colour.value.set(theme.path);
    this.set_wire_colour();
    this.materials.overlay.uniforms.colour.value.set(theme.overlay);
    const dots = { generator: theme.generator, added_generator: theme.added_generator, branch_point: theme.branch_point };
    for (const [key, fill] of Object.entries(dots)) {
      this.materials[key].uniforms.fill.value.set(fill);
      this.materials[key].uniforms.ring.value.set(key === 'branch_point' ? theme.generator : theme.branch_point);
    }
    this.stage.request_draw();
  }
}

// Shows the page's own data.
export async function start() {
  const manifest = read_manifest();
  panel.by_id('title').textContent = manifest.title;
  arrange_panels();
  try {
    await load_arrays();
    new Viewer(manifest);
  } catch (error) {
    panel.show_failure(`The surface can't be drawn: ${error.message}`);
    throw error;
  } finally {
    panel.by_id('loading').hidden = true;
  }
  document.documentElement.dataset.ready = 'true';
}
