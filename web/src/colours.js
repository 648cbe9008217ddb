// Colours: the regions', and those of the marks on them for light and dark pages.
import { Color, DataTexture, FloatType, RedFormat, RGBAFormat, SRGBColorSpace, UnsignedByteType } from 'three';
import { read_array } from './data.js';
import { ramp } from './ramp.js';

export const kTextureWidth = 256;
export const kLatticeWidth = 1024;

export const kUnlabelled = new Color('#c3d5e3');
export const kUnreachedFill = [156, 154, 151];  // kUnlabelledColor of gvd/io/label_color.hpp

// Added generators are red, brighter than any region. Their lightness differs from that of given generators too, so
// they differ without hue.
export const kThemes = {
  light: {
    page: '#eceeee',
    line: '#20262e',
    isoline: '#ffffff',
    path: '#e8112d',
    wire: '#20262e',
    light_wire: '#ffffff',
    overlay: '#5b6470',
    generator: '#20262e',
    added_generator: '#e8112d',
    branch_point: '#ffffff',
  },
  dark: {
    page: '#15181c',
    line: '#f4f2ea',
    isoline: '#ffffff',
    path: '#ff4b5c',
    wire: '#0b0d10',
    light_wire: '#ffffff',
    overlay: '#c3ccd6',
    generator: '#fffaf0',
    added_generator: '#ff3b30',
    branch_point: '#20262e',
  },
};

// The colours of the regions, [red, green, blue] for each label.
export function read_fills(entry) {
  const channels = read_array(entry.fills);
  return Array.from({ length: channels.length / 3 }, (_, g) => Array.from(channels.subarray(3 * g, 3 * g + 3)));
}

function make_texture(fills, width) {
  const rows = Math.ceil(fills.length / width);
  const texels = new Uint8Array(4 * width * rows);
  fills.forEach((fill, i) => texels.set([...fill, 255], 4 * i));
  const texture = new DataTexture(texels, width, rows, RGBAFormat, UnsignedByteType);
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

// The colours by code, as a texture for the surface's shader: unreached, cut (never read), then the labels.
export function fill_texture(fills) {
  return make_texture([kUnreachedFill, kUnreachedFill, ...fills], kTextureWidth);
}

// The colours of values, low to high.
export function ramp_texture() {
  return make_texture(Array.from({ length: 256 }, (_, i) => ramp(i / 255)), 256);
}

// The distances on the lattices of a SurfaceDistance, as shares of its scale.
export function lattice_texture({ lattice, scale_end }) {
  const rows = Math.max(1, Math.ceil(lattice.length / kLatticeWidth)), texels = new Float32Array(kLatticeWidth * rows);
  lattice.forEach((distance, i) => (texels[i] = distance / scale_end));
  const texture = new DataTexture(texels, kLatticeWidth, rows, RedFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}
