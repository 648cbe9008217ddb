// What the page saves: pictures, curves and a film of a whole turn.
import { animate_webp } from './animated_webp.js';
import { kThemes } from './colours.js';
import { curves_svg } from './curves_svg.js';
import { read_array } from './data.js';
import { draw_legend } from './legend.js';
import { kMarkWidths } from './marks.js';
import { by_id, show_failure } from './panel.js';
import { encode_canvas, file_name, fill_behind, save_blob } from './save_picture.js';

const kFrames = 90, kFramePause = 50;  // of a turn, milliseconds
const kFilmSide = 640;                 // longest side of the film, pixels
const kFilmQuality = 0.85;
const kSvgRatio = 2;                   // pixels of the surface in SVG, for each of the screen
const kLargestSide = 8192;             // pixels, what every WebGL device can draw

export class Pictures {
  constructor(viewer) {
    this.viewer = viewer;
    by_id('save').addEventListener('click', () => this.save_png(Math.max(2, viewer.stage.ratio), false));
    by_id('save-png').addEventListener('click', () => this.save_png(Number(by_id('picture-size').value), this.clear()));
    by_id('save-svg').addEventListener('click', () => this.save_svg());
    by_id('save-film').addEventListener('click', () => this.save_film());
  }

  clear() {
    return by_id('clear-ground').checked;
  }

  theme() {
    return kThemes[matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'];
  }

  name(ending) {
    return file_name(this.viewer.manifest.title, ending);
  }

  // The picture with its legend, `ratio` times as large as on the page.
  async save_png(ratio, clear) {
    const { stage, picture, colour } = this.viewer, fitting = Math.min(ratio, kLargestSide / Math.max(stage.width, stage.height));
    const canvas = stage.take_picture(fitting), range = picture.range(colour);
    stage.end_pictures();
    const legend = { title: this.viewer.legend_title(), range, exceeded: picture.exceeds(colour), ink: this.theme().line };
    if (range) draw_legend(canvas, fitting, legend);
    if (!clear) fill_behind(canvas, this.theme().page);
    save_blob(await encode_canvas(canvas, 'image/png'), this.name('png'));
  }

  // Curves and dots as paths, over a picture of the surface without them.
  save_svg() {
    const { stage, id_map, picture } = this.viewer;
    const shown = Object.entries(picture.marks).filter(([name, mark]) => mark?.visible && name !== 'shadow');
    for (const [, mark] of shown) mark.visible = false;
    const surface = stage.take_picture(kSvgRatio).toDataURL('image/png');
    for (const [, mark] of shown) mark.visible = true;
    id_map.invalidate();
    id_map.update(picture.mesh);
    const svg = curves_svg(stage, id_map, { surface, ...this.vector_marks(shown.map(([name]) => name)) });
    id_map.invalidate();
    stage.end_pictures();
    save_blob(new Blob([svg], { type: 'image/svg+xml' }), this.name('svg'));
  }

  // The lines and dots of the marks that are shown, as curves_svg takes them.
  vector_marks(shown) {
    const { stage, picture, materials } = this.viewer, { entry, dot_sizes } = picture, theme = this.theme();
    const arrays = ({ points, counts }) => ({ points: read_array(points), counts: read_array(counts) });
    const line = (name, colour, width) => ({ name, ...arrays(entry[name]), colour, width });
    const radius = (size) => (size * stage.pixels_per_unit()) / 2;
    const dot = (name, size, fill, ring) => ({ name, points: read_array(entry[name]), radius: radius(size), fill, ring });
    const made = (make, ...list) => list.filter(([name]) => shown.includes(name)).map((parts) => make(...parts));
    return {
      lines: made(
        line,
        ['bisectors', theme.line, materials.line.uniforms.width.value],
        ['borders', theme.line, kMarkWidths.borders],
        ['isolines', theme.isoline, kMarkWidths.isolines],
        ['paths', theme.path, kMarkWidths.paths],
      ),
      dots: made(
        dot,
        ['branch_points', dot_sizes.branch_point, theme.branch_point, theme.generator],
        ['generators', dot_sizes.generator, theme.generator, theme.branch_point],
        ['added_generators', dot_sizes.generator, theme.added_generator, theme.branch_point],
      ),
    };
  }

  // Pictures of a whole turn, one after the other, so that the page stays usable.
  async save_film() {
    const { stage } = this.viewer, ratio = Math.min(1, kFilmSide / Math.max(stage.width, stage.height)), bar = by_id('film-progress');
    const stills = [], clear = this.clear();
    let canvas;
    bar.hidden = false;
    for (let i = 0; i < kFrames; ++i) {
      canvas = stage.take_picture(ratio, (-2 * Math.PI * i) / kFrames);
      if (!clear) fill_behind(canvas, this.theme().page);
      const still = await encode_canvas(canvas, 'image/webp', kFilmQuality);
      if (still.type !== 'image/webp') break;
      stills.push(new Uint8Array(await still.arrayBuffer()));
      bar.value = (i + 1) / kFrames;
    }
    bar.hidden = true;
    stage.end_pictures();
    if (stills.length < kFrames) return show_failure("This browser can't write WebP.");
    const film = animate_webp(stills, { width: canvas.width, height: canvas.height, pause: kFramePause });
    save_blob(new Blob([film], { type: 'image/webp' }), this.name('webp'));
  }
}
