// The page that computes: the viewer, with a worker that makes its scenes anew whenever the generators change.
//
// A state is never changed but replaced, so that undo goes back to it: `model`, the `count` of farthest generators or the
// `generators` themselves, and what is shown of them. While a generator is dragged, the newest place is computed as soon
// as the worker is free; the state follows when it is dropped.
import { Vector3 } from 'three';
import { locate } from '../element_card.js';
import { IdMap } from '../id_map.js';
import { Viewer } from '../main.js';
import { make_lines } from '../marks.js';
import * as panel from '../panel.js';
import { save_blob } from '../save_picture.js';
import { with_arrays } from './arrays.js';
import { Controls } from './controls.js';
import { without } from './edits.js';
import { History } from './history.js';
import { format_link, round_bary } from './link.js';
import { python_lines, shell_command } from './recipe.js';

const kNear = { mouse: 12, touch: 24 };  // CSS pixels round a generator that mean it
const kClick = 6;                        // CSS pixels that a click may move
const kNudge = 12;                       // CSS pixels that a key moves a generator
const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

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
  }

  get state() {
    return this.history.state;
  }

  listen_to_generators() {
    const { canvas } = this;
    // Before the controls of the camera, which must not turn the surface then.
    canvas.addEventListener('pointerdown', (event) => this.take(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    for (const type of ['pointerup', 'pointercancel']) canvas.addEventListener(type, (event) => this.drop(event));
    document.addEventListener('keydown', (event) => this.on_key(event), { capture: true });  // before the camera has it
    canvas.ariaLabel += ' N selects the next generator in view, Shift and an arrow key move it, Delete removes it, Insert adds one in the middle.';
  }

  on_key(event) {
    const key = event.key.toLowerCase(), command = event.ctrlKey || event.metaKey;
    if (!command && (event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement)) return;
    if (key === 'delete' || key === 'backspace') this.remove_selected();
    else if (command && key === 'z') this.step(event.shiftKey ? 1 : -1);
    else if (command && key === 'y') this.step(1);
    else if (!command && key === 'n') this.select_next(event.shiftKey ? -1 : 1);
    else if (event.shiftKey && kArrows[event.key]) this.nudge(...kArrows[event.key]);
    else if (key === 'insert') this.add({ offsetX: this.stage.width / 2, offsetY: this.stage.height / 2 });
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // Where a point of the surface is on the canvas.
  pixel_of(point) {
    const { x, y } = new Vector3(...this.place(point)).project(this.stage.camera), { width, height } = this.stage;
    return { offsetX: ((x + 1) * width) / 2, offsetY: ((1 - y) * height) / 2 };
  }

  // Selects a generator, or none where it is null.
  select(generator) {
    this.selected = generator;
    this.controls.mark_selected(generator !== null && this.points.length > 1);
  }

  // The next generator in view after the selected one, or the one before where `by` is -1.
  select_next(by) {
    const count = this.points.length, from = this.selected ?? (by > 0 ? -1 : count);
    for (let k = 1; k <= count; ++k) {
      const i = (from + k * by + 2 * count) % count;
      if (this.generator_at(this.pixel_of(this.points[i])) !== i) continue;
      this.select(i);
      return this.pin(i);
    }
  }

  // Moves the selected generator over the surface as it is seen.
  nudge(right, down) {
    if (this.selected === null || !this.shows_input()) return;
    const { offsetX, offsetY } = this.pixel_of(this.points[this.selected]);
    const under = this.surface_at({ offsetX: offsetX + kNudge * right, offsetY: offsetY + kNudge * down });
    if (under) this.change({ generators: this.points.with(this.selected, { face: under.face, bary: under.bary }) }, this.selected);
  }

  // Adds a generator where the pointer is.
  add(event) {
    const under = this.shows_input() && this.surface_at(event);
    if (under) this.change({ generators: [...this.points, { face: under.face, bary: under.bary }] });
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
    if (!event.isPrimary) return this.let_go();
    if (event.button !== 0 || this.path_start !== undefined) return;
    const generator = this.generator_at(event);
    this.select(generator);
    if (generator === null) return;
    this.pin(null);
    this.dragged = { generator, from: event, moved: false };
    this.stage.controls.enabled = false;
    this.canvas.setPointerCapture(event.pointerId);
  }

  drag(event) {
    if (event.pointerId !== this.dragged?.from.pointerId) return;
    const { from, generator } = this.dragged;
    this.dragged.moved ||= Math.hypot(event.offsetX - from.offsetX, event.offsetY - from.offsetY) >= kClick;
    const under = this.dragged.moved && this.surface_at(event);
    if (!under) return;
    const { face, bary } = under;
    this.dragged.points = this.points.map((p, i) => (i === generator ? { face, bary } : p));
    this.stage.moving = true;
    this.stage.hold(true);
    const shown = this.show({ ...this.state, generators: this.dragged.points }, (args) => this.engine.ask_latest('show', args, () => this.stage.drawn));
    shown.then(() => this.engine.busy || this.stage.hold(false));  // the whole picture comes where the pointer rests
  }

  // Not while a generator is dragged: reading what the graphics card has drawn takes longer than the diagram.
  pick() {
    if (!this.dragged) super.pick();
  }

  // A second finger: the generator goes back to its place.
  let_go() {
    if (this.dragged) this.follow_state();
  }

  // What was dragged, or null.
  end_drag() {
    const { dragged } = this;
    if (!dragged) return null;
    this.dragged = null;
    this.stage.controls.enabled = true;
    this.stage.hold(false);
    return dragged;
  }

  drop(event) {
    if (event.pointerId !== this.dragged?.from.pointerId) return;
    const { points, generator } = this.end_drag();
    if (points) this.change({ generators: points }, generator);
    else this.pin(generator);  // a click
  }

  // A click on a generator has selected it; elsewhere it adds one, or names an end of a path.
  release(event) {
    const start = this.pressed;
    this.pressed = null;
    const moved = !start || Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) >= kClick;
    if (moved || event.button !== 0 || this.dragged || !this.shows_input()) return;
    if (this.path_start === undefined) return this.add(event);
    const under = this.surface_at(event);
    if (under) this.add_path_end({ face: under.face, bary: under.bary });
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
    this.change({ generators: without(this.points, this.selected) });
  }

  // A new state, which undo takes back; `selected` is the generator that stays selected.
  change(fields, selected = null) {
    this.history.push({ ...this.state, ...fields });
    return this.follow_state(selected);
  }

  step(by) {
    if (this.history.move(by)) this.follow_state();
  }

  async follow_state(selected = null) {
    const { state } = this;
    this.end_drag();  // of a second finger, or of a key that is pressed meanwhile
    this.select(selected);
    this.controls.follow(state, this.history);
    this.write_link();
    await this.show(state, (args) => this.engine.ask_latest('show', args));
  }

  // Computes what a state shows, and shows it. A newer question may go before it.
  async show(state, ask) {
    const { count, generators, show } = state;
    const answer = await this.attempt(() => ask({ count, generators, show }));
    if (!answer) return;
    this.points = answer.points;
    this.replace(with_arrays(answer));
    if (answer.note) this.controls.tell(answer.note);
    if (!this.dragged) this.controls.show_recipe(this.recipe());
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

  // The input is drawn with a coarse mesh.
  own_switches() {
    return super.own_switches().map((own) => ({ ...own, overlay: true }));
  }

  // Not of each place of a dragged generator where pictures are slow: drawing the panels takes as long as half of one.
  show_panels(on) {
    if (!this.dragged || !this.stage.quick) super.show_panels(on);
  }

  prepare(moving) {
    if (this.face_map && this.view !== `${this.current} ${this.stage.view_key()}`) this.face_map.invalidate();
    super.prepare(moving && !this.dragged);  // fewer triangles would have to be chosen anew for each picture
  }

  async relax() {
    const { state } = this, report = (scene) => this.state === state && this.replace(with_arrays(scene));
    const answer = await this.attempt(() => this.engine.ask('relax', { count: this.state.count, generators: this.state.generators }, report));
    const rounded = ({ face, bary }) => ({ face, bary: round_bary(bary) });
    if (answer && this.state === state) await this.change({ generators: answer.points.map(rounded), show: 'diagram' });
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
    this.select(null);
    if (this.path_start) this.path_start = null;  // it lies on the mesh before
    this.face_map.invalidate();
    this.show_other(with_arrays(scene));
    this.controls.follow(state, this.history);
    this.controls.show_recipe(this.recipe());
  }

  // The camera of a link: its place and what it looks at.
  look_from(camera) {
    this.stage.camera.position.fromArray(camera);
    this.stage.controls.target.fromArray(camera, 3);
    this.stage.controls.update();
    this.stage.request_draw();
  }

  // Runs what asks the worker, with the message of its error where it has one. Null if another mesh was opened meanwhile.
  async attempt(ask) {
    const { opened } = this;
    this.controls.set_busy(1);
    try {
      const answer = await ask();
      if (opened !== this.opened) return null;
      if (answer) this.controls.tell('');
      return answer;
    } catch (error) {
      if (opened === this.opened) this.controls.tell(error.message);
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
    history.replaceState(null, '', this.state.model ? this.link() : location.href.replace(/#.*/, ''));
  }
}
