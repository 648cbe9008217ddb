// The worker of the playground: one mesh, and what the page asks about it. Messages {id, kind, args} are answered by {id,
// result}, {id, error}, or first {id, progress}.
import { find_change } from './edits.js';
import { give } from './load.js';

const kIsolines = 12;  // levels up to the largest distance

let gvd, mesh, page;  // `page`: the last manifest, whose frame is that of all scenes, and the colours of the last regions
const last = {};  // what was made last: the farthest generators, the editor of the exact diagram, and the result of each kind

// Points of the page as the package takes them.
const join = (points) => ({ face: points.map(({ face }) => face), bary: points.flatMap(({ bary }) => bary) });
const to_points = ({ face, bary }) => Array.from(face, (f, i) => ({ face: f, bary: [...bary.subarray(3 * i, 3 * i + 3)] }));

// What `make` returns lives in the module's memory: it is freed after `use`.
function using(made, use) {
  try {
    return use(made);
  } finally {
    made.free();
  }
}

// Regions keep their colours as far as their neighbours allow.
function scene_of(made, options) {
  const { colors, ...scene } = made.scene({ ...options, colors: page.colors });
  if (colors.length) page.colors = colors;
  page.manifest = scene.manifest;
  return scene;
}

function forget(...kinds) {
  for (const kind of kinds) {
    const { made } = last[kind] ?? {};
    (made?.diagram ?? made)?.free?.();  // of an editor its diagram
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
const generators_of = ({ count, generators }) => generators ?? kept('farthest', count, () => to_points(mesh.farthest(count)));

// The exact diagram of points, by changing the last one where a single generator differs.
function exact_diagram(points, use) {
  const change = last.editor && find_change(last.editor.points, points);
  try {
    if (change) {
      const [name, ...args] = change, { made } = last.editor, before = made.diagram;
      if (name) made[name](...args.map((arg) => (arg.face === undefined ? arg : join([arg]))));
      if (before !== made.diagram) before.free();
    } else {
      forget('editor');
      last.editor = { made: new gvd.DiagramEditor(mesh, join(points)) };
    }
    last.editor.points = points;
  } catch (error) {
    forget('editor');
    throw error;
  }
  return use(last.editor.made.diagram);
}

const measure = (points) => kept('measured', points, () => mesh.measure(join(points)));
// As the page shows them, for formats that hold no distances.
const with_isolines = ({ figures: { largest } }) => mesh.measure(join(JSON.parse(last.measured.key)), { isolines: largest / (kIsolines + 1) });
const balance = (points) => {
  const { diagram, converged } = mesh.balance(join(points));
  return Object.assign(diagram, { note: converged ? '' : 'Not all areas are equal: masses jump where a bisector passes a corner of the surface.' });
};
// Farthest generators are relaxed before, as by the command; lists stay where they are.
const remesh = (points, listed) => (listed ? mesh.remesh(null, { generators: join(points) }) : mesh.remesh(points.length));

// What a remesh has kept of the surface. One without a certificate is an error.
function describe_remesh(made) {
  const { input_to_output, output_to_input } = made.figures.distance, farthest = Math.max(input_to_output.hausdorff_bound, output_to_input.hausdorff_bound);
  const percent = ((100 * farthest) / mesh.summary.bbox_diagonal).toPrecision(3);
  return `A manifold with the topology of the surface; at most ${percent} % of the diagonal from it.`;
}

// What is made of generators: a scene of it, and a file, of `part` of it where there is one.
const kShows = {
  diagram: {
    name: 'regions',
    make: exact_diagram,
    scene: (diagram) => scene_of(diagram),
    part: (diagram, use) => using(diagram.segment(), use),
  },
  equal: {
    name: 'equal',
    make: (points, use) => use(kept('equal', points, () => balance(points))),
    scene: (diagram) => ({ ...scene_of(diagram), note: diagram.note }),
    part: (diagram, use) => using(diagram.cut(), use),
  },
  distances: {
    name: 'distances',
    make: (points, use) => use(measure(points)),
    scene: (measured) => kept('distances', last.measured.key, () => scene_of(measured, { isolines: kIsolines })),
    part: (measured, use, format) => (format === 'obj' ? using(with_isolines(measured), use) : use(measured)),
  },
  remesh: {
    name: 'coarse',
    make: (points, use, listed) => use(kept('remesh', { points, listed }, () => remesh(points, listed))),
    scene: (made) => ({ ...scene_of(made), note: describe_remesh(made) }),
  },
};

const handlers = {
  async start({ module }) {
    give(module);
    gvd = await import('gvd');
  },

  // Reads a mesh and shows its first state. What was there stays until both are done.
  open({ name, bytes, state }) {
    forget(...Object.keys(last));
    const before = [mesh, page];
    try {
      [mesh, page] = [gvd.read(new Uint8Array(bytes), name), {}];
      const opened = { name, faces: mesh.summary.faces, notes: mesh.notes };
      const scene = handlers.show(state);
      before[0]?.free();
      return { opened, scene };
    } catch (error) {
      forget(...Object.keys(last));
      if (mesh !== before[0]) mesh.free();
      [mesh, page] = before;
      throw error;
    }
  },

  show(asked) {
    const points = generators_of(asked), { make, scene } = kShows[asked.show];
    return { points, ...make(points, scene, Boolean(asked.generators)) };
  },

  // Each iteration is shown, by the diagram of its generators.
  relax(asked, report) {
    const on_iteration = (count, energy, points) => report(using(mesh.voronoi(points, { method: 'gbgvd' }), (diagram) => scene_of(diagram)));
    return using(mesh.lloyd(null, { generators: join(generators_of(asked)), on_iteration }), ({ generators }) => ({ points: to_points(generators) }));
  },

  path({ from, to }) {
    const { end, positions, length } = mesh.path(join([from]), join([to]));
    if (end < 0) throw new gvd.Error('no path leads there', 'no_valid_result');
    const { origin, scale } = JSON.parse(page.manifest);
    return { points: Float32Array.from(positions, (x, i) => (x - origin[i % 3]) / scale), length };
  },

  file({ show, format, ...asked }) {
    const points = generators_of(asked), write = (made) => ({ bytes: made.to_bytes(format) });
    if (format === 'csv') return { name: 'generators', ...exact_diagram(points, write) };
    const { name, make, part = (made, use) => use(made) } = kShows[show];
    return { name, ...make(points, (made) => part(made, write, format), Boolean(asked.generators)) };
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
