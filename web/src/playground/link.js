// The state of the playground as text behind the # of a link, and back.
//
// A state has the name of a shipped model, generators or the number of farthest ones, what is shown of them, and the
// camera. Generators are (face, second and third barycentric coordinate). They are rounded when they are dropped, so that
// a link holds them exactly.

const kDigits = 6;  // of barycentric coordinates

// Rounds barycentric coordinates to what a link holds. They stay >= 0 and add up to 1.
export function round_bary([, b, c]) {
  const round = (value) => Number(Math.min(Math.max(value, 0), 1).toFixed(kDigits));
  const [second, third] = [round(b), round(c)];
  const sum = second + third;
  return sum <= 1 ? [1 - sum, second, third] : [0, 1 - third, third];
}

const format_point = ({ face, bary }) => `${face}_${bary[1]}_${bary[2]}`;

function parse_point(text) {
  const [face, b, c] = text.split('_').map(Number);
  if (![face, b, c].every(Number.isFinite) || !Number.isInteger(face) || face < 0) return null;
  return { face, bary: round_bary([1 - b - c, b, c]) };
}

export function format_link({ model, count, generators, show, camera }) {
  const fields = { model, n: generators ? undefined : count, show, g: generators?.map(format_point).join('~'), camera: camera?.map((x) => Number(x.toPrecision(5))).join('_') };
  const used = Object.entries(fields).filter(([, value]) => value !== undefined && value !== '');
  return `#${used.map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join('&')}`;
}

// What a link holds, without what makes no sense; `models` and `shows` are the names that do.
export function parse_link(hash, models, shows) {
  const fields = new URLSearchParams(hash.replace(/^#/, '')), found = {};
  if (models.includes(fields.get('model'))) found.model = fields.get('model');
  if (shows.includes(fields.get('show'))) found.show = fields.get('show');
  const count = Number(fields.get('n'));
  if (Number.isInteger(count) && count > 0) found.count = count;
  const generators = fields.get('g')?.split('~').map(parse_point);
  if (generators?.length && generators.every(Boolean)) found.generators = generators;
  const camera = fields.get('camera')?.split('_').map(Number);
  if (camera?.length === 6 && camera.every(Number.isFinite)) found.camera = camera;
  return found;
}
