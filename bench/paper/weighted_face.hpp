#pragma once

#include <array>
#include <map>
#include <vector>

#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/crossings.hpp"
#include "geodesic/distance_field.hpp"
#include "pieces.hpp"

namespace gvd::paper {

/// A part of a face's boundary with one label: from its first point to its last one, counter-clockwise. The points may
/// go on to a branch point inside.
struct BoundaryRun {
  GeneratorId generator;
  std::vector<std::array<double, 3>> points;
  /// Where the run begins and ends on the boundary: corner + parameter along the halfedge of that corner; begin is
  /// below 3, and end is not below begin.
  double begin = 0, end = 0;
};

/// Cuts a face by the additively weighted Voronoi diagram of the sources that reach it, with straight segments.
///
/// Two crossings are joined by a segment. Runs of three generators can follow each other. Then the one in the middle
/// ends in a point that is equally far from all three. No other generator is nearer to that point. The straight paths
/// back from that point must leave the face through these three runs. The same again with the runs that are left. A run
/// between two of one generator is closed by a segment, first where paths to one of the two enter through the other.
/// Where no rule applies the ends meet in the mean of the crossings, and the face counts as forced.
class WeightedFace {
 public:
  /// `sources`: all that reach the face, as `DistanceField::collect` gives them. Lengths in mesh units. Both must
  /// outlive this.
  WeightedFace(const FaceLayout& layout, const std::vector<FaceSource>& sources);

  struct Cut {
    std::vector<BoundaryRun> polygons;  ///< the points go round the whole piece
    bool forced = false;
  };
  /// `runs`: round the boundary; two or more, with different labels one after the other.
  Cut cut(std::vector<BoundaryRun> runs) const;

 private:
  using Three = std::array<const BoundaryRun*, 3>;

  const FaceSource* nearest(GeneratorId g, const Vec2& p, double& distance) const;
  bool enters_through(const BoundaryRun& run, const Vec2& p) const;
  bool is_branch_point(const Three& runs, const Vec2& p) const;
  const std::vector<Vec2>& find_equidistant_points(const Three& runs) const;
  std::vector<std::array<double, 3>> find_branch_points(const Three& runs) const;
  bool is_linked(const BoundaryRun& run, const BoundaryRun& other) const;
  bool contract_triple(std::vector<BoundaryRun>& runs, Cut& cut) const;
  bool contract_bump(std::vector<BoundaryRun>& runs, bool linked, Cut& cut) const;
  void join_last(std::vector<BoundaryRun> runs, Cut& cut) const;

  const FaceLayout& layout_;
  std::vector<std::vector<FaceSource>> sources_;  // by generator, ascending
  mutable EquidistantSearch search_;
  mutable std::map<std::array<GeneratorId, 3>, std::vector<Vec2>> equidistant_;  // what searches found
};

/// The runs of a face's boundary between its crossings, which are not empty.
std::vector<BoundaryRun> make_runs(const std::vector<BoundaryCrossing>& crossings);

}  // namespace gvd::paper
