// The C interface on top of the C++ library: handles that own C++ objects, and a guard that lets no exception out.
//
// Every handle holds its mesh by a shared pointer, so that handles may be freed in any order. Arguments of callers are
// checked where C++ types would rule the mistake out: null pointers, faces out of range, barycentric coordinates.

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/gvd.h"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/relaxation_start.hpp"
#include "gvd/remesh_surface.hpp"
#include "gvd/sampling.hpp"
#include "gvd/segment.hpp"
#include "gvd/soup.hpp"
#include "gvd/version.hpp"

namespace {

using namespace gvd;

/// A mesh with what its handle answers from. Shared by all handles that need it.
struct SharedMesh {
  Mesh mesh;
  std::vector<VertexId> vertex_of_input;
  Appearance appearance;
  std::string repairs;
  std::optional<std::vector<SurfacePoint>> generators;  ///< of the vertices of a remesh
  std::once_flag tree_made;
  std::unique_ptr<ClosestPointTree> tree;

  bool has_input(std::int64_t vertex) const { return vertex >= 0 && vertex < std::ssize(vertex_of_input); }
  const ClosestPointTree& closest() {
    std::call_once(tree_made, [this] { tree = std::make_unique<ClosestPointTree>(mesh); });
    return *tree;
  }
};

}  // namespace

struct gvd_mesh {
  std::shared_ptr<SharedMesh> shared;
  const gvd::Mesh& mesh() const { return shared->mesh; }
};
struct gvd_path {
  std::vector<gvd::SurfacePoint> points;
  double length = 0;
};
struct gvd_diagram {
  std::shared_ptr<SharedMesh> shared;
  gvd::Diagram diagram;
};

namespace {

thread_local std::string last_error;

gvd_status fail(gvd_status status, const char* message) noexcept {
  try {
    last_error = message;
  } catch (...) {
    last_error.clear();
  }
  return status;
}

/// Of each ErrorCode, in their order.
constexpr std::array<gvd_status, 7> kStatuses{GVD_INVALID_OPTION,  GVD_UNREADABLE_INPUT,  GVD_PRECONDITION,
                                              GVD_NO_VALID_RESULT, GVD_UNWRITABLE_OUTPUT, GVD_UNWRITABLE_OUTPUT,
                                              GVD_INTERRUPTED};
static_assert(std::size_t(ErrorCode::interrupted) + 1 == kStatuses.size());

/// Does the work of a call; its exceptions become a status and a message.
template <class Work>
gvd_status guarded(Work&& work) noexcept {
  try {
    work();
    return GVD_OK;
  } catch (const Error& error) {
    return fail(kStatuses[std::size_t(error.code())], error.what());
  } catch (const std::bad_alloc&) {
    return fail(GVD_OUT_OF_MEMORY, "out of memory; use a smaller mesh or fewer generators");
  } catch (const std::exception& error) {
    return fail(GVD_INTERNAL_ERROR, error.what());
  } catch (...) {
    return fail(GVD_INTERNAL_ERROR, "unknown exception");
  }
}

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

/// The value behind an argument that must not be NULL.
template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) refuse(std::string(name) + " is NULL");
  return *argument;
}

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

gvd_point to_c(const SurfacePoint& point) {
  return {point.face.value(), {point.bary[0], point.bary[1], point.bary[2]}};
}

void copy_points(const std::vector<SurfacePoint>& points, gvd_point* out) {
  std::transform(points.begin(), points.end(), out, to_c);
}

Progress progress_of(const gvd_run* run) {
  if (run == nullptr || run->progress == nullptr) return {};
  return [run](std::string_view step, double fraction) {
    return run->progress(run->data, std::string(step).c_str(), fraction) != 0;
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
  auto handle = std::make_unique<gvd_mesh>();
  handle->shared = std::make_shared<SharedMesh>();
  handle->shared->mesh = std::move(checked.mesh);
  handle->shared->vertex_of_input = std::move(checked.mesh_vertex);
  handle->shared->appearance = std::move(checked.appearance);
  for (const std::string& line : checked.defects.messages) handle->shared->repairs += line + '\n';
  return handle;
}

DefectPolicy policy(int repair) { return repair != 0 ? DefectPolicy::repair : DefectPolicy::error; }

/// What gvd_lloyd_options and gvd_remesh_options share.
template <class Options>
RelaxationStartOptions start_options(const Mesh& mesh, const gvd_point* listed, std::int32_t count,
                                     const Options& options, const gvd_run* run) {
  RelaxationStartOptions start;
  if (listed != nullptr) start.listed = to_points(mesh, listed, count);
  start.sampling = sampling_options(options.sampling, count, options.seed);
  if (!(options.crease_angle <= 0)) start.constraints.crease_angle = options.crease_angle;
  start.threads = threads_of(run);
  start.progress = progress_of(run);
  return start;
}

}  // namespace

const char* gvd_last_error(void) { return last_error.c_str(); }

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

void gvd_mesh_free(gvd_mesh* mesh) { delete mesh; }

const char* gvd_mesh_repairs(const gvd_mesh* mesh) { return mesh->shared->repairs.c_str(); }

int32_t gvd_mesh_vertex_count(const gvd_mesh* mesh) { return mesh->mesh().vertex_count(); }

int32_t gvd_mesh_face_count(const gvd_mesh* mesh) { return mesh->mesh().face_count(); }

int64_t gvd_mesh_input_vertex_count(const gvd_mesh* mesh) { return std::ssize(mesh->shared->vertex_of_input); }

int32_t gvd_mesh_vertex_of_input(const gvd_mesh* mesh, int64_t vertex) {
  const SharedMesh& shared = *mesh->shared;
  return shared.has_input(vertex) ? shared.vertex_of_input[std::size_t(vertex)].value() : -1;
}

void gvd_mesh_vertices(const gvd_mesh* mesh, double* vertices) {
  for (const Vec3& p : mesh->mesh().positions()) vertices = std::copy_n(p.data(), 3, vertices);
}

void gvd_mesh_faces(const gvd_mesh* mesh, int32_t* faces) {
  for (const auto& corners : mesh->mesh().face_vertices()) {
    for (const VertexId v : corners) *faces++ = v.value();
  }
}

gvd_status gvd_mesh_write(const gvd_mesh* mesh, const char* path) {
  return guarded([&] {
    LabelledMesh written{given(mesh, "mesh").mesh()};
    written.appearance = &mesh->shared->appearance;
    write_mesh(&given(path, "path"), written);
  });
}

gvd_status gvd_point_at_vertex(const gvd_mesh* mesh, int64_t vertex, gvd_point* point) {
  return guarded([&] {
    const SharedMesh& shared = *given(mesh, "mesh").shared;
    if (!shared.has_input(vertex)) {
      throw Error(ErrorCode::precondition, "there is no vertex " + std::to_string(vertex) + "; the last one is " +
                                               std::to_string(std::ssize(shared.vertex_of_input) - 1));
    }
    const VertexId v = shared.vertex_of_input[std::size_t(vertex)];
    if (!v.valid()) throw Error(ErrorCode::precondition, "vertex " + std::to_string(vertex) + " is in no face");
    given(point, "point") = to_c(vertex_point(shared.mesh, v));
  });
}

gvd_status gvd_point_near(const gvd_mesh* mesh, const double position[3], gvd_point* point, double* distance) {
  return guarded([&] {
    given(position, "position");
    const ClosestPoint found = given(mesh, "mesh").shared->closest().query(Vec3(position[0], position[1], position[2]));
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

double gvd_path_length(const gvd_path* path) { return path->length; }

int32_t gvd_path_point_count(const gvd_path* path) { return std::int32_t(path->points.size()); }

void gvd_path_points(const gvd_path* path, gvd_point* points) { copy_points(path->points, points); }

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
    *diagram = new gvd_diagram{mesh->shared, std::move(made)};
  });
}

void gvd_diagram_free(gvd_diagram* diagram) { delete diagram; }

void gvd_diagram_vertices(const gvd_diagram* diagram, int32_t* labels, double* distances) {
  const Diagram& made = diagram->diagram;
  for (const VertexId v : made.vertex_label.ids()) {
    if (labels != nullptr) labels[v.index()] = made.vertex_label[v].value();
    if (distances != nullptr) distances[v.index()] = made.vertex_distance[v];
  }
}

void gvd_diagram_areas(const gvd_diagram* diagram, double* areas) {
  for (const Cell& cell : diagram->diagram.cells) *areas++ = cell.area;
}

int32_t gvd_diagram_branch_point_count(const gvd_diagram* diagram) { return diagram->diagram.branch_points.count(); }

void gvd_diagram_branch_points(const gvd_diagram* diagram, gvd_point* points, double* distances) {
  for (const BranchPoint& branch : diagram->diagram.branch_points) {
    *points++ = to_c(branch.point);
    if (distances != nullptr) *distances++ = branch.distance;
  }
}

int32_t gvd_diagram_bisector_count(const gvd_diagram* diagram) { return diagram->diagram.bisectors.count(); }

namespace {

const Bisector& bisector_at(const gvd_diagram* diagram, std::int32_t index) {
  const auto& bisectors = given(diagram, "diagram").diagram.bisectors;
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
    const gvd_diagram& of = given(diagram, "diagram");
    const SegmentOptions options{smooth != 0 ? FaceLabels::smooth : FaceLabels::nearest, progress_of(run)};
    const Segmentation made = segment_faces(of.shared->mesh, of.diagram, options);
    int32_t* out = &given(labels, "labels");
    for (const GeneratorId label : made.face_label) *out++ = label.value();
  });
}

gvd_status gvd_segment_write(const gvd_diagram* diagram, const char* path, const gvd_run* run) {
  return guarded([&] {
    const gvd_diagram& of = given(diagram, "diagram");
    const Diagram& made = of.diagram;
    const std::filesystem::path file = &given(path, "path");
    const MeshFormat format = output_format(file);
    SegmentOptions options;
    options.progress = progress_of(run);
    const Segmentation labels = segment_faces(of.shared->mesh, made, options);
    if (format == MeshFormat::json) {
      return write_file(file, [&](std::ostream& out) { write_segmentation_json(out, of.shared->mesh, made, labels); });
    }
    LabelledMesh written = label_mesh(of.shared->mesh, made, labels.face_label);
    written.appearance = &of.shared->appearance;
    write_mesh(file, written);
  });
}

void gvd_lloyd_defaults(gvd_lloyd_options* options) { *options = {-1, -1, 0, 0, GVD_FARTHEST, 0}; }

gvd_status gvd_lloyd(const gvd_mesh* mesh, const gvd_point* listed, int32_t count, const gvd_lloyd_options* options,
                     const gvd_run* run, gvd_point* relaxed, double* energy) {
  return guarded([&] {
    gvd_lloyd_options asked;
    gvd_lloyd_defaults(&asked);
    if (options != nullptr) asked = *options;
    const Mesh& surface = given(mesh, "mesh").mesh();
    given(relaxed, "relaxed");
    LloydOptions relaxation;
    if (asked.iterations >= 0) relaxation.max_iterations = asked.iterations;
    if (!(asked.tolerance < 0)) relaxation.energy_tolerance = asked.tolerance;
    relaxation.diagram = diagram_options(run);
    relaxation.progress = progress_of(run);
    RelaxationStartOptions start = start_options(surface, listed, count, asked, run);
    start.constraints.keep_boundary = asked.keep_boundary != 0;
    start.copy = copy_options(relaxation);
    const RelaxationStart made = start_relaxation(surface, start);
    if (std::ssize(made.points) != count) refuse("some of the given generators coincide; leave these out");
    const LloydResult result = relax_generators(surface, made, relaxation);
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
    const Mesh& surface = given(mesh, "mesh").mesh();
    given(coarse, "coarse");
    SurfaceRemeshOptions remesh;
    if (asked.relaxation >= 0) remesh.relaxation = asked.relaxation;
    remesh.exact_count = asked.exact_count != 0;
    remesh.start = start_options(surface, listed, count, asked, run);
    remesh.start.constraints.prefers_boundary = asked.loose_boundary == 0;
    remesh.start.constraints.prefers_creases = asked.crease_angle < 0;
    if (asked.crease_angle < 0) remesh.start.constraints.crease_angle = kUsualCreaseAngle;
    remesh.remesh.diagram = diagram_options(run);
    RemeshResult result = remesh_surface(surface, remesh).result;
    auto handle = make_handle(as_input(std::move(result.mesh)));
    handle->shared->generators = std::move(result.generators);
    *coarse = handle.release();
  });
}

gvd_status gvd_mesh_generators(const gvd_mesh* coarse, gvd_point* points) {
  return guarded([&] {
    const auto& generators = given(coarse, "coarse").shared->generators;
    if (!generators) refuse("the mesh is no remesh, so its vertices have no generators");
    copy_points(*generators, &given(points, "points"));
  });
}
