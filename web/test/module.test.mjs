// The npm package against the commands, in Node.js and in a browser: node module.test.mjs PACKAGE BIN DATA.
//
// The same inputs must give the same labels and the same topology as the native build, and lengths to 1e-12. A browser
// must give the very numbers that Node.js gives. Without a browser, that part is skipped with a message.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join, resolve } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { curves, results } from './module_results.mjs';

const [packed, bin, data] = process.argv.slice(2).map((path) => resolve(path));
const gvd = await import(pathToFileURL(join(packed, 'index.mjs')).href);
const { Mesh } = gvd;
const kTolerance = 1e-12;
const kMeshes = ['figure.obj', 'torus.ply', 'half_sphere.off', 'plate.stl'];
const found = Object.fromEntries(kMeshes.map((name) => [name, results(gvd, readFileSync(join(data, name)), name)]));

function assertClose(actual, expected, what, tolerance = kTolerance) {
  assert.equal(actual.length, expected.length, what);
  const scale = Math.max(...expected.map(Math.abs));
  actual.forEach((value, i) =>
    assert.ok(Math.abs(value - expected[i]) <= tolerance * scale, `${what} ${i}: ${value} is not ${expected[i]}`));
}

const folder = mkdtempSync(join(tmpdir(), 'gvd-'));

/** What a command writes to a file with this name, after `option`. */
function runNative(command, name, file, option, ...options) {
  const path = join(folder, file);
  execFileSync(join(bin, command), [join(data, name), ...options, '-q', option, path]);
  return readFileSync(path, 'utf8');
}
const readNative = (command, name, ...options) => JSON.parse(runNative(command, name, 'native.json', '-o', ...options));

function writeText(file, text) {
  writeFileSync(join(folder, file), text);
  return join(folder, file);
}

const bisectorLength = ({ points, closed }) =>
  points.reduce((sum, { position }, i) => {
    const before = points.at(i - 1).position;
    return i > 0 || closed ? sum + Math.hypot(...position.map((x, k) => x - before[k])) : sum;
  }, 0);

for (const name of kMeshes) {
  test(`${name} as the commands have it`, () => {
    const native = readNative('gvd-segment', name, '-n', '30');
    const web = found[name];
    assert.deepEqual(web.labels, native.face_labels);
    assert.deepEqual(web.generators, native.generators.map(({ face }) => face));
    const ends = native.bisectors.map(({ left, right, closed, ends: [a, b] }) => [left, right, closed, a ?? -1, b ?? -1]);
    assert.deepEqual(web.bisectors, ends);
    assert.deepEqual(web.neighbours, native.cells.map(({ neighbours }) => neighbours));
    assertClose(web.bisector_lengths, native.bisectors.map(bisectorLength), 'bisector');
    assertClose(web.branch_distances, native.branch_points.map(({ distance }) => distance), 'branch point');
    assertClose(web.areas, native.cells.map(({ area }) => area), 'cell');
    assert.deepEqual(web.violations, []);
  });
  test(`${name} segmented inside regions as the command does`, () => {
    const web = found[name];
    const within = ['--within', writeText('within.txt', web.within.join('\n'))];
    const mask = ['--mask', writeText('mask.txt', web.mask.join('\n'))];
    const inside = readNative('gvd-segment', name, '-n', '40', ...within, ...mask);
    assert.deepEqual(web.inside.labels, inside.face_labels);
    assert.deepEqual(web.inside.regions, inside.face_numbers.region);
    assert.ok(web.inside.labels.includes(-1) && web.inside.border > 0);
    assert.deepEqual(web.each, readNative('gvd-segment', name, '--per-region', '3', '--labels', 'nearest', ...within).face_labels);
    assert.deepEqual(web.discs.labels, readNative('gvd-segment', name, '-n', '3', '--disc').face_labels);
    assert.ok(web.discs.euler.every((number) => number === 1));
    const { face_numbers } = readNative('gvd-segment', name, '--levels', '5,20');
    assert.deepEqual(web.nested, [face_numbers.label_1, face_numbers.label_2]);
  });
  test(`${name} segmented around curves as the command does`, () => {
    const web = found[name];
    const file = writeText('curves.txt', curves);
    const native = readNative('gvd-segment', name, '--curves', file);
    assert.deepEqual(web.bands.labels, native.face_labels);
    assertClose(web.bands.lengths, native.bisectors.map(bisectorLength), 'bisector');
    const table = runNative('gvd-distance', name, 'distances.csv', '-o', '--curves', file).trim().split('\n').slice(1);
    assertClose(web.bands.distances, web.input_vertex.map((v) => Number(table[v].split(',')[2])), 'distance');
    assert.equal(web.curves.length, 2);
  });
  test(`${name} with the charts of the command`, () => {
    const { flat, logmap } = found[name].charts;
    const named = ({ label, faces }) => [label, faces];
    const options = ['-n', '30', '--disc', '--cut', '--uv'];
    const native = (uv) => JSON.parse(runNative('gvd-segment', name, 'report.json', '--report', ...options, uv)).results.charts;
    for (const [web, { charts, scale }] of [[flat, native('flat')], [logmap, native('logmap')]]) {
      assert.deepEqual(web.list.map(named), charts.map(named));
      assertClose(web.list.map(({ area }) => area), charts.map(({ area }) => area), 'area');
      // At a corner where two shortest paths of a symmetric mesh are equally long, the last bit chooses its logarithm.
      assertClose([web.scale], [scale], 'scale', web === flat ? kTolerance : 1e-3);
      assertClose(web.list.map(({ stretch }) => stretch), charts.map(({ stretch }) => stretch), 'stretch', web === flat ? kTolerance : 1e-3);
    }
    const obj = runNative('gvd-segment', name, 'charts.obj', '-o', ...options, 'flat').split('\n').map((line) => line.split(' '));
    const vt = obj.filter(([word]) => word === 'vt').map(([, u, v]) => [Number(u), Number(v)]);
    const corners = obj.filter(([word]) => word === 'f').flatMap(([, ...f]) => f.flatMap((c) => vt[Number(c.split('/')[1]) - 1]));
    // OBJ has the faces by region, and charts of the same height may change places.
    const sides = (uv) => uv.map((x, i) => uv[i - (i % 6) + ((i % 6) + 2) % 6] - x).sort((a, b) => a - b);
    assertClose(sides(flat.texture), sides(corners), 'side', 1e-11);  // a linear system gives them
  });
  test(`${name}: logarithms have the distances, and rows are those of each point`, () => {
    const [first, second] = found[name].rows;
    assertClose(found[name].log_lengths, second, 'logarithm');
    assert.deepEqual(first, found[name].distances);
  });
  test(`${name} remeshed as the command does`, () => {
    const native = readNative('gvd-remesh', name, '-n', '100', '--relax', 'none');
    assert.deepEqual(found[name].remesh, native.remesh.faces.flat());
    assert.ok(found[name].certified);
  });
}

test('types have every option of the description', async () => {
  const types = readFileSync(join(packed, 'index.d.ts'), 'utf8'), { describe } = await import(pathToFileURL(join(packed, 'library.mjs')).href);
  const described = describe(), options = [...described.operations.flatMap((one) => one.options), ...described.file_options];
  // These are arguments, or the package gives them itself.
  const kOwn = 'from points file content repairs materials material_files part keep_coincident mesh_vertices move add remove map cut weld'.split(' ');
  const missing = options.map(({ name }) => name).filter((name) => !kOwn.includes(name) && !types.includes(`\n  ${name}?: `));
  assert.deepEqual(missing, []);
  assert.match(types, /\* Put generators on corners and creases first[^\n]*\n {2}features\?: number \| 'auto' \| 'none' \| null;/);
  assert.doesNotMatch(types, /^\/\/=/m);
});

test('the package has the version of the module', () => {
  assert.equal(gvd.version, JSON.parse(readFileSync(join(packed, 'package.json'), 'utf8')).version);
});

test('generators inside faces leave no holes between the pieces', () => {
  const mesh = gvd.read(readFileSync(join(data, 'figure.obj')), 'figure.obj');
  const face = Array.from({ length: 40 }, (_, i) => 140 * i + 60), diagram = mesh.voronoi({ face, bary: face.flatMap(() => [0.25, 0.5, 0.25]) });
  assert.deepEqual(diagram.check(), []);
});

test('arrays go in and out', () => {
  const square = new Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]);
  assert.deepEqual([...square.distances(0)], [0, 1, Math.SQRT2, 1]);
  assertClose([...square.path(1, 3).positions], [1, 0, 0, 0.5, 0.5, 0, 0, 1, 0], 'path');
  assert.deepEqual([...square.nearest([0, 2], { to: [[0.9, 0.9, 0]] }).labels], [1]);
  assert.equal(square.distances([0, 1], { each: true }).length, 8);
  assert.throws(() => square.nearest([0, 1], { each: true }), { code: 'invalid_option', message: /no option "each"/ });
  const lines = square.isolines(0, [0.5]);
  assert.ok(lines[0].positions.length >= 6 && !lines[0].closed);
  const { diagram, masses, converged } = square.balance([0, 2], { shares: [1, 3] });
  assert.ok(converged);
  assert.ok(Math.abs(masses[0] - 0.25) < 1e-9 && Math.abs(masses[1] - 0.75) < 1e-9, String(masses));
  assert.equal(diagram.cut().mesh.summary.area, 1);
  assertClose([...square.log_map(0)].map(Math.abs), [0, 0, 1, 0, Math.SQRT1_2 * Math.SQRT2, 1, 0, 1], 'logarithm');
  const rim = square.curves('boundary');
  assert.deepEqual([rim.length, ...square.distances(rim, { to: [[0.5, 0.25, 0]] })], [1, 0.25]);
  const edge = square.curves([[[0, 0, 0], [1, 0, 0], [1, 1, 0]]], { closed: true });
  assert.deepEqual([...edge.positions[0][0]].length, 12);
  assert.deepEqual([...square.distances(square.curves([[0, 1], [2]]))], [0, 0, 0, 1]);
  const file = square.curves(new TextEncoder().encode('0\n1\n'), { name: 'line.txt' });
  assert.deepEqual([...square.distances(file)], [0, 0, 1, 1]);
  assert.deepEqual([...gvd.read_values(new TextEncoder().encode('3 1\n4'), 'x.txt')], [3, 1, 4]);
  assert.equal(square.texture_coordinates, null);
});

test('an edited diagram is a new one of the same generators', () => {
  const mesh = gvd.read(readFileSync(join(data, 'figure.obj')), 'figure.obj'), editor = new gvd.DiagramEditor(mesh, mesh.farthest(30));
  const face = (f, a = 0.25) => ({ face: [f], bary: [a, 0.75 - a, 0.25] });
  const first = editor.diagram, length = first.length;
  const edits = [(e) => e.move(3, face(100)), (e) => e.move(3, face(101, 0.5)), (e) => e.add(face(2000)), (e) => e.remove(5), (e) => e.move(29, 7), (e) => e.remove(0)];
  for (const edit of edits) {
    edit(editor);
    const fresh = mesh.voronoi(editor.generators);
    for (const name of ['labels', 'distances', 'generators', 'branch_points', 'cells', 'curves', 'pieces', 'length']) {
      assert.deepEqual(editor.diagram[name], fresh[name], `${name} after ${edit}`);
    }
    assert.deepEqual(editor.to_bytes('json'), fresh.to_bytes('json'));
  }
  assert.equal(editor.generators.face.length, 29);
  assert.equal(first.length, length);
  const there = editor.generators, refused = (call, code) => assert.throws(call, (error) => error instanceof gvd.Error && error.code === code);
  refused(() => editor.move(29, face(1)), 'precondition');
  refused(() => editor.move(2 ** 40, face(1)), 'precondition');
  refused(() => editor.move(1.5, face(1)), 'invalid_option');
  refused(() => editor.move(1, [0, 1]), 'invalid_option');
  refused(() => editor.add({ face: [there.face[0]], bary: there.bary.subarray(0, 3) }), 'precondition');
  refused(() => new gvd.DiagramEditor(mesh, [0, 1], { method: 'gbgvd' }), 'invalid_option');
  assert.deepEqual(editor.generators, there);
});

test('an editor makes one change at a time', () => {
  const mesh = gvd.read(readFileSync(join(data, 'figure.obj')), 'figure.obj'), editor = new gvd.DiagramEditor(mesh, mesh.farthest(30));
  let told = null;
  editor.move(1, 5, { progress: () => {
    try {
      told ?? editor.move(2, 9);
    } catch (error) {
      told = error.message;
    }
  } });
  assert.equal(told, 'move: the editor is in the middle of a change');
  editor.move(2, 9);
});

test('objects may be frozen, and options null', () => {
  const square = Object.freeze(new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]));
  assert.equal(square.vertices, square.vertices);
  assert.equal(square.lloyd(2, { generators: null, fixed: null, density: null, iterations: 1 }).areas.length, 2);
  assert.equal(square.distances(0, { to: null }).length, 4);
  const { vertices, faces } = square, line = [[0, 1]], file = new TextEncoder().encode('0\n1\n');
  const calls = [
    (o) => new Mesh(vertices, faces, o), (o) => new Mesh(vertices, faces, o && { corners: null, on_defect: null, weld: null }), (o) => square.points(0, o),
    (o) => square.sample(2, o), (o) => square.distances(0, o), (o) => square.distances(0, o && { each: null }), (o) => [...square.distance_rows(0, o)],
    (o) => square.nearest(0, o), (o) => square.measure(0, o), (o) => square.log_map(0, o), (o) => square.path(0, 2, o), (o) => square.isolines(0, 0.5, o),
    (o) => square.curves('boundary', o), (o) => square.curves(line, o && { closed: null, angle: null }), (o) => square.curves(file, o && { name: null }),
    (o) => square.voronoi([0, 2], o), (o) => square.balance([0, 2], o), (o) => square.balance([0, 2], o && { density: null }), (o) => square.segment(2, o),
    (o) => square.lloyd(2, o), (o) => square.voronoi([0, 2]).cut(o), (o) => square.voronoi([0, 2]).segment(o), (o) => square.voronoi([0, 2]).scene(o),
    (o) => new gvd.DiagramEditor(square, [0, 2], o).move(0, 1, o).add(0, o).remove(0, o), (o) => square.to_bytes('ply', o),
    (o) => square.segment(2, o && { time_limit: null, progress: null }), (o) => gvd.read(square.to_bytes('ply'), 'x.ply', o),
  ];
  for (const call of calls) for (const options of [null, undefined, {}]) assert.doesNotThrow(() => call(options), String(call));
});

test('arrays are the caller\'s own: what is written into them changes no result', () => {
  const square = new Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]);
  for (const name of ['vertices', 'faces', 'input_vertex', 'vertex_of_input']) square[name].fill(0);
  assert.deepEqual([...square.positions(3)], [0, 1, 0]);
  assert.deepEqual(square.bounds, [[0, 0, 0], [1, 1, 0]]);
  assert.equal(square.path(1, 3).positions.length, 9);
});

test('seeds are what was given', () => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]), seed = 2n ** 53n + 1n;
  const made = square.segment(2, { seed, sampling: 'random' }), { options } = made.figures;
  assert.equal(options.seed, '9007199254740993');
  assert.deepEqual(square.segment(2, { seed: options.seed, sampling: 'random' }).figures, made.figures);
  assert.equal(square.segment(2, { seed: 7n }).figures.options.seed, 7);
});

test('a table that no memory holds is an error of memory', () => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]);
  for (const count of [18000, 30000]) {  // 2.6 GB, and more numbers than a list can have
    const points = square.sample(count, { sampling: 'random' });
    assert.throws(() => square.distances(points, { to: points, each: true }), { code: 'out_of_memory' });
  }
  assert.equal(square.distances(0).length, 4);
});

test('vertices of repaired meshes are their own', () => {
  const at = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [9, 9, 9]];
  const mesh = new Mesh(at, [[0, 1, 2], [0, 3, 4]], { on_defect: 'repair' });
  for (let v = 0; v < 6; ++v) {
    assert.deepEqual(mesh.positions(v), mesh.vertices.subarray(3 * v, 3 * v + 3));
    assert.equal(mesh.distances([v])[v], 0);
    assert.deepEqual(mesh.positions(mesh.segment(null, { vertices: [v] }).generators), mesh.vertices.subarray(3 * v, 3 * v + 3));
  }
});

test('relaxation reports its iterations', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  const energies = [];
  const relaxed = mesh.lloyd(20, { on_iteration: (_, energy, points) => energies.push([energy, points.face.length]) });
  assert.ok(energies.length > 1 && energies.every(([, points]) => points === 20));
  assert.ok(relaxed.energies.at(-1) < relaxed.energies[0]);
  assert.deepEqual(mesh.voronoi(relaxed.generators).generators, relaxed.generators);
});

test('a call ends where its time is over, and by what a function of the caller throws', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  assert.throws(() => mesh.remesh(300, { time_limit: 0.001 }), { code: 'interrupted', message: 'the time limit of 0.001 s is over' });
  for (const option of ['progress', 'on_iteration']) {
    const thrown = new RangeError('mine');
    assert.throws(() => mesh.lloyd(20, { [option]: () => { throw thrown; } }), (error) => error === thrown);
  }
  const inner = [];
  mesh.lloyd(20, { iterations: 2, on_iteration: (count, energy, points) => inner.push([count, mesh.voronoi(points).length]) });
  assert.deepEqual([inner[0][0], inner.at(-1)[0]], [0, 2]);
});

test('what commands have, the package has', () => {
  const name = 'torus.ply', mesh = gvd.read(readFileSync(join(data, name)), name), text = new TextDecoder();
  const bytes = (command, file, option, ...options) => {
    runNative(command, name, file, option, ...options);
    return readFileSync(join(folder, file));
  };
  assert.deepEqual([...mesh.segment(9, { balance: 'area' }).labels], JSON.parse(bytes('gvd-segment', 'b.json', '-o', '-n', '9', '--balance', 'area')).face_labels);
  const cut = mesh.segment(9, { cut: true });
  assert.ok(cut instanceof gvd.Cut && cut.labels.length > mesh.faces.length / 3 && cut.mesh.faces.length === 3 * cut.labels.length);
  const measured = mesh.measure([0, 3], { to: [100, 200], paths: true });
  assert.equal(text.decode(measured.to_bytes('csv')), String(bytes('gvd-distance', 'p.csv', '-o', '--from', '0,3', '--to', '100,200', '--paths')));
  assert.deepEqual(measured.paths.map(({ end }) => end).length, 2);
  const [path] = mesh.path([500], mesh.curves([[0, 1]]));
  assert.ok(path.length > 0 && path.positions.length === 3 * path.points.face.length);
  const steps = mesh.isolines(0, 0.5), levels = mesh.isolines(0, [...new Set(steps.map(({ level }) => level))]);
  assert.ok(steps.length > 2);
  assert.deepEqual(levels, steps);
  const regions = mesh.segment(9);
  assert.deepEqual(mesh.remesh(null, { error: '5%' }).figures.search.trials.length > 0, true);
  assert.equal(Math.abs(regions.areas.reduce((a, b) => a + b) - mesh.area) < 1e-9, true);
  assert.deepEqual(regions.figures.options.count, 9);
  assert.equal(mesh.lloyd(9, { balance: 'area', iterations: 5 }).figures.balance.converged, true);
  const { vertex, face } = gvd.read_properties(regions.to_bytes('ply'), 'x.ply');
  assert.deepEqual([Object.keys(vertex).length > 0, [...face.label]], [true, [...regions.labels]]);
  assert.deepEqual(mesh.bounds.map((corner) => corner.length), [3, 3]);
  const { manifest, blobs, colors } = regions.diagram.scene();
  assert.deepEqual([JSON.parse(manifest).schema, colors.length], ['gvd-view/1', 27]);
  assert.ok(blobs.every((blob) => blob.byteOffset === 0 && blob.length > 0));
});

test('a position that is far from the surface is told on the console', (context) => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply'), told = context.mock.method(console, 'warn', () => {});
  mesh.distances([[3, 17, 99]]);
  assert.match(told.mock.calls[0].arguments[0], /^gvd: .*from the surface/);
  mesh.distances([3, 17, 99]);
  assert.equal(told.mock.callCount(), 1);
});

test('objects that nobody has any more release themselves', () => {
  const program = `
    import { readFileSync } from 'node:fs';
    import { read } from ${JSON.stringify(pathToFileURL(join(packed, 'index.mjs')).href)};
    const mesh = read(readFileSync(process.argv[1]), 'torus.ply'), points = mesh.farthest(10);
    const make = async () => {
      for (let i = 0; i < 300; ++i) {
        mesh.voronoi(points, { method: 'gbgvd' });
        if (i % 20) continue;
        gc();
        await new Promise((done) => setTimeout(done));
      }
      return process.memoryUsage().rss;
    };
    const before = await make(), after = await make();
    console.log(after - before);`;
  const grown = execFileSync(process.execPath, ['--expose-gc', '--input-type=module', '--eval', program, join(data, 'torus.ply')], { encoding: 'utf8' });
  assert.ok(Number(grown) < 2 ** 24, `${grown} bytes more; 300 diagrams have 50 MB`);
});

test('calls leave nothing in the memory', () => {
  const mesh = gvd.read(readFileSync(join(data, 'plate.stl')), 'plate.stl');
  const make = () => {
    for (let i = 0; i < 50; ++i) {
      mesh.distances(i);
      mesh.path(i, i + 1);
      mesh.voronoi([i, i + 100]).free();
    }
  };
  const memory = () => process.memoryUsage().external + process.memoryUsage().arrayBuffers;
  make();
  const before = memory();
  for (let i = 0; i < 4; ++i) make();
  assert.ok(memory() < before + 2 ** 24, `${memory()} is much more than ${before}`);
});

test('what gzip packed is unpacked', async () => {
  const bytes = readFileSync(join(data, 'torus.ply'));
  const mesh = gvd.read(await gvd.unpack(gzipSync(bytes)), 'torus.ply.gz');
  assert.deepEqual(mesh.vertices, gvd.read(await gvd.unpack(bytes), 'torus.ply').vertices);
  const buffer = new Uint8Array(gzipSync('v 0 0 0')).buffer;
  assert.equal(new TextDecoder().decode(await gvd.unpack(buffer)), 'v 0 0 0');
});

test('results have the other files of the commands', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  const map = mesh.remesh(60, { relax: 0 }).map();
  assert.deepEqual(JSON.parse(new TextDecoder().decode(map.to_bytes('json'))).one_to_one, map.one_to_one);
  assert.equal(map.origins.face.length, 60);
  const points = new TextDecoder().decode(mesh.lloyd(20, { iterations: 1 }).points_to_bytes('xyz'));
  assert.equal(points.trim().split('\n').length, 20);
  assert.throws(() => mesh.lloyd(20, { iterations: 1 }).points_to_bytes('obj'), /extension must be one of \.npy, \.ply or \.xyz/);
});

test('a file that was written reads back', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  for (const format of ['ply', 'obj', 'off']) {
    assert.deepEqual(gvd.read(mesh.to_bytes(format), `x.${format}`).vertices, mesh.vertices, format);
  }
  assert.equal(gvd.read(mesh.to_bytes('glb'), 'x.glb').summary.faces, mesh.summary.faces);
});

test('a .gltf with its numbers inside is read, and a surface of MNI', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  const glb = mesh.to_bytes('glb');
  const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
  const read = (uri) => {
    gltf.buffers[0].uri = uri;
    return gvd.read(new TextEncoder().encode(JSON.stringify(gltf)), 'x.gltf');
  };
  const numbers = Buffer.from(glb.subarray(28 + length)).toString('base64');
  assert.equal(read(`data:application/octet-stream;base64,${numbers}`).summary.faces, mesh.summary.faces);
  assert.throws(() => read('x.bin'), /buffer 0, 'x\.bin', is not in the file/);
  const mni = 'P 0.3 0.3 0.4 10 1 3\n0 0 0\n1 0 0\n0 1 0\n\n0 0 1\n0 0 1\n0 0 1\n\n1\n0 1 1 1 1\n\n3\n\n0 1 2\n';
  assert.equal(gvd.read(new TextEncoder().encode(mni), 'x.obj').summary.faces, 1);
});

test('copies of vertices are joined where that is asked for', () => {
  const positions = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0.25], [1, 1, 0.25], [0, 1, 0.25]];
  const read = (options) => gvd.read(
    new TextEncoder().encode(`${positions.map((p) => `v ${p.join(' ')}`).join('\n')}\nf 1 2 3\nf 4 5 6\n`), 'x.obj', options).summary.vertices;
  assert.deepEqual([read(), read({ weld: false }), read({ weld: null }), read({ weld: true }), read({ weld: 0.25 })], [6, 6, 6, 6, 4]);
  positions.forEach((p) => { p[2] = 0; });
  assert.deepEqual([read(), read({ weld: true }), read({ weld: 0 })], [6, 4, 4]);
  assert.throws(() => read({ weld: -1 }), { code: 'invalid_option', message: /^weld: .*-1/ });
  assert.throws(() => read({ weld: 'all' }), { code: 'invalid_option', message: 'weld: true, false or a number is needed, not all' });
});

test('options that a call sets itself are none of its options', () => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]), diagram = square.voronoi([0, 2]), editor = new gvd.DiagramEditor(square, [0, 2]);
  const refused = (call, words) => assert.throws(call, (error) => error instanceof gvd.Error && error.code === 'invalid_option' && words.test(error.message), words);
  const calls = {
    sample: [(o) => square.sample(2, o), 'points generators vertices'], points: [(o) => square.points(0, o), 'points count'],
    distances: [(o) => square.distances(0, o), 'from curves paths logarithm mesh_vertices keep_coincident'],
    distance_rows: [(o) => [...square.distance_rows(0, o)], 'from each'], nearest: [(o) => square.nearest(0, o), 'from each'],
    path: [(o) => square.path(0, 2, o), 'from to paths each'], isolines: [(o) => square.isolines(0, 0.5, o), 'from to levels isolines'],
    log_map: [(o) => square.log_map(0, o), 'to logarithm'], measure: [(o) => square.measure(0, o), 'from curves'],
    voronoi: [(o) => square.voronoi([0, 2], o), 'generators vertices curves count'], balance: [(o) => square.balance([0, 2], o), 'generators balance'],
    segment: [(o) => diagram.segment(o), 'cut uv'], cut: [(o) => diagram.cut(o), 'cut labels'], remesh: [(o) => square.remesh(2, o), 'map'],
    curves: [(o) => square.curves('boundary', o), 'curves'], DiagramEditor: [(o) => new gvd.DiagramEditor(square, [0, 2], o), 'editable generators within'],
    move: [(o) => editor.move(0, 1, o), 'move to add'], add: [(o) => editor.add(1, o), 'add remove'], remove: [(o) => editor.remove(0, o), 'remove to'],
    to_bytes: [(o) => square.to_bytes('ply', o), 'part'], read: [(o) => gvd.read(square.to_bytes('ply'), 'x.ply', o), 'file content'],
  };
  for (const [name, [call, options]] of Object.entries(calls)) {
    for (const option of options.split(' ')) refused(() => call({ [option]: 1 }), new RegExp(`^${name}: there is no option "${option}"`));
    for (const wrong of [40, true, 'x', [1]]) refused(() => call(wrong), new RegExp(`^${name}: the options are an object`));
  }
  for (const call of [() => square.segment(1, 2), () => square.lloyd(1, 2), () => square.remesh(3, 2), () => new Mesh(square.vertices, square.faces, 3), () => diagram.scene(7)]) {
    refused(call, /: the options are an object, such as \{ name: value \}, not \d$/);
  }
  refused(() => square.segment(2, { on_iteration: () => {} }), /^segment: there is no option "on_iteration"; lloyd has it$/);
});

test('errors and warnings use the words of the call', async (context) => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]), told = context.mock.method(console, 'warn', () => {});
  const far = [[9, 9, 9]], calls = { end: () => square.path(0, far), start: () => square.path(far, 0), to: () => square.distances(0, { to: far }),
                                     points: () => square.voronoi(far), point: () => square.log_map(far) };
  for (const [name, call] of Object.entries(calls)) {
    call();
    assert.match(told.mock.calls.at(-1).arguments[0], new RegExp(`^gvd: ${name}: point 0 is .* from the surface`));
  }
  const refused = (call, code, words) => assert.throws(call, (error) => error instanceof gvd.Error && error.code === code && words.test(error.message), words);
  refused(() => square.sample(), 'invalid_option', /^sample: how many points\? Give a count or a radius$/);
  refused(() => square.to_bytes('html'), 'invalid_option', /^to_bytes: this package makes no pages; write \.html with the commands or Python$/);
  refused(() => new gvd.DiagramEditor(square, [0]).remove(0), 'precondition', /^generator 0 is the only one, and a diagram needs one; move it, or add another first$/);
  refused(() => square.voronoi([0, 2]).to_bytes('off', { no_curves: true }), 'invalid_option', /^no_curves: only \.obj, .* hold curves; write one or leave no_curves out$/);
  refused(() => square.voronoi([0, 2]).cut({ uv: 'logmap' }).to_bytes('off'), 'invalid_option', /^uv: only .* hold texture coordinates/);
  const bytes = gzipSync('v 0 0 0');
  await assert.rejects(gvd.unpack(bytes.subarray(0, bytes.length - 9)), (error) => error instanceof gvd.Error && error.code === 'unreadable_input' && /end too early$/.test(error.message));
});

test('one position is one start, in whatever array it is', () => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]);
  const is_list = (start) => Array.isArray(square.path(start, 1));
  assert.deepEqual([Float64Array.of(0, 0, 0), Float32Array.of(0, 0, 0), 0].map(is_list), [false, false, false]);
  assert.deepEqual([Float64Array.of(0, 0, 0, 1, 1, 0), [[0, 0, 0]], [0]].map(is_list), [true, true, true]);
});

test('what needs a mesh that was freed says so', () => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]), diagram = square.voronoi([0, 2]);
  square.free();
  assert.equal(diagram.segment().labels.length, 2);
  assert.throws(() => diagram.bisectors, { code: 'invalid_option', message: 'the mesh was freed, from which positions come; free it after its results' });
});

test('what can not be done is an error of one line', () => {
  const stl = new Uint8Array(134);  // of one triangle; with this count the length has 33 bits, and 88 in the lower 32
  new DataView(stl.buffer).setUint32(80, 85899346, true);
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]);
  const freed = new Mesh(square.vertices, [new Int32Array([0, 1, 2]), [0, 2, 3]]);
  for (let i = 0; i < 2; ++i) freed.free();
  const kRefused = [
    [() => gvd.read(new TextEncoder().encode('v 0 0 x\nf 1 2 3'), 'bad.obj'), 'unreadable_input', /^bad\.obj:1: coordinate z is 'x'/],
    [() => gvd.read(stl, 'a.stl'), 'unreadable_input', /85899346 triangles it should have 4294967384 bytes, not 134/],
    [() => gvd.read(new Uint8Array([31, 139, 8, 0]), 'a.obj.gz'), 'unreadable_input', /unpack it first/],
    [() => new Mesh([0, 0, 0], [0, 1, 2]), 'precondition', /./],
    [() => square.voronoi([0, 0]), 'precondition', /coincide/],
    [() => square.voronoi([4]), 'precondition', /4/],
    [() => square.voronoi([-1]), 'invalid_option', /^points: element 0 is -1; give whole numbers from 0 on$/],
    [() => new gvd.Mesh(square.vertices, square.faces, { file: 'x' }), 'invalid_option', /^Mesh: there is no option "file"/],
    [() => square.voronoi([0, 1], { methd: 'exact' }), 'invalid_option', /^voronoi: there is no option "methd"; did you mean "method"\?/],
    [() => square.voronoi([0, 1], { method: 'quick' }), 'invalid_option', /^method: 'quick' is not one of exact\|gbgvd\|paper/],
    [() => square.sample(1.5), 'invalid_option', /^count: .*whole number/],
    [() => square.to_bytes('xyz'), 'invalid_option', /^'xyz': the extension must be one of /],
    [() => square.segment(2, { within: [1] }), 'invalid_option', /^within: 1 number; give one for each vertex \(4\) or face \(2\)$/],
    [() => square.segment(2, { within: [1, 1.5] }), 'precondition', /^within: /],
    [() => square.segment(null, { per_region: 1 }), 'invalid_option', /per_region needs within/],
    [() => square.segment(null, { levels: [2, 2] }), 'invalid_option', /ascending/],
    [() => square.segment(2, { levels: [1, 2] }), 'invalid_option', /exclude each other/],
    [() => square.curves('creases'), 'precondition', /no two faces/],
    [() => square.curves('creases', { angle: 200 }), 'invalid_option', /below 180/],
    [() => square.curves('creases', { angle: 0 }), 'invalid_option', /^angle: a number above 0 and below 180/],
    [() => square.curves('creases:30'), 'precondition', /no two faces meet at more than 30 degrees/],
    [() => square.curves('rim'), 'invalid_option', /'boundary' or 'creases'/],
    [() => square.curves([[0, 9]]), 'precondition', /9/],
    [() => square.log_map([0, 1]), 'invalid_option', /one point/],
    [() => square.voronoi([0, 2]).cut({ uv: 'planar' }), 'invalid_option', /logmap.*flat/],
    [() => square.sample(3, { progress: () => false }), 'interrupted', /./],
    [() => square.sample(3, { progress: 5 }), 'invalid_option', /progress: a function/],
    [() => square.sample(3, { count: 2 }), 'invalid_option', /count is given twice/],
    [() => square.isolines(0, 'all'), 'invalid_option', /levels: an array of numbers/],
    [() => square.voronoi([0, 1], { weights: 3 }), 'invalid_option', /weights: an array/],
    [() => square.voronoi([[0, 0, 0], null]), 'invalid_option', /but not item 1/],
    [() => square.distances(0, { onto: 1 }), 'invalid_option', /^distances: /],
    [() => square.to_bytes(), 'invalid_option', /format: text/],
    [() => new Mesh(), 'invalid_option', /vertices: an array/],
    [() => new Mesh([0, 0, 0, 1, 0, 0, 0, 1, 0], [0.7, 1, 2]), 'invalid_option', /0\.7 is no whole number/],
    [() => new Mesh([[0, 0], [1, 0, 0, 0], [0, 1, 0]], [[0, 1, 2]]), 'invalid_option', /but not item 0/],
    [() => new Mesh([[0, 0, 0], [1, 0, null], [0, 1, 0]], [[0, 1, 2]]), 'invalid_option', /item 5 is null/],
    [() => new Mesh([0, 0, 0], [0, 0, 0], { corners: 0 }), 'invalid_option', /corners: a whole number from 3 on/],
    [() => new Mesh([0, 0, 0], [0, 0, 0], { on_defect: 3 }), 'invalid_option', /^on_defect: /],
    [() => gvd.read(new Uint8Array([1])), 'invalid_option', /name: text/],
    [() => gvd.read('v 0 0 0', 'a.obj'), 'invalid_option', /a Uint8Array/],
    [() => freed.distances(0), 'invalid_option', /was freed/],
    [() => square.segment(null, { curves: new gvd.Curves({ file: 'x' }, [], []) }), 'unreadable_input', /^curves: x: there is no such file$/],
    [() => square.sample(2, { seed: 2 ** 53 + 2 }), 'invalid_option', /^seed: 9007199254740994 is beyond 2\^53, .*; give a BigInt/],
    [() => square.distances([3, 3]), 'precondition', /^points: vertex 3 is listed twice; remove one$/],
    [() => new gvd.DiagramEditor(square, [0, 1]).move(0, 1), 'precondition', /^generators 0 and 1 coincide; remove one$/],
    [() => new gvd.DiagramEditor(null, [0, 1]), 'invalid_option', /^mesh: a Mesh is needed$/],
    [() => square.voronoi([0, 1], { weights: [1] }), 'invalid_option', /^weights: 1 number for 2 generators/],
    [() => square.balance([0, 1], { shares: [1] }), 'invalid_option', /^shares: 1 number for 2 generators/],
    ...[true, '1', 0, -1, NaN].map((limit) => [() => square.sample(2, { time_limit: limit }), 'invalid_option', /^time_limit: a number of seconds above 0 is needed/]),
    ...[undefined, null].flatMap((none) => [
      [() => square.isolines(0, none), 'invalid_option', /^levels: a distance, or an array of them, is needed$/],
      [() => square.path(0, none), 'invalid_option', /^end: points are needed$/],
      ...['points', 'distances', 'voronoi', 'balance'].map((name) => [() => square[name](none), 'invalid_option', /^points: points are needed$/]),
    ]),
    [() => square.path(9, 0), 'precondition', /^start: there is no vertex 9; the mesh has 4, numbered from 0$/],
    [() => square.path(0, 9), 'precondition', /^end: there is no vertex 9/],
    [() => square.segment(null, { n: 3 }), 'invalid_option', /^segment: there is no option "n"; did you mean "count"\?/],
    [() => square.distances(0, { at: 3 }), 'invalid_option', /^distances: there is no option "at"; did you mean "to"\?/],
    [() => square.distances([[NaN, 0, 0]]), 'precondition', /finite/],
  ];
  for (const [call, code, message] of kRefused) {
    assert.throws(call, (error) => {
      assert.ok(error instanceof gvd.Error, String(error));
      assert.deepEqual([error.code, /\n/.test(error.message)], [code, false], error.message);
      assert.match(error.message, message);
      return true;
    });
  }
});

test('Node.js computes the same where it may not evaluate strings', () => {
  const [package_url, results_url] = [pathToFileURL(join(packed, 'index.mjs')).href, new URL('module_results.mjs', import.meta.url).href];
  const program = `
    import { readFileSync } from 'node:fs';
    import * as gvd from ${JSON.stringify(package_url)};
    import { results } from ${JSON.stringify(results_url)};
    const [file, name] = process.argv.slice(1);
    console.log(JSON.stringify(results(gvd, readFileSync(file), name)));`;
  const options = ['--disallow-code-generation-from-strings', '--input-type=module', '--eval', program];
  const there = execFileSync(process.execPath, [...options, join(data, kMeshes[0]), kMeshes[0]], { encoding: 'utf8', maxBuffer: 1 << 28 });
  assert.deepEqual(JSON.parse(there), JSON.parse(JSON.stringify(found[kMeshes[0]])));
});

test('a browser computes the same numbers, under a policy that forbids to evaluate strings', async (context) => {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(executablePath)) return context.skip(`no browser at ${executablePath}`);
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu'] });
  try {
    const page = await browser.newPage();
    const kPolicy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'";  // without 'unsafe-eval', as servers send it
    const kPage = `<!doctype html><meta http-equiv="Content-Security-Policy" content="${kPolicy}">`;
    const kTypes = { '.mjs': 'text/javascript', '.wasm': 'application/wasm' };
    await page.route('https://gvd.test/**', (route) => {
      const path = new URL(route.request().url()).pathname;
      if (path === '/') return route.fulfill({ contentType: 'text/html', body: kPage });
      const here = path === '/module_results.mjs' ? new URL('module_results.mjs', import.meta.url) : null;
      const file = here ?? join(path.startsWith('/data/') ? data : packed, path.split('/').at(-1));
      return route.fulfill({ contentType: kTypes[extname(path)] ?? 'application/octet-stream', body: readFileSync(file) });
    });
    await page.goto('https://gvd.test/');
    for (const name of kMeshes) {
      const there = await page.evaluate(async (mesh) => {
        const [module, { results: compute }] = await Promise.all([import('/package/index.mjs'), import('/module_results.mjs')]);
        return compute(module, new Uint8Array(await (await fetch(`/data/${mesh}`)).arrayBuffer()), mesh);
      }, name);
      assert.deepEqual(there, found[name], name);
    }
  } finally {
    await browser.close();
  }
});
