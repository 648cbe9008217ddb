// The modules of the page that need no browser: node --test modules.test.mjs.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { make_coarse } from '../src/coarse.js';
import { fit_points } from '../src/fit.js';
import { format_share } from '../src/panel.js';
import { ramp, ramp_gradient } from '../src/ramp.js';
import { sort_labels } from '../src/region_table.js';
import { file_name } from '../src/save_picture.js';
import { face_qualities, position_in, triangles_area, value_range } from '../src/values.js';

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

test('qualities and areas of triangles', () => {
  const positions = [0, 0, 0, 1, 0, 0, 0.5, Math.sqrt(3) / 2, 0, 2, 0, 0];
  const [regular, flat] = face_qualities(positions, [0, 1, 2, 0, 1, 3]);
  near(regular, 1);
  near(flat, 0);
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
