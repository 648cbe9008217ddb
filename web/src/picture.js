// One scene of the page, ready to be drawn.
import { Group, Mesh } from 'three';
import { make_coarse } from './coarse.js';
import { fill_texture, kUnreachedFill, lattice_texture, read_fills } from './colours.js';
import { count_of, read_array } from './data.js';
import { dot_sizes, is_closed, make_dots, make_lines, make_wireframe, read_lines } from './marks.js';
import { kSources } from './materials.js';
import { make_overlay } from './overlay.js';
import { group_digits } from './panel.js';
import { ramp } from './ramp.js';
import { add_chart, add_distances, make_geometry, make_surface, set_face_values, set_open_shares } from './surface.js';
import { SurfaceDistance } from './surface_distance.js';
import { VertexPaths } from './vertex_paths.js';
import { face_angle, face_quality, face_values, position_in, round_step, triangles_area, usual_range, value_range } from './values.js';

const kManyTriangles = 300000;  // with more, fewer are drawn while the surface turns
// Ways of colouring by a value of each face, and the steps by which the ends of its scale are rounded.
const kFaceValues = { quality: { value: face_quality, step: 0.05 }, angle: { value: face_angle, step: 5 } };
const kChecks = 16;             // squares of the checkerboard along the side of the texture, for one region
const kCoarseStep = 0.012;      // shortest segment of bisectors then, in half diagonals of the box

// Whether the scene's overlay has so few triangles that it is shown from the start, and while the surface turns.
export function has_light_overlay({ overlay }) {
  return Boolean(overlay) && count_of(overlay.faces) / 3 <= kManyTriangles;
}

export class Picture {
  constructor(entry, scale, materials) {
    this.entry = entry;
    this.scale = scale;
    this.surface = make_surface(entry);
    this.distance = entry.surface_distance && new SurfaceDistance(entry.surface_distance, scale, this.surface.faces);
    this.vertex_paths = entry.vertex_paths && new VertexPaths(entry, this.surface, scale);
    this.generators = read_array(entry.vertex_generators);
    this.given = count_of(entry.generators) / 3;
    this.fills = read_fills(entry);
    this.textures = { regions: fill_texture(this.fills) };
    this.total_area = entry.cells.reduce((sum, cell) => sum + cell.area, 0);
    this.materials = materials;
    this.scales = {};
    this.make_meshes();
    this.make_marks();
  }

  make_meshes() {
    this.geometry = this.dress(this.surface.triangles);
    this.mesh = new Mesh(this.geometry, this.materials.outside);
    this.inside = new Mesh(this.geometry, this.materials.inside);
    this.group = new Group();
    this.mesh.frustumCulled = this.inside.frustumCulled = false;  // nearly all of it is in view
    this.group.add(this.mesh, this.inside);
  }

  // The geometry of some triangles, with all that does not depend on the way of colouring.
  dress(triangles) {
    const geometry = make_geometry(triangles);
    if (this.distance) add_distances(geometry, triangles, this.distance);
    if (this.entry.texture) add_chart(geometry, triangles, read_array(this.entry.texture));
    return geometry;
  }

  make_marks() {
    const { entry, materials } = this;
    this.marks = {
      bisectors: read_lines(entry.bisectors, materials.line),
      borders: read_lines(entry.borders, materials.border),
      isolines: read_lines(entry.isolines, materials.isoline),
      paths: read_lines(entry.paths, materials.path),
      generators: make_dots(entry.generators, materials.generator),
      added_generators: make_dots(entry.added_generators, materials.added_generator),
      branch_points: make_dots(entry.branch_points, materials.branch_point),
      wireframe: null,
      overlay: null,
    };
    for (const mark of Object.values(this.marks)) if (mark) this.group.add(mark);
    const generators = (count_of(entry.generators) + count_of(entry.added_generators)) / 3;
    this.spacing = Math.sqrt(triangles_area(this.surface.triangles.positions) / Math.max(1, generators, entry.cells.length));
    this.dot_sizes = dot_sizes(this.spacing);
  }

  // Whether the scene has what a switch or a way of colouring shows.
  offers(key) {
    if (key === 'regions') return this.surface.labelled;
    if (key === 'distance' || key === 'lines') return this.surface.largest_distance > 0;
    if (key === 'area' || key === 'energy') return this.surface.labelled && this.range(key) !== null;
    if (key === 'surface_distance') return Boolean(this.distance);
    if (key === 'overlay') return Boolean(this.entry.overlay);
    if (key === 'checker') return Boolean(this.entry.texture);
    if (['quality', 'angle', 'plain', 'wireframe', 'smooth', 'shadow'].includes(key)) return true;
    return Boolean(this.marks[key]);
  }

  // The number of dots that a switch shows; empty if it shows something else.
  count(key) {
    const mark = this.marks[key];
    return mark?.isPoints ? group_digits(mark.geometry.getAttribute('position').count) : '';
  }

  // The values at both ends of the legend of a way of colouring, in the units of its title; null where it has none.
  range(key) {
    if (key === 'distance') return [0, this.surface.largest_distance * this.scale];
    if (key === 'surface_distance') return [0, (100 * this.distance.scale_end) / this.distance.reference];
    if (kFaceValues[key]) return this.face_scale(key).range;
    if (key === 'area' || key === 'energy') return value_range(this.entry.cells.map((cell) => cell[key] ?? NaN));
    return null;
  }

  // Whether there are values beyond the ends of the range, which have their colours: {below, above}.
  exceeds(key) {
    return kFaceValues[key] ? this.face_scale(key) : { above: key === 'surface_distance' && this.distance.exceeds };
  }

  // The values and the scale of a way of colouring by faces: {values, range, below, above}.
  face_scale(key) {
    const { value, step } = kFaceValues[key], { positions, faces } = this.surface;
    const make = (values) => ({ values, ...usual_range(values, step) });
    return (this.scales[key] ??= make(face_values(positions, faces, value)));
  }

  // The colour of a label, [red, green, blue], in a way of colouring by region.
  colour_of(label, key) {
    const range = this.range(key);
    if (key === 'regions' || !range) return this.fills[label];
    const value = this.entry.cells[label]?.[key];
    return Number.isFinite(value) ? ramp(position_in(range, value)) : kUnreachedFill;
  }

  texture(key) {
    this.textures[key] ??= fill_texture(this.fills.map((_, label) => this.colour_of(label, key)));
    return this.textures[key];
  }

  // Gives each triangle the value of its face, for a way of colouring that needs it.
  need_face_values(key) {
    if (!kFaceValues[key] || this.valued === key) return;
    this.valued = key;
    set_face_values(this.geometry, this.surface.triangles, this.face_scale(key));
    if (this.coarse) set_face_values(this.coarse.geometry, this.coarse.triangles, this.face_scale(key));
  }

  // Makes what is drawn while the surface turns, if that is less than the whole.
  need_coarse() {
    if (this.coarse !== undefined) return;
    const many = this.surface.triangles.parents.length > kManyTriangles;
    const triangles = many ? make_coarse(this.surface.triangles) : null;
    this.coarse = triangles && { triangles, geometry: this.dress(triangles) };
    if (many) this.add_coarse_bisectors();
    if (this.coarse && this.valued) set_face_values(this.coarse.geometry, triangles, this.face_scale(this.valued));
  }

  add_coarse_bisectors() {
    this.coarse_bisectors = read_lines(this.entry.bisectors, this.materials.line, kCoarseStep);
    if (this.coarse_bisectors) this.group.add(this.coarse_bisectors);
  }

  // Draws the stored path nearest to a point of a face, in place of the last one. Returns the card about it.
  show_path(face, bary) {
    this.clear_path();
    const found = this.vertex_paths.from(face, bary);
    this.path = make_lines(found, this.materials.path);
    if (this.path) this.group.add(this.path);  // the path of a source has no length
    return found.card;
  }

  clear_path() {
    if (!this.path) return;
    this.group.remove(this.path);
    this.path.geometry.dispose();
    this.path = null;
  }

  // Takes what `Shading` has made of the surface.
  set_shading(shading) {
    if (this.shading === shading) return;
    const { shares, shadow } = (this.shading = shading);
    if (this.marks.shadow) this.group.remove(this.marks.shadow);
    this.group.add((this.marks.shadow = shadow.clone()));  // other pictures show it, too
    if (!shares) return;
    set_open_shares(this.geometry, this.surface.triangles, shares);
    if (this.coarse) set_open_shares(this.coarse.geometry, this.coarse.triangles, shares);
  }

  // Frees what the graphics card has of it.
  dispose() {
    this.clear_path();
    this.group.parent?.remove(this.group);
    for (const { geometry } of this.group.children) geometry?.dispose();
    for (const texture of Object.values(this.textures)) texture.dispose?.();
    this.coarse?.geometry.dispose();
  }

  // Whether everything is drawn, or fewer triangles and segments where the surface has many; `quick`: in haste.
  set_detail(whole, quick) {
    this.inside.visible = !quick;
    this.mesh.material = quick && !is_closed(this.surface) ? this.materials.both : this.materials.outside;
    if (!whole) this.need_coarse();
    const coarse = !whole && Boolean(this.coarse);
    if (this.coarse_bisectors) {
      this.coarse_bisectors.visible = this.bisectors && !whole;
      this.marks.bisectors.visible = this.bisectors && whole;
    }
    this.mesh.geometry = this.inside.geometry = coarse ? this.coarse.geometry : this.geometry;
    if (this.marks.wireframe) this.marks.wireframe.visible = this.wireframe && !coarse;
    if (this.marks.overlay) this.marks.overlay.visible = this.overlay && (whole || has_light_overlay(this.entry));
  }

  // Shows what `on` (key to boolean) asks for, in the way of colouring `colour`.
  apply(on, colour) {
    this.wireframe = on.wireframe;
    this.bisectors = on.bisectors;
    this.overlay = on.overlay;
    if (on.wireframe && !this.marks.wireframe) {
      this.marks.wireframe = make_wireframe(this.surface, this.materials.wire);
      this.group.add(this.marks.wireframe);
    }
    if (on.overlay && this.entry.overlay && !this.marks.overlay) {
      this.marks.overlay = make_overlay(this.entry.overlay, this.materials.overlay);
      this.group.add(this.marks.overlay);
    }
    for (const [key, mark] of Object.entries(this.marks)) if (mark) mark.visible = on[key];
    this.need_face_values(colour);
    this.set_uniforms(on, colour);
  }

  set_uniforms(on, colour) {
    const { outside, generator, added_generator, branch_point } = this.materials;
    const uniforms = outside.uniforms, largest = this.surface.largest_distance || 1;
    uniforms.source.value = kSources[colour] ?? kSources.regions;
    uniforms.fills.value = this.texture(colour in kSources ? 'regions' : colour);
    if (this.distance) uniforms.lattices.value = this.textures.lattices ??= lattice_texture(this.distance);
    uniforms.show_lines.value = on.lines && this.offers('lines');
    uniforms.smooth_normals.value = on.smooth;
    uniforms.shaded.value = on.shadow && Boolean(this.shading?.shares);
    uniforms.checks.value = on.checker && this.entry.texture ? kChecks * Math.sqrt(Math.max(1, this.entry.cells.length)) : 0;
    uniforms.largest_distance.value = largest;
    uniforms.line_spacing.value = round_step(largest * this.scale, 12) / this.scale;
    for (const dots of [generator, added_generator, branch_point]) dots.uniforms.spacing.value = this.spacing;
    generator.uniforms.size.value = added_generator.uniforms.size.value = this.dot_sizes.generator;
    branch_point.uniforms.size.value = this.dot_sizes.branch_point;
  }
}
