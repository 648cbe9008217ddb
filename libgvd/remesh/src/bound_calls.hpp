#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "bound_results.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

// What calls of Python and JavaScript have in common between their own arguments and the library.
namespace gvd {

/// The names of the codes of errors, by ErrorCode.
inline constexpr std::array<const char*, 7> kErrorCodeNames{"invalid_option",  "unreadable_input",  "precondition",
                                                            "no_valid_result", "unwritable_output", "reader_gone",
                                                            "interrupted"};

/// The kinds of points as both packages number them.
inline constexpr std::array<GeneratorEntry::Kind, 3> kPointKinds{
    GeneratorEntry::Kind::vertex, GeneratorEntry::Kind::face, GeneratorEntry::Kind::position};

/// Curves of a mesh as generators.
struct CurveSet {
  std::vector<GeneratorCurve> curves;
};

/// The points of a list. `coincident`: keep, merge or refuse.
std::vector<SurfacePoint> resolve_points(const Mesh& mesh, const GeneratorList& list, std::optional<double> max_snap,
                                         std::string_view coincident, const Progress& progress = {});

/// "boundary", or "creases" whose faces differ by more than `angle`, degrees; by default as --curves creases.
/// Throws Error{precondition} where there are none.
CurveSet find_curves(const Mesh& mesh, std::string_view kind, std::optional<double> angle);

/// The curves of a list, without a note on how far points were moved: only `max_snap` limits that.
CurveSet snap_curves(const Mesh& mesh, const CurveList& list, ResolveOptions options);

/// A polyline for each list of points, as files give curves.
CurveList join_polylines(const std::vector<GeneratorList>& polylines, bool closed);

/// Distances of points, or of all vertices where `at` is null, and which generator is nearest.
VertexDistances measure(const Mesh& mesh, const std::vector<SurfacePoint>& from, const std::vector<SurfacePoint>* at,
                        const ExactFieldOptions& options);
VertexDistances measure(const Mesh& mesh, const std::vector<GeneratorCurve>& from, const std::vector<SurfacePoint>* at,
                        const ExactFieldOptions& options);

/// The path from each point to the nearest of `to`.
std::vector<GeodesicPath> trace_paths(const Mesh& mesh, const std::vector<SurfacePoint>& from,
                                      const std::vector<SurfacePoint>& to, const ExactFieldOptions& options);

/// The logarithm of every vertex at a point; NaN where no path leads to it.
std::vector<Vec2> compute_log_map(const Mesh& mesh, const SurfacePoint& at, const ExactFieldOptions& options);

/// The number of vertices of a mesh with edges of this mean length. Throws Error{invalid_option} for too many.
std::int32_t count_for_edge(const Mesh& mesh, double edge);

/// The energy at the start and after each iteration.
std::vector<double> list_energies(const LloydResult& relaxed);

/// The file of gvd-lloyd --points. Throws Error{invalid_option} for another format than those of PointFormat.
void write_samples(std::ostream& out, const Mesh& mesh, const LloydResult& relaxed, const std::string& format);

/// Reads regions and generators, by their names in both packages (see gvd/named_options.hpp for `Given`).
template <class Given>
void read_regions(const Given& given, RegionOptions& regions, LevelOptions& level) {
  if (given.has("within")) regions.within = given.numbers("within");
  if (given.has("mask")) regions.mask = given.numbers("mask");
  if (given.has("levels")) {
    constexpr double kMost = std::numeric_limits<std::int32_t>::max();
    for (const double count : given.numbers("levels")) regions.levels.push_back(std::int32_t(std::min(count, kMost)));
  }
  if (given.has("generators")) {
    regions.listed = given.points("generators");
  } else {
    level.generators.sampling = given.sampling("sampler");
  }
  level.generators.each_region = given.has("per_region");
  given.read("labels", level.labels.labels, kFaceLabelNames);
}

}  // namespace gvd
