// The triangles that are drawn: whole faces, and the pieces of the cut ones.
import { BufferAttribute, BufferGeometry } from 'three';
import { read_array } from './data.js';
import { corner_normals } from './normals.js';
import { position_in } from './values.js';

export const kUnreached = 0;
const kCut = 1;
export const kFirstLabel = 2;

// Largest distance that is finite; 0 where there is none.
function largest_finite(values) {
  let largest = 0;
  for (const value of values) if (value > largest && Number.isFinite(value)) largest = value;
  return largest;
}

class Triangles {
  constructor(count) {
    this.positions = new Float32Array(9 * count);
    this.normals = new Int16Array(12 * count);
    this.codes = new Float32Array(3 * count);
    this.distances = new Float32Array(3 * count);
    this.parents = new Uint32Array(count);  // the face of each triangle
    this.barys = new Float32Array(9 * count);
    this.size = 0;
  }

  // Adds the point of face `f` with barycentric coordinates b0, b1, b2.
  add(mesh, f, b0, b1, b2, code) {
    const i = this.size++, parent = (i / 3) | 0;
    const u = mesh.faces[3 * f], v = mesh.faces[3 * f + 1], w = mesh.faces[3 * f + 2];
    for (let k = 0; k < 3; ++k) {
      this.positions[3 * i + k] =
        b0 * mesh.positions[3 * u + k] + b1 * mesh.positions[3 * v + k] + b2 * mesh.positions[3 * w + k];
      const n = 9 * f + k;
      const normal = b0 * mesh.normals[n] + b1 * mesh.normals[n + 3] + b2 * mesh.normals[n + 6];
      this.normals[4 * i + k] = Math.round(32767 * normal);
    }
    this.barys[3 * i] = b0;
    this.barys[3 * i + 1] = b1;
    this.barys[3 * i + 2] = b2;
    this.codes[i] = code;
    this.parents[parent] = f;
    const d = mesh.distances;
    const distance = d.length ? b0 * d[u] + b1 * d[v] + b2 * d[w] : -1;
    this.distances[i] = Number.isFinite(distance) ? distance : -1;
  }
}

// What the graphics card draws, of the arrays of `Triangles` or of its coarse version.
export function make_geometry(triangles) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(triangles.positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(triangles.normals, 4, true));
  geometry.setAttribute('code', new BufferAttribute(triangles.codes, 1));
  geometry.setAttribute('distance', new BufferAttribute(triangles.distances, 1));
  return geometry;
}

// Sets the attribute `open`: at each corner of the triangles the share of the sky, 0 to 255, given for corners of faces.
export function set_open_shares(geometry, { parents, barys }, shares) {
  const bytes = new Uint8Array(barys.length / 3);
  for (let i = 0; i < bytes.length; ++i) {
    const f = 3 * parents[Math.floor(i / 3)];
    bytes[i] = barys[3 * i] * shares[f] + barys[3 * i + 1] * shares[f + 1] + barys[3 * i + 2] * shares[f + 2];
  }
  geometry.setAttribute('open', new BufferAttribute(bytes, 1, true));
}

// Adds the attributes `share` and `lattice`, by which the shader knows the distances of the triangles' points.
export function add_distances(geometry, { parents }, distance) {
  const { shares, lattices } = distance.corner_values(parents);
  geometry.setAttribute('share', new BufferAttribute(shares, 1));
  geometry.setAttribute('lattice', new BufferAttribute(lattices, 2));
}

// Sets the attribute `value`: where the value of the face of each triangle lies in the range.
export function set_face_values(geometry, { parents }, { values, range }) {
  const bytes = new Uint8Array(3 * parents.length);
  parents.forEach((f, t) => bytes.fill(Math.round(255 * position_in(range, values[f])), 3 * t, 3 * t + 3));
  geometry.setAttribute('value', new BufferAttribute(bytes, 1, true));
}

// Adds the attribute `chart`: the texture coordinates of the triangles' corners, from those of the faces' corners.
export function add_chart(geometry, { parents, barys }, texture) {
  const chart = Float32Array.from({ length: (2 * barys.length) / 3 }, (_, n) => {
    const b = 3 * (n >> 1), c = 9 * parents[Math.floor(n / 6)] + (n & 1);
    return barys[b] * texture[c] + barys[b + 1] * texture[c + 3] + barys[b + 2] * texture[c + 6];
  });
  geometry.setAttribute('chart', new BufferAttribute(chart, 2));
}

function add_faces(triangles, mesh, codes) {
  for (let f = 0; f < mesh.faces.length / 3; ++f) {
    const code = codes.length ? codes[f] : kUnreached;
    if (code === kCut) continue;
    triangles.add(mesh, f, 1, 0, 0, code);
    triangles.add(mesh, f, 0, 1, 0, code);
    triangles.add(mesh, f, 0, 0, 1, code);
  }
}

function add_pieces(triangles, mesh, pieces) {
  let first_corner = 0, next = 0;
  for (let p = 0; p < pieces.faces.length; ++p) {
    for (let t = 0; t < 3 * pieces.triangle_counts[p]; ++t, ++next) {
      const at = 2 * (first_corner + pieces.triangles[next]);
      const b1 = pieces.corners[at], b2 = pieces.corners[at + 1];
      triangles.add(mesh, pieces.faces[p], 1 - b1 - b2, b1, b2, pieces.codes[p]);
    }
    first_corner += pieces.corner_counts[p];
  }
}

// The surface of a scene: {triangles, positions, faces, largest_distance, distances, labelled}.
export function make_surface(scene) {
  const mesh = {};
  for (const name of ['positions', 'faces', 'distances']) mesh[name] = read_array(scene[name]);
  mesh.normals = corner_normals(mesh.positions, mesh.faces);
  const codes = read_array(scene.codes);
  const pieces = {};
  for (const name of ['faces', 'codes', 'corner_counts', 'corners', 'triangle_counts', 'triangles']) {
    pieces[name] = read_array(scene.pieces?.[name]);
  }
  let count = pieces.triangles.length / 3;
  for (let f = 0; f < mesh.faces.length / 3; ++f) count += codes[f] !== kCut;
  const triangles = new Triangles(count);
  add_faces(triangles, mesh, codes);
  add_pieces(triangles, mesh, pieces);
  return {
    triangles,
    positions: mesh.positions,
    faces: mesh.faces,
    normals: mesh.normals,
    largest_distance: largest_finite(mesh.distances),
    distances: mesh.distances,
    labelled: codes.length > 0,
  };
}
