#include "common/relaxation/read_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

[[noreturn]] void refuse_density(const std::string& message) { throw Error(ErrorCode::unreadable_input, message); }

/// The value of each vertex of the mesh. The midpoint of a split edge, which the file does not know, takes the mean.
std::vector<double> to_vertices(const CheckedMesh& input, const std::vector<double>& values) {
  std::vector<double> of_mesh;
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (const std::int32_t v : input.input_vertex) {
    of_mesh.push_back(v < 0 ? mean : values[v]);
  }
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

}  // namespace

Density read_density(Run& run, const CheckedMesh& input, const ConstraintOptions& options) {
  const std::string& name = options.density;
  if (name.empty()) return {};
  if (name == "curvature") return make_curvature_density(input.mesh, {options.gradation});
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) {
    return make_density(input, assign(input, read_numbers(name), name), name);
  }
  const std::string& path = run.options().input.path;
  std::optional<SoupProperty> property = path == "-" ? std::nullopt : read_soup_property(path, name);
  if (property) {
    const std::string title = fmt::format("{}: property {}", path, name);
    check_count(input, *property, title);
    return make_density(input, *property, title);
  }
  refuse_density(fmt::format("--density {}: there is no such file, and {} has no such property", name,
                             path == "-" ? "standard input" : path));
}

}  // namespace gvd::app
