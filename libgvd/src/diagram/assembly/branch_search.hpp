#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>

#include "diagram/assembly/face_distances.hpp"
#include "diagram/assembly/face_polygon.hpp"
#include "diagram/assembly/label_intervals.hpp"

namespace gvd {

/// Looks for the branch points of a face: first those that the metric is sure of, then guesses.
/// The metric and the runs must outlive it.
class BranchSearch {
 public:
  using Bary = FaceDistances::Bary;

  BranchSearch(const FaceDistances& distances, LabelIntervals& runs) : distances_(distances), runs_(runs) {}

  /// A run that meets the runs before and after it in a point that the metric is sure of.
  struct Triple {
    std::size_t run;
    Bary point;
  };
  /// One of the polygon's, if there is one. What was looked for in vain is not looked for again.
  std::optional<Triple> find_confirmed(const FacePolygon& polygon);
  /// Runs have been united: paths may come by more of them now, and what failed is worth another look.
  void clear_failed_searches() { tried_.clear(); }

  /// A point that is equally far from the generators of run i and its neighbours, looked for from `start` on; it may
  /// lie outside of the face.
  std::optional<Bary> guess(const FacePolygon& polygon, std::size_t i, const Bary& start) const;

  /// How much nearer run i and its neighbours are than all others, where they meet. A triple that meets outside of the
  /// face, or nowhere, is the last choice.
  double lead(const FacePolygon& polygon, std::size_t i) const;

 private:
  enum class Search : std::uint8_t { nearby, everywhere };
  bool is_new_try(const FacePolygon& polygon, std::size_t i, Search search);
  std::optional<Bary> confirmed_point(const FacePolygon& polygon, std::size_t i, const Bary& start);

  const FaceDistances& distances_;
  LabelIntervals& runs_;
  std::set<std::tuple<Search, int, int, int>> tried_;  // searches for a branch point of three runs that found none
};

}  // namespace gvd
