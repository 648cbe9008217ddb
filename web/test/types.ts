// Uses the package as a program in TypeScript does; `tsc` reads it with the types of the package. It is not run.
import {
  Curves, Cut, Diagram, DiagramEditor, Error as GvdError, Mesh, Points, Remesh, Segmentation, read, read_properties, read_values, unpack, version,
} from 'gvd';

async function use(bytes: Uint8Array): Promise<void> {
  const mesh: Mesh = read(await unpack(bytes), 'bunny.obj.gz', { weld: true, on_defect: 'largest', input_format: 'obj' });
  const square = new Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], new Int32Array([0, 1, 2]), { corners: 3 });
  const spread: Points = mesh.sample(30, { sampling: 'poisson', seed: 7n, time_limit: 5, progress: (step, done) => done < 0.5 || step === '' });
  const lengths: Float64Array = mesh.distances(spread, { to: [0, 1], each: true, max_distance: null });
  for (const row of mesh.distance_rows([0, 17])) lengths.set(row);
  const { distances, labels } = mesh.nearest(mesh.curves('creases', { angle: 30 }));
  const measured = mesh.measure(0, { to: [1, 2], paths: true, isolines: 0.1 });
  const length: number = measured.paths[0].length + mesh.path(0, 100).length + mesh.isolines(0, [0.1, 0.2])[0].level + mesh.isolines(0, 0.5).length;
  const file: Uint8Array = measured.to_bytes('csv');
  const curves: Curves = mesh.curves([[0, 1], [[0, 0, 0]]], { closed: true, max_snap: 0.1 });
  const diagram: Diagram = mesh.voronoi(curves, { method: 'exact', chord_tolerance: 1e-3 });
  const ends: [number, number] = diagram.bisectors[0].ends;
  const regions: Segmentation = mesh.segment(null, { within: labels, per_region: 2, mask: [true, false], balance: 'area', disc: true, labels: 'nearest' });
  const cut: Cut = mesh.segment(30, { uv: 'flat' });
  const shares: number[] = cut.charts.map(({ flipped_share }) => flipped_share);
  const relaxed = mesh.lloyd(20, { on_iteration: (count, energy, { face }) => console.log(count + energy, face.length), coarse: 'off', density: 'curvature' });
  const coarse: Remesh = mesh.remesh(null, { error: '1%', relax: 'none', features: 'auto', exact_count: true });
  const picture: string = coarse.scene({ colors: diagram.scene().colors }).manifest;
  const editor: DiagramEditor = new DiagramEditor(mesh, 0).move(0, { face: [1], bary: [1, 0, 0] }).add(3).remove(1);
  const sizes: number[] = [square.area, ends[0], distances[0], ...regions.areas, ...shares, length, relaxed.residual, file.length, picture.length];
  const { ok, flipped_faces } = coarse.certificate;
  const more: Float64Array[] = [read_values(bytes, 'x.txt'), read_properties(bytes, 'x.ply').vertex.quality, balanced(mesh, spread)];
  console.log(sizes, ok, flipped_faces, more, version, editor.diagram.to_bytes('obj', { no_curves: true }), new GvdError('').code);
  // @ts-expect-error: an option of another name
  mesh.segment(30, { labls: 'nearest' });
  // @ts-expect-error: a value that is none of the choices
  mesh.segment(30, { labels: 'nearby' });
  // @ts-expect-error: a name of 0.2
  mesh.remesh(null, { n: 30 });
  // @ts-expect-error: files are written as bytes
  mesh.to_file('x.ply');
}

function balanced(mesh: Mesh, points: Points): Float64Array {
  return mesh.balance(points, { density: mesh.vertices, weights: [0, 1], shares: [1, 2] }).masses;
}

use(new Uint8Array());
