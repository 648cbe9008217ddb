#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "io/generators/list_location.hpp"

namespace gvd {
namespace {

using Kind = GeneratorEntry::Kind;

/// Largest difference of the sum of three coordinates from 1 at which they are kept bit by bit. Dimensionless: above
/// the rounding error of computed coordinates, and below that of coordinates with few printed digits, which are scaled.
constexpr double kExactSum = 1e-12;

/// The point of given coordinates. Those of a surface point are kept: make_surface_point would change their last bits.
SurfacePoint keep_or_make_point(FaceId face, const std::array<double, 3>& bary) {
  const auto is_kept = [](double b) { return b == 0 || (b >= 0.5 * kBarycentricSnap && b <= 1); };
  const bool whole = std::all_of(bary.begin(), bary.end(), is_kept);
  // JSON has no -0: the sum turns it into 0, so that a list means the same in each format.
  if (whole && std::abs(bary[0] + bary[1] + bary[2] - 1) <= kExactSum) {
    return {face, {bary[0] + 0.0, bary[1] + 0.0, bary[2] + 0.0}};
  }
  return make_surface_point(face, bary);
}

class Resolver {
 public:
  Resolver(const Mesh& mesh, const GeneratorList& list, const ResolveOptions& options)
      : mesh_(mesh), list_(list), options_(options) {}

  ResolvedGenerators run() {
    const auto count = static_cast<double>(list_.entries.size());
    for (const GeneratorEntry& entry : list_.entries) {
      report_progress(options_.progress, "generators", static_cast<double>(result_.points.size()) / count);
      result_.snap_distance.emplace_back();
      result_.points.push_back(resolve(entry));
    }
    merge_coincident();
    return std::move(result_);
  }

 private:
  std::string location(std::size_t entry) const {
    return detail::ListLocation{list_.name, list_.entries[entry].line}.text();
  }

  [[noreturn]] void refuse(std::size_t entry, const std::string& message) const {
    throw Error(ErrorCode::precondition, location(entry) + ": " + message, static_cast<std::int64_t>(entry));
  }

  /// Refuses the entry that is being resolved.
  [[noreturn]] void refuse(const std::string& message) const { refuse(result_.points.size(), message); }

  SurfacePoint resolve(const GeneratorEntry& entry) {
    switch (entry.kind) {
      case Kind::vertex:
        return resolve_vertex(entry.index);
      case Kind::face:
        return resolve_face(entry);
      case Kind::position:
        break;
    }
    return snap({entry.values[0], entry.values[1], entry.values[2]});
  }

  SurfacePoint resolve_vertex(std::int64_t index) const {
    const std::vector<VertexId>* const map = options_.input_vertices;
    const std::int64_t count = map ? static_cast<std::int64_t>(map->size()) : mesh_.vertex_count();
    if (index >= count) refuse(fmt::format("there is no vertex {}; the mesh has {}, numbered from 0", index, count));
    const VertexId v = map ? (*map)[index] : VertexId(index);
    if (!v.valid()) refuse(fmt::format("vertex {} is in no face of the mesh; choose another", index));
    return vertex_point(mesh_, v);
  }

  SurfacePoint resolve_face(const GeneratorEntry& entry) const {
    const std::int32_t count = mesh_.face_count();
    if (entry.index >= count) {
      refuse(fmt::format("there is no face {}; the mesh has {}, numbered from 0", entry.index, count));
    }
    try {
      return keep_or_make_point(FaceId(entry.index), entry.values);
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

  SurfacePoint snap(const Vec3& given) {
    if (!tree_) tree_.emplace(mesh_);
    ClosestPoint closest;
    try {
      closest = tree_->query(given);
    } catch (const Error& error) {
      refuse(error.what());
    }
    if (options_.max_snap && closest.distance > *options_.max_snap) {
      refuse(fmt::format("this position is {} from the surface, more than the {} allowed; move it, or raise max_snap",
                         closest.distance, *options_.max_snap));
    }
    result_.snap_distance.back() = closest.distance;
    return closest.point;
  }

  /// Leaves out or refuses entries that coincide with an earlier one.
  void merge_coincident() {
    const std::vector<std::int32_t> first = find_coincident(mesh_, result_.points);
    ResolvedGenerators kept;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto twin = static_cast<std::size_t>(first[i]);
      if (twin == i) {
        kept.points.push_back(result_.points[i]);
        kept.snap_distance.push_back(result_.snap_distance[i]);
      } else if (!options_.merge_coincident) {
        refuse(i, fmt::format(
                      "generator {} is in the same place as generator {} ({}); remove one, or set merge_coincident", i,
                      twin, location(twin)));
      }
    }
    kept.merged = static_cast<std::int32_t>(first.size() - kept.points.size());
    result_ = std::move(kept);
  }

  const Mesh& mesh_;
  const GeneratorList& list_;
  const ResolveOptions& options_;
  std::optional<ClosestPointTree> tree_;
  ResolvedGenerators result_;
};

}  // namespace

ResolvedGenerators resolve_generators(const Mesh& mesh, const GeneratorList& list, const ResolveOptions& options) {
  return Resolver(mesh, list, options).run();
}

}  // namespace gvd
