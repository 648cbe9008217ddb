// Exact geodesic Voronoi diagrams, distances, paths and remeshes on triangle meshes, by WebAssembly.
//
//   import { Mesh, read } from 'gvd';
//   const mesh = read(bytes, 'bunny.obj');
//   const regions = mesh.segment(30);
//   const file = regions.to_bytes('ply');
//
// What has a name in Python has the same name here, and gives the same results; index.d.ts has the documents. Calls
// block, so pages make them in a worker. Objects free their memory when they are collected, or by free().
import create from './gvd.mjs';
import wasmBinary from './load.mjs';
import { checkIndices, checkNames, checkNumbers, checkText, entries, Error, flat, isGiven, isSingle, oneOf, refuse } from './points.mjs';

const native = await create({ wasmBinary, Error });
const collected = new FinalizationRegistry((handle) => handle.delete());

export { Error };
export const version = native.version();

/** An object of the module. */
class Handle {
  constructor(handle) {
    this._handle = { native: handle };
    collected.register(this, handle, this);
  }

  get _native() {
    return this._handle.native ?? refuse('this object was freed');
  }

  free() {
    if (!this._handle.native) return;
    collected.unregister(this);
    this._handle.native.delete();
    this._handle.native = null;
  }

  to_bytes(format, options = {}) {
    checkText('format', format);
    checkNames('to_bytes', options, 'no_curves ascii_ply region_materials');
    return this._native.write(format.toLowerCase().replace(/^\./, ''), options);
  }
}

/** Gives a class getters for what its object in the module has by the same names; each value is taken once. */
function forward(target, ...names) {
  for (const name of names) lazy(target, name, (self) => self._native[name]());
}

function lazy(target, name, take) {
  const values = new WeakMap();
  const get = function () {
    if (!values.has(this)) values.set(this, take(this));
    return values.get(this);
  };
  Object.defineProperty(target.prototype, name, { get, configurable: true });
}

const SAMPLE = 'sampling seed radius progress';
const COMPUTE = 'method front chord_tolerance progress';
const RELAX = `${SAMPLE} ${COMPUTE} generators fixed features keep_boundary density gradation coarse`;

const isAscending = (levels) =>
  levels.length > 0 && Array.from(levels).every((n, i) => Number.isSafeInteger(n) && n > (i ? levels[i - 1] : 0));

/** n as a first argument, or in the options. */
function withCount(n, options) {
  if (isGiven(n) && isGiven(options.n)) refuse('n is given twice');
  return isGiven(n) ? { ...options, n } : options;
}

export class Mesh extends Handle {
  constructor(vertices, faces, { on_defect = 'error', corners = 3, ...others } = {}) {
    checkNames('Mesh', others, 'on_defect corners');
    checkText('on_defect', on_defect);
    const size = faces?.[0]?.length ?? corners;
    if (!Number.isInteger(size) || size < 3) refuse(`corners: a whole number from 3 on is needed, not ${size}`);
    const [at, of] = [flat('vertices', vertices, 3), flat('faces', faces, size)];
    checkNumbers('vertices', at);
    checkNumbers('faces', of);
    checkIndices('faces', of);
    if (at.length % 3) refuse(`vertices: three coordinates each are needed, not ${at.length} in all`);
    if (of.length % size) refuse(`faces: ${size} corners each are needed, not ${of.length} in all`);
    super(native.mesh_from_arrays(at, of, size, on_defect));
  }

  static _wrap(handle) {
    const mesh = Object.create(Mesh.prototype);
    mesh._handle = { native: handle };
    collected.register(mesh, handle, mesh);
    return mesh;
  }

  points(points, options = {}) {
    checkNames('points', options, 'max_snap');
    return this._native.points(entries('points', points, options));
  }

  positions(points) {
    return this._native.positions(entries('points', points));
  }

  sample(n, options = {}) {
    const all = withCount(n, options);
    checkNames('sample', all, `n ${SAMPLE}`);
    oneOf('sample', all, ['n', 'radius']);
    return this._native.sample(all);
  }

  farthest(n, options = {}) {
    return this.sample(n, options);
  }

  distances(points, { each = false, ...options } = {}) {
    const given = this._at('distances', options);
    return each ? this._native.rows(entries('points', points), given) : this._native.nearest(sources(points), given).distances;
  }

  /** The rows of distances(points, { each: true }), one after the other, in the memory of one. */
  *distance_rows(points, options = {}) {
    const { face, bary } = this.points(points);
    for (let i = 0; i < face.length; ++i) {
      yield this.distances({ face: face.subarray(i, i + 1), bary: bary.subarray(3 * i, 3 * i + 3) }, options);
    }
  }

  nearest(points, options = {}) {
    return this._native.nearest(sources(points), this._at('nearest', options));
  }

  log_map(point, options = {}) {
    checkNames('log_map', options, 'progress');
    const at = entries('point', point);
    if (at.id.length !== 1) refuse(`point: one point is needed, not ${at.id.length}`);
    return this._native.log_map(at, options);
  }

  curves(curves, { closed = false, angle, ...options } = {}) {
    checkNames('curves', options, 'closed angle max_snap name');
    const isWord = typeof curves === 'string', isFile = curves instanceof Uint8Array || curves instanceof ArrayBuffer;
    if (closed && (isWord || isFile)) refuse('closed: it is for polylines');
    if (angle !== undefined && curves !== 'creases') refuse("angle: it is for 'creases'");
    if (isWord) {
      if (curves !== 'boundary' && curves !== 'creases') refuse(`curves: 'boundary' or 'creases' is needed, not '${curves}'`);
      return new Curves(this, native.find_curves(this._native, curves, { angle }));
    }
    if (isFile) return new Curves(this, native.read_curves(this._native, curves, options.name ?? 'curves', options));
    const lines = Array.from(curves, (line, i) => entries(`curves[${i}]`, line));
    if (lines.length === 0) refuse('curves: empty');
    return new Curves(this, native.join_curves(this._native, lines, closed, options));
  }

  _at(call, options) {
    checkNames(call, options, 'at progress');
    return isGiven(options.at) ? { ...options, at: entries('at', options.at) } : options;
  }

  path(start, end, options = {}) {
    checkNames('path', options, 'progress');
    const paths = this._native.paths(entries('start', start), entries('end', end), options);
    return isSingle(start) || (start.face && start.face.length === 1) ? paths[0] : paths;
  }

  isolines(points, levels, options = {}) {
    checkNames('isolines', options, 'progress');
    checkNumbers('levels', levels);
    return this._native.isolines(entries('points', points), levels, options);
  }

  voronoi(points, { max_snap, merge_coincident = false, ...options } = {}) {
    checkNames('voronoi', options, `max_snap merge_coincident weights ${COMPUTE}`);
    if (isGiven(options.weights)) checkNumbers('weights', options.weights);
    const coincident = merge_coincident ? 'merge' : 'refuse';
    return new Diagram(this, native.voronoi(this._native, sources(points, { max_snap, coincident }), options));
  }

  balance(points, options = {}) {
    checkNames('balance', options, 'density shares weights progress');
    for (const name of ['shares', 'weights']) if (isGiven(options[name])) checkNumbers(name, options[name]);
    this._checkElements('density', options.density);
    const found = native.balance(this._native, entries('points', points, { coincident: 'refuse' }), options);
    return { ...found, diagram: new Diagram(this, found.diagram) };
  }

  segment(n, options = {}) {
    const { generators, labels, within, mask, per_region, levels, disc = false, ...all } = withCount(n, options);
    checkNames('segment', all, `n generators labels within mask per_region levels disc ${SAMPLE} ${COMPUTE}`);
    oneOf('segment', { ...all, generators, per_region, levels }, ['n', 'generators', 'radius', 'per_region', 'levels']);
    if (isGiven(per_region) && !isGiven(within)) refuse('per_region: give the regions, as within');
    if (isGiven(levels) && !isAscending(levels)) refuse(`levels: ascending whole numbers from 1 on are needed, not ${levels}`);
    const { n: count, sampling, seed, radius, ...compute } = all;
    const sampler = { ...compute, n: per_region ?? levels?.[levels.length - 1] ?? count, sampling, seed, radius };
    const regions = { within, mask, levels };
    const diagram = Object.values(regions).some(isGiven)
      ? this._inside(generators, { ...sampler, ...regions, per_region, labels })
      : this.voronoi(generators ?? this._native.sample(sampler), compute);
    const made = disc ? new Diagram(this, diagram._native.discs(compute)) : diagram;
    return made.segment({ labels, progress: all.progress });
  }

  /** The diagram inside regions. */
  _inside(generators, options) {
    this._checkElements('within', options.within);
    this._checkElements('mask', options.mask);
    const listed = isGiven(generators) ? { generators: entries('generators', generators, { coincident: 'refuse' }) } : {};
    return new Diagram(this, native.diagram_inside(this._native, { ...options, ...listed }));
  }

  lloyd(n, options = {}) {
    const all = withCount(n, options);
    checkNames('lloyd', all, `n ${RELAX} accelerate relocate iterations tolerance move_tolerance step on_iteration`);
    oneOf('lloyd', all, ['n', 'generators', 'radius']);
    return new Relaxation(this, native.lloyd(this._native, this._start(all)));
  }

  remesh(n, options = {}) {
    const all = withCount(n, options);
    checkNames('remesh', all, `n ${RELAX} target_edge error relax loose_boundary place shape exact_count max_added no_refine allow_intersections`);
    oneOf('remesh', all, ['n', 'generators', 'radius', 'target_edge', 'error']);
    const { loose_boundary = false, no_refine = false, ...others } = all;
    const given = { ...this._start(others), prefers_boundary: !loose_boundary, refine: !no_refine };
    return new Remesh(this, native.remesh(this._native, given));
  }

  /** The options of a relaxation as the module takes them. */
  _start(options) {
    const given = { ...options };
    for (const name of ['generators', 'fixed']) {
      if (isGiven(given[name])) given[name] = entries(name, given[name], { coincident: 'refuse' });
    }
    if (!isGiven(given.generators)) given.sampler = true;
    if (typeof given.density === 'string') {
      if (given.density !== 'curvature') refuse(`density: 'curvature' or an array is needed, not '${given.density}'`);
      given.weighs_curvature = true;
      delete given.density;
    }
    this._checkElements('density', given.density);
    return given;
  }

  _checkElements(name, values) {
    if (!isGiven(values)) return;
    checkNumbers(name, values);
    const counts = [this.vertices.length / 3, this.faces.length / 3];
    if (!counts.includes(values.length)) {
      refuse(`${name}: a number for each of ${counts[0]} vertices or ${counts[1]} faces is needed, not ${values.length}`);
    }
  }
}
forward(Mesh, 'vertices', 'faces', 'input_vertex', 'input_face', 'summary', 'notes');
lazy(Mesh, 'texture_coordinates', (self) => {
  const corners = self._native.texture_coordinates();
  return corners.length ? corners : null;
});

export class Curves extends Handle {
  constructor(mesh, handle) {
    super(handle);
    this.positions = handle.positions(mesh._native);
    this.length = this.positions.length;
  }
}

/** Curves, or points, for the calls that take both. */
const sources = (points, rules) => (points instanceof Curves ? { curves: points._native } : entries('points', points, rules));

export class Diagram extends Handle {
  constructor(mesh, handle) {
    super(handle);
    this.mesh = mesh;
  }

  check() {
    return this._native.check();
  }

  segment(options = {}) {
    checkNames('segment', options, 'labels progress');
    return new Segmentation(this, this._native.segment(options));
  }

  cut(options = {}) {
    checkNames('cut', options, 'uv progress');
    return new Cut(this, this._native.cut(options));
  }
}
forward(Diagram, 'labels', 'distances', 'face_labels', 'weights', 'generators', 'length', 'branch_points', 'cells', 'pieces');
lazy(Diagram, 'curves', (self) => self._native.bisectors());
lazy(Diagram, 'bisectors', ({ curves }) =>
  Array.from(curves.left, (left, i) => {
    const [begin, end] = [curves.first[i], curves.first[i + 1]];
    const bary = curves.points.bary.subarray(3 * begin, 3 * end);
    return {
      left,
      right: curves.right[i],
      closed: curves.closed[i] === 1,
      ends: [curves.ends[2 * i], curves.ends[2 * i + 1]],
      points: { face: curves.points.face.subarray(begin, end), bary },
      positions: curves.positions.subarray(3 * begin, 3 * end),
    };
  }));

/** An exact diagram of which one generator after the other is moved, added or removed. */
export class DiagramEditor extends Handle {
  constructor(mesh, points, { max_snap, ...options } = {}) {
    checkNames('DiagramEditor', options, `max_snap ${COMPUTE}`);
    super(native.edit(mesh._native, entries('points', points, { max_snap, coincident: 'refuse' }), options));
    this.mesh = mesh;
  }

  /** A copy, which stays as it is when the editor changes. */
  get diagram() {
    return (this._diagram ??= new Diagram(this.mesh, this._native.diagram()));
  }

  get generators() {
    return this._native.generators();
  }

  move(generator, to) {
    return this._change('move', generator, entries('to', to));
  }

  add(point) {
    return this._change('add', entries('point', point));
  }

  remove(generator) {
    return this._change('remove', generator);
  }

  /** What throws leaves the diagram as it was. */
  _change(name, ...args) {
    if (name !== 'add') checkIndices('generator', [args[0]]);
    this._native[name](...args);
    this._diagram = undefined;
    return this;
  }

  to_bytes(format, options) {
    return this.diagram.to_bytes(format, options);
  }
}

export class Segmentation extends Handle {
  constructor(diagram, handle) {
    super(handle);
    this.diagram = diagram;
  }
}
forward(Segmentation, 'labels', 'without_face', 'border_length');
lazy(Segmentation, 'regions', (self) => self._native.numbers().region ?? null);
lazy(Segmentation, 'levels', (self) =>
  Object.entries(self._native.numbers()).filter(([name]) => name.startsWith('label_')).map(([, labels]) => labels));

export class Cut extends Handle {
  constructor(diagram, handle) {
    super(handle);
    this.diagram = diagram;
  }
}
forward(Cut, 'labels', 'parents', 'vertex_labels', 'distances', 'charts', 'scale');
lazy(Cut, 'mesh', (self) => Mesh._wrap(self._native.mesh()));

export class Relaxation extends Handle {
  constructor(mesh, handle) {
    super(handle);
    this.diagram = new Diagram(mesh, handle.diagram());
  }

  to_bytes(format, options) {
    return this.diagram.to_bytes(format, options);
  }

  points_to_bytes(format) {
    checkText('format', format);
    return this._native.write_samples(format);
  }
}
forward(Relaxation, 'energies', 'areas', 'cell_energies', 'residual', 'stop');
lazy(Relaxation, 'generators', (self) => self.diagram.generators);

export class RemeshMap extends Handle {}
forward(RemeshMap, 'points', 'origins', 'one_to_one');

export class Remesh extends Handle {
  constructor(surface, handle) {
    super(handle);
    this.surface = surface;
  }

  map(options = {}) {
    checkNames('map', options, 'progress');
    return new RemeshMap(this._native.map(options));
  }
}
forward(Remesh, 'figures', 'certificate');
lazy(Remesh, 'mesh', (self) => Mesh._wrap(self._native.mesh()));
lazy(Remesh, 'diagram', (self) => new Diagram(self.surface, self._native.diagram()));

function checkBytes(bytes) {
  if (!(bytes instanceof Uint8Array || bytes instanceof ArrayBuffer)) refuse('a Uint8Array or an ArrayBuffer is needed');
}

/**
 * Reads the bytes of an OBJ, PLY, OFF, STL, glTF (buffers inside), MNI or legacy VTK file; `name` is the file's, for messages.
 * `weld`: true joins vertices at the same place, a number also those at most so many mesh units apart.
 */
export function read(bytes, name, { on_defect = 'repair', weld = false, ...others } = {}) {
  checkNames('read', others, 'on_defect weld');
  checkBytes(bytes);
  checkText('name', name);
  checkText('on_defect', on_defect);
  if (!['boolean', 'number'].includes(typeof (weld ?? false))) refuse(`weld: true, false or a number is needed, not ${weld}`);
  const tolerance = weld === true ? 0 : weld === false ? null : weld ?? null;
  return Mesh._wrap(native.mesh_from_bytes(bytes, name, on_defect, tolerance));
}

/** The numbers of a file that has one for each vertex or face: text, .npy, and FreeSurfer's .annot and values. */
export function read_values(bytes, name) {
  checkBytes(bytes);
  checkText('name', name);
  return native.parse_values(bytes, name);
}

/** The bytes that gzip packed, as `read` takes them; other bytes as they are. */
export async function unpack(bytes) {
  const [first, second] = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(2, bytes.byteLength));
  if (first !== 0x1f || second !== 0x8b) return bytes;
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(unpacked).arrayBuffer());
}
