// The numbers behind the colours: per region, and per face.

const kOutliers = 0.01;  // share of values on either side that are left out of a range

// The smallest and the largest finite value; null where there is none.
export function value_range(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : null;
}

// A round number (1, 2, 5 or 10 times a power of ten) that divides `range` into about `parts` steps.
export function round_step(range, parts) {
  const rough = range / parts, power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= rough * (1 - 1e-9));
}

// The least round number from `value` on with two digits.
export function round_up(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return Number((power * [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((factor) => factor * power >= value * (1 - 1e-9))).toPrecision(6));
}

// The range that nearly all of `values` have, with multiples of `step` as ends: outliers would leave the others with
// similar colours. {range, below, above}: whether there are some on either side.
export function usual_range(values, step) {
  const sorted = Float32Array.from(values).sort(), at = (share) => sorted[Math.round(share * (sorted.length - 1))];
  const first = Math.floor(at(kOutliers) / step + 1e-4), last = Math.max(Math.ceil(at(1 - kOutliers) / step - 1e-4), first + 1);
  const [low, high] = [first, last].map((k) => Number((k * step).toFixed(6)));
  return { range: [low, high], below: sorted[0] < low - 1e-6, above: sorted.at(-1) > high + 1e-6 };
}

// Where `value` lies in `range`, from 0 to 1; 0.5 in a range without length.
export function position_in([low, high], value) {
  return high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0.5;
}

// The lengths of the sides of face `f`, ascending.
function sides(positions, faces, f) {
  const u = 3 * faces[3 * f], v = 3 * faces[3 * f + 1], w = 3 * faces[3 * f + 2];
  const length = (i, j) =>
    Math.hypot(positions[i] - positions[j], positions[i + 1] - positions[j + 1], positions[i + 2] - positions[j + 2]);
  const a = length(v, w), b = length(w, u), c = length(u, v), least = Math.min(a, b, c), most = Math.max(a, b, c);
  return [least, Math.max(Math.min(a, b), Math.min(Math.max(a, b), c)), most];
}

// Four times the area of the triangle with the sides a <= b <= c, stable for thin ones.
// Source: Kahan, Miscalculating area and angles of a needle-like triangle, 2014.
function four_areas(a, b, c) {
  return Math.sqrt(Math.max(0, (c + (b + a)) * (a - (c - b)) * (a + (c - b)) * (c + (b - a))));
}

// The quality of face `f`, 6 A / (√3 p h), with the area A, half the perimeter p and the longest edge h: 1 for an
// equilateral one, 0 for one without area. Its mean is `q_average` of gvd-remesh.
export function face_quality(positions, faces, f) {
  const [a, b, c] = sides(positions, faces, f), scale = (a + b + c) * c;
  return scale > 0 ? Math.min(1, (3 * four_areas(a, b, c)) / (Math.sqrt(3) * scale)) : 0;
}

// The smallest angle of face `f`, degrees: it is opposite to the shortest side.
export function face_angle(positions, faces, f) {
  const [a, b, c] = sides(positions, faces, f);
  return (Math.atan2(four_areas(a, b, c), b * b + c * c - a * a) * 180) / Math.PI;
}

// `value(positions, faces, f)` of every face.
export function face_values(positions, faces, value) {
  return Float32Array.from({ length: faces.length / 3 }, (_, f) => value(positions, faces, f));
}

// The number of edges at a vertex, and whether it is on the boundary.
export function count_edges(faces, vertex) {
  const neighbours = new Set();
  let count = 0;
  for (let i = 0; i < faces.length; ++i) {
    if (faces[i] !== vertex) continue;
    const first = i - (i % 3);
    for (let k = first; k < first + 3; ++k) if (k !== i) neighbours.add(faces[k]);
    ++count;
  }
  return { edges: neighbours.size, boundary: neighbours.size !== count };
}

// The area of triangles, nine coordinates each.
export function triangles_area(positions) {
  let area = 0;
  for (let i = 0; i < positions.length; i += 9) {
    const ux = positions[i + 3] - positions[i], uy = positions[i + 4] - positions[i + 1];
    const uz = positions[i + 5] - positions[i + 2];
    const vx = positions[i + 6] - positions[i], vy = positions[i + 7] - positions[i + 1];
    const vz = positions[i + 8] - positions[i + 2];
    const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    area += Math.sqrt(nx * nx + ny * ny + nz * nz) / 2;
  }
  return area;
}
