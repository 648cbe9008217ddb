#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/envelope/bisector_sampler.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// Refines the straight arcs of a face to polylines along the bisectors of their two generators, by inner points. One
/// object serves one face after the other, to save allocations.
class ArcRefiner {
 public:
  /// No segment will be farther than `tolerance` (mesh units, > 0) from the bisector.
  explicit ArcRefiner(double tolerance) : tolerance_(tolerance), sampler_(tolerance) {}

  /// Appends the inner points of the arc from `begin` to `end`, in the face that the distances have entered, to
  /// `points`.
  /// Cost: O(points) samples, over the sources visible from near the arc; three where the bisector is straight.
  void refine(const SourceDistances& distances, const FaceArc& arc, const Bary& begin, const Bary& end,
              std::vector<Bary>& points);

 private:
  /// A point of the bisector, and the bisector's direction there.
  struct BisectorPoint {
    BisectorSample sample;
    Vec2 point, tangent;
    explicit BisectorPoint(const BisectorSample& at) : sample(at), point(at.point), tangent(at.tangent()) {}
  };

  bool refine(const BisectorPoint& begin, const BisectorPoint& end, int halvings);
  static double height_by_tangents(const BisectorPoint& begin, const BisectorPoint& end);
  bool is_near_quarters(const BisectorPoint& begin, const BisectorPoint& end) const;
  std::optional<Vec2> likely_corner(const BisectorPoint& begin, const BisectorPoint& end) const;
  std::optional<BisectorPoint> find_across(BisectorSample sample, const Vec2& along) const;
  std::pair<double, double> feasible_interval(const Vec2& p, const Vec2& direction) const;

  double tolerance_;
  BisectorSampler sampler_;
  const FaceLayout* layout_ = nullptr;   // of the current face
  std::vector<Bary>* points_ = nullptr;  // of the current arc
};

}  // namespace gvd
