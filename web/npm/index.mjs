// Exact geodesic Voronoi diagrams, distances, paths and remeshes on triangle meshes, by WebAssembly.
//
//   import { Mesh, read } from 'gvd';
//   const mesh = read(bytes, 'bunny.obj');
//   const regions = mesh.segment(30);
//   const file = regions.to_bytes('ply');
//
// Operations and options have the names of the commands, and the results are the same; index.d.ts has the documents.
// Calls block, so pages make them in a worker. Objects free their memory when they are collected, or by free().
import { Error, refuse } from './error.mjs';
import { call, Handle, version } from './library.mjs';
import { Curves, fileOf, optionsOf, run } from './options.mjs';
import { checkIndices, checkNumbers, flat, isGiven, isList, isSingle, pointRows } from './points.mjs';

export { Curves, Error, version };

const kSummary = ['vertices', 'edges', 'faces', 'components', 'boundary_loops', 'euler_characteristic', 'area', 'bbox_diagonal'];

/** An object of the library, with what was asked of it. */
class Thing {
  constructor(native, mesh = null) {
    this._native = native;
    this._kept = new Map(mesh ? [['mesh', mesh]] : []);
  }

  /** What `make` gives, which is asked once. */
  _keep(name, make) {
    if (!this._kept.has(name)) this._kept.set(name, make());
    return this._kept.get(name);
  }

  _array(name) {
    return this._keep(name, () => this._native.array(name));
  }

  /** A copy that the package computes with, which nobody else has. */
  _own(name) {
    const take = () => (this._native.known === null ? refuse('the mesh was freed, from which positions come; free it after its results') : this._native.array(name));
    return this._keep(`own ${name}`, take);
  }

  _points(name) {
    return this._keep(`${name} points`, () => ({ face: this._array(`${name}_faces`), bary: this._array(`${name}_bary`) }));
  }

  /** Lists that `offsets` parts, of `size` numbers an item. */
  _lists(offsets, values, size = 1) {
    return Array.from({ length: Math.max(offsets.length - 1, 0) }, (_, i) => values.subarray(size * offsets[i], size * offsets[i + 1]));
  }

  /** {points, positions} of each of several curves. */
  _curves(name) {
    const offsets = this._array(`${name}_offsets`), { face, bary } = this._points(name);
    const parts = [this._lists(offsets, face), this._lists(offsets, bary, 3), this._lists(offsets, positionsOf(this.mesh, { face, bary }), 3)];
    return parts[0].map((_, i) => ({ points: { face: parts[0][i], bary: parts[1][i] }, positions: parts[2][i] }));
  }

  get mesh() {
    return this._kept.get('mesh');
  }

  get figures() {
    return this._keep('figures', () => this._native.figures());
  }

  free() {
    this._native.free();
  }

  to_bytes(format, options = {}) {
    return fileOf('to_bytes', this._native, format, options);
  }

  scene(options = {}) {
    const { colors, ...others } = optionsOf('scene', options), own = { colors: colors?.length ? colors : null };
    return using(new Thing(run('scene', 'SceneOptions', this, others, { own })), (made) => ({
      manifest: made.figures.manifest,
      blobs: this._lists(made._array('offsets'), made._array('bytes')).map((bytes) => bytes.slice()),
      colors: made._array('colors'),
    }));
  }
}

/** What `take` makes of an object, which is freed then. */
function using(made, take) {
  try {
    return take(made);
  } finally {
    made.free();
  }
}

/** Gives a class getters: of an array by its name in the library, or of what a function takes from the object, once. */
function getters(target, table) {
  for (const [name, take] of Object.entries(table)) {
    const get = typeof take === 'string'
      ? function () { return this._array(take); }
      : function () { return this._keep(`.${name}`, () => take(this)); };
    Object.defineProperty(target.prototype, name, { get, configurable: true });
  }
}

function positionsOf(mesh, { face, bary }) {
  const [vertices, faces] = [mesh._own('vertex_positions'), mesh._own('face_vertices')];
  const positions = new Float64Array(3 * face.length);
  for (let i = 0; i < face.length; ++i) {
    const [a, b, c] = faces.subarray(3 * face[i], 3 * face[i] + 3), [u, v, w] = bary.subarray(3 * i, 3 * i + 3);
    for (let k = 0; k < 3; ++k) positions[3 * i + k] = u * vertices[3 * a + k] + v * vertices[3 * b + k] + w * vertices[3 * c + k];
  }
  return positions;
}

const needed = (name, given, what) => (isGiven(given) ? given : refuse(`${name}: ${what} needed`));
const sourcesOf = (option, points) => ({ [points instanceof Curves ? 'curves' : option]: needed('points', points, 'points are') });

/** A first argument, which is also an option. */
function countOf(call, count, options) {
  if (isGiven(count) && isGiven(options?.count)) refuse(`${call}: count is given twice`);
  return isGiven(count) ? { count } : {};
}

export class Mesh extends Thing {
  constructor(vertices, faces, options = {}) {
    if (vertices instanceof Handle) {
      super(vertices);
    } else {
      const { on_defect, corners, weld, ...others } = optionsOf('Mesh', options), size = faces?.[0]?.length ?? corners ?? 3;
      if ('file' in others || 'content' in others) refuse('Mesh: there is no option "file"; read makes a mesh of the bytes of a file');
      if (!Number.isInteger(size) || size < 3) refuse(`corners: a whole number from 3 on is needed, not ${size}`);
      const at = flat('vertices', vertices, 3), of = flat('faces', faces, size);
      checkNumbers('vertices', at);
      checkNumbers('faces', of);
      checkIndices('faces', of);
      if (at.length % 3) refuse(`vertices: three coordinates each are needed, not ${at.length} in all`);
      if (of.length % size) refuse(`faces: ${size} corners each are needed, not ${of.length} in all`);
      const arrays = [{ numbers: new Float64Array(at), columns: 3 }, { numbers: new Float64Array(of), columns: size }];
      super(run('Mesh', 'ReadOptions', null, others, { own: { on_defect: on_defect ?? 'error', weld: weldOption(weld) }, arrays }));
    }
    this._kept.set('mesh', this);
  }

  points(points, options = {}) {
    return pointsOf(run('points', 'PointOptions', this, options, { own: { points: needed('points', points, 'points are') } }));
  }

  positions(points) {
    return positionsOf(this, this.points(points));
  }

  sample(count, options = {}) {
    return this._sample('sample', count, options);
  }

  farthest(count, options = {}) {
    return this._sample('farthest', count, options);
  }

  _sample(name, count, options) {
    if (![count, options?.count, options?.radius].some(isGiven)) refuse(`${name}: how many points? Give a count or a radius`);
    return pointsOf(run(name, 'SampleOptions', this, options, { own: countOf(name, count, options) }));
  }

  measure(points, options = {}) {
    return this._measured('measure', 'MeasureOptions', points, options);
  }

  _measured(name, type, points, options, own = {}, names = {}) {
    const more = points instanceof Curves ? {} : { keep_coincident: true };
    return new Distances(run(name, type, this, options, { own: { ...own, ...sourcesOf('from', points) }, more, names }), this);
  }

  _measure(name, type, points, options, own, take, names) {
    return using(this._measured(name, type, points, options, own, names), take);
  }

  distances(points, options = {}) {
    const { each: given, ...others } = optionsOf('distances', options), each = given === true, has_targets = isGiven(others.to);
    return this._measure('distances', 'DistanceOptions', points, others, { each: given, mesh_vertices: each && !has_targets },
                         (made) => (each || has_targets ? made._array('rows') : made.distances));
  }

  *distance_rows(points, options = {}) {
    const { face, bary } = this.points(points), has_targets = isGiven(optionsOf('distance_rows', options).to);
    for (let i = 0; i < face.length; ++i) {
      yield this._measure('distance_rows', 'DistanceOptions', { face: face.subarray(i, i + 1), bary: bary.subarray(3 * i, 3 * i + 3) }, options, {},
                          (made) => (has_targets ? made._array('rows') : made.distances));
    }
  }

  nearest(points, options = {}) {
    return this._measure('nearest', 'DistanceOptions', points, options, {}, (made) => (
      isGiven(options?.to) ? { distances: made._array('rows'), labels: made._array('nearest') } : { distances: made.distances, labels: made.labels }));
  }

  log_map(point, options = {}) {
    const given = onePoint('point', point);
    return this._measure('log_map', 'PathOptions', given, options, { logarithm: true }, (made) => made._array('logarithms'), { points: 'point' });
  }

  path(start, end, options = {}) {
    const [from, to] = [needed('end', end, 'points are'), needed('start', start, 'points are')];
    const paths = this._measure('path', 'PathOptions', from, options, { to, paths: true }, (made) => made.paths, { to: 'start', points: 'end' });
    return isSingle(start) ? paths[0] : paths;
  }

  isolines(points, levels, options = {}) {
    const own = { [typeof levels === 'number' ? 'isolines' : 'levels']: needed('levels', levels, 'a distance, or an array of them, is') };
    return this._measure('isolines', 'PathOptions', points, options, own, (made) => made.isolines, { isolines: 'levels' });
  }

  curves(curves, options = {}) {
    const { closed, angle, name, ...others } = optionsOf('curves', options);
    const isWord = typeof curves === 'string', isFile = curves instanceof Uint8Array || curves instanceof ArrayBuffer;
    if (closed && (isWord || isFile)) refuse('closed: it is for polylines');
    if (isGiven(angle) && curves !== 'creases') refuse("angle: it is for 'creases'");
    if (isWord && !/^(boundary|creases(:.*)?)$/.test(curves)) refuse(`curves: 'boundary' or 'creases' is needed, not '${curves}'`);
    if (isGiven(angle) && !(angle > 0 && angle < 180)) refuse(`angle: a number above 0 and below 180, in degrees, is needed, not ${angle}`);
    const given = [];
    let option = isWord && isGiven(angle) ? `creases:${angle}` : curves;
    if (isFile) {
      given.push({ numbers: new Uint8Array(curves) });
      option = { file: name ?? 'curves', content: { array: 0 } };
    } else if (!isWord) {
      option = polylines(this, curves, closed ?? false, given);
    }
    return using(new Thing(run('curves', 'CurveOptions', this, others, { more: { curves: option }, arrays: given })), (made) => {
      const lines = this._lists(made._array('offsets'), made._array('positions'), 3), found = Array.from({ length: made.figures.count }, () => []);
      made._array('curve').forEach((curve, i) => found[curve].push(lines[i]));
      return new Curves(option, given, found);
    });
  }

  voronoi(points, options = {}) {
    const own = sourcesOf('generators', points), names = { generators: 'points' };
    return new Diagram(run('voronoi', 'DiagramOptions', this, options, { own, names }), this);
  }

  balance(points, options = {}) {
    const { density, ...others } = optionsOf('balance', options), generators = needed('points', points, 'points are');
    const own = { balance: density ?? 'area', generators }, names = { generators: 'points', balance: 'density' };
    const diagram = new Diagram(run('balance', 'BalanceOptions', this, others, { own, names }), this);
    const { tied, converged } = diagram.figures.balance;
    const sets = (tied ?? []).map((cells) => Int32Array.from(cells));
    return { diagram, masses: diagram._array('balance.masses'), targets: diagram._array('balance.targets'), tied: sets, converged };
  }

  segment(count, options = {}) {
    const { cut, uv, ...others } = optionsOf('segment', options);
    const made = run('segment', 'SegmentOptions', this, others, { own: { cut, uv, ...countOf('segment', count, others) } });
    return new (cut || isGiven(uv) ? Cut : Segmentation)(made, this);
  }

  lloyd(count, options = {}) {
    return new Relaxation(run('lloyd', 'LloydOptions', this, options, { own: countOf('lloyd', count, options) }), this);
  }

  remesh(count, options = {}) {
    return new Remesh(run('remesh', 'RemeshOptions', this, options, { own: countOf('remesh', count, options) }), this);
  }
}
getters(Mesh, {
  vertices: 'vertex_positions',
  faces: 'face_vertices',
  input_vertex: 'input_vertex',
  input_face: 'input_polygon',
  vertex_of_input: 'vertex_of_input',
  texture_coordinates: (mesh) => (mesh._array('texture').length ? mesh._array('texture') : null),
  summary: ({ figures }) => Object.fromEntries(kSummary.map((name) => [name, figures[name]])),
  area: ({ figures }) => figures.area,
  notes: ({ figures }) => figures.repairs,
  bounds(mesh) {
    const at = mesh._own('vertex_positions');
    return [Math.min, Math.max].map((pick) => [0, 1, 2].map((k) => at.reduce((found, x, i) => (i % 3 === k ? pick(found, x) : found), at[k])));
  },
});

const pointsOf = (native) => using(native, (made) => ({ face: made.array('points_faces'), bary: made.array('points_bary') }));

/** Polylines through points, as the library takes curves. */
function polylines(mesh, curves, closed, arrays) {
  if (!isList(curves) || curves.length === 0) refuse(`curves: an array of polylines is needed, not ${curves?.length === 0 ? 'an empty one' : typeof curves}`);
  const lines = Array.from(curves, (line, i) => mesh.points(needed(`curves[${i}]`, line, 'points are')));
  const rows = lines.flatMap(({ face, bary }) => Array.from(face, (f, i) => [f, ...bary.subarray(3 * i, 3 * i + 3)]));
  arrays.push({ numbers: new Float64Array(rows.flat()), columns: 4 });
  const offsets = lines.reduce((all, { face }) => [...all, all.at(-1) + face.length], [0]);
  return { points: { array: 0 }, offsets, closed };
}

class Distances extends Thing {}
getters(Distances, {
  distances: 'vertex_distances',
  labels: 'vertex_labels',
  paths: (made) => made._curves('path').map((curve, i) => {
    const { length, complete, source } = made.figures.paths[i];
    return { ...curve, length: length ?? Infinity, complete, end: source };
  }),
  isolines(made) {
    const [levels, closed] = [made._array('isoline_levels'), made._array('isoline_closed')];
    return made._curves('isoline').map((curve, i) => ({ level: levels[i], closed: closed[i] === 1, ...curve }));
  },
});

export class Diagram extends Thing {
  check() {
    return using(run('check', 'CheckOptions', this, {}), (made) => made.figures().violations);
  }

  segment(options = {}) {
    return new Segmentation(run('segment', 'LabelOptions', this, options), this.mesh);
  }

  cut(options = {}) {
    return new Cut(run('cut', 'CutOptions', this, options, { own: { cut: true } }), this.mesh);
  }
}
getters(Diagram, {
  labels: 'vertex_labels',
  distances: 'vertex_distances',
  face_labels: 'face_labels',
  weights: 'weights',
  areas: 'cell_areas',
  length: ({ figures }) => figures.length,
  generators: (diagram) => diagram._points('generators'),
  branch_points: (diagram) => ({
    points: diagram._points('branch_point'),
    positions: diagram._array('branch_point_positions'),
    distances: diagram._array('branch_point_distances'),
    generators: diagram._lists(diagram._array('branch_point_generators_offsets'), diagram._array('branch_point_generators')),
  }),
  curves: (diagram) => ({
    first: Int32Array.from(diagram._array('bisector_offsets')),
    left: diagram._array('bisector_left'),
    right: diagram._array('bisector_right'),
    closed: Int32Array.from(diagram._array('bisector_closed')),
    ends: diagram._array('bisector_ends'),
    points: diagram._points('bisector'),
    positions: positionsOf(diagram.mesh, diagram._points('bisector')),
  }),
  bisectors(diagram) {
    const { left, right, closed, ends } = diagram.curves;
    return diagram._curves('bisector').map((curve, i) => (
      { left: left[i], right: right[i], closed: closed[i] === 1, ends: [ends[2 * i], ends[2 * i + 1]], ...curve }));
  },
  cells(diagram) {
    const [area, euler_characteristic, components, boundary_loops] = ['areas', 'euler_characteristics', 'components', 'boundary_loops'].map(
      (name) => diagram._array(`cell_${name}`));
    const neighbours = diagram._lists(diagram._array('cell_neighbours_offsets'), diagram._array('cell_neighbours'));
    return neighbours.map((list, i) => ({ generator: i, area: area[i], euler_characteristic: euler_characteristic[i],
                                          components: components[i], boundary_loops: boundary_loops[i], neighbours: list }));
  },
  pieces: (diagram) => using(diagram._native.part('pieces'), (made) => (
    { positions: Float32Array.from(made.array('positions')), face: made.array('faces'), label: made.array('labels') })),
});

/** An exact diagram of which one generator after the other is moved, added or removed. */
export class DiagramEditor {
  constructor(mesh, points, options = {}) {
    if (!(mesh instanceof Mesh)) refuse('mesh: a Mesh is needed');
    const own = { editable: true, generators: needed('points', points, 'points are') };
    const diagram = new Diagram(run('DiagramEditor', 'EditorOptions', mesh, options, { own, names: { generators: 'points' } }), mesh);
    Object.assign(this, { mesh, _state: { diagram, given: false } });  // whether somebody has the diagram
  }

  get diagram() {
    this._state.given = true;
    return this._state.diagram;
  }

  get generators() {
    return this._state.diagram.generators;
  }

  move(generator, to, options = {}) {
    return this._change('move', options, { move: this._find(generator), to: onePoint('to', to) });
  }

  add(point, options = {}) {
    return this._change('add', options, { add: onePoint('point', point) });
  }

  remove(generator, options = {}) {
    return this._change('remove', options, { remove: this._find(generator) });
  }

  _find(generator) {
    checkIndices('generator', [generator]);
    if (generator < 2 ** 31) return generator;  // the library knows how many there are
    throw new Error(`generator: there is no generator ${generator}`, 'precondition', generator);
  }

  /** What throws leaves the diagram as it was. */
  _change(name, options, own) {
    if (this._state.changing) refuse(`${name}: the editor is in the middle of a change`);
    this._state.changing = true;
    try {
      const made = new Diagram(run(name, 'EditOptions', this._state.diagram, options, { own, names: { add: 'point' } }), this.mesh);
      this.free();
      Object.assign(this._state, { diagram: made, given: false });
    } finally {
      this._state.changing = false;
    }
    return this;
  }

  /** A diagram that was asked for stays. */
  free() {
    if (!this._state.given) this._state.diagram.free();
  }

  to_bytes(format, options) {
    return this._state.diagram.to_bytes(format, options);
  }
}

function onePoint(name, point) {
  const { numbers, columns = 1 } = pointRows(name, point), count = numbers.length / columns;
  return count === 1 ? point : refuse(`${name}: one point is needed, not ${count}`);
}

/** What has a diagram; `surface` is the mesh that it was made on. */
class Result extends Thing {}
getters(Result, {
  surface: (made) => made._kept.get('mesh'),  // whose name is that of another one, where the result makes a mesh
  diagram: (made) => new Diagram(made._native.part('diagram'), made.surface),
  generators: (made) => made._points('generators'),
});

export class Segmentation extends Result {}
getters(Segmentation, {
  labels: 'face_labels',
  areas: 'regions.area',
  without_face: ({ figures }) => Int32Array.from(figures.generators_without_face ?? []),
  border_length: ({ figures }) => figures.border_length,
  regions: (made) => (made.figures.options.within ? made._array('region') : null),
  levels: (made) => (made.figures.options.levels ?? []).map((_, i) => made._array(`label_${i + 1}`)),
});

export class Cut extends Result {}
getters(Cut, {
  mesh: (made) => new Mesh(made._native.part('cut_mesh')),
  labels: 'face_labels',
  parents: 'face_parents',
  vertex_labels: 'vertex_labels',
  distances: 'vertex_distances',
  scale: ({ figures }) => figures.charts?.scale ?? 0,
  charts: ({ figures }) => (figures.charts?.charts ?? []).map(({ box, ...chart }) => (
    { torn_share: 0, origin: [0, 0], ...chart, box: box ? [box.slice(0, 2), box.slice(2)] : [] })),
});

export class Relaxation extends Result {
  points_to_bytes(format) {
    return fileOf('points_to_bytes', this._native, format, {}, { part: 'points' });
  }
}
getters(Relaxation, {
  energies: 'energies',
  areas: 'areas',
  cell_energies: 'cell_energies',
  residual: ({ figures }) => figures.residual,
  stop: ({ figures }) => figures.stop,
});

/** Where the vertices of a surface are on its remesh, and where those of the remesh come from. */
export class RemeshMap extends Thing {
  to_bytes(format) {
    return fileOf('to_bytes', this._native, format, {}, { part: 'map' });
  }
}
getters(RemeshMap, {
  points: (map) => map._points('map_points'),
  origins: (map) => map._points('map_origins'),
  one_to_one: ({ figures }) => figures.map.one_to_one,
});

export class Remesh extends Result {
  map(options = {}) {
    return new RemeshMap(run('map', 'MapOptions', this, options), this.surface);
  }
}
getters(Remesh, {
  mesh: (made) => new Mesh(made._native.part('mesh')),
  certificate: ({ figures }) => ({ ok: true, ...figures.certificate }),  // what has none is an error
});

/** The bytes of a file, for the library. */
function contentOf(bytes, name) {
  if (!(bytes instanceof Uint8Array || bytes instanceof ArrayBuffer)) refuse('a Uint8Array or an ArrayBuffer is needed');
  if (typeof name !== 'string') refuse(`name: text is needed, not ${name}`);
  return [{ numbers: bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes) }];
}

function weldOption(weld) {
  if (!['boolean', 'number'].includes(typeof (weld ?? false))) refuse(`weld: true, false or a number is needed, not ${weld}`);
  return weld === true ? 0 : weld === false ? null : weld;
}

export function read(bytes, name, options = {}) {
  const { weld, ...others } = optionsOf('read', options);
  const given = { own: { weld: weldOption(weld) }, more: { file: name, content: true }, arrays: contentOf(bytes, name) };
  return new Mesh(run('read', 'ReadOptions', null, others, given));
}

function readNumbers(operation, bytes, name) {
  return new Thing(call(operation, null, { file: name, content: true }, contentOf(bytes, name)));
}

export function read_values(bytes, name) {
  return readNumbers('values', bytes, name)._array('values');
}

export function read_properties(bytes, name) {
  const made = readNumbers('properties', bytes, name), found = { vertex: {}, face: {} };
  for (const full of made.figures.names) {
    const [element, ...own] = full.split(' ');
    found[element][own.join(' ')] = made._array(full);
  }
  return found;
}

/** The bytes that gzip packed, as `read` takes them; other bytes as they are. */
export async function unpack(bytes) {
  const [first, second] = new Uint8Array(bytes.buffer ?? bytes, bytes.byteOffset ?? 0, Math.min(2, bytes.byteLength));
  if (first !== 0x1f || second !== 0x8b) return bytes;
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  try {
    return new Uint8Array(await new Response(unpacked).arrayBuffer());
  } catch {
    throw new Error('the bytes that gzip packed are damaged or end too early', 'unreadable_input');
  }
}
