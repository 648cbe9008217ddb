// What lies on the surface: bisectors, the mesh's edges, generators and branch points.
import { BufferAttribute, BufferGeometry, LineSegments, Points } from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { read_array } from './data.js';
import { make_dot_material, make_line_material, make_wire_material } from './materials.js';

// Pixels.
const kBisectorWidth = 2.4;
const kGeneratorDiameter = 10;
const kBranchPointDiameter = 7.5;

export function make_mark_materials() {
  return {
    line: make_line_material(kBisectorWidth),
    wire: make_wire_material(),
    generator: make_dot_material(kGeneratorDiameter),
    added_generator: make_dot_material(kGeneratorDiameter),
    branch_point: make_dot_material(kBranchPointDiameter),
  };
}

export function make_bisectors(scene, material) {
  if (!scene.bisectors) return null;
  const points = read_array(scene.bisectors.points), counts = read_array(scene.bisectors.counts);
  let segments = 0;
  for (const count of counts) segments += Math.max(0, count - 1);
  const ends = new Float32Array(6 * segments);
  let at = 0, first = 0;
  for (const count of counts) {
    for (let i = first; i + 1 < first + count; ++i, at += 6) ends.set(points.subarray(3 * i, 3 * i + 6), at);
    first += count;
  }
  return segments ? new LineSegments2(new LineSegmentsGeometry().setPositions(ends), material) : null;
}

export function make_dots(reference, material) {
  if (!reference) return null;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(read_array(reference), 3));
  const dots = new Points(geometry, material);
  dots.renderOrder = 2;
  return dots;
}

// Every edge once, as pairs of vertices.
function unique_edges(faces, vertex_count) {
  const keys = new Float64Array(faces.length);
  for (let i = 0; i < faces.length; ++i) {
    const u = faces[i], v = faces[i % 3 === 2 ? i - 2 : i + 1];
    keys[i] = Math.min(u, v) * vertex_count + Math.max(u, v);
  }
  keys.sort();
  const edges = new Uint32Array(2 * keys.length);
  let size = 0;
  for (let i = 0; i < keys.length; ++i) {
    if (i > 0 && keys[i] === keys[i - 1]) continue;
    edges[size++] = Math.floor(keys[i] / vertex_count);
    edges[size++] = keys[i] % vertex_count;
  }
  return edges.slice(0, size);
}

export function make_wireframe(surface, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(surface.positions, 3));
  geometry.setIndex(new BufferAttribute(unique_edges(surface.faces, surface.positions.length / 3), 1));
  const lines = new LineSegments(geometry, material);
  lines.renderOrder = 1;
  return lines;
}
