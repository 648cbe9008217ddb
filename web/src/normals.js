// Normals at the corners of the faces.

// Corners share a normal across an edge with a smaller angle than this: curved regions look smooth, creases sharp.
const kCreaseCosine = Math.cos((40 * Math.PI) / 180);

// Per face: the normal, of length twice its area.
function face_vectors(positions, faces) {
  const vectors = new Float32Array(faces.length);
  for (let f = 0; f < faces.length; f += 3) {
    const a = 3 * faces[f], b = 3 * faces[f + 1], c = 3 * faces[f + 2];
    const [ax, ay, az] = [positions[a], positions[a + 1], positions[a + 2]];
    const ux = positions[b] - ax, uy = positions[b + 1] - ay, uz = positions[b + 2] - az;
    const vx = positions[c] - ax, vy = positions[c + 1] - ay, vz = positions[c + 2] - az;
    vectors[f] = uy * vz - uz * vy;
    vectors[f + 1] = uz * vx - ux * vz;
    vectors[f + 2] = ux * vy - uy * vx;
  }
  return vectors;
}

// The corners that lie at each vertex: corner[start[v]] up to corner[start[v + 1]].
function corners_of_vertices(vertex_count, faces) {
  const start = new Uint32Array(vertex_count + 2);
  for (const v of faces) ++start[v + 2];
  for (let v = 2; v < start.length; ++v) start[v] += start[v - 1];
  const corner = new Uint32Array(faces.length);
  faces.forEach((v, i) => (corner[start[v + 1]++] = i));
  return { start, corner };
}

const known = new WeakMap();  // by positions: {faces, normals} of the last faces

// As `compute_normals`, which is called once for the same arrays.
export function corner_normals(positions, faces) {
  if (known.get(positions)?.faces !== faces) known.set(positions, { faces, normals: compute_normals(positions, faces) });
  return known.get(positions).normals;
}

// A unit normal for each corner of each face: the area-weighted mean over the faces at its vertex whose normals are
// close to the face's own.
function compute_normals(positions, faces) {
  const vectors = face_vectors(positions, faces);
  const lengths = new Float32Array(faces.length / 3);
  for (let f = 0; f < lengths.length; ++f) {
    lengths[f] = Math.sqrt(vectors[3 * f] ** 2 + vectors[3 * f + 1] ** 2 + vectors[3 * f + 2] ** 2);
  }
  const { start, corner } = corners_of_vertices(positions.length / 3, faces);
  const normals = new Float32Array(3 * faces.length);
  for (let i = 0; i < faces.length; ++i) {
    const f = Math.floor(i / 3);
    const fx = vectors[3 * f], fy = vectors[3 * f + 1], fz = vectors[3 * f + 2];
    let x = 0, y = 0, z = 0;
    for (let k = start[faces[i]]; k < start[faces[i] + 1]; ++k) {
      const g = Math.floor(corner[k] / 3);
      const gx = vectors[3 * g], gy = vectors[3 * g + 1], gz = vectors[3 * g + 2];
      if (fx * gx + fy * gy + fz * gz < kCreaseCosine * lengths[f] * lengths[g]) continue;
      x += gx;
      y += gy;
      z += gz;
    }
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    normals[3 * i] = x / length;
    normals[3 * i + 1] = y / length;
    normals[3 * i + 2] = z / length;
  }
  return normals;
}
