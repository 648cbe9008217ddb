// One scene of the page, ready to be drawn.
import { Group, Mesh } from 'three';
import { fill_texture, read_fills } from './colours.js';
import { make_bisectors, make_dots, make_wireframe } from './marks.js';
import { make_surface } from './surface.js';

// A round number (1, 2, 5 or 10 times a power of ten) that divides `range` into about `parts` steps.
function round_step(range, parts) {
  const rough = range / parts, power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= rough);
}

export class Picture {
  constructor(entry, scale, materials) {
    this.entry = entry;
    this.scale = scale;
    this.surface = make_surface(entry);
    this.fills = read_fills(entry);
    this.texture = fill_texture(this.fills);
    this.total_area = entry.cells.reduce((sum, cell) => sum + cell.area, 0);
    this.materials = materials;
    this.mesh = new Mesh(this.surface.geometry, materials.outside);
    this.marks = {
      bisectors: make_bisectors(entry, materials.line),
      generators: make_dots(entry.generators, materials.generator),
      added_generators: make_dots(entry.added_generators, materials.added_generator),
      branch_points: make_dots(entry.branch_points, materials.branch_point),
      wireframe: null,
    };
    this.group = new Group();
    this.group.add(this.mesh, new Mesh(this.surface.geometry, materials.inside));
    for (const mark of Object.values(this.marks)) if (mark) this.group.add(mark);
  }

  // Whether the scene has what a switch shows.
  offers(key) {
    if (key === 'regions') return this.surface.labelled;
    if (key === 'shading' || key === 'lines') return this.surface.largest_distance > 0;
    if (key === 'wireframe' || key === 'smooth') return true;
    return Boolean(this.marks[key]);
  }

  // The number of dots that a switch shows; empty if it shows something else.
  count(key) {
    const mark = this.marks[key];
    return mark?.isPoints ? String(mark.geometry.getAttribute('position').count) : '';
  }

  // Shows what `on` (key to boolean) asks for.
  apply(on) {
    if (on.wireframe && !this.marks.wireframe) {
      this.marks.wireframe = make_wireframe(this.surface, this.materials.wire);
      this.group.add(this.marks.wireframe);
    }
    for (const [key, mark] of Object.entries(this.marks)) if (mark) mark.visible = on[key];
    const uniforms = this.materials.outside.uniforms;
    const largest = this.surface.largest_distance || 1;
    uniforms.fills.value = this.texture;
    uniforms.show_regions.value = on.regions && this.offers('regions');
    uniforms.show_shading.value = on.shading;
    uniforms.show_lines.value = on.lines;
    uniforms.smooth_normals.value = on.smooth;
    uniforms.largest_distance.value = largest;
    uniforms.line_spacing.value = round_step(largest * this.scale, 12) / this.scale;
  }
}
