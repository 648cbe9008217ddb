// Options by their names and kinds, as the library describes them.
import { Error as GvdError, refuse } from './error.mjs';
import { kCalls } from './calls.mjs';
import { call, describe } from './library.mjs';
import { checkNumbers, isGiven, isList, pointRows } from './points.mjs';

/** Curves of a mesh as generators: Mesh.curves makes them. `positions` has the polylines of each. */
export class Curves {
  constructor(option, arrays, positions) {
    Object.assign(this, { option, arrays, positions });
  }

  get length() {
    return this.positions.length;
  }
}

const byName = (options) => new Map(options.map((option) => [option.name, option]));
const { operations, file_options } = describe();

/** The options of each operation by their names, and those of files. */
const kKnown = new Map([...operations.map(({ name, options }) => [name, byName(options)]), ['file', byName(file_options)]]);

function refer(arrays, array, kind = 'array') {
  arrays.push(array);
  return { [kind]: arrays.length - 1 };
}

/** The same value, with the places of arrays after those that are there. */
function shift(value, by) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, key === 'array' ? one + by : shift(one, by)]));
}

function curvesOption(value, arrays) {
  if (typeof value === 'string') return value;
  if (!(value instanceof Curves)) refuse(`curves: what Mesh.curves makes is needed, not ${typeof value}`);
  const by = arrays.push(...value.arrays) - value.arrays.length;
  return shift(value.option, by);
}

/** JSON has neither infinity nor NaN, and loses whole numbers beyond 2^53; texts of numbers serve. */
function plain(name, value, kind) {
  if (typeof value === 'bigint') return String(value);
  if (kind === 'whole number' && Number.isInteger(value) && !Number.isSafeInteger(value)) {
    refuse(`${name}: ${value} is beyond 2^53, where numbers are rounded; give a BigInt, as 2n ** 60n`);
  }
  if (typeof value === 'number') return Number.isFinite(value) ? value : String(value).replace('Infinity', 'inf');
  if (typeof value === 'string' || typeof value === 'boolean') return value;
  return refuse(`${name}: a number, a text, true or false is needed, not ${value === Object(value) ? typeof value : value}`);
}

/** One option as JSON, whose arrays go behind `arrays`. */
export function optionJson({ name, kind, choices }, value, arrays) {
  if (kind === 'points' || kind === 'vertices') {
    const rows = pointRows(name === 'from' ? 'points' : name, value);
    return refer(arrays, rows, rows.columns ? 'array' : 'mesh_vertices');
  }
  if (kind === 'curves') return curvesOption(value, arrays);
  if (kind === 'values' && !(typeof value === 'string' && choices)) {
    checkNumbers(name, value);
    return refer(arrays, { numbers: Float64Array.from(value, Number) });
  }
  if (kind === 'counts') return isList(value) ? Array.from(value, (one) => plain(name, one)) : refuse(`${name}: an array of whole numbers is needed, not ${value}`);
  return plain(name, value, kind);
}

function toJson(operation, options, arrays) {
  const known = kKnown.get(operation), made = {};
  for (const [name, value] of Object.entries(options)) {
    if (isGiven(value)) made[name] = known.has(name) ? optionJson(known.get(name), value, arrays) : null;
    else if (!known.has(name)) made[name] = null;  // which the library tells the user
  }
  return made;
}

/** The options of a call, which are an object. */
export function optionsOf(name, options) {
  if (isGiven(options) && (typeof options !== 'object' || isList(options))) {
    refuse(`${name}: the options are an object, such as { name: value }, not ${options}`);
  }
  return options ?? {};
}

/** The operation of a call, for which options that the call sets itself are none. */
function operationOf(name, type, options) {
  const { operation, without } = kCalls[type], wrong = Object.keys(options).find((one) => without.includes(one));
  return wrong === undefined ? operation : refuse(`${name}: there is no option "${wrong}"`);
}

const renamed = (line, names) => line.replace(/^\w+(?=: )/, (option) => names[option] ?? option);

/**
 * Runs the operation of a call with the user's options, of a type of calls.mjs, and with those that the call sets: `own`, and
 * `more`, which are JSON already. `names` are the call's own of options. What the commands warn of goes to the console: a
 * position that is far from the surface, say.
 */
export function run(name, type, on, options, { own = {}, more = {}, arrays = [], names = {} } = {}) {
  const { progress, on_iteration, time_limit, ...others } = optionsOf(name, options), told = { progress, on_iteration, time_limit };
  const operation = operationOf(name, type, others);
  for (const one of ['progress', 'on_iteration']) if (isGiven(told[one]) && typeof told[one] !== 'function') refuse(`${one}: a function is needed`);
  if (isGiven(on_iteration) && operation !== 'lloyd') refuse(`${name}: there is no option "on_iteration"; lloyd has it`);
  const is_limit = typeof time_limit === 'number' && time_limit > 0;
  if (isGiven(time_limit) && !is_limit) refuse(`time_limit: a number of seconds above 0 is needed, not ${time_limit}`);
  const made = named(name, () => call(operation, on?._native, { ...toJson(operation, { ...others, ...own }, arrays), ...more }, arrays, told), names);
  if (arrays.some(({ columns }) => columns === 3) && operation !== 'mesh') {
    for (const line of made.figures().warnings) console.warn(`gvd: ${renamed(line, names)}`);
  }
  return made;
}

/** The bytes of a file of an object. */
export function fileOf(name, native, format, options, more = {}) {
  if (typeof format !== 'string') refuse(`format: text is needed, not ${format}`);
  if (/^\.?html?$/i.test(format)) refuse(`${name}: this package makes no pages; write .html with the commands or Python`);
  const operation = operationOf(name, 'FileOptions', optionsOf(name, options));
  return named(name, () => native.file(format.toLowerCase(), { ...toJson(operation, options ?? {}, []), ...more }));
}

/** Says which call has no such option, and calls an option as the call does. */
function named(name, work, names = {}) {
  try {
    return work();
  } catch (error) {
    if (error.code === 'invalid_option' && error.message.startsWith('there is no option')) error.message = `${name}: ${error.message}`;
    if (error instanceof GvdError) error.message = renamed(error.message, names);
    throw error;
  }
}
