// Finds the camera that sees all points as large as possible.

// For points (three coordinates each) and unit vectors `right`, `up` and `back` (from the points to the eye), arrays of
// three: {x, y, distance}. `wide` and `high` are the tangents of half the angles of view. The eye at
// x right + y up + distance back sees every point, and no nearer one does. Points exactly at the edge of the view remain.
export function fit_points(positions, { right, up, back }, wide, high) {
  const reach = { left: -Infinity, right: -Infinity, down: -Infinity, up: -Infinity };
  for (let i = 0; i < positions.length; i += 3) {
    const px = positions[i], py = positions[i + 1], pz = positions[i + 2];
    const x = (px * right[0] + py * right[1] + pz * right[2]) / wide;
    const y = (px * up[0] + py * up[1] + pz * up[2]) / high;
    const z = px * back[0] + py * back[1] + pz * back[2];
    if (z + x > reach.right) reach.right = z + x;
    if (z - x > reach.left) reach.left = z - x;
    if (z + y > reach.up) reach.up = z + y;
    if (z - y > reach.down) reach.down = z - y;
  }
  return {
    x: (wide * (reach.right - reach.left)) / 2,
    y: (high * (reach.up - reach.down)) / 2,
    distance: Math.max(reach.right + reach.left, reach.up + reach.down) / 2,
  };
}
