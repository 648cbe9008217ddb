// What the test of the web module compares, from the package in Node.js and in a browser.

/** A polyline and a point, as a file gives them. */
export const curves = '0\n40\n90\n\n100\n';

/** Labels, topology and lengths of a mesh's segmentation, its remesh and a path, as plain lists. */
export function results(gvd, bytes, name) {
  const mesh = gvd.read(bytes, name);
  const regions = mesh.segment(30);
  const { diagram } = regions;
  const length = ({ positions, closed }) => {
    let sum = 0;
    for (let i = closed ? 0 : 3; i < positions.length; i += 3) {
      const before = i ? i - 3 : positions.length - 3;
      sum += Math.hypot(...[0, 1, 2].map((k) => positions[i + k] - positions[before + k]));
    }
    return sum;
  };
  const remesh = mesh.remesh(100, { relax: 0 });
  const within = Int32Array.from({ length: mesh.faces.length / 3 }, (_, f) => (mesh.vertices[3 * mesh.faces[3 * f]] > 0 ? 7 : 4));
  const mask = Array.from(within, (_, f) => f < 100);
  const [inside, nested] = [mesh.segment(40, { within, mask }), mesh.segment(null, { levels: [5, 20] })];
  const discs = mesh.segment(3, { disc: true });
  const each = mesh.segment(null, { within, per_region: 3, labels: 'nearest' });
  const line = mesh.curves(new TextEncoder().encode(curves), { name: 'curves.txt' });
  const bands = mesh.voronoi(line);
  const islands = mesh.segment(30, { disc: true }).diagram;
  const charts = (uv) => {
    const made = islands.cut({ uv });
    return { list: made.charts, scale: made.scale, texture: [...made.mesh.texture_coordinates] };
  };
  const logs = mesh.log_map(17);
  return {
    vertices: mesh.vertices.length / 3,
    faces: [...mesh.faces],
    input_vertex: [...mesh.input_vertex],
    labels: [...regions.labels],
    generators: [...diagram.generators.face],
    bisectors: diagram.bisectors.map(({ left, right, closed, ends }) => [left, right, closed, ...ends]),
    bisector_lengths: diagram.bisectors.map(length),
    branch_distances: [...diagram.branch_points.distances],
    areas: diagram.cells.map((cell) => cell.area),
    neighbours: diagram.cells.map((cell) => [...cell.neighbours]),
    distances: [...mesh.distances(0)],
    path: mesh.path(0, mesh.vertices.length / 3 - 1).length,
    violations: [diagram, discs.diagram, inside.diagram, nested.diagram, bands].flatMap((each) => each.check()),
    within: [...within],
    mask: mask.map(Number),
    inside: { labels: [...inside.labels], regions: [...inside.regions], border: inside.border_length },
    each: [...each.labels],
    discs: { labels: [...discs.labels], euler: discs.diagram.cells.map((cell) => cell.euler_characteristic) },
    nested: nested.levels.map((labels) => [...labels]),
    curves: line.positions.map((parts) => parts.map((part) => [...part])),
    bands: { labels: [...bands.segment().labels], lengths: bands.bisectors.map(length), distances: [...mesh.distances(line)] },
    charts: { flat: charts('flat'), logmap: charts('logmap') },
    logs: [...logs],
    log_lengths: Array.from({ length: logs.length / 2 }, (_, v) => Math.hypot(logs[2 * v], logs[2 * v + 1])),
    rows: [...mesh.distance_rows([0, 17])].map((row) => [...row]),
    remesh: [...remesh.mesh.faces],
    certified: remesh.certificate.ok && mesh.remesh(100).certificate.ok,
    files: Object.fromEntries(['ply', 'obj', 'glb', 'json', 'off', 'stl'].map((f) => [f, regions.to_bytes(f).length])),
  };
}
