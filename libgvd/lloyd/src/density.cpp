// Weights of the surface: given ones, and those out of a file.
//
// Files number the vertices and polygons that they hold; a checked mesh has lost some, has triangles for polygons, and
// may have new vertices where edges were split. CheckedMesh leads from each element to that of the file. An element
// that the file has no number for is an error, but for midpoints of split edges, which it can't know.
#include "gvd/density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse_density(const std::string& message) { throw Error(ErrorCode::unreadable_input, message); }

/// The value of each vertex of the mesh. The midpoint of a split edge, which the file does not know, takes the mean.
std::vector<double> to_vertices(const CheckedMesh& input, const std::vector<double>& values) {
  std::vector<double> of_mesh;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (const std::int32_t v : input.input_vertex) of_mesh.push_back(v < 0 ? mean : values[v]);
  return of_mesh;
}

std::int64_t least_polygons(const CheckedMesh& input) {
  return 1 + *std::max_element(input.input_polygon.begin(), input.input_polygon.end());
}

bool lost_polygons(const CheckedMesh& input) {
  return input.defects.count(DefectKind::degenerate_faces) + input.defects.count(DefectKind::duplicate_faces) +
             input.defects.count(DefectKind::dropped_components) >
         0;
}

Density make_density(const CheckedMesh& input, const SoupProperty& property, const std::string& name) {
  try {
    if (property.of_vertices) return make_vertex_density(input.mesh, to_vertices(input, property.values));
    std::vector<double> of_faces;
    for (const std::int32_t p : input.input_polygon) of_faces.push_back(property.values[p]);
    return make_face_density(input.mesh, of_faces);
  } catch (const Error& error) {
    throw Error(error.code(), name + ": " + error.what(), error.element());
  }
}

/// Refuses a property that some polygons lack: strips of triangles have none.
void check_count(const CheckedMesh& input, const SoupProperty& property, const std::string& name) {
  if (property.of_vertices || std::ssize(property.values) >= least_polygons(input)) return;
  refuse_density(fmt::format("{}: {} for {}", name, counted(std::ssize(property.values), "number", "numbers"),
                             counted(least_polygons(input), "polygon", "polygons")));
}

/// Whether a list has a number for each vertex of the input or for each of its polygons.
SoupProperty assign(const CheckedMesh& input, std::vector<double> values, const std::string& name) {
  const auto count = std::ssize(values);
  if (count == std::ssize(input.mesh_vertex)) return {true, std::move(values)};
  const std::int64_t polygons = least_polygons(input);
  if (count == polygons || (count > polygons && lost_polygons(input))) return {false, std::move(values)};
  refuse_density(fmt::format("{}: {}; give one for each vertex ({}) or each face ({})", name,
                             counted(count, "number", "numbers"), input.mesh_vertex.size(), polygons));
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

std::optional<Density> read_density(const CheckedMesh& input, const std::string& name,
                                    const std::filesystem::path& mesh_file) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) {
    return make_density(input, assign(input, read_values(name), name), name);
  }
  if (mesh_file.empty()) return std::nullopt;
  const std::optional<SoupProperty> property = read_soup_property(mesh_file, name);
  if (!property) return std::nullopt;
  const std::string title = fmt::format("{}: property {}", mesh_file.string(), name);
  check_count(input, *property, title);
  return make_density(input, *property, title);
}

void check_density(const Mesh& mesh, const Density& density) {
  if (density.is_uniform() || std::ssize(density.corners) == mesh.face_count()) return;
  throw Error(ErrorCode::precondition, "the density is not of this mesh: the number of faces differs");
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
