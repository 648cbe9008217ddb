// Calm colours: the regions', and those of the marks on them for light and dark pages.
import { Color, DataTexture, RGBAFormat, SRGBColorSpace, UnsignedByteType } from 'three';

export const kTextureWidth = 256;

// Sixteen fills: eight hues round the circle of OKLCH, in a lighter tone (0.84, 0.075) and a deeper one (0.71, 0.09).
const kHues = 8;
const kFills = [
  '#f8b8b2', '#f0c099', '#dacb93', '#b1d7a9', '#91dbd1', '#9ad3f5', '#c0c6fb', '#eab9de',
  '#d48b85', '#cb9467', '#b3a15e', '#83b07a', '#57b4a9', '#66abd2', '#969bd9', '#c58cb8',
].map((hex) => new Color(hex));
const kStride = 5;          // from one label's first choice to the next one's: far apart, and prime to the 16
const kWellApart = 2;       // steps of hue; more is not better

export const kUnlabelled = new Color('#c9d1d8');
const kUnreachedFill = new Color('#8d8f92');

export const kThemes = {
  light: { page: '#f3f4f2', line: '#20262e', wire: '#20262e', generator: '#20262e', branch_point: '#ffffff' },
  dark: { page: '#15181c', line: '#f4f2ea', wire: '#0b0d10', generator: '#fffaf0', branch_point: '#20262e' },
};

// How far two fills are apart, in steps of hue; another tone counts half a step.
function difference(i, j) {
  const steps = Math.abs((i % kHues) - (j % kHues));
  return Math.min(steps, kHues - steps) + (Math.floor(i / kHues) === Math.floor(j / kHues) ? 0 : 0.5);
}

// A fill for each cell: the one furthest from those that its neighbours already have, ties by a rotating order.
export function region_fills(cells, label_count) {
  const chosen = [];
  for (let g = 0; g < label_count; ++g) {
    const taken = (cells[g]?.neighbours ?? []).filter((other) => other < g).map((other) => chosen[other]);
    let best = 0, best_gap = -1;
    for (let k = 0; k < kFills.length; ++k) {
      const fill = (kStride * g + k) % kFills.length;
      const gap = Math.min(kWellApart, ...taken.map((other) => difference(fill, other)));
      if (gap > best_gap) [best, best_gap] = [fill, gap];
    }
    chosen.push(best);
  }
  return chosen.map((fill) => kFills[fill]);
}

// Texture that the surface's shader reads a code's colour from: unreached, cut (never read), then the labels.
export function fill_texture(fills) {
  const rows = Math.ceil((fills.length + 2) / kTextureWidth);
  const texels = new Uint8Array(4 * kTextureWidth * rows);
  [kUnreachedFill, kUnreachedFill, ...fills].forEach((fill, i) => {
    const hex = fill.getHex(SRGBColorSpace);
    texels.set([hex >> 16, (hex >> 8) & 255, hex & 255, 255], 4 * i);
  });
  const texture = new DataTexture(texels, kTextureWidth, rows, RGBAFormat, UnsignedByteType);
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}
