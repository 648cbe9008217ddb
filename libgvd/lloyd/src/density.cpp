// Weights of the surface: given ones, those out of a file, and those for cells whose size follows the radius of
// curvature.
//
// Files number the vertices and polygons that they hold; a checked mesh has lost some, has triangles for polygons, and
// may have new vertices where edges were split. CheckedMesh leads from each element to that of the file. An element
// that the file has no number for is an error, but for midpoints of split edges, which it can't know. Curvature is
// estimated on the edges (G. Taubin, Estimating the tensor of curvature of a surface from a polyhedral approximation,
// 1995), and averaged over rings. Sizes are its inverse, limited to a range, and then lowered until no size exceeds a
// neighbour's by more than the gradation allows. Cells of a minimum of the energy have sizes that go with
// density^(-1/4), so the density is size^-4. Sizes are relative to the smallest one: units of the mesh cancel.
#include "gvd/density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"
#include "mesh/vertex_ring.hpp"

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

using VertexValues = IdVector<VertexId, double>;

/// Share of the vertices whose size may be below the range: a few corners must not decide about all others.
constexpr double kBelowRange = 0.05;

/// The largest curvature of the edges at each vertex.
VertexValues largest_curvatures(const Mesh& mesh) {
  IdVector<VertexId, Vec3> normal;
  for (const VertexId v : mesh.vertices()) normal.push_back(surface_normal(mesh, vertex_point(mesh, v)));
  VertexValues curvature(normal.size(), 0);
  for (const VertexId v : mesh.vertices()) {
    for_each_neighbour(mesh, v, [&](VertexId w, HalfedgeId) {
      const Vec3 way = mesh.position(w) - mesh.position(v);
      const double of_edge = std::abs((normal[w] - normal[v]).dot(way)) / way.squaredNorm();
      if (std::isfinite(of_edge)) curvature[v] = std::max(curvature[v], of_edge);
    });
  }
  return curvature;
}

VertexValues averaged_over_rings(const Mesh& mesh, const VertexValues& values) {
  VertexValues means;
  for (const VertexId v : mesh.vertices()) {
    double sum = values[v];
    int count = 1;
    for_each_neighbour(mesh, v, [&](VertexId w, HalfedgeId) {
      sum += values[w];
      ++count;
    });
    means.push_back(sum / count);
  }
  return means;
}

/// The inverse curvatures within the range; all are 1 on a flat surface.
VertexValues sizes_in_range(const VertexValues& curvature, double range) {
  std::vector<double> sorted(curvature.begin(), curvature.end());
  const auto at = static_cast<std::ptrdiff_t>((1 - kBelowRange) * double(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  const double largest = sorted[at];
  VertexValues sizes;
  for (const double c : curvature) {
    sizes.push_back(largest > 0 ? largest / std::clamp(c, largest / range, largest) : 1);
  }
  return sizes;
}

/// Lowers sizes, as Dijkstra's algorithm lowers distances, until none exceeds a neighbour's by more than the gradation.
void limit_gradation(const Mesh& mesh, double gradation, VertexValues& sizes) {
  using Item = std::pair<double, VertexId>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const VertexId v : mesh.vertices()) queue.emplace(sizes[v], v);
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > sizes[v]) continue;
    for_each_neighbour(mesh, v, [&, size = size](VertexId w, HalfedgeId h) {
      const double most = size + gradation * mesh.length(h);
      if (!(most < sizes[w])) return;
      sizes[w] = most;
      queue.emplace(most, w);
    });
  }
}

}  // namespace

std::optional<Density> read_density(const CheckedMesh& input, const std::string& name,
                                    const std::filesystem::path& mesh_file) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(name, ignored)) {
    return make_density(input, assign(input, read_numbers(name), name), name);
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

Density make_curvature_density(const Mesh& mesh, const CurvatureDensityOptions& options) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::invalid_option, message); };
  if (!(options.gradation > 0) || !std::isfinite(options.gradation)) refuse("the gradation must be above 0");
  if (!(options.range >= 1) || !std::isfinite(options.range)) refuse("the range of sizes must be 1 or more");
  const VertexValues curvature = averaged_over_rings(mesh, largest_curvatures(mesh));
  VertexValues sizes = sizes_in_range(curvature, options.range);
  // A size of 1 is the smallest radius of curvature. In mesh units, a size grows by `gradation` per length.
  const double smallest = 1 / *std::max_element(curvature.begin(), curvature.end());
  if (std::isfinite(smallest)) limit_gradation(mesh, options.gradation / smallest, sizes);
  std::vector<double> values;
  for (const double size : sizes) values.push_back(std::pow(size, -4));
  return make_vertex_density(mesh, values);
}

}  // namespace gvd
