// What lies on the surface: bisectors, the mesh's edges, generators and branch points.
import { BufferAttribute, BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute, LineSegments, Mesh, Points } from 'three';
import { read_array } from './data.js';
import { make_dot_material, make_line_material, make_wire_material } from './materials.js';

// Pixels.
const kBisectors = { least: 0.6, most: 2.4, share: 0.06 };
const kGenerators = { least: 3, most: 14, share: 0.3 };
const kBranchPoints = { least: 2.5, most: 10, share: 0.22 };
export const kMarkWidths = { borders: 3.5, isolines: 1.2, paths: 3 };
const kLargestDot = 0.036;  // of half the diagonal of the picture's box

export function make_mark_materials() {
  return {
    line: make_line_material(kBisectors.most),
    border: make_line_material(kMarkWidths.borders),
    isoline: make_line_material(kMarkWidths.isolines),
    path: make_line_material(kMarkWidths.paths),
    wire: make_wire_material(),
    generator: make_dot_material(kGenerators.least, kGenerators.most),
    added_generator: make_dot_material(kGenerators.least, kGenerators.most),
    branch_point: make_dot_material(kBranchPoints.least, kBranchPoints.most),
  };
}

// Diameters of dots in the page's coordinates: a share of the distance from a generator to the next.
export function dot_sizes(spacing) {
  const size = ({ share }) => Math.min(share * spacing, (share / kGenerators.share) * kLargestDot);
  return { generator: size(kGenerators), branch_point: size(kBranchPoints) };
}

// The width of bisectors in pixels where generators are `spacing` pixels apart.
export function bisector_width(spacing) {
  return Math.min(Math.max(kBisectors.share * spacing, kBisectors.least), kBisectors.most);
}

// The ends of the segments of polylines, `counts` points each: six coordinates a segment. Points that are nearer than
// `step` to the one before are left out, but for first and last ones.
export function line_segments(points, counts, step) {
  const ends = [];
  let first = 0;
  for (const count of counts) {
    let from = 3 * first;
    for (let i = first + 1; i < first + count; ++i) {
      const to = 3 * i, last = i === first + count - 1;
      const squared =
        (points[to] - points[from]) ** 2 + (points[to + 1] - points[from + 1]) ** 2 + (points[to + 2] - points[from + 2]) ** 2;
      if (!last && squared < step * step) continue;
      for (let k = 0; k < 3; ++k) ends.push(points[from + k]);
      for (let k = 0; k < 3; ++k) ends.push(points[to + k]);
      from = to;
    }
    first += count;
  }
  return new Float32Array(ends);
}

// The polylines {points, counts}, which are arrays. Null where there is nothing to draw.
export function make_lines({ points, counts }, material, step = 0) {
  const ends = line_segments(points, counts, step);
  return ends.length ? make_segments(ends, material) : null;
}

// Four vertices a segment, each with both ends.
function make_segments(ends, material) {
  const count = ends.length / 6, copies = new Float32Array(4 * ends.length), corners = new Uint32Array(ends.length);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 24; ++k) copies[24 * i + k] = ends[6 * i + (k % 6)];
    for (let k = 0; k < 6; ++k) corners[6 * i + k] = 4 * i + [0, 1, 2, 2, 1, 3][k];
  }
  const geometry = new BufferGeometry().setIndex(new BufferAttribute(corners, 1)), both = new InterleavedBuffer(copies, 6);
  geometry.setAttribute('position', new InterleavedBufferAttribute(both, 3, 0));
  geometry.setAttribute('end', new InterleavedBufferAttribute(both, 3, 3));
  const lines = new Mesh(geometry, material);
  lines.frustumCulled = false;  // it would need the sphere round them
  return lines;
}

// The polylines that a manifest entry refers to.
export function read_lines(reference, material, step = 0) {
  const read = (name) => read_array(reference?.[name]);
  return make_lines({ points: read('points'), counts: read('counts') }, material, step);
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

const closed = new WeakMap();  // by faces

// Whether every edge has two faces, so that only an eye inside the surface sees its inside.
export function is_closed({ faces, positions }) {
  if (!closed.has(faces)) closed.set(faces, unique_edges(faces, positions.length / 3).length === faces.length);
  return closed.get(faces);
}

export function make_wireframe(surface, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(surface.positions, 3));
  geometry.setIndex(new BufferAttribute(unique_edges(surface.faces, surface.positions.length / 3), 1));
  const lines = new LineSegments(geometry, material);
  lines.renderOrder = 1;
  return lines;
}
