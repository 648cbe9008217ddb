// The text beside the picture: switches, figures, and the card of the region under the pointer.

// The meaning of figures, by their names.
const kWords = {
  'Euler characteristic': 'Vertices - edges + faces: 2 for a closed surface like a sphere, 2 less for each handle, 1 less for each hole.',
  'Euler count': 'Branch points found, of those that the topology of the surface and its regions demands. Equal: no bisector is missing.',
  'Disc regions': 'Regions in one piece and without holes. Others reach round a handle or meet themselves.',
  'Branch points': 'Where three or more regions meet: points with three or more nearest generators.',
  Bisectors: 'Curves between two regions: points with two nearest generators.',
  Energy: 'The integral of the squared distance to the generator: the smaller, the more compact.',
  Q: 'Quality of triangles: 1 for an equilateral one, 0 for one without area.',
  'Regular vertices': 'Vertices with 6 edges, or 4 on the boundary.',
};

export const by_id = (id) => document.getElementById(id);

export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// The text with commas between thousands, but for digits after a point.
export const group_digits = (text) => String(text).replace(/(?<![.\d])\d{4,}/g, (digits) => Number(digits).toLocaleString('en-US'));

// Six significant digits, without trailing zeros.
export function format_number(value) {
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size >= 1e-4 && size < 1e7 ? group_digits(Number(value.toPrecision(6))) : value.toExponential(4);
}

// A share in percent: one digit after the point, or two significant ones.
export function format_share(share) {
  const percent = 100 * share;
  return percent >= 1 ? percent.toFixed(1) : String(Number(percent.toPrecision(2)));
}

// The row of a figure. If there is a text about it, a click on its name shows that in a row below.
function make_rows([name, value]) {
  const words = kWords[name.replace(/,.*/, '')], head = element('th', { scope: 'row' }, name);
  const row = element('tr', {}, head, element('td', { textContent: value }));
  if (!words) return [row];
  const button = element('button', { type: 'button', textContent: name, title: words, ariaExpanded: 'false' });
  const text = element('tr', { className: 'words', hidden: true }, element('td', { colSpan: 2, textContent: words }));
  button.addEventListener('click', () => (button.ariaExpanded = String(!(text.hidden = !text.hidden))));
  head.replaceChildren(button);
  return [row, text];
}

const fill_rows = (body, rows) => body.replaceChildren(...rows.flatMap(make_rows));

// The buttons that choose a scene, if there are several. Scenes of iterations without a name have none: the slider
// chooses them. Calls `choose` with the scene's index. Returns a function that marks the button of a scene, if any.
export function make_scene_switch(scenes, choose) {
  const box = by_id('scenes');
  const inputs = scenes.map((scene, i) => {
    if (!scene.name && Number.isInteger(scene.iteration)) return null;
    const input = element('input', { type: 'radio', name: 'scene', value: String(i) });
    input.addEventListener('change', () => choose(i));
    box.append(element('label', {}, input, scene.name || `Picture ${i + 1}`));
    return input;
  });
  box.hidden = inputs.filter(Boolean).length < 2;
  return (chosen) => inputs.forEach((input, i) => input && (input.checked = i === chosen));
}

// The indices of the scenes that have an iteration, in its order.
export function order_by_iteration(scenes) {
  const order = [...scenes.keys()].filter((i) => Number.isInteger(scenes[i].iteration));
  return order.sort((a, b) => scenes[a].iteration - scenes[b].iteration);
}

// The slider over the scenes that have an iteration, if there are several. Calls `choose` with the scene's index.
// Returns a function that sets the slider to a scene.
export function make_iteration_slider(scenes, choose) {
  const order = order_by_iteration(scenes), box = by_id('iterations');
  const input = box.querySelector('input'), text = box.querySelector('output');
  box.hidden = order.length < 2;
  input.max = String(Math.max(0, order.length - 1));
  input.addEventListener('input', () => choose(order[Number(input.value)]));
  return (chosen) => {
    const at = order.indexOf(chosen);
    if (at < 0) return;
    input.value = String(at);
    text.textContent = `Iteration ${scenes[chosen].iteration} of ${scenes[order.at(-1)].iteration}`;
    input.setAttribute('aria-valuetext', text.textContent);
  };
}

// The ways of colouring [key, text], of which the scene offers some. Calls `change` with the key. Returns the options by
// key.
export function make_colour_choice(entries, change) {
  const options = {}, select = by_id('colour');
  for (const [value, textContent] of entries) select.append((options[value] = element('option', { value, textContent })));
  select.addEventListener('change', () => change(select.value));
  return options;
}

// One checkbox for each [key, text]. Calls `change` with the key and whether it is on. Returns by key the row, its
// input, and the elements for its text and for the number of dots.
export function make_toggles(entries, change) {
  const inputs = {};
  for (const [key, text] of entries) {
    const input = element('input', { type: 'checkbox', id: `toggle-${key}` });
    input.addEventListener('change', () => change(key, input.checked));
    const name = element('span', { textContent: text }), count = element('small');
    const row = element('label', {}, input, name, count);
    by_id('toggles').append(row);
    inputs[key] = { row, input, text: name, count };
  }
  return inputs;
}

export function show_figures(figures) {
  by_id('figures').hidden = figures.length === 0;
  fill_rows(by_id('figures').querySelector('tbody'), figures.map(([name, value]) => [name, group_digits(value)]));
}

// The first neighbours, and the number of the others.
function list_neighbours(neighbours) {
  const kShown = 12;
  if (neighbours.length === 0) return 'none';
  const shown = neighbours.slice(0, kShown).join(', ');
  return neighbours.length > kShown ? `${shown} and ${neighbours.length - kShown} more` : shown;
}

// The card `id` with a title, a swatch of `colour` if there is one, and rows [name, value].
export function show_card(id, { title, colour = null, rows }) {
  const card = by_id(id), heading = [title];
  card.hidden = false;
  if (colour) {
    heading.unshift(element('i'));
    heading[0].style.background = colour;
  }
  card.querySelector('strong').replaceChildren(...heading);
  fill_rows(card.querySelector('tbody'), rows);
}

// The card `id` of a region: {label, colour, cell, share, distance}; hides it where `region` is null.
export function show_region(id, region) {
  by_id(id).hidden = !region;
  if (!region) return;
  const rows = [];
  if (region.cell) {
    const share = region.share > 0 ? ` (${format_share(region.share)}\u00a0%)` : '';
    rows.push(['Area', format_number(region.cell.area) + share]);
    if (Number.isFinite(region.cell.energy)) rows.push(['Energy', format_number(region.cell.energy)]);
    rows.push(['Neighbours', list_neighbours(region.cell.neighbours)]);
    if (region.cell.euler_characteristic !== 1) rows.push(['Euler characteristic', region.cell.euler_characteristic]);
  }
  if (region.distance !== null) rows.push(['Distance here', region.distance]);
  const title = region.label === null ? 'No generator reaches this' : `Region ${region.label}`;
  show_card(id, { title, colour: region.colour, rows });
}

export function show_failure(text) {
  by_id('failure').textContent = text;
  by_id('failure').hidden = false;
}
