// Soft shade of a surface and its shadow on the ground, made once for each mesh while the page rests.
import { BufferAttribute, BufferGeometry, DataTexture, LinearFilter, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { Sky } from './sky.js';

const kGroundPoints = 128;      // along each side of the ground
const kGroundSide = 2.8;        // in radii of everything
const kGroundShade = 0.85;      // opacity of the ground where it sees no sky
const kGroundNarrow = 2.5;      // exponent of the light from the side: only what is above the ground darkens it
const kGroundLeast = 0.2;       // what hides less of the sky than this casts no shadow
const kGroundBlur = 8;          // times that each point becomes the mean of its row and column
const kMostShaded = 300000;     // faces; the shade of more takes too much memory

// The positions of the corners of faces, three coordinates each.
function corner_positions({ positions, faces }) {
  const corners = new Float32Array(3 * faces.length);
  faces.forEach((v, i) => corners.set(positions.subarray(3 * v, 3 * v + 3), 3 * i));
  return corners;
}

// A square below the surface: {corners, points, normals}, with a lattice of points, row by row.
function make_ground({ positions }, up, radius) {
  const side = new Vector3(up.y, up.z, up.x), across = new Vector3().crossVectors(up, side);
  const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate(), p = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    p.fromArray(positions, i).set(p.dot(side), p.dot(up), p.dot(across));
    low.min(p);
    high.max(p);
  }
  const half = (kGroundSide * radius) / 2, middle = low.clone().add(high).multiplyScalar(0.5).setY(low.y - 0.002 * radius);
  const in_plane = (x, z) => new Vector3().addScaledVector(side, middle.x + x * half).addScaledVector(across, middle.z + z * half);
  const at = (x, z) => in_plane(x, z).addScaledVector(up, middle.y);
  const n = kGroundPoints, points = new Float32Array(3 * n * n), normals = points.slice();
  for (let i = 0; i < n * n; ++i) {
    at(((i % n) + 0.5) / (n / 2) - 1, (Math.floor(i / n) + 0.5) / (n / 2) - 1).toArray(points, 3 * i);
    up.toArray(normals, 3 * i);
  }
  return { points, normals, corners: [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, z]) => at(x, z)) };
}

// The ground as a black square, opaque where little of the sky is seen, and clear at its rim.
function make_shadow({ corners }, shares) {
  const n = kGroundPoints, texels = new Uint8Array(4 * n * n);
  let dark = Float32Array.from(shares, (share) => Math.max(0, 1 - share / 255 - kGroundLeast) ** 1.3);
  for (let pass = 0; pass < kGroundBlur; ++pass) for (const step of [1, n]) {
    dark = dark.map((own, i) => ((dark[i - step] ?? 0) + 2 * own + (dark[i + step] ?? 0)) / 4);
  }
  dark.forEach((share, i) => {
    const x = ((i % n) + 0.5) / (n / 2) - 1, z = (Math.floor(i / n) + 0.5) / (n / 2) - 1;
    const rim = Math.min(1, Math.max(0, 3 * (1 - Math.hypot(x, z))));
    texels[4 * i + 3] = 255 * kGroundShade * rim * share;
  });
  const map = new DataTexture(texels, n, n);
  map.minFilter = map.magFilter = LinearFilter;
  map.needsUpdate = true;
  const geometry = new BufferGeometry().setFromPoints(corners).setIndex([0, 1, 2, 0, 2, 3]);
  geometry.setAttribute('uv', new BufferAttribute(Float32Array.of(0, 0, 1, 0, 1, 1, 0, 1), 2));
  return new Mesh(geometry, new MeshBasicMaterial({ map, transparent: true, depthWrite: false }));
}

const pause = () => new Promise((done) => setTimeout(done));

export class Shading {
  constructor(stage) {
    this.stage = stage;
    this.known = new Map();  // by mesh and axis that points up
  }

  // The shade {shares, shadow} of a picture: the shares of the sky at the corners of faces, null where there are too many,
  // and the ground. Pictures with the same mesh have the same one.
  of({ entry, surface, coarse, geometry }) {
    const { renderer, bounds, camera } = this.stage, up = camera.up.clone();
    const mesh = entry.positions.blob ?? entry.positions, key = [...up].join(' ');
    const make = async () => {
      const sky = new Sky(renderer, coarse?.geometry ?? geometry, bounds.radius, up), ground = make_ground(surface, up, bounds.radius);
      await sky.prepare(pause);
      const shares = surface.faces.length <= 3 * kMostShaded ? await sky.look(corner_positions(surface), surface.normals) : null;
      const shadow = make_shadow(ground, await sky.look(ground.points, ground.normals, kGroundNarrow));
      sky.dispose();
      return { shares, shadow };
    };
    if (!this.known.has(mesh)) this.known.set(mesh, {});
    return (this.known.get(mesh)[key] ??= make());
  }
}
