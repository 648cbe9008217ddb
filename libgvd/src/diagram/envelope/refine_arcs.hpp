#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "diagram/envelope/source_distances.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// Bends the straight arcs of a face into the bisectors of their two generators.
///
/// A bisector is made of pieces of hyperbolas, straight where the two offsets agree, with a corner wherever the
/// source that reaches it first changes. A straight piece that is too far off, as the bisector's directions at its ends
/// and looks at a few places show, is parted by a point of the bisector.
class ArcRefiner {
 public:
  using Bary = FaceDistances::Bary;

  /// `metric` has to outlive this. No straight piece will be farther than `tolerance` (mesh units) from the bisector.
  ArcRefiner(const SourceDistances& distances, double tolerance) : distances_(distances), tolerance_(tolerance) {}

  /// Appends the inner points of the arc from `begin` to `end`, in the face that the metric has entered, to `points`.
  /// Cost: O(points) looks at the sources that are seen from near the arc; three where the bisector is straight.
  void refine(const FaceArc& arc, const Bary& begin, const Bary& end, std::vector<Bary>& points);

 private:
  /// What the two generators look like from a point.
  struct View {
    Vec2 point;
    FaceSource::Path left, right;
    /// Whether a source of each sees the point.
    bool is_known() const { return std::isfinite(left.distance) && std::isfinite(right.distance); }
    double error() const { return left.distance - right.distance; }
    /// How much of the error may be rounding.
    double rounding() const;
    /// How the error changes, per mesh unit.
    Vec2 gradient() const { return direction(point, left.from) - direction(point, right.from); }
    /// Along the bisector.
    Vec2 way() const { return turned_left(gradient()); }
    /// How far off along `across`, a unit vector, the two straight paths are equally long, by Newton's steps.
    double way_to_meeting(const Vec2& across, double precision) const;
  };
  /// A point of the bisector, and the way that it runs there.
  struct OnBisector {
    Vec2 point, way;
    explicit OnBisector(const View& view) : point(view.point), way(view.way()) {}
  };

  /// A source, and the part of the strip along the arc in which it may see something, mesh units.
  struct VisibleSource {
    const FaceSource* source;
    double first, last;
  };
  /// The arc at work, and how far from it looks are sure to see what is the nearest.
  struct SearchBand {
    Vec2 from, along, across;  // the last two are unit vectors
    double length, width;      // the strip goes on by its width beyond both ends
    double place(const Vec2& p) const { return (p - from).dot(along); }
    bool contains(const Vec2& p) const {
      const double there = place(p);
      return std::abs((p - from).dot(across)) <= width && there >= -width && there <= length + width;
    }
    bool is_all() const { return std::isinf(width); }
  };

  void collect_visible_sources(GeneratorId g, std::vector<VisibleSource>& seeing) const;
  bool refine(const OnBisector& begin, const OnBisector& end, int halvings);
  static double height_by_ends(const OnBisector& begin, const OnBisector& end);
  View look(const Vec2& p) const;
  static FaceSource::Path nearest(const std::vector<VisibleSource>& seeing, double place, const Vec2& p);
  bool is_near(const View& view) const;
  bool is_near_quarters(const Vec2& begin, const Vec2& chord) const;
  std::optional<Vec2> likely_corner(const OnBisector& begin, const OnBisector& end) const;
  std::optional<OnBisector> moved_across(View view, const Vec2& along) const;
  std::pair<double, double> room(const Vec2& p, const Vec2& way) const;

  const SourceDistances& distances_;
  double tolerance_;
  SearchBand band_{};
  std::vector<VisibleSource> left_, right_;  // what may be the nearest in the strip
  std::vector<Bary>* points_ = nullptr;
};

}  // namespace gvd
