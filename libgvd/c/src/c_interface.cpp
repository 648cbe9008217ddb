// The C interface on top of the C++ library: handles that own C++ objects, and a guard that lets no exception out.
//
// Arguments of callers are checked where C++ types would rule the mistake out: null pointers, faces out of range,
// barycentric coordinates.

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/gvd.h"
#include "gvd/lloyd_operation.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/remesh_operation.hpp"
#include "gvd/sampling.hpp"
#include "gvd/segment.hpp"
#include "gvd/segment_operation.hpp"
#include "gvd/soup.hpp"
#include "gvd/version.hpp"
#include "handles.hpp"

namespace {

using namespace gvd;

using namespace gvd::c;

}  // namespace

struct gvd_path {
  std::vector<gvd::SurfacePoint> points;
  double length = 0;
};
namespace {

SurfacePoint to_point(const Mesh& mesh, const gvd_point& point) {
  if (point.face < 0 || point.face >= mesh.face_count()) {
    throw Error(ErrorCode::precondition, "a point has face " + std::to_string(point.face) + ", and the mesh has " +
                                             std::to_string(mesh.face_count()) + " faces");
  }
  return restore_surface_point(FaceId(point.face), {point.bary[0], point.bary[1], point.bary[2]});
}

std::vector<SurfacePoint> to_points(const Mesh& mesh, const gvd_point* points, std::int32_t count) {
  if (count < 1) refuse("count is " + std::to_string(count) + "; give at least 1");
  std::vector<SurfacePoint> made;
  for (std::int32_t i = 0; i < count; ++i) made.push_back(to_point(mesh, (&given(points, "points"))[i]));
  return made;
}

GeneratorList to_list(const Mesh& mesh, const gvd_point* points, std::int32_t count) {
  GeneratorList list{"generators", {}};
  for (const SurfacePoint& point : to_points(mesh, points, count)) {
    list.entries.push_back({GeneratorEntry::Kind::face, point.face.value(), point.bary, 0});
  }
  return list;
}

gvd_point to_c(const SurfacePoint& point) {
  return {point.face.value(), {point.bary[0], point.bary[1], point.bary[2]}};
}

void copy_points(const std::vector<SurfacePoint>& points, gvd_point* out) {
  std::transform(points.begin(), points.end(), out, to_c);
}

Progress progress_of(const gvd_run* run) {
  if (run == nullptr) return {};
  return [observer = std::make_shared<CallObserver>(run)](std::string_view step, double fraction) {
    return observer->progress(step, fraction);
  };
}

int threads_of(const gvd_run* run) { return run == nullptr ? 0 : run->threads; }

DiagramOptions diagram_options(const gvd_run* run) {
  DiagramOptions options;
  options.threads = threads_of(run);
  options.progress = progress_of(run);
  return options;
}

SamplingOptions sampling_options(gvd_sampling kind, std::int32_t count, std::uint64_t seed) {
  constexpr std::array<Sampling, 4> kKinds{Sampling::farthest, Sampling::random, Sampling::poisson, Sampling::vertices};
  if (kind < 0 || std::size_t(kind) >= kKinds.size()) refuse("sampling is none of gvd_sampling");
  SamplingOptions options;
  options.kind = kKinds[std::size_t(kind)];
  options.count = count;
  options.seed = seed;
  return options;
}

std::unique_ptr<gvd_mesh> make_handle(CheckedMesh checked) {
  return std::make_unique<gvd_mesh>(std::make_shared<MeshObject>(std::make_shared<CheckedMesh>(std::move(checked))));
}

bool has(const std::vector<VertexId>& vertices, std::int64_t vertex) {
  return vertex >= 0 && vertex < std::ssize(vertices);
}

DefectPolicy policy(int repair) { return repair != 0 ? DefectPolicy::repair : DefectPolicy::error; }

/// The generators of gvd_lloyd and gvd_remesh: those of a list, or sampled ones.
GeneratorOptions generator_options(const Mesh& mesh, const gvd_point* listed, std::int32_t count, gvd_sampling kind,
                                   std::uint64_t seed) {
  GeneratorOptions options;
  if (listed != nullptr) {
    options.points.list = std::make_shared<GeneratorList>(to_list(mesh, listed, count));
    return options;
  }
  const SamplingOptions sampling = sampling_options(kind, count, seed);
  options.count = sampling.count;
  options.sampling = sampling.kind;
  options.seed = sampling.seed;
  return options;
}

}  // namespace

const char* gvd_version(void) {
  static const std::string kText(gvd::version());
  return kText.c_str();
}

gvd_status gvd_mesh_read(const char* path, int repair, gvd_mesh** mesh) {
  return guarded([&] {
    given(mesh, "mesh");
    const std::string name = &given(path, "path");
    *mesh = make_handle(build_mesh(read_soup(name), policy(repair), name)).release();
  });
}

gvd_status gvd_mesh_read_welded(const char* path, int repair, double tolerance, gvd_mesh** mesh) {
  return guarded([&] {
    given(mesh, "mesh");
    const std::string name = &given(path, "path");
    PolygonSoup soup = read_soup(name);
    weld_soup(soup, tolerance);
    *mesh = make_handle(build_mesh(soup, policy(repair), name)).release();
  });
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
    if (!v.valid()) throw Error(ErrorCode::precondition, "vertex " + std::to_string(vertex) + " is in no face");
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
    SamplingOptions options = sampling_options(kind, count, seed);
    options.progress = progress_of(run);
    const std::vector<SurfacePoint> made = sample_generators(given(mesh, "mesh").mesh(), options);
    copy_points(made, &given(points, "points"));
  });
}

gvd_status gvd_distances(const gvd_mesh* mesh, const gvd_point* sources, int32_t source_count, const gvd_run* run,
                         double* distances, int32_t* nearest) {
  return guarded([&] {
    const Mesh& surface = given(mesh, "mesh").mesh();
    given(distances, "distances");
    const VertexDistances found = compute_vertex_distances(surface, to_points(surface, sources, source_count),
                                                           {.progress = progress_of(run), .threads = threads_of(run)});
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
    const ExactField field(surface, to_points(surface, to, 1),
                           {.progress = progress_of(run), .threads = threads_of(run)});
    GeodesicPath found = field.path(to_point(surface, given(from, "from")));
    if (!found.generator.valid()) {
      throw Error(ErrorCode::no_valid_result, "the two points are in different components; there is no path");
    }
    *path = new gvd_path{std::move(found.points), found.length};
  });
}

void gvd_path_free(gvd_path* path) { delete path; }

double gvd_path_length(const gvd_path* path) {
  return answered(0.0, [&] { return given(path, "path").length; });
}

int32_t gvd_path_point_count(const gvd_path* path) {
  return answered(0, [&] { return std::int32_t(given(path, "path").points.size()); });
}

void gvd_path_points(const gvd_path* path, gvd_point* points) {
  guarded([&] { copy_points(given(path, "path").points, &given(points, "points")); });
}

gvd_status gvd_diagram_compute(const gvd_mesh* mesh, const gvd_point* generators, int32_t count, gvd_method method,
                               const gvd_run* run, gvd_diagram** diagram) {
  return guarded([&] {
    constexpr std::array<Method, 3> kMethods{Method::exact, Method::gbgvd, Method::paper};
    if (method < 0 || std::size_t(method) >= kMethods.size()) refuse("method is none of gvd_method");
    const Mesh& surface = given(mesh, "mesh").mesh();
    given(diagram, "diagram");
    DiagramOptions options = diagram_options(run);
    options.method = kMethods[std::size_t(method)];
    Diagram made = compute_diagram(surface, to_points(surface, generators, count), options);
    *diagram = new gvd_object(
        std::make_shared<DiagramObject>(mesh->checked(), std::make_shared<const Diagram>(std::move(made)), options));
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
    const DiagramObject& of = given(diagram, "diagram").diagram_object();
    const SegmentOptions options{smooth != 0 ? FaceLabels::smooth : FaceLabels::nearest, progress_of(run)};
    const Segmentation made = segment_faces(of.mesh()->mesh, of.diagram(), options);
    int32_t* out = &given(labels, "labels");
    for (const GeneratorId label : made.face_label) *out++ = label.value();
  });
}

gvd_status gvd_segment_write(const gvd_diagram* diagram, const char* path, const gvd_run* run) {
  return guarded([&] {
    const DiagramObject& of = given(diagram, "diagram").diagram_object();
    const std::string name = &given(path, "path");
    LabelCall call;
    CallObserver observer(run);
    write_object(name, *gvd::run(of, call, observer), {}, progress_of(observer));
  });
}

void gvd_lloyd_defaults(gvd_lloyd_options* options) { *options = {-1, -1, 0, 0, GVD_FARTHEST, 0}; }

gvd_status gvd_lloyd(const gvd_mesh* mesh, const gvd_point* listed, int32_t count, const gvd_lloyd_options* options,
                     const gvd_run* run, gvd_point* relaxed, double* energy) {
  return guarded([&] {
    gvd_lloyd_options asked;
    gvd_lloyd_defaults(&asked);
    if (options != nullptr) asked = *options;
    const MeshPtr& input = given(mesh, "mesh").checked();
    given(relaxed, "relaxed");
    LloydCall call;
    call.generators = generator_options(input->mesh, listed, count, asked.sampling, asked.seed);
    if (asked.iterations >= 0) call.relaxation.max_iterations = asked.iterations;
    if (!(asked.tolerance < 0)) call.relaxation.energy_tolerance = asked.tolerance;
    if (!(asked.crease_angle <= 0)) call.start.constraints.crease_angle = asked.crease_angle;
    call.start.constraints.keep_boundary = asked.keep_boundary != 0;
    CallObserver observer(run);
    const auto outcome = gvd::run(input, call, observer);
    const LloydResult& result = *outcome->relaxed;
    copy_points(result.generators, relaxed);
    if (energy != nullptr) *energy = result.final_energy;
  });
}

void gvd_remesh_defaults(gvd_remesh_options* options) { *options = {-1, 0, -1, 0, GVD_FARTHEST, 0}; }

gvd_status gvd_remesh(const gvd_mesh* mesh, const gvd_point* listed, int32_t count, const gvd_remesh_options* options,
                      const gvd_run* run, gvd_mesh** coarse) {
  return guarded([&] {
    gvd_remesh_options asked;
    gvd_remesh_defaults(&asked);
    if (options != nullptr) asked = *options;
    const MeshPtr& input = given(mesh, "mesh").checked();
    given(coarse, "coarse");
    RemeshCall call;
    call.generators = generator_options(input->mesh, listed, count, asked.sampling, asked.seed);
    if (asked.relaxation >= 0) call.remesh.relaxation = asked.relaxation;
    call.remesh.exact_count = asked.exact_count != 0;
    StartOptions& constraints = call.remesh.start.constraints;
    constraints.prefers_boundary = asked.loose_boundary == 0;
    constraints.prefers_creases = asked.crease_angle < 0;
    constraints.crease_angle.reset();
    if (asked.crease_angle < 0) constraints.crease_angle = kUsualCreaseAngle;
    if (!(asked.crease_angle <= 0)) constraints.crease_angle = asked.crease_angle;
    CallObserver observer(run);
    const auto outcome = gvd::run(input, call, observer);
    const RemeshResult& result = outcome->result();
    auto handle = make_handle(as_input(result.mesh));
    handle->generators = result.generators;
    *coarse = handle.release();
  });
}

gvd_status gvd_mesh_generators(const gvd_mesh* coarse, gvd_point* points) {
  return guarded([&] {
    const auto& generators = given(coarse, "coarse").generators;
    if (!generators) refuse("the mesh is no remesh, so its vertices have no generators");
    copy_points(*generators, &given(points, "points"));
  });
}
