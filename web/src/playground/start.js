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
    by_id('play-model').append(...kModels.map(([value, textContent]) => element('option', { value, textContent })), element('option', { value: '', textContent: 'Your own file …' }));
    by_id('play-model').addEventListener('change', ({ target }) => (target.value ? this.open_model({ ...kFirst, model: target.value }) : by_id('play-file').click()));
    by_id('play-file').addEventListener('change', ({ target }) => target.files[0] && this.open_file(target.files[0]));
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

  async open_model({ camera, ...state }) {
    await this.open(state.model, embedded(`model-${state.model}`), state, camera);
  }

  async open_file(file) {
    await this.open(file.name, file.arrayBuffer(), { ...kFirst, model: '' });
  }

  // A mesh that can't be read leaves what is there as it is.
  async open(name, reading, state, camera) {
    document.documentElement.dataset.computing = 'true';
    try {
      const bytes = await reading;
      const { opened, scene } = await this.engine.ask('open', { name, bytes, state }, null, [bytes]);
      if (this.playground) this.playground.open(opened, state, scene);
      else this.playground = new Playground(this.engine, opened, state, scene);
      if (camera) this.playground.look_from(camera);
      by_id('title').textContent = name;
      by_id('play-model').value = state.model;
      this.playground.controls.tell(opened.notes.join('\n'));
    } catch (error) {
      if (!this.playground) throw error;
      this.playground.controls.tell(error.message);
      by_id('play-model').value = this.playground.state.model;
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
