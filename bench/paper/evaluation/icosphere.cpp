#include "icosphere.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "list_faces.hpp"
#include "refine_flat.hpp"

namespace gvd::paper {
namespace {

Mesh make_icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const double g = golden;
  std::vector<Vec3> positions{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::array<std::array<int, 3>, 20> kFaces{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  std::vector<Corners> faces;
  for (const auto& [a, b, c] : kFaces) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return Mesh(std::move(positions), std::move(faces));
}

Mesh push_to_sphere(const Mesh& mesh) {
  std::vector<Vec3> positions = mesh.positions();
  for (Vec3& p : positions) p = p / p.norm();
  return Mesh(std::move(positions), list_faces(mesh));
}

}  // namespace

Mesh make_icosphere(int subdivisions) {
  Mesh sphere = push_to_sphere(make_icosahedron());
  for (int i = 0; i < subdivisions; ++i) sphere = push_to_sphere(bench::refine_flat(sphere));
  return sphere;
}

}  // namespace gvd::paper
