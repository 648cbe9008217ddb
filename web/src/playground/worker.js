// The worker of the playground: one mesh, and what the page asks about it. Messages {id, kind, args} are answered by {id,
// result}, {id, error}, or first {id, progress}.
import make_module from 'gvd-module';
import { find_change } from './edits.js';

class GvdError extends Error {
  constructor(message, code) {
    super(message);
    this.code = code;
  }
}

let gvd, mesh, scenes;
const last = {};  // what was made last: the farthest generators, the editor of the exact diagram, and the result of each kind

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

function forget(...kinds) {
  for (const kind of kinds) {
    last[kind]?.made.delete?.();
    delete last[kind];
  }
}

// What `make` gives, or gave the last time if that was of the same: it is kept until another one is made.
function kept(kind, of, make) {
  const key = JSON.stringify(of);
  if (last[kind]?.key !== key) {
    forget(kind);
    last[kind] = { key, made: make() };
  }
  return last[kind].made;
}

// The given generators, or the farthest ones.
const generators_of = ({ count, generators }) => generators ?? kept('farthest', count, () => to_points(mesh.sample({ n: count, sampling: 'farthest' })));

// The exact diagram of points, by changing the last one where a single generator differs.
function exact_diagram(points, use) {
  const change = last.editor && find_change(last.editor.points, points);
  try {
    if (change) {
      const [name, ...args] = change;
      if (name) last.editor.made[name](...args.map((arg) => (arg.face === undefined ? arg : entries([arg]))));
    } else {
      forget('editor');
      last.editor = { made: gvd.edit(mesh, entries(points), {}) };
    }
    last.editor.points = points;
  } catch (error) {
    forget('editor');
    throw error;
  }
  return using(last.editor.made.shown(), use);
}

const of_diagram = (diagram) => scenes.of_diagram(diagram);
const balance = (points) => {
  const { diagram, converged } = gvd.balance(mesh, entries(points), {});
  return Object.assign(diagram, { note: converged ? '' : 'Not all areas are equal: masses jump where a bisector passes a corner of the surface.' });
};
// Farthest generators are relaxed before, as by the command; lists stay where they are.
const remesh = (points, listed) => gvd.remesh(mesh, listed ? { generators: entries(points) } : { n: points.length, sampler: true });

// What a remesh has kept of the surface. One without a certificate is an error.
function describe_remesh(made) {
  const { input_to_output, output_to_input } = made.figures(), farthest = Math.max(input_to_output.hausdorff, output_to_input.hausdorff);
  const percent = ((100 * farthest) / mesh.summary().bbox_diagonal).toPrecision(3);
  return `A manifold with the topology of the surface; at most ${percent} % of the diagonal from it.`;
}

// What is made of generators: a scene of it, and a file, of `part` of it where there is one.
const kShows = {
  diagram: {
    name: 'regions',
    make: exact_diagram,
    scene: of_diagram,
    part: (diagram, use) => using(diagram.segment({}), use),
  },
  equal: {
    name: 'equal',
    make: (points, use) => use(kept('equal', points, () => balance(points))),
    scene: (diagram) => ({ ...of_diagram(diagram), note: diagram.note }),
    part: (diagram, use) => using(diagram.cut({}), use),
  },
  distances: {
    name: 'distances',
    make: (points, use) => use(points),
    scene: (points) => kept('distances', points, () => scenes.of_distances(entries(points))),
    part: (points, use) => use({ write: (format) => scenes.write_distances(entries(points), format) }),
  },
  remesh: {
    name: 'coarse',
    make: (points, use, listed) => use(kept('remesh', { points, listed }, () => remesh(points, listed))),
    scene: (made) => ({ ...gvd.remesh_scene(scenes, made), note: describe_remesh(made) }),
  },
};

const handlers = {
  async start({ module }) {
    gvd = await make_module({ wasmBinary: module, Error: GvdError });
  },

  // Reads a mesh and shows its first state. What was there stays until both are done.
  open({ name, bytes, state }) {
    forget(...Object.keys(last));
    const before = [mesh, scenes], made = [];
    try {
      made.push((mesh = gvd.mesh_from_bytes(new Uint8Array(bytes), name, 'repair', null)));
      made.push((scenes = new gvd.Scenes(mesh)));
      const opened = { name, faces: mesh.summary().faces, notes: mesh.notes() };
      const scene = handlers.show(state);
      for (const old of before) old?.delete();
      return { opened, scene };
    } catch (error) {
      forget(...Object.keys(last));
      for (const one of made) one.delete();
      [mesh, scenes] = before;
      throw error;
    }
  },

  show(asked) {
    const points = generators_of(asked), { make, scene } = kShows[asked.show];
    return { points, ...make(points, scene, Boolean(asked.generators)) };
  },

  // Each iteration is shown, by the diagram of its generators.
  relax(asked, report) {
    const on_iteration = (count, energy, points) => report(using(gvd.voronoi(mesh, entries(to_points(points)), { method: 'gbgvd' }), of_diagram));
    return using(gvd.lloyd(mesh, { generators: entries(generators_of(asked)), on_iteration }), (relaxed) =>
      using(relaxed.diagram(), (diagram) => ({ points: to_points(diagram.generators()) })));
  },

  path({ from, to }) {
    const [path] = mesh.paths(entries([from]), entries([to]), {});
    if (path.end < 0) throw new GvdError('no path leads there');
    return { points: scenes.to_page(path.positions), length: path.length };
  },

  file({ show, format, ...asked }) {
    const points = generators_of(asked), write = (made) => ({ bytes: made.write(format, {}) });
    if (format === 'csv') return { name: 'generators', ...exact_diagram(points, write) };
    const { name, make, part = (made, use) => use(made) } = kShows[show];
    return { name, ...make(points, (made) => part(made, write), Boolean(asked.generators)) };
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
