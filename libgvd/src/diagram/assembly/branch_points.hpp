#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>

#include "base/barycentric.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "diagram/assembly/face_polygon.hpp"

namespace gvd {

/// Searches the branch points of a face. An interval of a polygon and its two neighbours may have a branch point in
/// common, which the paths confirm or which is guessed. Distances, paths and intervals must outlive this object.
class BranchSearch {
 public:
  /// `paths` is null if nothing can be confirmed.
  BranchSearch(const FaceDistances& distances, const FacePaths* paths, LabelIntervals& intervals)
      : distances_(distances), paths_(paths), intervals_(intervals) {}

  /// A confirmed branch point of the interval at corner `corner` and its two neighbours.
  struct Confirmed {
    std::size_t corner;
    Bary point;
  };
  /// The first confirmed branch point of the polygon, if it has one. Searches that failed are not repeated.
  std::optional<Confirmed> find_confirmed(const FacePolygon& polygon);
  /// Allows failed searches again. Call it after uniting intervals, because a path may then enter through more of them.
  void clear_failed_searches() { failed_.clear(); }

  /// A point equally far from the generators of corner i's interval and its neighbours, searched from `start`; it may
  /// lie outside the face.
  std::optional<Bary> guess(const FacePolygon& polygon, std::size_t i, const Bary& start) const;

  /// How much farther every other generator of the polygon is than corner i's interval and its neighbours, at the point
  /// equally far from these three. The lowest double if that point is outside the face or does not exist.
  double clearance(const FacePolygon& polygon, std::size_t i) const;

 private:
  enum class Search : std::uint8_t { from_nearby, everywhere };
  bool is_first_search(const FacePolygon& polygon, std::size_t i, Search search);
  std::optional<Bary> confirmed_point(const FacePolygon& polygon, std::size_t i, const Bary& start);

  const FaceDistances& distances_;
  const FacePaths* paths_;
  LabelIntervals& intervals_;
  std::set<std::tuple<Search, int, int, int>> failed_;  // kind of search and the three intervals
};

// The following functions move a guessed branch point to where the arcs that end there can't cross: to the nearest
// valid point on the way from a point that is certainly valid. `is_accurate` tells whether the distances can confirm
// branch points. If so, a guess may stay as near to a side, and as far beyond another arc, as ties require.

/// For a polygon of all three crossings of the face. Returns a point strictly inside the face.
Bary place_in_face(const FacePolygon& polygon, const std::optional<Bary>& wanted, bool is_accurate);
/// For a polygon of three corners. Returns a point inside the polygon.
Bary place_in_polygon(const FacePolygon& polygon, const std::optional<Bary>& wanted, bool is_accurate);
/// For the closing of interval i, whose two corners the branch point replaces. Returns a point inside the polygon for
/// which the rest of the polygon is convex.
Bary place_at_interval(const FacePolygon& polygon, std::size_t i, const std::optional<Bary>& wanted, bool is_accurate);

}  // namespace gvd
