// Distances of a scene's surface from another one: per vertex and, in large faces, on a lattice.
import { read_array } from './data.js';
import { round_up } from './values.js';

// Where a point with the weights b0 and b2 of corners 0 and 2 lies in a lattice of k steps: the numbers of the three
// points of its triangle, and their weights. The shader of materials.js does the same.
export function locate_in_lattice(k, b0, b2) {
  const at = (row, j) => (row * (2 * k + 3 - row)) / 2 + j;
  const x = Math.max(b0 * k, 0), y = Math.max(b2 * k, 0);
  const i = Math.min(Math.floor(x), k - 1), j = Math.min(Math.floor(y), k - 1 - i);
  const u = x - i, v = y - j;
  if (u + v > 1 && i + j < k - 1) return { points: [at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)], weights: [u + v - 1, 1 - u, 1 - v] };
  return { points: [at(i, j), at(i + 1, j), at(i, j + 1)], weights: [1 - u - v, u, v] };
}

export class SurfaceDistance {
  // `entry`: of the manifest. Values are in mesh units.
  constructor(entry, scale, faces) {
    this.other = entry.other;
    this.reference = entry.reference;
    this.scale_end = (round_up((100 * entry.scale_end) / entry.reference) * entry.reference) / 100;  // a round percentage
    this.faces = faces;
    this.vertices = read_array(entry.vertices).map((distance) => distance * scale);
    this.steps = read_array(entry.steps);  // empty where no face has a lattice
    const values = read_array(entry.lattice);
    this.lattice = Float32Array.from(values, (value) => value * (entry.lattice_unit ?? 0));
    const is_beyond = (distance) => distance > this.scale_end * (1 + 1e-4);  // the rounding of the arrays is less
    this.exceeds = this.vertices.some(is_beyond) || this.lattice.some(is_beyond);
    this.first = new Uint32Array(this.steps.length);
    let next = 0;
    this.steps.forEach((k, f) => {
      this.first[f] = next;
      if (k > 1) next += ((k + 1) * (k + 2)) / 2;
    });
  }

  // At the point of face `f` with barycentric coordinates `bary`.
  at(f, bary) {
    const k = this.steps[f] ?? 1;
    if (k < 2) return bary.reduce((sum, b, i) => sum + b * this.vertices[this.faces[3 * f + i]], 0);
    const { points, weights } = locate_in_lattice(k, bary[0], bary[2]);
    return points.reduce((sum, point, i) => sum + weights[i] * this.lattice[this.first[f] + point], 0);
  }

  // The largest sample of face `f`.
  largest(f) {
    const k = this.steps[f] ?? 1;
    if (k < 2) return Math.max(...[0, 1, 2].map((i) => this.vertices[this.faces[3 * f + i]]));
    const first = this.first[f];
    return this.lattice.subarray(first, first + ((k + 1) * (k + 2)) / 2).reduce((a, b) => Math.max(a, b));
  }

  // For each corner of triangles whose faces are `parents`: its distance, as a share of the scale; and two numbers, where
  // the lattice of its face begins and what steps it has, 0 where it has none.
  corner_values(parents) {
    const shares = new Float32Array(3 * parents.length), lattices = new Float32Array(6 * parents.length);
    parents.forEach((f, t) => {
      const k = this.steps[f] ?? 1;
      for (let i = 0; i < 3; ++i) {
        shares[3 * t + i] = this.vertices[this.faces[3 * f + i]] / this.scale_end;
        if (k > 1) lattices.set([this.first[f], k], 6 * t + 2 * i);
      }
    });
    return { shares, lattices };
  }
}
