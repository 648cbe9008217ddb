#pragma once

#include <cstdint>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A label interval between two generators of a crease counts if it is longer than this fraction of the generators'
/// distance, because a cell may touch a crease at a point.
inline constexpr double kLeastForeignShare = 1e-6;

/// A new generator is not nearer to the generators on its two sides than this fraction of their distance.
inline constexpr double kLeastEndShare = 0.05;

/// An edge between consecutive generators of a crease must not cut off a bend of more than this, in degrees, so that a
/// circle has at least nine edges. The direction of an arc differs from its edge's direction by at most half of the
/// bend.
inline constexpr double kLargestBend = 40;

/// A part of a curve that the dual's edges do not follow, or along which they cut off a bend.
struct CreaseDefect {
  std::vector<SurfacePoint> places;  ///< where generators would help
  double length = 0;                 ///< mesh units; defects of a curve do not overlap; 0 for a bend
  bool at_corner = false;            ///< the part beside a corner without a generator
  bool waits = false;                ///< for a generator at a corner of the curve, which changes this defect
};

/// Finds where the dual of a diagram leaves the creases.
///
/// The dual follows a curve if the cells of any two consecutive generators cover the curve between them. Then these two
/// cells share a bisector that crosses the curve, so that an edge joins the two generators, and no other cell contains
/// a point of the curve there, so that no edge between generators on its two sides crosses it. Other generators of the
/// curve count as foreign there as well. Ends and turns need generators at the corners themselves, and a closed curve
/// needs three.
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
/// `spacing` is the spacing of evenly spread generators, in mesh units. Shorter edges may cut off bends, because a
/// circle that is small compared with the triangles needs few edges. Returns the defects at corners first, then the
/// others by length, the longest first. The sum of their lengths exceeds the length of the curves by rounding at most.
/// Cost: O(n), and O(k log k) for k labels on creases.
std::vector<CreaseDefect> find_crease_defects(const Mesh& mesh, const std::vector<CreaseCurve>& curves,
                                              const Diagram& diagram, double spacing);

/// The largest number of rounds that add generators on creases. As a rule, a round shrinks the defects to less than
/// three quarters. If few generators are given for many creases, the first rounds fill corners and closed curves, and
/// some defects may stay.
inline constexpr int kCreaseRounds = 12;

/// Adds generators on creases, round by round, so that the dual's edges follow them.
class CreaseFollower {
 public:
  /// The mesh and the creases must outlive this. `max_added` limits the generators of all rounds together; `spacing` is
  /// as for find_crease_defects. Cost: O(n).
  CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added, double spacing);

  /// New generators for the largest defects, at most `may_add`. None if there is no defect, or if the rounds or the
  /// generators are used up; the other defects then stay. Cost: O(n), and O(k m) for k new generators besides m others.
  std::vector<SurfacePoint> propose(const Diagram& diagram, std::int64_t may_add);

  std::int64_t added() const { return added_; }
  /// Whether the last `propose` would have returned more generators for a larger `may_add`.
  bool is_held_back() const { return is_held_back_; }
  /// The length of all creases, mesh units.
  double length() const { return length_; }
  /// The length of the parts that the dual of the last `propose` does not follow, mesh units, in [0, length()].
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
