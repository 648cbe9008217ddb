#pragma once

#include <cstdint>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Least length of a label interval between two generators of a crease that counts, relative to the generators'
/// distance: cells may touch a crease in a point.
inline constexpr double kLeastForeignShare = 1e-6;

/// New generators are not nearer than this to the generators on their two sides, relative to the distance of these.
inline constexpr double kLeastEndShare = 0.05;

/// The edge between consecutive generators of a crease shall not cut off a bend of more degrees: a circle then has nine
/// edges at least. The direction of an arc differs from that of such an edge by half of that at most.
inline constexpr double kLargestBend = 40;

/// A part of a curve that the dual's edges do not follow, or where they cut off a bend.
struct CreaseDefect {
  std::vector<SurfacePoint> places;  ///< where generators would help
  double length = 0;                 ///< mesh units; defects of a curve do not overlap; 0 for a bend
  bool at_corner = false;            ///< the part beside a corner without a generator
  bool waits = false;                ///< for a generator at a corner of the curve, which changes this defect
};

/// Finds where the dual of a diagram leaves the creases.
///
/// The dual follows a curve of the creases if the cells of any two consecutive generators cover the curve between them.
/// Then these cells share a bisector that crosses the curve there: an edge joins consecutive generators. No other cell
/// contains a point of the curve, so that no edge between generators on the two sides crosses it. The other generators
/// of the curve count as foreign there, too. The generators of the ends and of turns have to be at the corners
/// themselves, and a closed curve needs three.
///
/// The place of a generator for each kind of defect:
/// - from a corner without a generator to the first generator of the curve: the corner;
/// - a whole curve that has too few generators: thirds of its length;
/// - beside a corner that a curve of the foreign generator leaves: the point whose distance from the corner is a power
///   of two, and a third to two thirds of the way between the two generators;
/// - any other: the point nearest to the foreign generator;
/// - any other, where that point is next to an end (kLeastEndShare): the middle of the foreign cells;
/// - a bend (kLargestBend) of a crease between generators that are farther apart than `spacing`: the middle. Boundaries
///   of scans bend at every scale, so bends of boundaries do not count.
///
/// `spacing`: that of evenly spread generators, mesh units. Shorter edges may cut off bends: circles that are small
/// beside the triangles need few edges.
/// Returns: the defects at corners first, then the longest first. The sum of their lengths exceeds that of the curves by
/// rounding at most. Cost: O(n), and O(k log k) for k labels on creases.
std::vector<CreaseDefect> find_crease_defects(const Mesh& mesh, const std::vector<CreaseCurve>& curves,
                                              const Diagram& diagram, double spacing);

/// Rounds that add generators on creases. Defects shrink to less than three quarters each time, as a rule: where few
/// generators are given for many creases, the first rounds fill corners and closed curves, and some defects may stay.
inline constexpr int kCreaseRounds = 12;

/// Adds generators on creases, round by round, so that the dual's edges follow them.
class CreaseFollower {
 public:
  /// Mesh and creases must outlive this. `max_added`: generators in all rounds together. `spacing`: as in
  /// find_crease_defects. Cost: O(n).
  CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added, double spacing);

  /// New generators for the largest defects, at most `may_add`. None where there is no defect, and once the rounds or
  /// the generators are used up: other defects then stay. Cost: O(n), and O(k m) for k new ones beside m generators.
  std::vector<SurfacePoint> propose(const Diagram& diagram, std::int64_t may_add);

  std::int64_t added() const { return added_; }
  /// Whether the last `propose` would have returned more generators for a larger `may_add`.
  bool is_held_back() const { return is_held_back_; }
  /// The length of all creases, mesh units.
  double length() const { return length_; }
  /// The length of what the dual of the last `propose` does not follow, mesh units, in [0, length()].
  double gap_length() const { return gap_length_; }

 private:
  const Mesh& mesh_;
  const std::vector<CreaseCurve>& curves_;
  double length_ = 0;
  double gap_length_ = 0;
  std::int64_t max_added_;
  double spacing_;
  std::int64_t added_ = 0;
  bool is_held_back_ = false;
  int rounds_ = 0;
};

}  // namespace gvd
