// The colours of values, low to high: viridis (Smith and van der Walt 2015, CC0), whose lightness rises evenly, so that
// the colour-blind can read it too.

const kStops = ['440154', '472d7b', '3b528b', '2c728e', '21918c', '28ae80', '5ec962', 'addc30', 'fde725'].map((hex) =>
  [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)),
);

// [red, green, blue] from 0 to 255 of a value from 0 to 1.
export function ramp(t) {
  const at = Math.min(Math.max(t, 0), 1) * (kStops.length - 1);
  const low = Math.min(Math.floor(at), kStops.length - 2);
  return kStops[low].map((channel, i) => Math.round(channel + (at - low) * (kStops[low + 1][i] - channel)));
}

// The ramp as a gradient of CSS, from left to right.
export function ramp_gradient() {
  return `linear-gradient(to right, ${kStops.map((stop) => `rgb(${stop})`).join(', ')})`;
}
