// What the test of the web module compares, from the package in Node.js and in a browser.

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
  return {
    vertices: mesh.vertices.length / 3,
    faces: [...mesh.faces],
    labels: [...regions.labels],
    generators: [...diagram.generators.face],
    bisectors: diagram.bisectors.map(({ left, right, closed, ends }) => [left, right, closed, ...ends]),
    bisector_lengths: diagram.bisectors.map(length),
    branch_distances: [...diagram.branch_points.distances],
    areas: diagram.cells.map((cell) => cell.area),
    neighbours: diagram.cells.map((cell) => [...cell.neighbours]),
    distances: [...mesh.distances(0)],
    path: mesh.path(0, mesh.vertices.length / 3 - 1).length,
    violations: diagram.check(),
    remesh: [...remesh.mesh.faces],
    certified: remesh.certificate.ok && mesh.remesh(100).certificate.ok,
    files: Object.fromEntries(['ply', 'obj', 'glb', 'json', 'off', 'stl'].map((f) => [f, regions.to_bytes(f).length])),
  };
}
