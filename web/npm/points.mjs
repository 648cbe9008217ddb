// Points of a mesh as users give them, and as the library takes them.
import { refuse } from './error.mjs';

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

/** Rows of a face and its barycentric coordinates. */
function ofFaces(name, face, bary) {
  if (!isList(face) || !isList(bary) || bary.length !== 3 * face.length) {
    refuse(`${name}: points {face, bary} have an array of faces, and three weights for each`);
  }
  const rows = new Float64Array(4 * face.length);
  for (let i = 0; i < face.length; ++i) rows.set([face[i], bary[3 * i], bary[3 * i + 1], bary[3 * i + 2]], 4 * i);
  return { numbers: rows, columns: 4 };
}

function ofPositions(name, at) {
  if (at.length % 3) refuse(`${name}: positions have three coordinates each, not ${at.length} in all`);
  return { numbers: new Float64Array(at), columns: 3 };
}

function ofVertices(name, ids) {
  if (!isList(ids)) refuse(`${name}: vertices, {face, bary} or positions are needed, not ${typeof ids}`);
  checkNumbers(name, ids);
  return { numbers: Float64Array.from(ids) };
}

const isFloats = (given) => given instanceof Float64Array || given instanceof Float32Array;

/** Whether one point was given, and not a list. */
export const isSingle = (given) => typeof given === 'number' || given?.face?.length === 1 || (isFloats(given) && given.length === 3);

/**
 * Points as an array of the library's. A number is a vertex, as is each item of an array of numbers; {face, bary} are
 * points in faces; a Float64Array or Float32Array, or an array of arrays, has positions.
 */
export function pointRows(name, given) {
  const rows = given?.face !== undefined ? ofFaces(name, given.face, given.bary)
    : isFloats(given) || (isList(given) && isList(given[0])) ? ofPositions(name, flat(name, given, 3))
    : ofVertices(name, typeof given === 'number' ? [given] : given);
  return rows.numbers.length > 0 ? rows : refuse(`${name}: empty`);
}
