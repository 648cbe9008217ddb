// Makes densities of given values and of files.
//
// CheckedMesh maps each element to an element of the file. An element for which the file has no number is an error,
// except midpoints of split edges, which the file can't have.
#include "gvd/density.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// The value of each vertex of the mesh. The midpoint of a split edge, which the file does not have, gets the mean.
std::vector<double> to_vertices(const CheckedMesh& input, const std::vector<double>& values) {
  std::vector<double> of_mesh;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (const std::int32_t v : input.input_vertex) of_mesh.push_back(v < 0 ? mean : values[v]);
  return of_mesh;
}

void check_values(const std::vector<double>& values, std::int64_t wanted, const char* one, const char* many) {
  if (std::ssize(values) != wanted) {
    throw Error(ErrorCode::precondition,
                fmt::format("the density has {}, and the mesh {}", counted(std::ssize(values), "value", "values"),
                            counted(wanted, one, many)));
  }
  for (int i = 0; i < std::ssize(values); ++i) {
    if (values[i] > 0 && std::isfinite(values[i])) continue;
    throw Error(ErrorCode::precondition,
                fmt::format("the density of {} {} is {}; give finite numbers above 0", one, i, values[i]), i);
  }
}

}  // namespace

Density make_density(const CheckedMesh& input, const ElementValues& given) {
  const SoupProperty& property = given.soup;
  try {
    if (given.of_mesh) {
      return property.of_vertices ? make_vertex_density(input.mesh, property.values)
                                  : make_face_density(input.mesh, property.values);
    }
    if (property.of_vertices) return make_vertex_density(input.mesh, to_vertices(input, property.values));
    std::vector<double> of_faces;
    for (const std::int32_t p : input.input_polygon) of_faces.push_back(property.values[p]);
    return make_face_density(input.mesh, of_faces);
  } catch (const Error& error) {
    throw error.at(given.title);
  }
}

std::optional<Density> read_density(const CheckedMesh& input, const std::string& name,
                                    const std::filesystem::path& mesh_file) {
  const std::optional<ElementValues> values = read_element_values(input, name, mesh_file);
  return values ? std::optional(make_density(input, *values)) : std::nullopt;
}

void check_density(const Mesh& mesh, const Density& density) {
  if (density.is_uniform() || std::ssize(density.corners) == mesh.face_count()) return;
  throw Error(ErrorCode::precondition, "the density belongs to another mesh: the number of faces differs");
}

Density make_vertex_density(const Mesh& mesh, const std::vector<double>& values) {
  check_values(values, mesh.vertex_count(), "vertex", "vertices");
  Density density;
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
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
