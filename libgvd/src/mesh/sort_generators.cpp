#include "mesh/sort_generators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "gvd/counted.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

void check_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  if (generators.empty()) throw Error(ErrorCode::precondition, "there is no generator; give at least one");
  for (std::size_t i = 0; i < generators.size(); ++i) {
    if (!generators[i].face.valid() || generators[i].face.value() >= mesh.face_count()) {
      throw Error(ErrorCode::precondition,
                  fmt::format("generator {} lies in face {}, and the mesh has {}", i, generators[i].face.value(),
                              counted(mesh.face_count(), "face", "faces")),
                  static_cast<std::int64_t>(i));
    }
  }
}

EdgeGenerator on_first_halfedge(const Mesh& mesh, const SurfacePoint& generator, GeneratorId g) {
  const SurfacePoint point = canonical(mesh, generator);
  const HalfedgeId h = halfedge(point);
  return {h, point.bary[Mesh::corner(Mesh::next(h))], g};
}

}  // namespace

SortedGenerators sort_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  check_generators(mesh, generators);
  SortedGenerators sorted;
  for (std::size_t i = 0; i < generators.size(); ++i) {
    const GeneratorId g(i);
    switch (generators[i].kind()) {
      case SurfacePoint::Kind::vertex:
        sorted.on_vertices.emplace_back(vertex(mesh, generators[i]), g);
        break;
      case SurfacePoint::Kind::edge:
        sorted.on_edges.push_back(on_first_halfedge(mesh, generators[i], g));
        break;
      case SurfacePoint::Kind::face:
        sorted.in_faces[generators[i].face].push_back(g);
        break;
    }
  }
  std::sort(sorted.on_edges.begin(), sorted.on_edges.end(), [](const EdgeGenerator& a, const EdgeGenerator& b) {
    return std::tuple(a.halfedge, a.t, a.generator) < std::tuple(b.halfedge, b.t, b.generator);
  });
  return sorted;
}

}  // namespace gvd
