// Points of a mesh as users give them, and as the library takes them.
import { Error as GvdError, refuse } from './error.mjs';

export const isList = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));
export const isGiven = (value) => value !== undefined && value !== null;

/** Refuses all but an array of numbers, or of true and false. */
export function checkNumbers(name, given) {
  if (!isList(given)) refuse(`${name}: an array of numbers is needed, not ${given}`);
  const bad = given.findIndex((value) => typeof value !== 'number' && typeof value !== 'boolean');
  if (bad >= 0) refuse(`${name}: item ${bad} is ${given[bad]}, and no number`, bad);
}

/** One array of numbers, from one or from an array of rows with `size` numbers each. */
export function flat(name, given, size) {
  if (!isList(given) || !isList(given[0])) return given;
  const odd = given.findIndex((row) => row?.length !== size);
  if (odd >= 0) refuse(`${name}: each has ${size} numbers, but not item ${odd}`, odd);
  return given.flatMap((row) => [...row]);
}

export function checkIndices(name, ids) {
  const bad = ids.findIndex((id) => !Number.isSafeInteger(id) || id < 0);
  if (bad >= 0) refuse(`${name}: ${ids[bad]} is no whole number from 0 on, as vertices and faces are`, bad);
}

function checkFinite(name, at) {
  const bad = at.findIndex((value) => !Number.isFinite(value));
  if (bad >= 0) refuse(`${name}: the coordinates of point ${Math.floor(bad / 3)} are not finite`, Math.floor(bad / 3));
}

/** Rows of a face and its barycentric coordinates. */
function rowsOf(face, bary) {
  const rows = new Float64Array(4 * face.length);
  for (let i = 0; i < face.length; ++i) rows.set([face[i], bary[3 * i], bary[3 * i + 1], bary[3 * i + 2]], 4 * i);
  return { numbers: rows, columns: 4 };
}

function ofFaces(name, face, bary) {
  if (!isList(face) || !isList(bary) || bary.length !== 3 * face.length) {
    refuse(`${name}: points {face, bary} have an array of faces, and three weights for each`);
  }
  checkIndices(name, face);
  checkFinite(name, bary);
  return rowsOf(face, bary);
}

function ofPositions(name, at) {
  if (at.length % 3) refuse(`${name}: positions have three coordinates each, not ${at.length} in all`);
  checkFinite(name, at);
  return { numbers: new Float64Array(at), columns: 3 };
}

/** The library counts vertices as the input does, which repairs may have given other numbers, or copies. */
function ofVertices(name, ids, mesh) {
  checkIndices(name, ids);
  const { input_vertex, vertex_of_input } = mesh;
  const inputs = Float64Array.from(ids, (v) => {
    if (v >= input_vertex.length) throw new GvdError(`${name}: there is no vertex ${v}; the last one is ${input_vertex.length - 1}`, 'precondition');
    return vertex_of_input[input_vertex[v]] === v ? input_vertex[v] : -1;
  });
  if (inputs.every((v) => v >= 0)) return { numbers: inputs };
  const corners = Array.from(ids, (v) => mesh.faces.indexOf(v));
  return rowsOf(corners.map((corner) => Math.floor(corner / 3)), corners.flatMap((corner) => [0, 1, 2].map((i) => Number(i === corner % 3))));
}

/** Whether one point was given, and not a list. */
export const isSingle = (given) => typeof given === 'number' || given?.face?.length === 1;

/**
 * Points as an array of the library's. A number is a vertex, as is each item of an array of numbers; {face, bary} are
 * points in faces; a Float64Array or Float32Array, or an array of arrays, has positions.
 */
export function pointRows(name, given, mesh) {
  const made = () => {
    if (typeof given === 'number') return ofVertices(name, [given], mesh);
    if (given?.face !== undefined) return ofFaces(name, given.face, given.bary);
    if (given instanceof Float64Array || given instanceof Float32Array) return ofPositions(name, given);
    if (isList(given) && isList(given[0])) return ofPositions(name, flat(name, given, 3));
    if (isList(given)) return ofVertices(name, given, mesh);
    return refuse(`${name}: vertices, {face, bary} or positions are needed, not ${typeof given}`);
  };
  const rows = made();
  if (rows.numbers.length === 0) refuse(`${name}: empty`);
  return rows;
}
