// Where a ray meets a triangle.

const minus = (p, q) => p.map((value, k) => value - q[k]);
const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];

// Barycentric coordinates of the point of the plane of a, b and c on the ray from `eye` through `to`; a third each where
// there is none.
export function cross_plane(eye, to, a, b, c) {
  const normal = cross(minus(b, a), minus(c, a)), direction = minus(to, eye);
  const along = dot(minus(a, eye), normal) / dot(direction, normal);
  const p = eye.map((value, k) => value + along * direction[k]);
  const share = (u, v) => dot(cross(minus(u, p), minus(v, p)), normal) / dot(normal, normal);
  const bary = [share(b, c), share(c, a), share(a, b)];
  return bary.every(Number.isFinite) ? bary : [1 / 3, 1 / 3, 1 / 3];
}
