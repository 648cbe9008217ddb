// The npm package against the commands, in Node.js and in a browser: node module.test.mjs PACKAGE BIN DATA.
//
// The same inputs must give the same labels and the same topology as the native build, and lengths to 1e-12. A browser
// must give the very numbers that Node.js gives. Without a browser, that part is skipped with a message.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join, resolve } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';
import { results } from './module_results.mjs';

const [packed, bin, data] = process.argv.slice(2).map((path) => resolve(path));
const gvd = await import(pathToFileURL(join(packed, 'index.mjs')).href);
const { Mesh } = gvd;
const kTolerance = 1e-12;
const kMeshes = ['figure.obj', 'torus.ply', 'half_sphere.off', 'plate.stl'];
const found = Object.fromEntries(kMeshes.map((name) => [name, results(gvd, readFileSync(join(data, name)), name)]));

function assertClose(actual, expected, what) {
  assert.equal(actual.length, expected.length, what);
  const scale = Math.max(...expected.map(Math.abs));
  actual.forEach((value, i) =>
    assert.ok(Math.abs(value - expected[i]) <= kTolerance * scale, `${what} ${i}: ${value} is not ${expected[i]}`));
}

function readNative(command, name, ...options) {
  const file = join(mkdtempSync(join(tmpdir(), 'gvd-')), 'native.json');
  execFileSync(join(bin, command), [join(data, name), ...options, '-q', '-o', file]);
  return JSON.parse(readFileSync(file, 'utf8'));
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
  test(`${name} remeshed as the command does`, () => {
    const native = readNative('gvd-remesh', name, '-n', '100', '--relax', 'none');
    assert.deepEqual(found[name].remesh, native.remesh.faces.flat());
    assert.ok(found[name].certified);
  });
}

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
  assert.deepEqual([...square.nearest([0, 2], { at: [[0.9, 0.9, 0]] }).labels], [1]);
  assert.equal(square.distances([0, 1], { each: true }).length, 8);
  const lines = square.isolines(0, [0.5]);
  assert.ok(lines[0].positions.length >= 6 && !lines[0].closed);
  const { diagram, masses, converged } = square.balance([0, 2], { shares: [1, 3] });
  assert.ok(converged);
  assert.ok(Math.abs(masses[0] - 0.25) < 1e-9 && Math.abs(masses[1] - 0.75) < 1e-9, String(masses));
  assert.equal(diagram.cut().mesh.summary.area, 1);
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

test('relaxation reports its iterations', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  const energies = [];
  const relaxed = mesh.lloyd(20, { on_iteration: (_, energy, points) => energies.push([energy, points.face.length]) });
  assert.ok(energies.length > 1 && energies.every(([, points]) => points === 20));
  assert.ok(relaxed.energies.at(-1) < relaxed.energies[0]);
  assert.deepEqual(mesh.voronoi(relaxed.generators).generators, relaxed.generators);
});

test('a file that was written reads back', () => {
  const mesh = gvd.read(readFileSync(join(data, 'torus.ply')), 'torus.ply');
  for (const format of ['ply', 'obj', 'off']) {
    assert.deepEqual(gvd.read(mesh.to_bytes(format), `x.${format}`).vertices, mesh.vertices, format);
  }
  assert.equal(gvd.read(mesh.to_bytes('glb'), 'x.glb').summary.faces, mesh.summary.faces);
});

test('what can not be done is an error of one line', () => {
  const square = new Mesh([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [0, 1, 2, 0, 2, 3]);
  const kRefused = [
    [() => gvd.read(new TextEncoder().encode('v 0 0 x\nf 1 2 3'), 'bad.obj'), 'unreadable_input', /^bad\.obj:1: coordinate z is 'x'/],
    [() => gvd.read(new Uint8Array([31, 139, 8, 0]), 'a.obj.gz'), 'unreadable_input', /unpack it first/],
    [() => new Mesh([0, 0, 0], [0, 1, 2]), 'precondition', /./],
    [() => square.voronoi([0, 0]), 'precondition', /coincide/],
    [() => square.voronoi([4]), 'precondition', /4/],
    [() => square.voronoi([-1]), 'invalid_option', /-1 is no whole number/],
    [() => square.voronoi([0, 1], { methd: 'exact' }), 'invalid_option', /no option 'methd'/],
    [() => square.voronoi([0, 1], { method: 'quick' }), 'invalid_option', /one of exact, gbgvd, paper is needed/],
    [() => square.sample(1.5), 'invalid_option', /n: a whole number/],
    [() => square.to_bytes('xyz'), 'invalid_option', /'xyz' is no format/],
    [() => square.sample(3, { progress: () => false }), 'interrupted', /./],
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

test('a browser computes the same numbers', async (context) => {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  if (!existsSync(executablePath)) return context.skip(`no browser at ${executablePath}`);
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu'] });
  try {
    const page = await browser.newPage();
    const kTypes = { '.mjs': 'text/javascript', '.wasm': 'application/wasm' };
    await page.route('https://gvd.test/**', (route) => {
      const path = new URL(route.request().url()).pathname;
      if (path === '/') return route.fulfill({ contentType: 'text/html', body: '<!doctype html>' });
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
