// The pictures of figures 1, 9, 10 and 11 of the paper, from the pages that scripts/make_gallery.sh writes; pictures.mjs says what the
// fields are.

export const kWidth = 500;

const kShow = { generators: true, branch_points: true };
const upright = (name) => ({ name, page: name, size: [400, 400], show: kShow });
const kGallery = ['lucy', 'kitten', 'bunny', 'bear', 'spot', 'elephant', 'fandisk', 'rocker_arm', 'figure'].map(upright);

// One picture for each scene of a page of gvd-compare. Branch points are off: comparators have none.
const scenes = (page, named, view = {}) =>
  named.map(([suffix, scene]) => ({
    name: `${page}_${suffix}`, page, scene, size: [400, 400], show: { generators: true, branch_points: false }, ...view,
  }));
const kZigZag = [['diffusion', 'diffusion [8]'], ['planar', 'gbgvd planar'], ['circle', 'gbgvd circle']];
const kStraight = [['rvd', 'RVD [29]'], ['lrvd', 'LRVD [28]'], ['planar', 'gbgvd planar'], ['exact', 'exact']];
const kClose = { zoom: 6, pan: { from: [200, 200], to: [200, 380] } };  // of Spot: its neck and head

export const kPictures = [
  ...kGallery,
  ...scenes('figure_10', kZigZag),
  ...scenes('figure_10', kZigZag, kClose).map((picture) => ({ ...picture, name: `${picture.name}_close` })),
  ...scenes('figure_11', kStraight),
  ...scenes('plate', kStraight),
];
