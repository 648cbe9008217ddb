#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd::test {

// A family of meshes, made here. Every function is deterministic; `n` is a resolution.

Mesh make_sphere(int subdivisions);               ///< icosphere of radius 1: 20 * 4^subdivisions faces
Mesh make_torus(int around, int across);          ///< radii 1 and 0.35
Mesh make_plate(int n, double thickness = 0.01);  ///< a closed thin box, 1 x 1 x thickness
Mesh make_grid(int nx, int ny);                   ///< a flat open rectangle nx x ny of unit squares, split in triangles
Mesh make_ring(int around, int across);           ///< an open cylinder of radius 1 and height 0.5: two boundary loops
Mesh make_half_sphere(int subdivisions);          ///< open, one boundary loop
Mesh make_bumpy_sphere(int subdivisions, unsigned seed);       ///< radius varied by seeded waves
Mesh make_thin_faced_sphere(int subdivisions, unsigned seed);  ///< stretched and jittered
Mesh make_genus3(int n);                                       ///< a slab with three square holes, closed, genus 3
Mesh make_two_components();                                    ///< a sphere and a torus side by side
Mesh make_nested_spheres(double inner_radius);                 ///< one of radius 1 round a smaller one

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

/// Small members of every family above: a few hundred faces each.
std::vector<NamedMesh> small_family();

}  // namespace gvd::test
