// Another surface, drawn translucent over that of the scene.
import { Mesh } from 'three';
import { make_geometry, make_surface } from './surface.js';

// `entry`: {name, positions, faces} of the manifest.
export function make_overlay(entry, material) {
  const overlay = new Mesh(make_geometry(make_surface(entry).triangles), material);
  overlay.renderOrder = 0.5;  // after the surface, before its edges and dots, which it would dim
  return overlay;
}
