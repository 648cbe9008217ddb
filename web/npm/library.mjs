// The library: its calls, its objects, and copies of their arrays (gvd/gvd.h, and web/module/module.cpp beside it).
//
// `call` runs an operation by its name, with options as JSON and arrays beside it. Memory that grows leaves views of it
// without their numbers, so arrays are copied out.
import create from './gvd.mjs';
import { Error as GvdError, refuse } from './error.mjs';
import wasmBinary from './load.mjs';

const native = await create({ wasmBinary });
const kTypes = [Int8Array, Uint8Array, Int16Array, Uint16Array, Int32Array, Uint32Array, BigInt64Array, BigUint64Array, Float32Array, Float64Array];
const kOutOfMemory = 1, kInterrupted = 130, kJavaScript = 2;
const kReportInterval = 100;  // between two calls of a progress function, milliseconds

const encoder = new TextEncoder(), decoder = new TextDecoder();

function refuseMemory() {
  throw new GvdError('the memory of the page is full; use a smaller mesh or fewer points', 'out_of_memory');
}

function readText(address) {
  const at = address >>> 0, heap = native.HEAPU8;
  return decoder.decode(heap.subarray(at, heap.indexOf(0, at)));
}

/** Calls use(put, room), which copy bytes into the module's memory, or make room there, and return the address. */
function borrow(use) {
  const taken = [];
  const room = (length) => {
    const at = native._malloc(length || 1) >>> 0;
    if (at === 0) refuseMemory();
    taken.push(at);
    return at;
  };
  const put = (given) => {
    const bytes = typeof given === 'string' ? encoder.encode(`${given}\0`) : new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
    const at = room(bytes.length);
    native.HEAPU8.set(bytes, at);
    return at;
  };
  try {
    return use(put, room);
  } finally {
    for (const at of taken) native._free(at);
  }
}

function check(status) {
  if (status === 0) return;
  if (status === kOutOfMemory) refuseMemory();
  const code = readText(native._gvd_last_error_code()) || 'internal_error';
  throw new GvdError(readText(native._gvd_last_error()), code, native._gvd_web_last_error_element());
}

const collected = new FinalizationRegistry((address) => native._gvd_release(address));

/** An object of the library. It is released when this is collected, or by free(). */
export class Handle {
  constructor(address) {
    this.known = address;
    collected.register(this, address, this);
  }

  get address() {
    return this.known ?? refuse('this object was freed');
  }

  free() {
    if (this.known === null) return;
    collected.unregister(this);
    native._gvd_release(this.known);
    this.known = null;
  }

  /** A copy of an array, row by row. 64-bit integers become numbers. */
  array(name) {
    return borrow((put, room) => {
      const view = room(24);
      check(native._gvd_web_array_of(this.address, put(name), view));
      const [data, type, rows, columns, down, across] = new Uint32Array(native.HEAPU8.buffer, view, 6);
      const copied = copyNumbers(kTypes[type], data, [rows, columns], [down, across]);
      return copied instanceof BigInt64Array || copied instanceof BigUint64Array ? Float64Array.from(copied, Number) : copied;
    });
  }

  /** A part, such as the diagram of a result. */
  part(name) {
    return makeHandle((put, result) => native._gvd_object_of(this.address, put(name), result));
  }

  figures() {
    return JSON.parse(readText(native._gvd_figures(this.address)));
  }

  /** The bytes of a file in the format of an extension. */
  file(format, options) {
    const file = makeHandle((put, result) => native._gvd_web_file_of(this.address, put(format), put(JSON.stringify(options)), result));
    const bytes = file.array('bytes');
    file.free();
    return bytes;
  }
}

function copyNumbers(Type, data, [rows, columns], [down, across]) {
  const size = Type.BYTES_PER_ELEMENT, count = rows * columns;
  if (count === 0) return new Type(0);
  const { buffer } = native.HEAPU8;
  if (down === columns * size && (columns === 1 || across === size)) return new Type(buffer, data, count).slice();
  const heap = new Type(buffer, data, ((rows - 1) * down + (columns - 1) * across) / size + 1), copied = new Type(count);
  for (let i = 0, k = 0; i < rows; ++i) for (let j = 0; j < columns; ++j) copied[k++] = heap[(i * down + j * across) / size];
  return copied;
}

/** The object of a call that puts its address where its last argument is. */
function makeHandle(work) {
  return borrow((put, room) => {
    const result = room(4);
    check(work(put, result));
    return new Handle(new Uint32Array(native.HEAPU8.buffer, result, 1)[0]);
  });
}

/** What a call tells: `ended` throws what has ended it. A function of the page's that throws ends the call, too. */
function listen({ progress, time_limit, on_iteration }) {
  const begin = performance.now(), deadline = begin + 1000 * (time_limit ?? Infinity);
  let next = begin, thrown;
  const attempt = (work) => {
    try {
      return thrown === undefined && work();
    } catch (error) {
      thrown = { error };
      return false;
    }
  };
  return {
    progress: (step, fraction) => {
      const now = performance.now();
      if (thrown || now > deadline) return 0;
      if (!progress || now < next) return 1;
      next = now + kReportInterval;
      return attempt(() => progress(readText(step), fraction) !== false) ? 1 : 0;
    },
    iterated: (iterations, energy, points) => {
      const of = { array: (name) => Handle.prototype.array.call({ address: points }, name) };
      attempt(() => on_iteration(iterations, energy, { face: of.array('points_faces'), bary: of.array('points_bary') }));
    },
    ended: (status) => {
      if (thrown) throw thrown.error;
      if (status === kInterrupted && performance.now() > deadline) throw new GvdError(`the time limit of ${time_limit} s is over`, 'interrupted');
    },
  };
}

/**
 * Runs an operation. In `options`, {"array": 0} stands for the first of `arrays`: {numbers, columns}, without `columns`
 * of one dimension. `told`: functions that hear of the call, and its time limit in seconds.
 */
export function call(operation, on, options = {}, arrays = [], told = {}) {
  const hears = [told.progress ?? told.time_limit ?? told.on_iteration, told.on_iteration].map((one) => (one === undefined || one === null ? 0 : 1));
  const before = [native.progress, native.iterated], listener = listen(told);
  [native.progress, native.iterated] = [listener.progress, listener.iterated];
  try {
    return makeHandle((put, result) => {
      const table = arrays.flatMap(({ numbers, columns = 0 }) => {
        const type = kTypes.findIndex((Type) => numbers instanceof Type);
        return [put(numbers), type, numbers.length / (columns || 1), columns];
      });
      const status = native._gvd_web_call(put(operation), on?.address ?? 0, put(JSON.stringify(options)), put(Int32Array.from(table)),
                                          arrays.length, ...hears, result);
      listener.ended(status);
      return status;
    });
  } finally {
    [native.progress, native.iterated] = before;
  }
}

export const version = readText(native._gvd_version());

/** The operations with their options and results, the kinds of objects and the formats. */
export const describe = () => JSON.parse(readText(native._gvd_describe_for(kJavaScript)));
