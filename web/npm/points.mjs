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

/** Refuses all but an array of numbers, or of true and false; the module would take any other item for a number. */
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

/** Whether one vertex was given, and not a list. */
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
      return ofPositions(name, flat(name, given, 3));
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
  const known = [...new Set(names.split(' '))];
  for (const [name, value] of Object.entries(options)) {
    if (!known.includes(name)) refuse(`${call}: there is no option '${name}'; there are ${known.join(', ')}`);
    if (/^progress$|^on_/.test(name) && isGiven(value) && typeof value !== 'function') refuse(`${name}: a function is needed`);
  }
}

/** Refuses all but text, such as a name or a format. */
export function checkText(name, given) {
  if (typeof given !== 'string') refuse(`${name}: text is needed, not ${given}`);
}

export const isGiven = (value) => value !== undefined && value !== null;

/** Refuses any but one of several ways to say the same. */
export function oneOf(call, options, names) {
  const given = names.filter((name) => isGiven(options[name]));
  if (given.length !== 1) refuse(`${call}: give one of ${names.join(', ')}`);
}
