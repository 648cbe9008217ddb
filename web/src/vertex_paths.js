// Shortest paths of vertices, which a click shows. They are the exact ones that the file holds: none is computed here.
import { read_array } from './data.js';
import { format_number, group_digits } from './panel.js';

function square_distance(p, i, q, k) {
  const x = p[3 * i] - q[3 * k], y = p[3 * i + 1] - q[3 * k + 1], z = p[3 * i + 2] - q[3 * k + 2];
  return x * x + y * y + z * z;
}

// The point nearest to point `k` of `others`, among the points `at(i)` of `points` with i from 0 to `count` - 1.
function nearest_point(points, others, k, count, at) {
  let best = 0, least = Infinity;
  for (let i = 0; i < count; ++i) {
    const squared = square_distance(points, at(i), others, k);
    if (squared < least) [best, least] = [i, squared];
  }
  return { index: best, distance: Math.sqrt(least) };
}

export class VertexPaths {
  constructor(entry, surface, scale) {
    this.vertices = read_array(entry.vertex_paths.vertices);
    this.counts = read_array(entry.vertex_paths.counts);
    this.points = read_array(entry.vertex_paths.points);
    this.sources = read_array(entry.generators);
    this.first = new Uint32Array(this.counts.length + 1);
    this.counts.forEach((count, i) => (this.first[i + 1] = this.first[i] + count));
    [this.surface, this.scale] = [surface, scale];
  }

  // The path of the vertex that is nearest to a point of face `f`: {points, counts}, to be drawn, and a card.
  from(f, bary) {
    const { positions, faces, distances } = this.surface;
    const clicked = [0, 1, 2].map((k) => bary.reduce((sum, b, i) => sum + b * positions[3 * faces[3 * f + i] + k], 0));
    const near = nearest_point(positions, clicked, 0, this.vertices.length, (i) => this.vertices[i]);
    const vertex = this.vertices[near.index], first = this.first[near.index], last = this.first[near.index + 1];
    const source = nearest_point(this.sources, this.points, last - 1, this.sources.length / 3, (i) => i);
    const length = (value) => format_number(Number((value * this.scale).toPrecision(6)));
    const rows = [
      ['Exact length', length(distances[vertex])],
      ['Source', String(source.index)],
      ['Click to vertex', length(near.distance)],
      ['Stored paths', group_digits(`${this.vertices.length} of ${positions.length / 3} vertices`)],
    ];
    const points = this.points.subarray(3 * first, 3 * last);
    return { points, counts: [last - first], card: { title: `Path from vertex ${vertex}`, rows } };
  }
}
