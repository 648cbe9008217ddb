// Points, curves and measurements, as Python and JavaScript ask for them.
//
// What users give passes the same steps as files: entries of a list, which resolve_generators and resolve_curves turn
// into points and curves of the surface. So the packages and the commands read the same.
#include "bound_calls.hpp"

#include <fmt/format.h>

#include <numbers>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/io/point_writer.hpp"
#include "gvd/sampling.hpp"

namespace gvd {
namespace {

constexpr std::size_t kPointsAtOnce = 256;  ///< points or vertices whose paths one thread traces before it reports

template <class Generator>
VertexDistances measure_from(const Mesh& mesh, const std::vector<Generator>& from, const std::vector<SurfacePoint>* at,
                             const ExactFieldOptions& options) {
  if (at == nullptr) return compute_vertex_distances(mesh, from, options);
  const ExactField field(mesh, from, options);
  VertexDistances found;
  for (const SurfacePoint& point : *at) {
    const ExactField::Nearest nearest = field.nearest(point);
    found.distance.push_back(nearest.distance);
    found.label.push_back(nearest.generator);
  }
  return found;
}

/// The results of `find(i)` for i up to `count`, by all threads.
template <class Find>
auto collect(std::size_t count, const char* step, const ExactFieldOptions& options, const Find& find) {
  return ParallelChunks(options.threads, options.progress)
      .collect(cut_into_chunks(count, kPointsAtOnce), {step}, [&](const Chunk& chunk) {
        std::vector<decltype(find(chunk.begin))> found;
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) found.push_back(find(i));
        return found;
      });
}

}  // namespace

std::vector<SurfacePoint> resolve_points(const Mesh& mesh, const GeneratorList& list, std::optional<double> max_snap,
                                         std::string_view coincident, const Progress& progress) {
  ResolveOptions options{.max_snap = max_snap, .progress = progress};
  options.merge_coincident = coincident == "merge";
  options.keep_coincident = coincident == "keep";
  return resolve_generators(mesh, list, options).points;
}

CurveSet find_curves(const Mesh& mesh, std::string_view kind, std::optional<double> angle) {
  const double least = angle.value_or(kUsualCreaseAngle);
  if (!(least > 0 && least < 180)) throw Error(ErrorCode::invalid_option, "angle: it is not above 0 and below 180");
  const bool is_boundary = kind == "boundary";
  auto curves = is_boundary ? boundary_curves(mesh) : crease_curves(mesh, least * std::numbers::pi / 180);
  if (!curves.empty()) return {std::move(curves)};
  const char* const reason = is_boundary ? "the mesh is closed" : "no two faces meet at such an angle";
  throw Error(ErrorCode::precondition, fmt::format("curves: {}", reason));
}

CurveSet snap_curves(const Mesh& mesh, const CurveList& list, ResolveOptions options) {
  ResolvedGenerators snapped;
  return {resolve_curves(mesh, list, std::move(options), snapped)};
}

CurveList join_polylines(const std::vector<GeneratorList>& polylines, bool closed) {
  CurveList list;
  list.points.name = "curves";
  for (const GeneratorList& polyline : polylines) {
    auto& entries = list.points.entries;
    const auto first = std::int32_t(entries.size());
    entries.insert(entries.end(), polyline.entries.begin(), polyline.entries.end());
    const auto end = std::int32_t(entries.size());
    list.curve.resize(std::size_t(end), std::int32_t(&polyline - polylines.data()));
    for (std::int32_t i = first + 1; i < end; ++i) list.segments.push_back({i - 1, i});
    if (closed && end - first > 2) list.segments.push_back({end - 1, first});
  }
  return list;
}

VertexDistances measure(const Mesh& mesh, const std::vector<SurfacePoint>& from, const std::vector<SurfacePoint>* at,
                        const ExactFieldOptions& options) {
  return measure_from(mesh, from, at, options);
}

VertexDistances measure(const Mesh& mesh, const std::vector<GeneratorCurve>& from, const std::vector<SurfacePoint>* at,
                        const ExactFieldOptions& options) {
  return measure_from(mesh, from, at, options);
}

std::vector<GeodesicPath> trace_paths(const Mesh& mesh, const std::vector<SurfacePoint>& from,
                                      const std::vector<SurfacePoint>& to, const ExactFieldOptions& options) {
  const ExactField field(mesh, to, options);
  return collect(from.size(), "paths", options, [&](std::size_t i) { return field.path(from[i]); });
}

std::vector<Vec2> compute_log_map(const Mesh& mesh, const SurfacePoint& at, const ExactFieldOptions& options) {
  const ExactField field(mesh, std::vector{at}, options);
  return collect(std::size_t(mesh.vertex_count()), "logarithms", options, [&](std::size_t i) -> Vec2 {
    const VertexId v(i);
    const Vec2 log = field.departure(vertex_point(mesh, v));
    const bool unknown = log.isZero(0) && field.distance(v) > 0;
    return unknown ? Vec2::Constant(std::numeric_limits<double>::quiet_NaN()) : log;
  });
}

std::int32_t count_for_edge(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (edge > 0 && count <= std::numeric_limits<std::int32_t>::max()) return std::int32_t(count);
  throw Error(ErrorCode::invalid_option,
              fmt::format("target_edge: {} is not above 0, or needs too many vertices", edge));
}

std::vector<double> list_energies(const LloydResult& relaxed) {
  std::vector<double> found{relaxed.initial_energy};
  for (const LloydIteration& iteration : relaxed.iterations) found.push_back(iteration.energy);
  return found;
}

void write_samples(std::ostream& out, const Mesh& mesh, const LloydResult& relaxed, const std::string& format) {
  const auto known = parse_point_format(format);
  if (!known) {
    const std::vector<std::string_view> names = names_in(kPointFormatNames);
    throw Error(ErrorCode::invalid_option, fmt::format("{}: points are written as {}", format,
                                                       list_extensions({names.begin(), names.end()}, "or")));
  }
  std::vector<SurfaceSample> samples;
  for (const GeneratorId g : relaxed.moments.ids()) {
    const CellMoments& moments = relaxed.moments[g];
    samples.push_back({relaxed.generators[g.index()], moments.area, moments.energy});
  }
  write_points(out, mesh, samples, *known);
}

}  // namespace gvd
