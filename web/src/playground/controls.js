// The panel of the playground: what is computed, of how many generators, and what is saved.
import { by_id, element } from '../panel.js';

// What can be shown of the generators.
export const kShows = [
  ['diagram', 'Regions'],
  ['equal', 'Equal regions'],
  ['distances', 'Distances'],
  ['remesh', 'Coarse mesh'],
];
const kFormats = ['ply', 'obj', 'glb', 'json', 'csv'];

export class Controls {
  constructor(playground) {
    this.playground = playground;
    this.busy = 0;
    by_id('play-show').append(...kShows.map(([value, textContent]) => element('option', { value, textContent })));
    by_id('play-save').append(...kFormats.map((value) => element('option', { value, textContent: `.${value}` })));
    const on = (id, type, react) => by_id(id).addEventListener(type, ({ target }) => react(target));
    on('play-show', 'change', ({ value }) => playground.change({ show: value }));
    on('play-count', 'input', ({ value }) => (by_id('play-count-text').textContent = value));
    on('play-count', 'change', ({ value }) => playground.change({ count: Number(value), generators: null }));
    on('play-relax', 'click', () => playground.relax());
    on('play-remove', 'click', () => playground.remove_selected());
    on('play-undo', 'click', () => playground.step(-1));
    on('play-redo', 'click', () => playground.step(1));
    on('play-path', 'change', ({ checked }) => this.set_path_mode(checked));
    on('play-link', 'click', () => this.copy(location.href.replace(/#.*/, '') + playground.link(), 'The link is copied.'));
    on('play-save', 'change', (select) => {
      playground.save(select.value);
      select.value = '';
    });
    for (const id of ['play-shell', 'play-python']) on(id, 'click', ({ textContent }) => this.copy(textContent, 'Copied.'));
  }

  set_path_mode(on) {
    this.playground.set_path_mode(on);
    this.tell(on ? 'Click where the path begins.' : '');
  }

  async copy(text, told) {
    const copied = navigator.clipboard?.writeText(text) ?? Promise.reject();  // pages without https have none
    await copied.then(() => this.tell(told), () => this.tell(text));
  }

  // Shows a state, and which of undo and redo are possible.
  follow({ count, generators, show, model }, { at, states }) {
    const number = generators?.length ?? count;
    by_id('play-count').value = String(number);
    by_id('play-count-text').textContent = String(number);
    by_id('play-show').value = show;
    by_id('play-undo').disabled = at === 0;
    by_id('play-redo').disabled = at === states.length - 1;
    by_id('play-link').disabled = !model;
    by_id('play-path').disabled = show === 'remesh';
    by_id('play-save').querySelector('[value=glb]').disabled = show === 'distances';  // as by the command
  }

  mark_selected(removable) {
    by_id('play-remove').disabled = !removable;
  }

  show_recipe({ shell, python }) {
    by_id('play-shell').textContent = shell;
    by_id('play-python').textContent = python;
  }

  tell(message) {
    by_id('play-message').textContent = message;
    by_id('play-message').hidden = !message;
  }

  // More or fewer questions that are not answered.
  set_busy(by) {
    this.busy += by;
    document.documentElement.dataset.computing = String(this.busy > 0);
  }
}
