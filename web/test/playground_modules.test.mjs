// Tests of the playground's modules that need no browser: node --test playground_modules.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { find_change, without } from '../src/playground/edits.js';
import { Engine } from '../src/playground/engine.js';
import { History } from '../src/playground/history.js';
import { format_link, parse_link, round_bary } from '../src/playground/link.js';
import { python_lines, shell_command } from '../src/playground/recipe.js';

const kModels = ['figure', 'torus'], kShows = ['diagram', 'remesh'];

test('undo and redo go through the states, and a new state ends what was undone', () => {
  const history = new History(0);
  for (const state of [1, 2, 3]) history.push(state);
  assert.ok(history.move(-1) && history.move(-1));
  assert.equal(history.state, 1);
  assert.ok(history.move(1));
  history.push(4);
  assert.deepEqual([history.state, history.move(1), history.state], [4, false, 4]);
  for (const state of [2, 1, 0]) assert.ok(history.move(-1) && history.state === state);
  assert.equal(history.move(-1), false);
});

test('a link holds a state exactly', () => {
  const generators = [[0.2, 0.3, 0.5], [1, 0, 0], [1 / 3, 1 / 3, 1 / 3], [0, 0.5000004, 0.4999996], [0, 1e-9, 1]].map((bary, face) => ({ face, bary: round_bary(bary) }));
  for (const { bary } of generators) {
    assert.ok(bary.every((b) => b >= 0 && b <= 1));
    assert.ok(Math.abs(bary[0] + bary[1] + bary[2] - 1) < 1e-15);
  }
  const state = { model: 'torus', show: 'remesh', generators, camera: [1, 2, 3, 0, -0.5, 0.25] };
  assert.deepEqual(parse_link(format_link({ ...state, count: 5 }), kModels, kShows), state);
  assert.deepEqual(parse_link(format_link({ model: 'figure', count: 40 }), kModels, kShows), { model: 'figure', count: 40 });
});

test('what makes no sense in a link is left out', () => {
  for (const hash of ['', '#', '#model=none&show=x&n=-3&g=1_2&camera=1', '#n=2.5&g=a_b_c', '#g=-1_0_0', '#%']) {
    assert.deepEqual(parse_link(hash, kModels, kShows), {}, hash);
  }
});

test('recipes name the file, and the generators where they are not the farthest ones', () => {
  const state = { file: 'my mesh.obj', count: 30, generators: null, show: 'diagram' };
  assert.equal(shell_command(state), "gvd-segment 'my mesh.obj' -n 30 -o regions.ply");
  const moved = { ...state, generators: [{ face: 7, bary: [0.5, 0.25, 0.25] }], show: 'remesh' };
  assert.equal(shell_command(moved), "gvd-remesh 'my mesh.obj' --generators generators.csv -o coarse.obj");
  assert.match(python_lines(moved), /Points\(numpy.array\(\[7\]\), numpy.array\(\[\(0.5, 0.25, 0.25\)\]\)\)/);
});

test('a change of one generator is found, and no other', () => {
  const [a, b, c, d] = [1, 2, 3, 4].map((face) => ({ face, bary: [0.5, 0.25, 0.25] })), moved = { face: 2, bary: [0.5, 0.5, 0] };
  assert.deepEqual(find_change([a, b, c], [a, b, c]), []);
  assert.deepEqual(find_change([a, b, c], [a, moved, c]), ['move', 1, moved]);
  assert.deepEqual(find_change([a, b], [a, b, c]), ['add', c]);
  for (const i of [0, 1, 2]) assert.deepEqual(find_change([a, b, c], without([a, b, c], i)), ['remove', i]);
  assert.deepEqual(without([a, b, c], 0), [c, b]);
  for (const after of [[b, a, c], [b, c], [a, b, c, d, d], [a], [a, moved, c, d]]) assert.equal(find_change([a, b, c], after), null);
});

test('the next question waits until the page is ready for its answer', async () => {
  const worker = new FakeWorker(), engine = new Engine(worker);
  let ready;
  const first = engine.ask_latest('move', 'a', () => new Promise((done) => (ready = done))), second = engine.ask_latest('move', 'b');
  worker.answer('A');
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(worker.asked.length, 1);
  ready();
  assert.equal(await first, 'A');
  assert.equal(worker.asked.length, 2);
  worker.answer('B');
  assert.equal(await second, 'B');
});

class FakeWorker {
  asked = [];
  postMessage(message) {
    this.asked.push(message);
  }
  answer(result) {
    this.onmessage({ data: { id: this.asked.at(-1).id, result } });
  }
}

test('of questions that come faster than answers, only the newest is asked', async () => {
  const worker = new FakeWorker(), engine = new Engine(worker);
  const [first, second, third] = ['a', 'b', 'c'].map((args) => engine.ask_latest('move', args));
  assert.equal(await second, null);
  worker.answer('A');
  assert.equal(await first, 'A');
  await new Promise((resolve) => setTimeout(resolve));
  worker.answer('C');
  assert.equal(await third, 'C');
  assert.deepEqual(worker.asked.map(({ args }) => args), ['a', 'c']);
});

test('errors and progress of the worker reach who asked', async () => {
  const worker = new FakeWorker(), engine = new Engine(worker), seen = [];
  const asked = engine.ask('lloyd', {}, (progress) => seen.push(progress));
  const { id } = worker.asked[0];
  worker.onmessage({ data: { id, progress: 1 } });
  worker.onmessage({ data: { id, progress: 2 } });
  worker.onmessage({ data: { id, error: 'there is no generator' } });
  await assert.rejects(asked, /there is no generator/);
  assert.deepEqual(seen, [1, 2]);
});
