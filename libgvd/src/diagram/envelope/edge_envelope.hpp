#pragma once

#include <cstdint>
#include <vector>

#include "geodesic/distance_field.hpp"
#include "geodesic/symbolic_offset.hpp"

namespace gvd {

/// The lower envelope of the sources' distances along one edge: which source is the nearest where.
///
/// The distance of a source is a branch of a hyperbola over its interval, and two of them are equal in at most two
/// points. The sources of the edge's ends reach all of it, so that there is no gap.
/// Cost: O(k^2) for k sources at worst; k is seldom above 8.
class EdgeEnvelope {
 public:
  /// An interval of the edge on which one source is the nearest. It begins where the one before ends.
  struct Segment {
    double end;           ///< mesh units
    std::int32_t source;  ///< index
    double most = 0;      ///< the largest distance of the source on the interval
  };

  /// `sources` as DistanceField::collect gives them, at least two; `length` of the edge in mesh units, > 0.
  void build(const std::vector<EdgeSource>& sources, double length, const SymbolicOffset& offset);

  double length() const { return length_; }
  /// Ascending, up to `length`. Neighbours have different sources, but often the same generator.
  const std::vector<Segment>& segments() const { return segments_; }
  GeneratorId generator(const Segment& s) const { return sources_[s.source].generator; }
  /// All sources, with their symbolic offsets and within the edge.
  const std::vector<EdgeSource>& sources() const { return sources_; }

 private:
  std::int32_t nearer(std::int32_t a, std::int32_t b, double t) const {
    const EdgeSource &first = sources_[a], &second = sources_[b];
    return second.straight(t) < first.straight(t) ? b : a;
  }
  double begin_of(std::vector<Segment>::const_iterator segment) const {
    return segment == segments_.begin() ? 0 : (segment - 1)->end;
  }
  void insert(std::int32_t source);
  void replace(std::vector<Segment>::iterator first, std::vector<Segment>::iterator last);
  void append(double end, std::int32_t source);
  bool append_nearer(std::int32_t old_source, std::int32_t source, double begin, double end);
  bool append_nearer_pieces(std::int32_t old_source, std::int32_t source, double begin, double end);

  std::vector<EdgeSource> sources_;
  std::vector<Segment> segments_;
  std::vector<Segment> pieces_;  // that replace some segments when a source is inserted
  double length_ = 0;
  double unit_ = 1;  // as equidistant_positions wants it
};

}  // namespace gvd
