// The modules of the page that need no browser: node --test modules.test.mjs.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { animate_webp } from '../src/animated_webp.js';
import { make_coarse } from '../src/coarse.js';
import { sum_steps } from '../src/data.js';
import { choose_first_view } from '../src/first_view.js';
import { fit_points } from '../src/fit.js';
import { make_ticks } from '../src/legend.js';
import { format_share, group_digits } from '../src/panel.js';
import { ramp, ramp_gradient } from '../src/ramp.js';
import { cross_plane } from '../src/ray.js';
import { sort_labels } from '../src/region_table.js';
import { file_name } from '../src/save_picture.js';
import { locate_in_lattice, SurfaceDistance } from '../src/surface_distance.js';
import { VertexPaths } from '../src/vertex_paths.js';
import { count_edges, face_angle, face_quality, face_values, position_in, round_up, triangles_area, usual_range, value_range } from '../src/values.js';

const kAxes = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] };
const near = (value, wanted, tolerance = 1e-6) => assert.ok(Math.abs(value - wanted) <= tolerance, `${value}, not ${wanted}`);

test('the fitted camera sees every point, and one of them at each end of the tighter direction', () => {
  const positions = [];
  for (let i = 0; i < 300; ++i) positions.push(2 + Math.sin(7 * i), Math.cos(3 * i) * 0.4 - 1, Math.sin(5 * i) * 0.7);
  const [wide, high] = [0.3, 0.25], { x, y, distance } = fit_points(positions, kAxes, wide, high);
  let [most_x, most_y] = [0, 0];
  for (let i = 0; i < positions.length; i += 3) {
    const depth = distance - positions[i + 2];
    most_x = Math.max(most_x, Math.abs(positions[i] - x) / depth / wide);
    most_y = Math.max(most_y, Math.abs(positions[i + 1] - y) / depth / high);
  }
  near(most_x, 1);
  assert.ok(most_y <= 1 + 1e-9);
  near(fit_points([3, 4, 5], kAxes, 1, 1).x, 3);
});

test('qualities, angles and areas of triangles', () => {
  const positions = [0, 0, 0, 1, 0, 0, 0.5, Math.sqrt(3) / 2, 0, 2, 0, 0, 0.5, 1e-5, 0, 1, 1, 0];
  const faces = [0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5];
  const [regular, flat, thin] = face_values(positions, faces, face_quality);
  near(regular, 1);
  near(flat, 0);
  near(thin, (6 * 0.5e-5) / Math.sqrt(3), 1e-8);
  const angles = face_values(positions, faces, face_angle);
  near(angles[0], 60, 1e-4);
  near(angles[1], 0);
  near(angles[2] / ((2e-5 * 180) / Math.PI), 1, 1e-5);
  near(angles[3], 45, 1e-4);
  near(triangles_area([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 0, 2]), 2.5);
});

test('ranges leave out what is not finite', () => {
  assert.deepEqual(value_range([3, Infinity, 1, NaN]), [1, 3]);
  assert.equal(value_range([NaN]), null);
  assert.deepEqual([position_in([1, 3], 2), position_in([1, 3], 9), position_in([2, 2], 2)], [0.5, 1, 0.5]);
});

test('the ramp becomes lighter from end to end', () => {
  const lightness = ([r, g, b]) => 0.2126 * r ** 2.2 + 0.7152 * g ** 2.2 + 0.0722 * b ** 2.2;
  for (let i = 1; i <= 64; ++i) assert.ok(lightness(ramp(i / 64)) > lightness(ramp((i - 1) / 64)), String(i));
  assert.deepEqual([ramp(0), ramp(1), ramp(-1)], [[68, 1, 84], [253, 231, 37], [68, 1, 84]]);
  assert.match(ramp_gradient(), /^linear-gradient\(to right, rgb\(68,1,84\), .*\)$/);
});

// A flat square of 2 n^2 triangles with code 3 on its left half and 4 on its right.
function make_square(n) {
  const positions = [], codes = [];
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < n; ++j) {
      positions.push(i, j, 0, i + 1, j, 0, i + 1, j + 1, 0, i, j, 0, i + 1, j + 1, 0, i, j + 1, 0);
      for (let k = 0; k < 6; ++k) codes.push(2 * i < n ? 3 : 4);
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Int16Array((4 * positions.length) / 3),
    codes: new Float32Array(codes),
    distances: new Float32Array(codes.length).fill(0.5),
    parents: Uint32Array.from({ length: codes.length / 3 }, (_, t) => t),
    barys: new Float32Array(3 * codes.length),
  };
}

test('the coarse surface covers nearly the same with far fewer triangles', () => {
  const square = make_square(100), coarse = make_coarse(square, 20);
  assert.ok(coarse.parents.length < square.parents.length / 15, `${coarse.parents.length} triangles`);
  near(triangles_area(coarse.positions) / triangles_area(square.positions), 1, 0.12);
  assert.equal(coarse.codes.length, 3 * coarse.parents.length);
  assert.equal(coarse.normals.length, 12 * coarse.parents.length);
  coarse.parents.forEach((f, t) => assert.equal(coarse.codes[3 * t], square.codes[3 * f]));
});

test('a surface that a grid would not thin out has no coarse version', () => {
  assert.equal(make_coarse(make_square(10), 20), null);
});

test('labels sort by a column, equal ones by label', () => {
  const cells = [{ area: 2, neighbours: [1] }, { area: 5, neighbours: [0, 2] }, { area: 2, neighbours: [1] }];
  assert.deepEqual(sort_labels(cells, 'area', false), [1, 0, 2]);
  assert.deepEqual(sort_labels(cells, 'area', true), [0, 2, 1]);
  assert.deepEqual(sort_labels(cells, 'neighbours', false), [1, 0, 2]);
  assert.deepEqual(sort_labels(cells, 'label', false), [2, 1, 0]);
});

test('shares have one digit after the point, small ones two that are not 0', () => {
  assert.deepEqual([0.123456, 0.0149, 0.00035041, 0.00002].map(format_share), ['12.3', '1.5', '0.035', '0.002']);
});

test('titles become file names', () => {
  assert.equal(file_name('gvd-segment: a b.obj'), 'gvd-segment-a-b.obj.png');
  assert.equal(file_name('../<>'), 'picture.png');
});

test('a vertex has as many edges as neighbours, one more than faces on the boundary', () => {
  const fan = [0, 1, 2, 0, 2, 3, 4, 0, 3];
  assert.deepEqual(count_edges(fan, 0), { edges: 4, boundary: true });
  assert.deepEqual(count_edges([...fan, 0, 4, 1], 0), { edges: 4, boundary: false });
  assert.deepEqual(count_edges(fan, 2), { edges: 3, boundary: true });
});

// Row i of a lattice of k steps has the weight i / k of corner 0, point j of it j / k of corner 2.
function make_lattice(k, value) {
  const values = [];
  for (let i = 0; i <= k; ++i) for (let j = 0; j <= k - i; ++j) values.push(value(i / k, (k - i - j) / k, j / k));
  return values;
}

test('lattices have their values at their points, and are linear between them', () => {
  for (const k of [2, 3, 10, 64]) {
    const linear = make_lattice(k, (a, b, c) => 3 * a + 5 * b + 11 * c);
    for (let i = 0; i < 300; ++i) {
      const s = (i * 0.618034) % 1, t = (1 - s) * ((i * 0.754878) % 1);
      const { points, weights } = locate_in_lattice(k, s, t);
      near(weights.reduce((sum, w) => sum + w, 0), 1, 1e-12);
      assert.ok(weights.every((w) => w > -1e-9 && w < 1 + 1e-9), `${weights}`);
      near(points.reduce((sum, p, n) => sum + weights[n] * linear[p], 0), 3 * s + 5 * (1 - s - t) + 11 * t, 1e-9);
    }
    for (const [s, t] of [[1, 0], [0, 1], [0, 0], [0.5, 0.5], [1 + 1e-7, -1e-7], [-1e-7, 1 + 1e-7]]) {
      const { points, weights } = locate_in_lattice(k, s, t);
      assert.ok(points.every((p) => p >= 0 && p < linear.length));
      near(points.reduce((sum, p, n) => sum + weights[n] * linear[p], 0), 3 * s + 5 * (1 - s - t) + 11 * t, 1e-5);
    }
  }
});

test('distances of a surface come from its lattices, and from its vertices where a face has none', () => {
  const faces = Uint32Array.from([0, 1, 2, 1, 3, 2]);
  const bump = make_lattice(4, (a, b, c) => (Math.min(a, b, c) >= 0.25 ? 1000 : 0));  // the three inner points
  {
    const [vertices, steps, lattice] = [Float32Array.from([1, 2, 3, 4]), Uint8Array.from([1, 4]), Uint16Array.from(bump)];
    const entry = { other: 'it', reference: 8, scale_end: 2, vertices, steps, lattice, lattice_unit: 0.01 };
    const distance = new SurfaceDistance(entry, 0.5, faces);
    near(distance.at(0, [0.2, 0.3, 0.5]), 0.5 * (0.2 + 0.6 + 1.5));
    near(distance.largest(0), 1.5);
    near(distance.at(1, [0.5, 0.25, 0.25]), 10, 1e-5);
    near(distance.at(1, [0, 0.5, 0.5]), 0);
    near(distance.largest(1), 10, 1e-5);
    assert.ok(distance.exceeds);
    const { shares, lattices } = distance.corner_values([1, 0]);
    assert.deepEqual([...shares], [0.5, 1, 0.75, 0.25, 0.5, 0.75]);
    assert.deepEqual([...lattices], [0, 4, 0, 4, 0, 4, 0, 0, 0, 0, 0, 0]);
  }
  const distance = new SurfaceDistance({ other: 'it', reference: 8, scale_end: 2, vertices: Float32Array.from([1, 2, 3, 4]) }, 0.5, faces);
  near(distance.at(1, [1, 0, 0]), 1);
  assert.equal(distance.exceeds, false);
});

test('ticks are round numbers at their places, and those at the ends say where other values have their colours', () => {
  const ticks = (range, exceeded) => make_ticks(range, exceeded).map(({ text, share }) => `${text} at ${Number(share.toFixed(3))}`);
  assert.deepEqual(ticks([0, 0.123456]), ['0 at 0', '0.05 at 0.405', '0.1 at 0.81']);
  assert.deepEqual(ticks([0.06373, 0.2]), ['0.1 at 0.266', '0.15 at 0.633', '0.2 at 1']);
  assert.deepEqual(ticks([0, 5], { above: true }), ['0 at 0', '2 at 0.4', '4 at 0.8']);
  assert.deepEqual(ticks([0.7, 1], { below: true }).at(0), '≤ 0.7 at 0');
  assert.deepEqual(ticks([0, 12000], { above: true }).at(-1), '10,000 at 0.833');
  assert.deepEqual(ticks([3, 3]), ['3 at 0.5']);
  assert.deepEqual([0.123, 4.7, 5, 1300].map(round_up), [0.15, 5, 5, 1500]);
});

test('the range of values of faces leaves out outliers, and has round ends', () => {
  const values = Array.from({ length: 1000 }, (_, i) => 0.62 + (0.33 * i) / 999), range = (list) => usual_range(list, 0.05);
  assert.deepEqual(range(values), { range: [0.6, 0.95], below: false, above: false });
  assert.deepEqual(range([0.01, ...values, 0.97]), { range: [0.6, 0.95], below: true, above: true });
  assert.deepEqual(range([0.7, 0.7]).range, [0.7, 0.75]);
});

test('coordinates are sums of differences with the sign in the lowest bit, lowest bytes first', () => {
  const bytes = Uint8Array.of(6, 5, 0, 0, 1, 44, 0, 0, 0, 0, 0, 1);  // 6, 5, 0, 0, 1, 300
  assert.deepEqual([...sum_steps(bytes, { count: 6, step: 3, unit: 0.5 })], [1.5, -1.5, 0, 1.5, -2, 75]);
  assert.equal(sum_steps(new Uint8Array(0), { count: 0, step: 3, unit: 1 }).length, 0);
});

test('thousands have commas, but not digits after a point', () => {
  assert.deepEqual(['5876', '999', '2000 of 12345678', '14266.3', '0.123456', '1.51 %'].map(group_digits),
                   ['5,876', '999', '2,000 of 12,345,678', '14,266.3', '0.123456', '1.51 %']);
});

test('a film of WebP pictures has the parts that the format demands', () => {
  const chunk = (name, size) => Buffer.concat([Buffer.from(name), Buffer.from([size, 0, 0, 0]), Buffer.alloc(size + (size % 2), 7)]);
  const still = Buffer.concat([Buffer.from('RIFF____WEBP'), chunk('VP8X', 10), chunk('ALPH', 3), chunk('VP8 ', 6)]);
  const film = Buffer.from(animate_webp([still, still], { width: 300, height: 20, pause: 50 })), names = [];
  assert.equal(film.readUInt32LE(4), film.length - 8);
  for (let at = 12; at < film.length; at += 8 + film.readUInt32LE(at + 4)) names.push(film.toString('latin1', at, at + 4));
  assert.deepEqual(names, ['VP8X', 'ANIM', 'ANMF', 'ANMF']);
  assert.deepEqual([film.readUIntLE(24, 3), film.readUIntLE(27, 3)], [299, 19]);
  const frame = film.subarray(film.indexOf('ANMF'));
  assert.deepEqual([frame.readUIntLE(20, 3), frame.indexOf('ALPH'), frame.indexOf('VP8 ')], [50, 24, 36]);
});

test('a surface is seen first from the side with its shape, unless the usual side is as good', () => {
  const axes = { up: [0, 1, 0], ahead: [0, 0, 1], side: [1, 0, 0] }, positions = [], faces = [], n = 24;
  for (let i = 0; i <= n; ++i) for (let j = 0; j < 2 * n; ++j) {
    const a = (Math.PI * i) / n, b = (Math.PI * j) / n, bump = 1 + (Math.cos(b) < -0.3 ? 0.1 * Math.sin(12 * a) * Math.sin(12 * b) : 0);
    positions.push(bump * Math.sin(a) * Math.sin(b), bump * Math.cos(a), bump * Math.sin(a) * Math.cos(b));  // bumps towards -z
    const u = 2 * n * i + j, v = 2 * n * i + ((j + 1) % (2 * n));
    if (i < n) faces.push(u, u + 2 * n, v, v, u + 2 * n, v + 2 * n);
  }
  const view = (points) => choose_first_view(points, faces, axes);
  assert.ok(view(positions)[2] < -0.8, `${view(positions)}`);
  const smooth = positions.map((value, i) => value / Math.hypot(...positions.slice(i - (i % 3), i - (i % 3) + 3)));
  assert.ok(view(smooth)[2] > 0.7 && view(smooth)[0] > 0.4, `${view(smooth)}`);
});

test('an opening is seen first obliquely, a cap without much inside from outside', () => {
  const axes = { up: [0, 1, 0], ahead: [0, 0, 1], side: [1, 0, 0] }, n = 24, m = 48;
  const view_cap = (degrees) => {  // round the z axis
    const positions = [], faces = [];
    for (let i = 0; i <= n; ++i) for (let j = 0; j < m; ++j) {
      const a = (degrees * Math.PI * i) / (180 * n), b = (2 * Math.PI * j) / m, u = m * i + j, v = m * i + ((j + 1) % m);
      positions.push(Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a));
      if (i < n) faces.push(u, u + m, v, v, u + m, v + m);
    }
    return choose_first_view(positions, faces, axes)[2];
  };
  for (const degrees of [10, 60, 75]) assert.ok(view_cap(degrees) > 0.9, `${degrees}: ${view_cap(degrees)}`);
  for (const degrees of [90, 110, 130]) assert.ok(Math.abs(view_cap(degrees) + 0.55) < 0.25, `${degrees}: ${view_cap(degrees)}`);
});

test('a ray through the canvas finds its point of a face', () => {
  const corners = [[0, 0, 0], [4, 0, 1], [0, 2, -1]], bary = [0.5, 0.2, 0.3];
  const point = [0, 1, 2].map((k) => bary.reduce((sum, b, i) => sum + b * corners[i][k], 0));
  cross_plane([3, 1, 9], point, ...corners).forEach((b, i) => near(b, bary[i], 1e-12));
  assert.deepEqual(cross_plane([0, 0, 1], [1, 0, 1], [0, 0, 0], [1, 0, 0], [0, 1, 0]), [1 / 3, 1 / 3, 1 / 3]);
});

test('a click shows the stored path of the nearest vertex that has one', () => {
  const entry = {
    vertex_paths: {
      vertices: Uint8Array.of(0, 3),
      counts: Uint8Array.of(1, 3),
      points: Float32Array.of(0, 0, 0, 1, 1, 0, 0.5, 0.5, 0, 0, 0, 0),
    },
    generators: Float32Array.of(9, 9, 9, 0, 0, 0),
  };
  const surface = {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0),
    faces: Uint8Array.of(0, 1, 2, 1, 3, 2),
    distances: Float32Array.of(0, 1, 1, Math.SQRT2),
  };
  const paths = new VertexPaths(entry, surface, 10), found = paths.from(1, [0.3, 0.5, 0.2]);
  assert.deepEqual([...found.points], [1, 1, 0, 0.5, 0.5, 0, 0, 0, 0]);
  assert.deepEqual(found.counts, [3]);
  assert.equal(found.card.title, 'Path from vertex 3');
  const rows = Object.fromEntries(found.card.rows);
  assert.deepEqual([rows['Exact length'], rows.Source, rows['Stored paths']], ['14.1421', '1', '2 of 4 vertices']);
  near(Number(rows['Click to vertex']), 10 * Math.hypot(0.2, 0.3), 1e-4);
  assert.equal(paths.from(0, [0.8, 0.1, 0.1]).card.title, 'Path from vertex 0');
});
