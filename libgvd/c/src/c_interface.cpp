// The functions of the C interface for programs written by hand. To compute, they call an operation, as gvd_call does,
// with a few of its options, and copy the results out of its arrays. Only gvd_distances calls the library directly,
// because the operation would also keep the data for paths.
//
// Arguments are checked where C++ types would rule a mistake out: null pointers, faces out of range, barycentric
// coordinates.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/diagram.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/gvd.h"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "gvd/version.hpp"
#include "handles.hpp"

namespace {

using namespace gvd;

using namespace gvd::c;

using Json = nlohmann::ordered_json;

}  // namespace

struct gvd_path {
  std::shared_ptr<const gvd::DistancesOutcome> found;  // distances with a single path
  const gvd::GeodesicPath& path() const { return found->table.paths.front().path; }
};

namespace {

/// Converts and checks a point. `element`: its index in a list, for errors.
SurfacePoint to_point(const Mesh& mesh, const gvd_point& point, std::int64_t element = 0) {
  try {
    if (point.face < 0 || point.face >= mesh.face_count()) {
      throw Error(ErrorCode::precondition, "a point has face " + std::to_string(point.face) + ", and the mesh has " +
                                               std::to_string(mesh.face_count()) + " faces");
    }
    return restore_surface_point(FaceId(point.face), {point.bary[0], point.bary[1], point.bary[2]});
  } catch (const Error& error) {
    throw Error(error.code(), error.text(), element);
  }
}

std::vector<SurfacePoint> to_points(const Mesh& mesh, const gvd_point* points, std::int32_t count) {
  if (count < 1) refuse("count is " + std::to_string(count) + "; give at least 1");
  std::vector<SurfacePoint> made;
  for (std::int32_t i = 0; i < count; ++i) made.push_back(to_point(mesh, (&given(points, "points"))[i], i));
  return made;
}

/// Converts points to rows for options of operations: a face and three barycentric coordinates.
std::vector<std::array<double, 4>> to_rows(const Mesh& mesh, const gvd_point* points, std::int32_t count) {
  std::vector<std::array<double, 4>> rows;
  for (const SurfacePoint& p : to_points(mesh, points, count)) {
    rows.push_back({double(p.face.value()), p.bary[0], p.bary[1], p.bary[2]});
  }
  return rows;
}

gvd_point to_c(const SurfacePoint& point) {
  return {point.face.value(), {point.bary[0], point.bary[1], point.bary[2]}};
}

void copy_points(const std::vector<SurfacePoint>& points, gvd_point* out) {
  std::transform(points.begin(), points.end(), out, to_c);
}

template <class T>
T number_at(const ArrayView& view, std::int64_t row, std::int64_t column = 0) {
  return *reinterpret_cast<const T*>(static_cast<const std::byte*>(view.data) + row * view.strides[0] +
                                     column * view.strides[1]);
}

/// Copies an array of an object, whose numbers must have the type T.
template <class T>
void copy_array(const gvd_object& from, const char* name, T* out) {
  const ArrayView view = from.views().arrays.at(name)();
  for (std::int64_t i = 0; i < view.shape[0]; ++i) out[i] = number_at<T>(view, i);
}

/// Copies a list of points of an object.
std::vector<gvd_point> points_of(const gvd_object& from, const std::string& name) {
  const ArrayView faces = from.views().arrays.at(name + "_faces")(), bary = from.views().arrays.at(name + "_bary")();
  std::vector<gvd_point> points;
  for (std::int64_t i = 0; i < faces.shape[0]; ++i) {
    const auto at = [&](std::int64_t column) { return number_at<double>(bary, i, column); };
    points.push_back({number_at<std::int32_t>(faces, i), {at(0), at(1), at(2)}});
  }
  return points;
}

/// A number as a string, because JSON has no infinity.
Json to_json(double number) { return fmt::format("{}", number); }

/// Makes the options for generators, which are listed in array 0 or sampled.
Json generator_options(bool are_listed, std::int32_t count, gvd_sampling kind, std::uint64_t seed) {
  if (are_listed) return {{"generators", {{"array", 0}}}};
  constexpr std::array kKinds{"farthest", "random", "poisson", "vertices"};  // as in gvd_sampling
  if (kind < 0 || std::size_t(kind) >= kKinds.size()) refuse("sampling is none of gvd_sampling");
  return {{"count", count}, {"sampling", kKinds[std::size_t(kind)]}, {"seed", seed}};
}

/// Calls an operation on a mesh. Its options may refer to the listed generators as array 0.
std::unique_ptr<gvd_object> call_with(const char* operation, const gvd_mesh* mesh, const Json& options,
                                      const gvd_point* listed, std::int32_t count, const gvd_run* run) {
  std::vector<std::array<double, 4>> points;
  if (options.contains("generators")) points = to_rows(given(mesh, "mesh").mesh(), listed, count);
  const std::array arrays{view(points)};
  return call(operation, mesh, options.dump(), arrays, run);
}

std::unique_ptr<gvd_mesh> make_handle(CheckedMesh checked) {
  return std::make_unique<gvd_mesh>(std::make_shared<MeshObject>(std::make_shared<CheckedMesh>(std::move(checked))));
}

bool has(const std::vector<VertexId>& vertices, std::int64_t vertex) {
  return vertex >= 0 && vertex < std::ssize(vertices);
}

DefectPolicy policy(int repair) { return repair != 0 ? DefectPolicy::repair : DefectPolicy::error; }

gvd_status read_mesh(const char* path, int repair, std::optional<double> tolerance, gvd_mesh** mesh) {
  return guarded([&] {
    given(mesh, "mesh");
    const std::string name = given_path(path);
    PolygonSoup soup = read_soup(name);
    if (tolerance) weld_soup(soup, *tolerance);
    *mesh = make_handle(build_mesh(soup, policy(repair), name)).release();
  });
}

}  // namespace

const char* gvd_version(void) {
  static const std::string kText(gvd::version());
  return kText.c_str();
}

gvd_status gvd_mesh_read(const char* path, int repair, gvd_mesh** mesh) { return read_mesh(path, repair, {}, mesh); }

gvd_status gvd_mesh_read_welded(const char* path, int repair, double tolerance, gvd_mesh** mesh) {
  return read_mesh(path, repair, tolerance, mesh);
}

gvd_status gvd_mesh_create(const double* vertices, int64_t vertex_count, const int32_t* faces, int64_t face_count,
                           int repair, gvd_mesh** mesh) {
  return guarded([&] {
    given(mesh, "mesh");
    if (vertex_count < 0 || face_count < 0) refuse("a count is negative");
    if (vertex_count > 0) given(vertices, "vertices");
    if (face_count > 0) given(faces, "faces");
    const std::vector<std::int64_t> corners(faces, faces + 3 * face_count);
    const PolygonSoup soup = make_soup({vertices, 3 * std::size_t(vertex_count)}, corners);
    *mesh = make_handle(build_mesh(soup, policy(repair))).release();
  });
}

void gvd_mesh_free(gvd_mesh* mesh) { gvd_release(mesh); }

const char* gvd_mesh_repairs(const gvd_mesh* mesh) { return mesh == nullptr ? "" : mesh->repairs.c_str(); }

int32_t gvd_mesh_vertex_count(const gvd_mesh* mesh) {
  return answered(0, [&] { return given(mesh, "mesh").mesh().vertex_count(); });
}

int32_t gvd_mesh_face_count(const gvd_mesh* mesh) {
  return answered(0, [&] { return given(mesh, "mesh").mesh().face_count(); });
}

int64_t gvd_mesh_input_vertex_count(const gvd_mesh* mesh) {
  return answered<int64_t>(0, [&] { return std::ssize(given(mesh, "mesh").checked()->mesh_vertex); });
}

int32_t gvd_mesh_vertex_of_input(const gvd_mesh* mesh, int64_t vertex) {
  return answered(-1, [&] {
    const std::vector<VertexId>& vertices = given(mesh, "mesh").checked()->mesh_vertex;
    return has(vertices, vertex) ? vertices[std::size_t(vertex)].value() : -1;
  });
}

void gvd_mesh_vertices(const gvd_mesh* mesh, double* vertices) {
  guarded([&] {
    double* out = &given(vertices, "vertices");
    for (const Vec3& p : given(mesh, "mesh").mesh().positions()) out = std::copy_n(p.data(), 3, out);
  });
}

void gvd_mesh_faces(const gvd_mesh* mesh, int32_t* faces) {
  guarded([&] {
    int32_t* out = &given(faces, "faces");
    for (const auto& corners : given(mesh, "mesh").mesh().face_vertices()) {
      for (const VertexId v : corners) *out++ = v.value();
    }
  });
}

gvd_status gvd_mesh_write(const gvd_mesh* mesh, const char* path) { return gvd_write(mesh, path, nullptr); }

gvd_status gvd_point_at_vertex(const gvd_mesh* mesh, int64_t vertex, gvd_point* point) {
  return guarded([&] {
    const CheckedMesh& checked = *given(mesh, "mesh").checked();
    if (!has(checked.mesh_vertex, vertex)) {
      throw Error(ErrorCode::precondition, "there is no vertex " + std::to_string(vertex) + "; the last one is " +
                                               std::to_string(std::ssize(checked.mesh_vertex) - 1));
    }
    const VertexId v = checked.mesh_vertex[std::size_t(vertex)];
    if (!v.valid()) {
      throw Error(ErrorCode::precondition,
                  "vertex " + std::to_string(vertex) + " is in no face, or in a component that was dropped");
    }
    given(point, "point") = to_c(vertex_point(checked.mesh, v));
  });
}

gvd_status gvd_point_near(const gvd_mesh* mesh, const double position[3], gvd_point* point, double* distance) {
  return guarded([&] {
    given(position, "position");
    const ClosestPoint found = given(mesh, "mesh").closest().query(Vec3(position[0], position[1], position[2]));
    given(point, "point") = to_c(found.point);
    if (distance != nullptr) *distance = found.distance;
  });
}

gvd_status gvd_point_position(const gvd_mesh* mesh, const gvd_point* point, double out[3]) {
  return guarded([&] {
    const Mesh& surface = given(mesh, "mesh").mesh();
    const Vec3 p = position(surface, to_point(surface, given(point, "point")));
    std::copy_n(p.data(), 3, &given(out, "position"));
  });
}

gvd_status gvd_sample(const gvd_mesh* mesh, int32_t count, gvd_sampling kind, uint64_t seed, const gvd_run* run,
                      gvd_point* points) {
  return guarded([&] {
    given(mesh, "mesh");
    given(points, "points");
    const auto made = call("sample", mesh, generator_options(false, count, kind, seed).dump(), {}, run);
    std::ranges::copy(points_of(*made, "points"), points);
  });
}

gvd_status gvd_distances(const gvd_mesh* mesh, const gvd_point* sources, int32_t source_count, const gvd_run* run,
                         double* distances, int32_t* nearest) {
  return guarded([&] {
    const Mesh& surface = given(mesh, "mesh").mesh();
    given(distances, "distances");
    CallObserver observer(run);  // the operation would also keep the data for paths, and take twice the time
    const VertexDistances found =
        compute_vertex_distances(surface, to_points(surface, sources, source_count),
                                 {.progress = progress_of(observer), .threads = observer.threads});
    for (const VertexId v : surface.vertices()) {
      distances[v.index()] = found.distance[v];
      if (nearest != nullptr) nearest[v.index()] = found.label[v].value();
    }
  });
}

gvd_status gvd_path_compute(const gvd_mesh* mesh, const gvd_point* from, const gvd_point* to, const gvd_run* run,
                            gvd_path** path) {
  return guarded([&] {
    const Mesh& surface = given(mesh, "mesh").mesh();
    given(path, "path");
    const auto ends = to_rows(surface, to, 1), begins = to_rows(surface, from, 1);
    const std::array arrays{view(ends), view(begins)};
    const auto made =
        call("distances", mesh, R"({"from": {"array": 0}, "to": {"array": 1}, "paths": true})", arrays, run);
    auto found = std::dynamic_pointer_cast<const DistancesOutcome>(made->object);
    if (found->table.paths.empty() || !found->table.paths.front().source.valid()) {
      throw Error(ErrorCode::no_valid_result, "the two points are in different components; there is no path");
    }
    *path = new gvd_path{std::move(found)};
  });
}

void gvd_path_free(gvd_path* path) { delete path; }

double gvd_path_length(const gvd_path* path) {
  return answered(0.0, [&] { return given(path, "path").path().length; });
}

int32_t gvd_path_point_count(const gvd_path* path) {
  return answered(0, [&] { return std::int32_t(given(path, "path").path().points.size()); });
}

void gvd_path_points(const gvd_path* path, gvd_point* points) {
  guarded([&] { copy_points(given(path, "path").path().points, &given(points, "points")); });
}

gvd_status gvd_diagram_compute(const gvd_mesh* mesh, const gvd_point* generators, int32_t count, gvd_method method,
                               const gvd_run* run, gvd_diagram** diagram) {
  return guarded([&] {
    constexpr std::array kMethods{"exact", "gbgvd", "paper"};  // as in gvd_method
    if (method < 0 || std::size_t(method) >= kMethods.size()) refuse("method is none of gvd_method");
    given(mesh, "mesh").mesh();
    given(diagram, "diagram");
    Json options = generator_options(true, count, 0, 0);
    options["method"] = kMethods[std::size_t(method)];
    *diagram = call_with("diagram", mesh, options, generators, count, run).release();
  });
}

void gvd_diagram_free(gvd_diagram* diagram) { gvd_release(diagram); }

void gvd_diagram_vertices(const gvd_diagram* diagram, int32_t* labels, double* distances) {
  guarded([&] {
    const Diagram& made = given(diagram, "diagram").diagram();
    for (const VertexId v : made.vertex_label.ids()) {
      if (labels != nullptr) labels[v.index()] = made.vertex_label[v].value();
      if (distances != nullptr) distances[v.index()] = made.vertex_distance[v];
    }
  });
}

void gvd_diagram_areas(const gvd_diagram* diagram, double* areas) {
  guarded([&] {
    double* out = &given(areas, "areas");
    for (const Cell& cell : given(diagram, "diagram").diagram().cells) *out++ = cell.area;
  });
}

int32_t gvd_diagram_branch_point_count(const gvd_diagram* diagram) {
  return answered(0, [&] { return given(diagram, "diagram").diagram().branch_points.count(); });
}

void gvd_diagram_branch_points(const gvd_diagram* diagram, gvd_point* points, double* distances) {
  guarded([&] {
    gvd_point* out = &given(points, "points");
    for (const BranchPoint& branch : given(diagram, "diagram").diagram().branch_points) {
      *out++ = to_c(branch.point);
      if (distances != nullptr) *distances++ = branch.distance;
    }
  });
}

int32_t gvd_diagram_bisector_count(const gvd_diagram* diagram) {
  return answered(0, [&] { return given(diagram, "diagram").diagram().bisectors.count(); });
}

namespace {

const Bisector& bisector_at(const gvd_diagram* diagram, std::int32_t index) {
  const auto& bisectors = given(diagram, "diagram").diagram().bisectors;
  if (index < 0 || index >= bisectors.count()) {
    refuse("there is no bisector " + std::to_string(index) + " of " + std::to_string(bisectors.count()));
  }
  return bisectors[BisectorId(index)];
}

}  // namespace

gvd_status gvd_diagram_bisector(const gvd_diagram* diagram, int32_t index, gvd_bisector* out) {
  return guarded([&] {
    const Bisector& b = bisector_at(diagram, index);
    given(out, "bisector") = {b.left.value(),
                              b.right.value(),
                              {b.ends[0].value(), b.ends[1].value()},
                              b.closed ? 1 : 0,
                              std::int32_t(b.points.size())};
  });
}

gvd_status gvd_diagram_bisector_points(const gvd_diagram* diagram, int32_t index, gvd_point* points) {
  return guarded([&] { copy_points(bisector_at(diagram, index).points, &given(points, "points")); });
}

gvd_status gvd_segment(const gvd_diagram* diagram, int smooth, const gvd_run* run, int32_t* labels) {
  return guarded([&] {
    given(diagram, "diagram").diagram();
    given(labels, "labels");
    const auto made =
        call("label", diagram, smooth != 0 ? R"({"labels": "smooth"})" : R"({"labels": "nearest"})", {}, run);
    copy_array(*made, "face_labels", labels);
  });
}

gvd_status gvd_segment_write(const gvd_diagram* diagram, const char* path, const gvd_run* run) {
  gvd_object* labelled = nullptr;
  gvd_status status = guarded([&] {
    given(diagram, "diagram").diagram();
    labelled = call("label", diagram, "{}", {}, run).release();
  });
  if (status == GVD_OK) status = gvd_write(labelled, path, run);
  gvd_release(labelled);
  return status;
}

void gvd_lloyd_defaults(gvd_lloyd_options* options) { *options = {-1, -1, 0, 0, GVD_FARTHEST, 0}; }

gvd_status gvd_lloyd(const gvd_mesh* mesh, const gvd_point* listed, int32_t count, const gvd_lloyd_options* options,
                     const gvd_run* run, gvd_point* relaxed, double* energy) {
  return guarded([&] {
    gvd_lloyd_options asked;
    gvd_lloyd_defaults(&asked);
    if (options != nullptr) asked = *options;
    given(mesh, "mesh").mesh();
    given(relaxed, "relaxed");
    Json json = generator_options(listed != nullptr, count, asked.sampling, asked.seed);
    if (asked.iterations >= 0) json["iterations"] = asked.iterations;
    if (!(asked.tolerance < 0)) json["tolerance"] = to_json(asked.tolerance);
    if (!(asked.crease_angle <= 0)) json["features"] = to_json(asked.crease_angle);
    json["keep_boundary"] = asked.keep_boundary != 0;
    const auto made = call_with("lloyd", mesh, json, listed, count, run);
    std::ranges::copy(points_of(*made, "generators"), relaxed);
    if (energy != nullptr) *energy = Json::parse(made->figures()).at("final_energy").get<double>();
  });
}

void gvd_remesh_defaults(gvd_remesh_options* options) { *options = {-1, 0, -1, 0, GVD_FARTHEST, 0}; }

gvd_status gvd_remesh(const gvd_mesh* mesh, const gvd_point* listed, int32_t count, const gvd_remesh_options* options,
                      const gvd_run* run, gvd_mesh** coarse) {
  return guarded([&] {
    gvd_remesh_options asked;
    gvd_remesh_defaults(&asked);
    if (options != nullptr) asked = *options;
    given(mesh, "mesh").mesh();
    given(coarse, "coarse");
    Json json = generator_options(listed != nullptr, count, asked.sampling, asked.seed);
    if (asked.relaxation >= 0) json["relax"] = asked.relaxation;
    json["exact_count"] = asked.exact_count != 0;
    json["loose_boundary"] = asked.loose_boundary != 0;
    if (asked.crease_angle == 0) json["features"] = "none";
    if (!(asked.crease_angle <= 0)) json["features"] = to_json(asked.crease_angle);
    const auto made = call_with("remesh", mesh, json, listed, count, run);
    auto handle = std::make_unique<gvd_object>(made->views().parts.at("mesh").make());
    handle->generators = points_of(*made, "generators");
    *coarse = handle.release();
  });
}

gvd_status gvd_mesh_generators(const gvd_mesh* coarse, gvd_point* points) {
  return guarded([&] {
    const auto& generators = given(coarse, "coarse").generators;
    if (!generators) refuse("the mesh is no remesh, so its vertices have no generators");
    std::ranges::copy(*generators, &given(points, "points"));
  });
}
