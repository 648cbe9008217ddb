// The numbers behind the colours: per region, and per face.

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

// Where `value` lies in `range`, from 0 to 1; 0.5 in a range without length.
export function position_in([low, high], value) {
  return high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0.5;
}

// Per face 6 A / (sqrt 3 p h), with the area A, half the perimeter p and the longest edge h: 1 where it is equilateral,
// 0 where it has no area. It is `q_average` of gvd-remesh, per face.
export function face_qualities(positions, faces) {
  const qualities = new Float32Array(faces.length / 3);
  const length = (u, v) =>
    Math.hypot(positions[u] - positions[v], positions[u + 1] - positions[v + 1], positions[u + 2] - positions[v + 2]);
  for (let f = 0; f < qualities.length; ++f) {
    const u = 3 * faces[3 * f], v = 3 * faces[3 * f + 1], w = 3 * faces[3 * f + 2];
    const a = length(v, w), b = length(w, u), c = length(u, v), p = (a + b + c) / 2;
    const area = Math.sqrt(Math.max(0, p * (p - a) * (p - b) * (p - c)));
    const scale = p * Math.max(a, b, c);
    qualities[f] = scale > 0 ? Math.min(1, (6 * area) / (Math.sqrt(3) * scale)) : 0;
  }
  return qualities;
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
