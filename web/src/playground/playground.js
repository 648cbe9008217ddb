// The page that computes: the viewer, with a worker that makes its scenes anew whenever the generators change.
//
// A state is never changed but replaced, so that undo goes back to it: `model`, the `count` of farthest generators or the
// `generators` themselves, and what is shown of them. While a generator is dragged, the newest place is computed as soon
// as the worker is free; the state follows when it is dropped.
import { locate } from '../element_card.js';
import { IdMap } from '../id_map.js';
import { Viewer } from '../main.js';
import { make_lines } from '../marks.js';
import * as panel from '../panel.js';
import { save_blob } from '../save_picture.js';
import { with_arrays } from './arrays.js';
import { Controls } from './controls.js';
import { History } from './history.js';
import { format_link, round_bary } from './link.js';
import { python_lines, shell_command } from './recipe.js';

const kNear = { mouse: 12, touch: 24 };  // CSS pixels round a generator that mean it
const kClick = 6;                        // CSS pixels that a click may move
const kManyFaces = 30000;                // while dragging, more have the diagram of the faster method

export class Playground extends Viewer {
  // `first`: the state to begin with; `opened`: what the worker says of its mesh; `scene`: the first answer.
  constructor(engine, opened, first, scene) {
    super(with_arrays(scene));
    this.engine = engine;
    this.opened = opened;
    this.history = new History(first);
    this.points = scene.points;
    this.selected = null;
    this.face_map = new IdMap(this.stage);
    this.controls = new Controls(this);
    this.listen_to_generators();
    this.controls.follow(first, this.history);
    this.controls.show_recipe(this.recipe());
    this.write_link();
  }

  get state() {
    return this.history.state;
  }

  listen_to_generators() {
    const { canvas } = this;
    // Before the controls of the camera, which must not turn the surface then.
    canvas.addEventListener('pointerdown', (event) => this.take(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    for (const type of ['pointerup', 'pointercancel']) canvas.addEventListener(type, () => this.drop());
    document.addEventListener('keydown', (event) => this.on_key(event));
  }

  on_key(event) {
    if (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement) return;
    const key = event.key.toLowerCase(), command = event.ctrlKey || event.metaKey;
    if (key === 'delete' || key === 'backspace') this.remove_selected();
    else if (command && key === 'z') this.step(event.shiftKey ? 1 : -1);
    else if (command && key === 'y') this.step(1);
    else return;
    event.preventDefault();
  }

  // The face, barycentric coordinates and position of the surface under the pointer; null beside it.
  surface_at(event) {
    const { picture } = this, pointer = { x: event.offsetX, y: event.offsetY };
    this.face_map.update(picture.mesh, picture.surface.triangles.parents);
    const hit = this.face_map.at(pointer.x, pointer.y);
    if (!hit) return null;
    const { face, bary } = locate(this.stage, picture.surface, hit.code, pointer);
    const inside = bary.map((b) => Math.max(b, 0)), sum = inside[0] + inside[1] + inside[2];
    const rounded = round_bary(inside.map((b) => b / sum));
    return { face, bary: rounded, at: this.place({ face, bary: rounded }) };
  }

  // The generator that the pointer means; null where there is none near it. A hidden one is far from what is under it.
  generator_at(event) {
    const under = this.shows_input() && this.surface_at(event);
    if (!under) return null;
    const reach = (kNear[event.pointerType] ?? kNear.mouse) / this.stage.pixels_per_unit();
    let nearest = null, least = reach;
    this.points.forEach((point, i) => {
      const distance = Math.hypot(...this.place(point).map((x, k) => x - under.at[k]));
      if (distance < least) [nearest, least] = [i, distance];
    });
    return nearest;
  }

  click_hint() {
    return this.shows_input() ? ', drag a dot to move a generator, click to add one' : '';
  }

  // Whether the surface is the input, on which generators lie.
  shows_input() {
    return this.history?.state.show !== 'remesh';
  }

  // In the coordinates of the page.
  place({ face, bary }) {
    const { positions, faces } = this.picture.surface;
    return [0, 1, 2].map((k) => bary.reduce((p, b, i) => p + b * positions[3 * faces[3 * face + i] + k], 0));
  }

  take(event) {
    if (event.button !== 0 || this.path_start !== undefined) return;
    const generator = this.generator_at(event);
    this.selected = generator;
    this.controls.mark_selected(generator);
    if (generator === null) return;
    this.pin(null);
    this.dragged = { generator, from: event, moved: false };
    this.stage.controls.enabled = false;
    this.canvas.setPointerCapture(event.pointerId);
  }

  drag(event) {
    if (!this.dragged) return;
    const { from, generator } = this.dragged;
    this.dragged.moved ||= Math.hypot(event.offsetX - from.offsetX, event.offsetY - from.offsetY) >= kClick;
    const under = this.dragged.moved && this.surface_at(event);
    if (!under) return;
    const { face, bary } = under;
    this.dragged.points = this.points.map((p, i) => (i === generator ? { face, bary } : p));
    const method = this.opened.faces > kManyFaces ? 'gbgvd' : 'exact';
    this.show({ ...this.state, generators: this.dragged.points, method }, (args) => this.engine.ask_latest('show', args));
  }

  // Not while a generator is dragged: reading what the graphics card has drawn takes longer than the diagram.
  pick() {
    if (!this.dragged) super.pick();
  }

  drop() {
    if (!this.dragged) return;
    const { points, generator } = this.dragged;
    this.dragged = null;
    this.stage.controls.enabled = true;
    if (points) this.change({ generators: points });
    else this.pin(generator);  // a click
  }

  // A click on a generator has selected it; elsewhere it adds one, or names an end of a path.
  release(event) {
    const start = this.pressed;
    this.pressed = null;
    const moved = !start || Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) >= kClick;
    if (moved || event.button !== 0 || this.dragged || !this.shows_input()) return;
    const under = this.surface_at(event);
    if (!under) return;
    const point = { face: under.face, bary: under.bary };
    if (this.path_start !== undefined) return this.add_path_end(point);
    this.change({ generators: [...this.points, point] });
  }

  // Path mode begins and ends; it has no start until the first click.
  set_path_mode(on) {
    this.path_start = on ? null : undefined;
    this.picture.clear_path();
    this.stage.request_draw();
  }

  async add_path_end(point) {
    if (this.path_start === null) {
      this.path_start = point;
      return this.controls.tell('Click where the path ends.');
    }
    const from = this.path_start;
    this.path_start = null;
    const answer = await this.attempt(() => this.engine.ask('path', { from, to: point }));
    if (!answer) return;
    this.picture.clear_path();
    this.picture.path = make_lines({ points: answer.points, counts: [answer.points.length / 3] }, this.materials.path);
    if (this.picture.path) this.picture.group.add(this.picture.path);
    this.controls.tell(`Length of the path: ${panel.format_number(answer.length)}`);
    this.stage.request_draw();
  }

  remove_selected() {
    if (this.selected === null || this.points.length < 2) return;
    const generators = this.points.filter((_, i) => i !== this.selected);
    this.selected = null;
    this.controls.mark_selected(null);
    this.change({ generators });
  }

  // A new state, which undo takes back.
  change(fields) {
    this.history.push({ ...this.state, ...fields });
    return this.follow_state();
  }

  step(by) {
    if (this.history.move(by)) this.follow_state();
  }

  async follow_state() {
    const { state } = this;
    this.controls.follow(state, this.history);
    this.write_link();
    await this.show(state, (args) => this.engine.ask_latest('show', args));
  }

  // Computes what a state shows, and shows it. A newer question may go before it.
  async show(state, ask) {
    const { count, generators, show, method } = state;
    const answer = await this.attempt(() => ask({ count, generators, show, method }));
    if (!answer) return;
    this.points = answer.points;
    this.replace(with_arrays(answer));
    if (answer.note) this.controls.tell(answer.note);
    this.controls.show_recipe(this.recipe());
  }

  // Other scenes in place of the current ones; switches keep their positions.
  replace(manifest) {
    const { positions } = this.picture.entry;
    this.picture.dispose();
    Object.assign(this.manifest, { scenes: manifest.scenes, scale: manifest.scale });
    this.pictures = manifest.scenes.map(() => null);
    if (positions.blob !== manifest.scenes[0].positions.blob) {
      this.face_map.invalidate();
      this.own = this.own_switches();
    }
    this.id_map.invalidate();
    this.hover_mark.clear();
    this.choose(0);
    this.pin(this.dragged ? null : this.selected);
    this.pick();
  }

  prepare(moving) {
    if (this.face_map && this.view !== `${this.current} ${this.stage.view_key()}`) this.face_map.invalidate();
    super.prepare(moving);
  }

  async relax() {
    const report = ({ scene }) => this.replace(with_arrays(scene));
    const answer = await this.attempt(() => this.engine.ask('relax', { count: this.state.count, generators: this.state.generators }, report));
    if (answer) await this.change({ generators: answer.points, show: 'diagram' });
  }

  async save(format) {
    const { count, generators, show } = this.state;
    const answer = await this.attempt(() => this.engine.ask('file', { count, generators, show, format }));
    if (answer) save_blob(new Blob([answer.bytes]), `${answer.name}.${format}`);
  }

  // Another mesh with its first state.
  open(opened, state, scene) {
    this.opened = opened;
    this.history = new History(state);
    this.points = scene.points;
    this.selected = null;
    this.face_map.invalidate();
    this.show_other(with_arrays(scene));
    this.controls.follow(state, this.history);
    this.controls.show_recipe(this.recipe());
    this.write_link();
  }

  // The camera of a link: its place and what it looks at.
  look_from(camera) {
    this.stage.camera.position.fromArray(camera);
    this.stage.controls.target.fromArray(camera, 3);
    this.stage.controls.update();
    this.stage.request_draw();
  }

  // Runs what asks the worker, with the message of its error where it has one.
  async attempt(ask) {
    this.controls.set_busy(1);
    try {
      const answer = await ask();
      if (answer) this.controls.tell('');
      return answer;
    } catch (error) {
      this.controls.tell(error.message);
      return null;
    } finally {
      this.controls.set_busy(-1);
    }
  }

  recipe() {
    const { count, generators, show } = this.state, file = this.opened.name;
    const given = { file, count, generators, show };
    return { shell: shell_command(given), python: python_lines(given) };
  }

  link() {
    const { position } = this.stage.camera, { target } = this.stage.controls;
    return format_link({ ...this.state, camera: [...position, ...target] });
  }

  // Only shipped models can be named.
  write_link() {
    if (this.state.model) history.replaceState(null, '', this.link());
  }
}
