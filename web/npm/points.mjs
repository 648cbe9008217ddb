// Errors and arguments: points of a mesh as users give them, and options by their names.

/** What can't be done: one line in `message`, `code` as in Python, and the first offending `element`, -1 for none. */
class GvdError extends Error {
  constructor(message, code, element = -1) {
    super(message);
    this.name = 'gvd.Error';
    this.code = code;
    this.element = element;
  }
}

export { GvdError as Error };

export function refuse(message, element) {
  throw new GvdError(message, 'invalid_option', element);
}

const VERTEX = 0;
const FACE = 1;
const POSITION = 2;

const isList = (value) => Array.isArray(value) || ArrayBuffer.isView(value);

/** Whether one vertex was given, or one position as an array of its own, and not a list. */
export const isSingle = (given) => typeof given === 'number';

export function checkIndices(name, ids) {
  const bad = ids.findIndex((id) => !Number.isSafeInteger(id) || id < 0);
  if (bad >= 0) refuse(`${name}: ${ids[bad]} is no whole number from 0 on, as vertices and faces are`, bad);
}

function checkFinite(name, at) {
  const bad = at.findIndex((value) => !Number.isFinite(value));
  if (bad >= 0) refuse(`${name}: the coordinates of point ${Math.floor(bad / 3)} are not finite`, Math.floor(bad / 3));
}

function ofFaces(name, face, bary) {
  if (!isList(face) || !isList(bary) || bary.length !== 3 * face.length) {
    refuse(`${name}: points {face, bary} have an array of faces, and three weights for each`);
  }
  checkIndices(name, face);
  checkFinite(name, bary);
  return { kind: FACE, id: face, at: bary };
}

function ofPositions(name, at) {
  if (at.length % 3) refuse(`${name}: positions have three coordinates each, not ${at.length} in all`);
  checkFinite(name, at);
  return { kind: POSITION, id: new Int32Array(at.length / 3), at };
}

/**
 * The points for the module. A number is a vertex, as is each item of an array of numbers; {face, bary} are points in
 * faces; a Float64Array or Float32Array, or an array of arrays, has positions.
 * @param rules `coincident`: keep, merge or refuse; `max_snap`: the farthest that a position may be
 */
export function entries(name, given, rules = {}) {
  const found = () => {
    if (typeof given === 'number') return { kind: VERTEX, id: [given], at: [] };
    if (given?.face !== undefined) return ofFaces(name, given.face, given.bary);
    if (given instanceof Float64Array || given instanceof Float32Array) return ofPositions(name, given);
    if (isList(given) && given.length > 0 && isList(given[0])) {
      if (given.some((item) => item.length !== 3)) refuse(`${name}: positions have three coordinates each`);
      return ofPositions(name, given.flatMap((item) => [...item]));
    }
    if (isList(given)) return { kind: VERTEX, id: given, at: [] };
    return refuse(`${name}: vertices, {face, bary} or positions are needed, not ${typeof given}`);
  };
  const made = found();
  if (made.id.length === 0) refuse(`${name}: empty`);
  if (made.kind === VERTEX) checkIndices(name, made.id);
  return { coincident: 'keep', ...rules, ...made };
}

/** Refuses options that a call does not have: `names` are those that it has, between blanks. */
export function checkNames(call, options, names) {
  const known = names.split(' ');
  for (const name of Object.keys(options)) {
    if (!known.includes(name)) refuse(`${call}: there is no option '${name}'; there are ${known.join(', ')}`);
  }
}

export const isGiven = (value) => value !== undefined && value !== null;

/** Refuses any but one of several ways to say the same. */
export function oneOf(call, options, names) {
  const given = names.filter((name) => isGiven(options[name]));
  if (given.length !== 1) refuse(`${call}: give one of ${names.join(', ')}`);
}
