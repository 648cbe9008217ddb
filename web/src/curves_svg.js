// The visible curves and dots of a picture as SVG: paths that stay sharp at any size and that other programs can change.
import { Vector3 } from 'three';

const kHidden = 0.004;  // a point is hidden if the surface is nearer to the eye by this share of its distance

// The parts of polylines that `see(point)` shows, as SVG's path data; `see` gives {x, y} or null.
export function visible_paths({ points, counts }, see) {
  const paths = [], p = new Vector3();
  let next = 0;
  for (const count of counts) {
    let drawn = false;
    for (const end = next + count; next < end; ++next) {
      const at = see(p.fromArray(points, 3 * next));
      if (at) paths.push(`${drawn ? 'L' : 'M'}${at.x.toFixed(2)} ${at.y.toFixed(2)}`);
      drawn = Boolean(at);
    }
  }
  return paths.join('');
}

// Where points are on the canvas of `stage`; null for those that `id_map` has a nearer surface for.
function make_view({ camera, width, height }, id_map) {
  const eye = new Vector3();
  return (point) => {
    const depth = -eye.copy(point).applyMatrix4(camera.matrixWorldInverse).z;
    const { x, y, z } = point.project(camera), at = { x: ((x + 1) * width) / 2, y: ((1 - y) * height) / 2 };
    if (Math.abs(z) > 1 || Math.abs(x) > 1 || Math.abs(y) > 1) return null;
    return depth <= id_map.depth(at.x, at.y) * (1 + kHidden) ? at : null;
  };
}

// `surface`: address of a picture below; `lines`: {name, points, counts, colour, width}; `dots`: {name, points, radius,
// fill, ring}.
export function curves_svg(stage, id_map, { surface, lines, dots }) {
  const see = make_view(stage, id_map), { width, height } = stage;
  const paths = lines.map((line) => {
    const d = visible_paths(line, see);
    return `<path id="${line.name}" d="${d}" stroke="${line.colour}" stroke-width="${line.width.toFixed(2)}"/>`;
  });
  const circles = dots.map(({ name, points, radius, fill, ring }) => {
    const seen = Array.from({ length: points.length / 3 }, (_, i) => see(new Vector3().fromArray(points, 3 * i))).filter(Boolean);
    const marks = seen.map(({ x, y }) => `<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${radius.toFixed(2)}"/>`);
    return `<g id="${name}" fill="${fill}" stroke="${ring}" stroke-width="${(radius / 3).toFixed(2)}">${marks.join('')}</g>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">
<image id="surface" href="${surface}" width="${width}" height="${height}"/>
<g fill="none" stroke-linejoin="round" stroke-linecap="round">
${paths.join('\n')}
</g>
${circles.join('\n')}
</svg>
`;
}
