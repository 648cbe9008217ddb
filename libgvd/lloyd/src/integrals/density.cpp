#include "gvd/density.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

void check_values(const std::vector<double>& values, std::int64_t wanted, const char* one, const char* many) {
  if (std::ssize(values) != wanted) {
    throw Error(ErrorCode::precondition,
                fmt::format("the density has {}, and the mesh {}", counted(std::ssize(values), "value", "values"),
                            counted(wanted, one, many)));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > 0 && std::isfinite(values[i])) continue;
    throw Error(ErrorCode::precondition,
                fmt::format("the density of {} {} is {}; give finite numbers above 0", one, i, values[i]),
                static_cast<std::int64_t>(i));
  }
}

}  // namespace

void check_density(const Mesh& mesh, const Density& density) {
  if (density.is_uniform() || std::ssize(density.corners) == mesh.face_count()) return;
  throw Error(ErrorCode::precondition, "the density is not of this mesh: the number of faces differs");
}

Density make_vertex_density(const Mesh& mesh, const std::vector<double>& values) {
  check_values(values, mesh.vertex_count(), "vertex", "vertices");
  Density density;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    density.corners.push_back({values[a.index()], values[b.index()], values[c.index()]});
  }
  return density;
}

Density make_face_density(const Mesh& mesh, const std::vector<double>& values) {
  check_values(values, mesh.face_count(), "face", "faces");
  Density density;
  for (const double value : values) density.corners.push_back({value, value, value});
  return density;
}

}  // namespace gvd
