// The pictures of figures 1 and 9 of the paper, from the pages that scripts/make_gallery.sh writes; pictures.mjs says what the
// fields are.

export const kWidth = 500;

const kShow = { generators: true, branch_points: true };
const upright = (name) => ({ name, page: name, size: [400, 400], show: kShow });

export const kPictures = ['lucy', 'kitten', 'bunny', 'bear', 'spot', 'elephant', 'fandisk', 'rocker_arm', 'figure'].map(upright);
