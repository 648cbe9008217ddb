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
import { checkIndices, checkNames, entries, Error, isSingle, oneOf, refuse } from './points.mjs';

const native = await create({ wasmBinary, Error });
const collected = new FinalizationRegistry((handle) => handle.delete());

export { Error };
export const version = native.version();

/** An object of the module. */
class Handle {
  constructor(handle) {
    this._native = handle;
    collected.register(this, handle, this);
  }

  free() {
    collected.unregister(this);
    this._native.delete();
  }

  to_bytes(format, options = {}) {
    checkNames('to_bytes', options, 'no_curves ascii_ply region_materials');
    return this._native.write(format.toLowerCase().replace(/^\./, ''), options);
  }
}

/** Gives a class getters for what its object in the module has by the same names; each value is taken once. */
function forward(target, ...names) {
  for (const name of names) lazy(target, name, (self) => self._native[name]());
}

function lazy(target, name, take) {
  const get = function () {
    const value = take(this);
    Object.defineProperty(this, name, { value, enumerable: true });
    return value;
  };
  Object.defineProperty(target.prototype, name, { get, configurable: true });
}

const SAMPLE = 'sampling seed radius progress';
const COMPUTE = 'method front chord_tolerance progress';
const RELAX = `${SAMPLE} ${COMPUTE} generators fixed features keep_boundary density gradation coarse`;

/** n as a first argument, or in the options. */
const withCount = (n, options) => (n === undefined || n === null ? options : { n, ...options });

export class Mesh extends Handle {
  constructor(vertices, faces, { on_defect = 'error', corners = 3, ...others } = {}) {
    checkNames('Mesh', others, 'on_defect corners');
    const flat = (list) => (Array.isArray(list) && Array.isArray(list[0]) ? list.flat() : list);
    const size = Array.isArray(faces) && Array.isArray(faces[0]) ? faces[0].length : corners;
    if (Array.isArray(faces[0]) && faces.some((face) => face.length !== size)) refuse('faces: all have equally many corners');
    const [at, of] = [flat(vertices), flat(faces)];
    if (at.length % 3) refuse(`vertices: three coordinates each are needed, not ${at.length} in all`);
    if (of.length % size) refuse(`faces: ${size} corners each are needed, not ${of.length} in all`);
    super(native.mesh_from_arrays(at, of, size, on_defect));
  }

  static _wrap(handle) {
    const mesh = Object.create(Mesh.prototype);
    mesh._native = handle;
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
    return each ? this._native.rows(entries('points', points), this._at('distances', options)) : this.nearest(points, options).distances;
  }

  nearest(points, options = {}) {
    return this._native.nearest(entries('points', points), this._at('nearest', options));
  }

  _at(call, options) {
    checkNames(call, options, 'at progress');
    return options.at === undefined ? options : { ...options, at: entries('at', options.at) };
  }

  path(start, end, options = {}) {
    checkNames('path', options, 'progress');
    const paths = this._native.paths(entries('start', start), entries('end', end), options);
    return isSingle(start) || (start.face && start.face.length === 1) ? paths[0] : paths;
  }

  isolines(points, levels, options = {}) {
    checkNames('isolines', options, 'progress');
    return this._native.isolines(entries('points', points), levels, options);
  }

  voronoi(points, { max_snap, merge_coincident = false, ...options } = {}) {
    checkNames('voronoi', options, `max_snap merge_coincident weights ${COMPUTE}`);
    const coincident = merge_coincident ? 'merge' : 'refuse';
    return new Diagram(this, native.voronoi(this._native, entries('points', points, { max_snap, coincident }), options));
  }

  balance(points, options = {}) {
    checkNames('balance', options, 'density shares weights progress');
    this._checkDensity(options);
    const found = native.balance(this._native, entries('points', points, { coincident: 'refuse' }), options);
    return { ...found, diagram: new Diagram(this, found.diagram) };
  }

  segment(n, options = {}) {
    const { generators, labels, ...all } = withCount(n, options);
    checkNames('segment', all, `n generators labels ${SAMPLE} ${COMPUTE}`);
    oneOf('segment', { ...all, generators }, ['n', 'generators', 'radius']);
    const { n: count, sampling, seed, radius, ...compute } = all;
    const points = generators ?? this._native.sample({ ...compute, n: count, sampling, seed, radius });
    return this.voronoi(points, compute).segment({ labels, progress: all.progress });
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
      if (given[name] !== undefined) given[name] = entries(name, given[name], { coincident: 'refuse' });
    }
    if (given.generators === undefined) given.sampler = true;
    if (typeof given.density === 'string') {
      if (given.density !== 'curvature') refuse(`density: 'curvature' or an array is needed, not '${given.density}'`);
      given.weighs_curvature = true;
      delete given.density;
    }
    this._checkDensity(given);
    return given;
  }

  _checkDensity({ density }) {
    const counts = [this.vertices.length / 3, this.faces.length / 3];
    if (density !== undefined && !counts.includes(density.length)) {
      refuse(`density: a number for each of ${counts[0]} vertices or ${counts[1]} faces is needed, not ${density.length}`);
    }
  }
}
forward(Mesh, 'vertices', 'faces', 'input_vertex', 'input_face', 'summary', 'notes');

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
    checkNames('cut', options, 'progress');
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

export class Cut extends Handle {
  constructor(diagram, handle) {
    super(handle);
    this.diagram = diagram;
  }
}
forward(Cut, 'labels', 'parents', 'vertex_labels', 'distances');
lazy(Cut, 'mesh', (self) => Mesh._wrap(self._native.mesh()));

export class Relaxation extends Handle {
  constructor(mesh, handle) {
    super(handle);
    this.diagram = new Diagram(mesh, handle.diagram());
  }

  to_bytes(format, options) {
    return this.diagram.to_bytes(format, options);
  }
}
forward(Relaxation, 'energies', 'areas', 'cell_energies', 'residual', 'stop');
lazy(Relaxation, 'generators', (self) => self.diagram.generators);

export class Remesh extends Handle {
  constructor(surface, handle) {
    super(handle);
    this.surface = surface;
  }

  map(options = {}) {
    checkNames('map', options, 'progress');
    return this._native.map(options);
  }
}
forward(Remesh, 'figures', 'certificate');
lazy(Remesh, 'mesh', (self) => Mesh._wrap(self._native.mesh()));
lazy(Remesh, 'diagram', (self) => new Diagram(self.surface, self._native.diagram()));

/** Reads the bytes of an OBJ, PLY, OFF, STL, GLB or legacy VTK file; `name` is the file's, for messages. */
export function read(bytes, name, { on_defect = 'repair', ...others } = {}) {
  checkNames('read', others, 'on_defect');
  return Mesh._wrap(native.mesh_from_bytes(bytes, name, on_defect));
}
