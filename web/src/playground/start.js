// Begins the playground: the worker, the state of the link, and files that are chosen or dropped.
import { unpack } from '../data.js';
import { arrange_panels } from '../layout.js';
import { by_id, element, show_failure } from '../panel.js';
import { kShows } from './controls.js';
import { Engine } from './engine.js';
import { parse_link } from './link.js';
import { Playground } from './playground.js';

const kModels = [['figure.obj', 'Figure'], ['torus.ply', 'Torus'], ['half_sphere.off', 'Half sphere']];
const kFirst = { model: 'figure.obj', count: 30, generators: null, show: 'diagram' };

// The build puts the worker and the models into the page: it works from disk, without a server.
const embedded = (id) => unpack(by_id(id).textContent);

// The bytes of a file, unpacked where gzip packed it.
function bytes_of(file) {
  const packed = file.name.toLowerCase().endsWith('.gz');
  return packed ? new Response(file.stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer() : file.arrayBuffer();
}

async function make_engine() {
  const [script, module] = await Promise.all([embedded('worker'), embedded('module')]);
  const address = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
  const engine = new Engine(new Worker(address));
  await engine.ask('start', { module }, null, [module]);
  return engine;
}

class Start {
  constructor(engine) {
    this.engine = engine;
    this.own = element('option', { value: 'own', hidden: true });
    const models = [...kModels, ['', 'Your own file …']].map(([value, textContent]) => element('option', { value, textContent }));
    by_id('play-model').append(...models, this.own);
    by_id('play-model').addEventListener('change', ({ target: { value } }) => (value ? this.open_model({ ...kFirst, model: value }) : by_id('play-file').click()));
    by_id('play-file').addEventListener('cancel', () => this.show_model());
    by_id('play-file').addEventListener('change', ({ target }) => {
      if (target.files[0]) this.open_file(target.files[0]);
      target.value = '';  // so that the same file can be chosen again
    });
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', (event) => {
      event.preventDefault();
      if (event.dataTransfer.files[0]) this.open_file(event.dataTransfer.files[0]);
    });
    addEventListener('hashchange', () => this.open_link());
  }

  open_link() {
    const models = kModels.map(([name]) => name), shows = kShows.map(([name]) => name);
    return this.open_model({ ...kFirst, ...parse_link(location.hash, models, shows) });
  }

  // A link that does not fit its model, as one of another version: the model is opened without it.
  async open_model({ camera, ...state }) {
    const open = (state, camera) => this.open(state.model, embedded(`model-${state.model}`), state, camera);
    const failed = await open(state, camera);
    if (!failed || this.playground) return;
    const again = await open({ ...kFirst, model: state.model });
    if (again) throw again;
    this.playground.controls.tell(failed.message);
  }

  async open_file(file) {
    await this.open(file.name, bytes_of(file), { ...kFirst, model: '' });
  }

  // An own file has an option of its own, so that another one can be chosen after it.
  show_model() {
    const { model } = this.playground.state;
    if (!model) Object.assign(this.own, { textContent: this.playground.opened.name, hidden: false });
    by_id('play-model').value = model || 'own';
  }

  // A mesh that can't be read or shown leaves what is there as it is. Returns the error, if any.
  async open(name, reading, state, camera) {
    document.documentElement.dataset.computing = 'true';
    try {
      const bytes = await reading;
      const { opened, scene } = await this.engine.ask('open', { name, bytes, state }, null, [bytes]);
      if (this.playground) this.playground.open(opened, state, scene);
      else this.playground = new Playground(this.engine, opened, state, scene);
      if (camera) this.playground.look_from(camera);
      this.playground.write_link();
      by_id('title').textContent = name;
      this.show_model();
      this.playground.controls.tell(opened.notes.join('\n'));
    } catch (error) {
      if (!this.playground) return error;
      this.playground.controls.tell(error.message);
      this.playground.write_link();
      this.show_model();
      return error;
    } finally {
      document.documentElement.dataset.computing = 'false';
    }
  }
}

async function start() {
  arrange_panels();
  try {
    await new Start(await make_engine()).open_link();
    document.documentElement.dataset.ready = 'true';
  } catch (error) {
    show_failure(`The page can't compute: ${error.message}`);
    throw error;
  } finally {
    by_id('loading').hidden = true;
  }
}

start();
