// The worker of the playground: one mesh, and what the page asks about it. Messages {id, kind, args} are answered by {id,
// result}, {id, error}, or first {id, progress}.
import make_module from 'gvd-module';

class GvdError extends Error {
  constructor(message, code) {
    super(message);
    this.code = code;
  }
}

let gvd, mesh, scenes;

// Points of the page as the module takes them.
const kFace = 1;
const entries = (points) => ({ kind: kFace, id: points.map(({ face }) => face), at: points.flatMap(({ bary }) => bary), coincident: 'refuse' });
const to_points = ({ face, bary }) => Array.from(face, (f, i) => ({ face: f, bary: [...bary.subarray(3 * i, 3 * i + 3)] }));

// What `make` returns lives in the module's memory: it is freed after `use`.
function using(made, use) {
  try {
    return use(made);
  } finally {
    made.delete();
  }
}

// The given generators, or the farthest ones.
const generators_of = ({ count, generators }) => generators ?? to_points(mesh.sample({ n: count, sampling: 'farthest' }));

const of_diagram = (diagram) => scenes.of_diagram(diagram);
const balanced = (points, use) => {
  const { diagram, converged } = gvd.balance(mesh, entries(points), {});
  const note = converged ? '' : 'Not all areas are equal: masses jump where a bisector passes a corner of the surface.';
  return { ...using(diagram, use), note };
};

// What is made of generators: a scene of it, and a file.
const kShows = {
  diagram: {
    name: 'regions',
    make: (points, use, { method } = {}) => using(gvd.voronoi(mesh, entries(points), { method }), use),
    scene: of_diagram,
  },
  equal: { name: 'equal', make: balanced, scene: of_diagram },
  distances: {
    name: 'distances',
    make: (points, use) => use(points),
    scene: (points) => scenes.of_distances(entries(points)),
  },
  remesh: {
    name: 'coarse',
    make: (points, use) => using(gvd.remesh(mesh, { generators: entries(points) }), use),
    scene: (remesh) => gvd.remesh_scene(scenes, remesh),
  },
};

const handlers = {
  async start({ module }) {
    gvd = await make_module({ wasmBinary: module, Error: GvdError });
  },

  // The mesh that was there stays until the new one has been read.
  open({ name, bytes }) {
    const read = gvd.mesh_from_bytes(new Uint8Array(bytes), name, 'repair'), { faces } = read.summary();
    scenes?.delete();
    mesh?.delete();
    [mesh, scenes] = [read, new gvd.Scenes(read)];
    return { name, faces, notes: mesh.notes() };
  },

  show(asked) {
    const points = generators_of(asked), { make, scene } = kShows[asked.show];
    return { points, ...make(points, scene, asked) };
  },

  // Each iteration is shown, by the diagram of its generators.
  relax(asked, report) {
    const on_iteration = (count, energy, points) => report({ scene: kShows.diagram.make(to_points(points), of_diagram, { method: 'gbgvd' }), points: to_points(points) });
    return using(gvd.lloyd(mesh, { generators: entries(generators_of(asked)), on_iteration }), (relaxed) =>
      using(relaxed.diagram(), (diagram) => ({ points: to_points(diagram.generators()) })));
  },

  path({ from, to }) {
    const [path] = mesh.paths(entries([from]), entries([to]), {});
    if (!path.complete) throw new GvdError('no path leads there');
    return { points: scenes.to_page(path.positions), length: path.length };
  },

  file({ show, format, ...asked }) {
    const { name, make } = kShows[show], points = generators_of(asked);
    if (format === 'csv' || show === 'distances') return { name: format === 'csv' ? 'generators' : name, bytes: kShows.diagram.make(points, (diagram) => diagram.write(format, {})) };
    const write = (made) => ({ bytes: made.write(format, {}) });
    const cut_first = (diagram) => using(diagram.cut({}), write);
    return { name, ...make(points, show === 'equal' && format !== 'json' ? cut_first : write) };
  },
};

onmessage = async ({ data: { id, kind, args } }) => {
  try {
    const result = await handlers[kind](args, (progress) => postMessage({ id, progress }));
    postMessage({ id, result });
  } catch (error) {
    postMessage({ id, error: error.message });
  }
};
