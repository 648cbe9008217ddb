// Fewer triangles for while the surface turns: corners in the same cube of a grid become one (Rossignac and Borrel 1993).

const kCubes = 144;           // along the longest side of the box: about three pixels on a large screen
const kWorthwhile = 0.5;      // with more triangles left than this share, the whole surface is drawn

function box_of(positions) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    const k = i % 3, value = positions[i];
    if (value < low[k]) low[k] = value;
    if (value > high[k]) high[k] = value;
  }
  return { low, high };
}

// Per corner, the number of its cube, in the order in which cubes are met; and their number.
function number_cubes(positions, cubes) {
  const { low, high } = box_of(positions);
  const side = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / cubes || 1;
  const count = [0, 1, 2].map((k) => Math.floor((high[k] - low[k]) / side) + 1);
  const number = new Int32Array(count[0] * count[1] * count[2]);
  const cube = new Uint32Array(positions.length / 3);
  let size = 0;
  for (let i = 0; i < cube.length; ++i) {
    const x = Math.floor((positions[3 * i] - low[0]) / side);
    const y = Math.floor((positions[3 * i + 1] - low[1]) / side);
    const z = Math.floor((positions[3 * i + 2] - low[2]) / side);
    const at = x + count[0] * (y + count[1] * z);
    if (number[at] === 0) number[at] = ++size;
    cube[i] = number[at] - 1;
  }
  return { cube, size };
}

// The mean position of the corners in each cube.
function mean_positions(positions, cube, size) {
  const means = new Float32Array(3 * size), weight = new Float32Array(size);
  for (let i = 0; i < cube.length; ++i) {
    const c = cube[i];
    ++weight[c];
    for (let k = 0; k < 3; ++k) means[3 * c + k] += (positions[3 * i + k] - means[3 * c + k]) / weight[c];
  }
  return means;
}

// The first corners of the triangles with corners in three different cubes, one triangle for each three cubes.
function choose_triangles(cube) {
  const kept = [], known = new Set();
  for (let i = 0; i < cube.length; i += 3) {
    const a = cube[i], b = cube[i + 1], c = cube[i + 2];
    if (a === b || b === c || c === a) continue;
    const key = a < b && a < c ? `${a},${b},${c}` : b < c ? `${b},${c},${a}` : `${c},${a},${b}`;
    if (known.has(key)) continue;
    known.add(key);
    kept.push(i);
  }
  return kept;
}

// Fewer triangles {positions, normals, codes, distances, parents, barys} for those given, or null where that gains little.
// Positions are means of their cubes, all else is that of a triangle that was there.
export function make_coarse(triangles, cubes = kCubes) {
  const { cube, size } = number_cubes(triangles.positions, cubes);
  const kept = choose_triangles(cube);
  if (3 * kept.length > kWorthwhile * cube.length) return null;
  const means = mean_positions(triangles.positions, cube, size);
  const coarse = {
    positions: new Float32Array(9 * kept.length),
    normals: new Int16Array(12 * kept.length),
    codes: new Float32Array(3 * kept.length),
    distances: new Float32Array(3 * kept.length),
    parents: new Uint32Array(kept.length),
    barys: new Float32Array(9 * kept.length),
  };
  kept.forEach((first, t) => {
    coarse.normals.set(triangles.normals.subarray(4 * first, 4 * first + 12), 12 * t);
    coarse.codes.set(triangles.codes.subarray(first, first + 3), 3 * t);
    coarse.distances.set(triangles.distances.subarray(first, first + 3), 3 * t);
    coarse.parents[t] = triangles.parents[first / 3];
    coarse.barys.set(triangles.barys.subarray(3 * first, 3 * first + 9), 9 * t);
    for (let k = 0; k < 3; ++k) {
      coarse.positions.set(means.subarray(3 * cube[first + k], 3 * cube[first + k] + 3), 9 * t + 3 * k);
    }
  });
  return coarse;
}
