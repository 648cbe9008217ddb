// Exact distances and shortest paths for users: propagates all windows once, then answers queries from the windows.
//
// Idea: generators become vertices of a working mesh. A query is translated into that mesh, answered by the window
// field, and translated back.
// Source: window propagation as in propagate_windows.hpp.
// Invariant: the working mesh is the same surface, so that points keep their distances in both directions.
#include "gvd/exact_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "base/barycentric.hpp"
#include "base/parallel_chunks.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/nearest_source.hpp"
#include "geodesic/tangent_fan.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/shortest_path.hpp"
#include "geodesic/windows/trace_isolines.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {
namespace {

const ExactFieldOptions& checked(const ExactFieldOptions& options, std::size_t generators) {
  const std::vector<double>& offsets = options.offsets;
  if (options.threads < 0) throw Error(ErrorCode::invalid_option, "the number of threads must not be negative");
  if (!(options.max_distance >= 0)) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("the largest distance is {}; give 0 or more", options.max_distance));
  }
  if (!offsets.empty() && offsets.size() != generators) {
    throw Error(
        ErrorCode::precondition,
        fmt::format("there are {} offsets for {} generators; give one for each or none", offsets.size(), generators));
  }
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (offsets[i] >= 0 && std::isfinite(offsets[i])) continue;
    throw Error(ErrorCode::invalid_option,
                fmt::format("offset {} is negative or not finite; give a number of 0 or more", i), std::int64_t(i));
  }
  return options;
}

/// The point of a triangle that is nearest to p. The corners and p are given in barycentric coordinates of one face. In
/// a thin triangle, areas only determine the distance of p from the longest side, so the position along that side is
/// measured on the side itself. The point is then accurate up to rounding, although its coordinates may not be.
PlacedInTriangle nearest_inside(const std::array<Bary, 3>& corners, const Bary& p) {
  const auto way = [](const Bary& a, const Bary& b) { return Vec2(b[0] - a[0], b[1] - a[1]); };
  const auto side = [&](std::size_t k) { return way(corners[(k + 1) % 3], corners[(k + 2) % 3]); };
  std::size_t tip = 0;  // opposite the longest side
  for (std::size_t i = 1; i < 3; ++i) {
    if (side(i).squaredNorm() > side(tip).squaredNorm()) tip = i;
  }
  const std::size_t from = (tip + 1) % 3, to = (tip + 2) % 3;
  const Vec2 base = side(tip), to_tip = way(corners[from], corners[tip]), to_p = way(corners[from], p);
  Bary local{};
  local[tip] = std::clamp(cross(base, to_p) / cross(base, to_tip), 0.0, 1.0);
  local[to] = std::clamp((to_p - local[tip] * to_tip).dot(base) / base.squaredNorm(), 0.0, 1 - local[tip]);
  local[from] = std::max(0.0, 1 - local[tip] - local[to]);
  return {local, (local[to] * base + local[tip] * to_tip - to_p).norm()};
}

/// `sources`: generators, points or curves.
template <class Sources>
VertexDistances compute_from(const Mesh& mesh, const Sources& sources, const ExactFieldOptions& options) {
  checked(options, sources.size());
  const WorkingMesh working(mesh, sources, options.progress);
  WindowField field = propagate_windows(working,
                                        {.keep = KeepWindows::none,
                                         .offsets = options.offsets,
                                         .threads = options.threads,
                                         .max_distance = options.max_distance},
                                        options.progress);
  // The vertices of the input come first, then those of generators inside faces.
  field.distance.resize(mesh.vertex_count());
  field.label.resize(mesh.vertex_count());
  return {std::move(field.distance), std::move(field.label)};
}

}  // namespace

struct ExactField::State {
  /// `sources`: generators, points or curves.
  template <class Sources>
  State(const Mesh& mesh, const Sources& sources, const ExactFieldOptions& options)
      : working(mesh, sources, options.progress),
        field(propagate_windows(
            working, {.offsets = options.offsets, .threads = options.threads, .max_distance = options.max_distance},
            options.progress)),
        offsets(options.offsets),
        max_distance(options.max_distance),
        split(working),
        memo(working.generator_vertices().raw()) {}

  /// The same point on the working mesh.
  SurfacePoint to_working(const SurfacePoint& point) const {
    const std::span<const SplitFaces::Part> parts = split.parts_of(point.face);
    if (parts.empty()) return point;
    const SurfacePoint inside =
        locate_in_parts(parts, [&](const std::array<Bary, 3>& corners) { return nearest_inside(corners, point.bary); });
    return make_surface_point(inside.face, inside.bary);
  }
  SurfacePoint to_input(const SurfacePoint& point) const {
    if (!working.is_split(point.face)) return point;
    return make_surface_point(working.parent(point.face), working.parent_bary(point.face, point.bary));
  }
  /// The tangent plane of a generator. The first call makes the planes of all generators.
  const TangentFan& fan(GeneratorId g) {
    std::call_once(fans_made, [this] {
      for (const SurfacePoint& generator : generators) fans.emplace_back(working.input(), generator);
    });
    return fans[g.index()];
  }
  double offset(GeneratorId g) const { return offsets.empty() ? 0 : offsets[g.index()]; }

  std::vector<SurfacePoint> generators;  // empty if they are curves
  WorkingMesh working;
  WindowField field;
  std::vector<double> offsets;
  double max_distance;
  SplitFaces split;
  PathMemo memo;
  std::once_flag fans_made;
  std::vector<TangentFan> fans;
};

ExactField::ExactField(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const ExactFieldOptions& options)
    : state_(std::make_unique<State>(mesh, generators, checked(options, generators.size()))) {
  state_->generators = generators;
}
ExactField::ExactField(const Mesh& mesh, const std::vector<GeneratorCurve>& curves, const ExactFieldOptions& options)
    : state_(std::make_unique<State>(mesh, curves, checked(options, curves.size()))) {}
ExactField::~ExactField() = default;
ExactField::ExactField(ExactField&&) noexcept = default;
ExactField& ExactField::operator=(ExactField&&) noexcept = default;

double ExactField::distance(VertexId v) const { return state_->field.distance[v]; }
GeneratorId ExactField::label(VertexId v) const { return state_->field.label[v]; }

ExactField::Nearest ExactField::nearest(const SurfacePoint& point) const {
  const Mesh& mesh = state_->working.mesh();
  const SurfacePoint p = state_->to_working(point);
  if (p.kind() == SurfacePoint::Kind::vertex) {
    const VertexId v = vertex(mesh, p);
    return {distance(v), label(v)};
  }
  Nearest nearest{};
  if (p.kind() == SurfacePoint::Kind::edge) {
    const HalfedgeId h = halfedge(p);
    std::vector<EdgeSource> sources;
    collect_edge_sources(mesh, state_->field, h, sources);
    const double t = p.bary[Mesh::corner(Mesh::next(h))] * mesh.length(h);
    if (const EdgeSource* best = nearest_source(sources, t, nearest.distance)) nearest.generator = best->generator;
  } else {
    std::vector<FaceSource> sources;
    collect_face_sources(mesh, state_->field, p.face, sources);
    const Vec2 at = FaceLayout(mesh, p.face).at(p.bary);
    if (const FaceSource* best = nearest_source(sources, at, nearest.distance)) nearest.generator = best->generator;
  }
  // Sources within the limit also see points beyond it, though not on shortest paths.
  return nearest.distance > state_->max_distance ? Nearest{kInfinity, GeneratorId()} : nearest;
}

GeodesicPath ExactField::path(const SurfacePoint& point, GeneratorId only) const {
  const WorkingMesh& working = state_->working;
  GeodesicPath path = trace_shortest_path(working.mesh(), state_->field, state_->memo, state_->to_working(point), only);
  if (!path.generator.valid() || path.length > state_->max_distance) return {{}, GeneratorId(), kInfinity, false};
  path.length -= state_->offset(path.generator);
  for (SurfacePoint& p : path.points) p = state_->to_input(p);
  return path;
}

std::vector<Isoline> ExactField::isolines(const std::vector<double>& levels, const IsolineOptions& options) const {
  if (!(options.chord_tolerance > 0))
    throw Error(ErrorCode::invalid_option, "the chord tolerance must be a number above 0");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i] > (i > 0 ? levels[i - 1] : 0) && levels[i] <= state_->max_distance && std::isfinite(levels[i]))
      continue;
    throw Error(ErrorCode::invalid_option,
                fmt::format("level {} is {}; give ascending levels above 0, up to the largest distance", i, levels[i]),
                std::int64_t(i));
  }
  const WorkingMesh& working = state_->working;
  std::vector<Isoline> lines =
      trace_isolines(working.mesh(), state_->field, levels, working.input().mean_edge_length(), options);
  for (Isoline& line : lines) {
    for (SurfacePoint& p : line.points) p = state_->to_input(p);
  }
  return lines;
}

Vec2 ExactField::departure(const GeodesicPath& path) const {
  const Mesh& mesh = state_->working.input();
  if (!path.complete || path.points.size() < 2 || state_->generators.empty()) return Vec2::Zero();
  const TangentFan& fan = state_->fan(path.generator);
  // The last piece of the path lies in one face, mostly in the face that its end names. The fan has the generator as a
  // point of each of its faces.
  const SurfacePoint& before = path.points[path.points.size() - 2];
  const auto holds_piece = [&](const TangentSector& s) {
    return locate_in_face(mesh, s.point.face, before).has_value();
  };
  const TangentSector* sector = fan.sector_in(path.points.back().face);
  if (sector == nullptr || !holds_piece(*sector)) {
    const auto found = std::ranges::find_if(fan.sectors(), holds_piece);
    if (found == fan.sectors().end()) return Vec2::Zero();
    sector = &*found;
  }
  const FaceId f = sector->point.face;
  const Vec2 direction = *locate_in_face(mesh, f, before) - FaceLayout(mesh, f).at(sector->point.bary);
  return path.length * unit_vector(fan.angle(f, direction));
}

VertexDistances compute_vertex_distances(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                         const ExactFieldOptions& options) {
  return compute_from(mesh, generators, options);
}
VertexDistances compute_vertex_distances(const Mesh& mesh, const std::vector<GeneratorCurve>& curves,
                                         const ExactFieldOptions& options) {
  return compute_from(mesh, curves, options);
}

void compute_distance_rows(const Mesh& mesh, const std::vector<SurfacePoint>& sources,
                           const std::vector<SurfacePoint>* at, std::span<double> rows,
                           const ExactFieldOptions& options) {
  const std::size_t columns = at != nullptr ? at->size() : std::size_t(mesh.vertex_count());
  if (!options.offsets.empty())
    throw Error(ErrorCode::invalid_option, "rows of distances take no offsets; leave them out");
  if (rows.size() != sources.size() * columns) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("the array has room for {} numbers, and {} rows of {} distances need {}", rows.size(),
                            sources.size(), columns, sources.size() * columns));
  }
  ExactFieldOptions alone = options;
  alone.threads = 1;
  alone.progress = {};
  ParallelChunks(options.threads, options.progress).run(sources.size(), {"distances"}, [&](std::size_t i) {
    const std::span<double> row = rows.subspan(i * columns, columns);
    if (at == nullptr) {
      const VertexDistances found = compute_vertex_distances(mesh, {sources[i]}, alone);
      std::copy(found.distance.begin(), found.distance.end(), row.begin());
    } else {
      const ExactField field(mesh, {sources[i]}, alone);
      std::transform(at->begin(), at->end(), row.begin(),
                     [&](const SurfacePoint& point) { return field.nearest(point).distance; });
    }
  });
}

}  // namespace gvd
