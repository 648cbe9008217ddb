// What the card tells of the face or the vertex under the pointer, where the surface has no regions.
import { Vector3 } from 'three';
import { format_number } from './panel.js';
import { cross_plane } from './ray.js';
import { count_edges, face_angle, face_quality } from './values.js';

// Round a vertex in which the pointer means it: CSS pixels, and of the face's shortest side on the canvas.
const kVertexRadius = 11, kVertexShare = 0.3;

const corner = (positions, v) => new Vector3(...positions.subarray(3 * v, 3 * v + 3));

// The face `f` at the pointer {x, y} of the canvas: its point there, and the corner that the pointer means, if any, with
// its place on the canvas.
export function locate(stage, surface, f, pointer) {
  const { camera, width, height } = stage, { positions, faces } = surface;
  const ids = [0, 1, 2].map((i) => faces[3 * f + i]), corners = ids.map((v) => corner(positions, v));
  const to = new Vector3((2 * pointer.x) / width - 1, 1 - (2 * pointer.y) / height, 0.5).unproject(camera);
  const bary = cross_plane(camera.position.toArray(), to.toArray(), ...corners.map((p) => p.toArray()));
  const to_pixels = ({ x, y }) => ({ x: ((x + 1) * width) / 2, y: ((1 - y) * height) / 2 });
  const places = corners.map((p) => to_pixels(p.clone().project(camera)));
  const distances = places.map(({ x, y }) => Math.hypot(x - pointer.x, y - pointer.y));
  const nearest = distances.indexOf(Math.min(...distances));
  const side = (i) => Math.hypot(places[i].x - places[(i + 1) % 3].x, places[i].y - places[(i + 1) % 3].y);
  const radius = Math.min(kVertexRadius, kVertexShare * Math.min(side(0), side(1), side(2)));
  const vertex = distances[nearest] <= radius ? ids[nearest] : null;
  return { face: f, bary, vertex, place: vertex === null ? null : places[nearest] };
}

// Distances below this share of the reference are rounding.
const kRounding = 1e-8;

function format_distance(distance, { reference }) {
  if (distance < kRounding * reference) return '0';
  const round = (value) => format_number(Number(value.toPrecision(3)));
  return `${round((100 * distance) / reference)}\u00a0% (${round(distance)})`;
}

function face_rows({ surface, distance, scale }, { face, bary }) {
  const { positions, faces, distances } = surface, rows = [];
  if (distance) {
    rows.push(['Distance here', format_distance(distance.at(face, bary), distance)]);
    rows.push(['Largest in face', format_distance(distance.largest(face), distance)]);
  }
  if (distances.length) {
    const at = bary.reduce((sum, b, i) => sum + b * distances[faces[3 * face + i]], 0);
    rows.push(['Distance, linear', Number.isFinite(at) ? format_number(Number((at * scale).toPrecision(5))) : 'inf']);
  }
  rows.push(['Quality Q', face_quality(positions, faces, face).toFixed(3)]);
  rows.push(['Smallest angle', `${face_angle(positions, faces, face).toFixed(1)}°`]);
  rows.push(['Vertices', [...faces.subarray(3 * face, 3 * face + 3)].join(', ')]);
  return rows;
}

function vertex_rows({ surface, distance, generators, given }, { vertex }, scale) {
  const rows = [], { edges, boundary } = count_edges(surface.faces, vertex);
  if (distance) rows.push(['Distance', format_distance(distance.vertices[vertex], distance)]);
  const exact = surface.distances[vertex];
  const format_exact = () => (Number.isFinite(exact) ? format_number(Number((exact * scale).toPrecision(6))) : 'inf');
  if (exact !== undefined) rows.push(['Exact distance', format_exact()]);
  rows.push(['Valence', boundary ? `${edges}, on the boundary` : String(edges)]);
  if (!generators.length) return rows;
  rows.push(['Generator', vertex < given ? String(vertex) : `${vertex}, added`]);
  const moved = corner(generators, vertex).distanceTo(corner(surface.positions, vertex)) * scale;
  if (distance) rows.push(['Distance from it', format_distance(moved, distance)]);
  return rows;
}

// Title and rows of the card of what `locate` found in a picture.
export function describe_element(picture, found) {
  if (found.vertex === null) return { title: `Face ${found.face}`, rows: face_rows(picture, found) };
  return { title: `Vertex ${found.vertex}`, rows: vertex_rows(picture, found, picture.scale) };
}
