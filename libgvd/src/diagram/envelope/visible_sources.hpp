#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "diagram/envelope/source_distances.hpp"
#include "geodesic/distance_field.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A band along a chord, in which a bisector is searched: all points within `width` of it, and up to `width` beyond its
/// two ends. Mesh units.
struct SearchBand {
  Vec2 from;           ///< beginning of the chord
  Vec2 along, across;  ///< unit vectors, the second one to the left of the first
  double length;       ///< of the chord
  double width;        ///< infinite for a band that is the whole plane

  double position(const Vec2& p) const { return (p - from).dot(along); }
  bool contains(const Vec2& p) const {
    const double at = position(p);
    return std::abs((p - from).dot(across)) <= width && at >= -width && at <= length + width;
  }
  bool is_all() const { return std::isinf(width); }
};

/// A source with the interval of positions along a band in which it may see a point of the band.
struct VisibleSource {
  const FaceSource* source;
  double first, last;  ///< mesh units along the chord
};

/// Replaces `visible` by the sources that may see a point of the band. Cost: O(sources).
void collect_visible_sources(std::span<const FaceSource> sources, const SearchBand& band,
                             std::vector<VisibleSource>& visible);

/// The shortest path to p, at a position along the band, over the sources that may see it; infinite where none does.
inline SourceDistances::Nearest nearest_visible(const std::vector<VisibleSource>& visible, double position,
                                                const Vec2& p) {
  SourceDistances::Nearest best{nullptr, {std::numeric_limits<double>::infinity(), p}};
  for (const VisibleSource& s : visible) {
    if ((position < s.first) | (position > s.last)) continue;
    if (take_nearer(*s.source, p, best.path)) best.source = s.source;
  }
  return best;
}

}  // namespace gvd
