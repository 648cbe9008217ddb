// The pictures of the documents: which page of the viewer each one shows, and how.
//
//   name        the file, without .webp
//   page        the page that scripts/make_pictures.sh writes, without .html
//   size        of the window in CSS pixels. The picture is about kWidth wide. Marks have a fixed size in CSS
//               pixels or less, so a larger window makes them smaller
//   scene       the text of a scene's button
//   turn        number of presses of arrow keys; zoom: of the key +
//   pan         a right-drag, `from` and `to` in CSS pixels; hover: where the pointer rests
//   show        switches of the page, by key; colour: what the surface is coloured by
//   whole_page  the page's panels are in the picture too

export const kWidth = 800;

const kSmall = [400, 320];
const kLarge = [600, 480];
const kClose = {
  size: kSmall,
  zoom: 17,
  pan: { from: [240, 163], to: [200, 160] },
  show: { wireframe: true, generators: false, shadow: false },
};
const kNoBranchPoints = { branch_points: false };
const kPlain = { colour: 'plain', show: { generators: false, overlay: false } };
const kError = { colour: 'surface_distance' };
const kDistances = { colour: 'distance', show: { lines: true, branch_points: false } };

export const kPictures = [
  { name: 'segments', page: 'segments', size: kSmall },
  { name: 'samples', page: 'samples', size: kLarge, show: kNoBranchPoints },
  { name: 'coarse', page: 'coarse', size: kLarge, ...kPlain },
  { name: 'task_parcels', page: 'task_parcels', size: kSmall, show: kNoBranchPoints },
  { name: 'task_samples', page: 'task_samples', size: kSmall, zoom: -1, turn: { right: 7 }, show: kNoBranchPoints },
  { name: 'task_simulation', page: 'task_simulation', size: kSmall, ...kPlain },
  { name: 'task_measure', page: 'task_measure', size: kSmall, turn: { right: 12 } },
  { name: 'unplaced', page: 'coarse', scene: 'Before placement', size: kSmall, ...kError },
  { name: 'remesh', page: 'coarse', scene: 'Remesh', size: kSmall, ...kError },
  { name: 'distances', page: 'segments', size: kSmall, ...kDistances },
  { name: 'bisectors', page: 'segments', ...kClose },
  { name: 'cut', page: 'cut', ...kClose },
  { name: 'farthest', page: 'farthest', size: kSmall, show: kNoBranchPoints },
  { name: 'poisson', page: 'poisson', size: kSmall, show: kNoBranchPoints },
  { name: 'random', page: 'relaxed', scene: 'Start', size: kSmall, show: kNoBranchPoints },
  { name: 'relaxed', page: 'relaxed', scene: 'Relaxed', size: kSmall, show: kNoBranchPoints },
  { name: 'open', page: 'open', size: kSmall, zoom: -1, turn: { right: 10 } },
  { name: 'open_coarse', page: 'open_coarse', size: kSmall, zoom: -1, turn: { right: 10 }, ...kPlain },
  { name: 'isolines', page: 'isolines', size: kSmall },
  { name: 'gallery_equal', page: 'gallery_equal', size: kSmall },
  { name: 'gallery_levels', page: 'gallery_levels', size: kSmall, show: kNoBranchPoints },
  { name: 'gallery_discs', page: 'gallery_discs', size: kSmall },
  { name: 'gallery_bands', page: 'gallery_bands', size: kSmall, show: kNoBranchPoints },
  { name: 'gallery_torus', page: 'gallery_torus', size: kSmall, zoom: -1 },
  { name: 'gallery_torus_samples', page: 'gallery_torus_samples', size: kSmall, zoom: -1, show: kNoBranchPoints },
  { name: 'gallery_box', page: 'gallery_box', size: kSmall, ...kPlain },
  { name: 'gallery_curvature', page: 'gallery_curvature', size: kSmall, ...kPlain },
  { name: 'viewer', page: 'segments', size: [1000, 620], hover: [420, 330], whole_page: true },
];
