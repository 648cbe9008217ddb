// The side from which a surface is seen first: one that shows much of it, of its shape, and of an opening.
//
// Where more area has its inside towards the eye than its outside, the difference is seen through openings. A view is best
// if that is half of what it shows: the outside alone hides that a half sphere is open, the inside alone looks like a disc.

const kSides = 24;     // directions that are tried, round the axis that points up
const kRise = 0.36;    // of the eye over the horizon, as the tangent of the angle
const kUsual = 0.555;  // the turn that is taken unless another one is clearly better
const kBetter = 1.05;  // by this factor
const kShape = 2;      // how much the shape counts, against the area
const kOpen = 1.2;     // how much an opening counts: a half sphere shows it, the cap of an angle of 75 degrees its outside
const kInside = 0.8;   // how much area and shape count on the inside

// Per face {area, normal, bend}: how far the normals at its corners are from its own.
function face_shapes(positions, faces) {
  const normals = new Float32Array(faces.length), at_vertices = new Float32Array(positions.length);
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [3 * faces[f], 3 * faces[f + 1], 3 * faces[f + 2]], u = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const v = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    for (let k = 0; k < 3; ++k) {
      const [i, j] = [(k + 1) % 3, (k + 2) % 3];
      normals[f + k] = u[i] * v[j] - u[j] * v[i];
      for (const corner of [a, b, c]) at_vertices[corner + k] += normals[f + k];
    }
  }
  const bends = new Float32Array(faces.length / 3);
  for (let f = 0; f < faces.length; f += 3) {
    for (let i = 0; i < 3; ++i) {
      const v = 3 * faces[f + i], dot = (p, q, s, t) => p[s] * q[t] + p[s + 1] * q[t + 1] + p[s + 2] * q[t + 2];
      const lengths = Math.sqrt(dot(normals, normals, f, f) * dot(at_vertices, at_vertices, v, v));
      if (lengths > 0) bends[f / 3] += 1 - dot(normals, at_vertices, f, v) / lengths;
    }
  }
  return { normals, bends };
}

// The unit vector from the surface to the eye, for unit vectors `up`, `ahead` and `side`.
export function choose_first_view(positions, faces, { up, ahead, side }) {
  const { normals, bends } = face_shapes(positions, faces), found = [];
  for (let i = 0; i < kSides; ++i) {
    const turn = kUsual + (2 * Math.PI * i) / kSides, length = Math.hypot(1, kRise);
    const d = [0, 1, 2].map((k) => (Math.cos(turn) * ahead[k] + Math.sin(turn) * side[k] + kRise * up[k]) / length);
    const areas = [0, 0], shapes = [0, 0];  // of faces with their outside towards the eye, and of the others
    for (let f = 0; f < normals.length; f += 3) {
      const seen = normals[f] * d[0] + normals[f + 1] * d[1] + normals[f + 2] * d[2], inside = seen < 0 ? 1 : 0;
      areas[inside] += Math.abs(seen);
      shapes[inside] += Math.abs(seen) * bends[f / 3];
    }
    const open = Math.max(0, 1 - areas[0] / areas[1]) || 0;  // the share of the inside that is seen
    const sum = ([outside, inside]) => outside + kInside * open * inside;
    found.push({ d, area: sum(areas), shape: sum(shapes), open: 4 * open * (1 - open) });
  }
  const most = (key) => Math.max(...found.map((view) => view[key])) || 1, [area, shape] = [most('area'), most('shape')];
  const score = (view) => view.area / area + (kShape * view.shape) / shape + kOpen * view.open;
  const best = found.reduce((one, two) => (score(two) > score(one) ? two : one));
  return score(best) > kBetter * score(found[0]) ? best.d : found[0].d;
}
