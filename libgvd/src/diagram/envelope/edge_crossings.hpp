#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/symbolic_offset.hpp"

namespace gvd {

/// A source's straight paths to the two ends of an interval.
struct EndPaths {
  struct StraightPath {
    double along, straight, distance;
    StraightPath(const EdgeSource& s, double t)
        : along(t - s.x), straight(std::sqrt(along * along + s.depth * s.depth)), distance(s.offset + straight) {
      if (s.is_parallel()) [[unlikely]]
        *this = {s.x, 1, s.straight(t)};
    }
    StraightPath(double slope, double unit, double length) : along(slope), straight(unit), distance(length) {}
    /// Derivative of the distance along the edge.
    double slope() const { return straight > 0 ? along / straight : 0; }
  };
  StraightPath begin, end;
  EndPaths(const EdgeSource& s, double from, double to) : begin(s, from), end(s, to) {}
};

/// Whether a source that is farther than another source at both ends of an interval is certainly farther everywhere in
/// it. Both distances are convex: the farther one lies above its tangents at the ends, and the nearer one below its
/// chord. The answer is therefore yes if the tangents intersect above the chord.
inline bool is_farther_between(const EndPaths& paths, const EndPaths& others, double width) {
  const double first = paths.begin.slope(), last = paths.end.slope();
  if (!(last > first)) return true;
  const double intersection = (paths.begin.distance - paths.end.distance + last * width) / (last - first);
  const double chord = others.begin.distance + (others.end.distance - others.begin.distance) * (intersection / width);
  return paths.begin.distance + first * intersection > chord;
}

/// Which of two sources of an edge is nearer on an interval, by their straight paths; `open` if the nearer one may
/// change.
enum class Nearer { first, second, open };

/// Compares two sources on [begin, end]. Cost: O(1). It is inline because in the innermost loop of the envelope a call
/// would cost as much as the comparison.
inline Nearer compare_sources(const EdgeSource& first, const EdgeSource& second, double begin, double end) {
  const EndPaths a(first, begin, end), b(second, begin, end);
  const double at_begin = b.begin.distance - a.begin.distance, at_end = b.end.distance - a.end.distance;
  if (at_begin > 0 && at_end > 0 && is_farther_between(b, a, end - begin)) return Nearer::first;
  if (at_begin < 0 && at_end < 0 && is_farther_between(a, b, end - begin)) return Nearer::second;
  return Nearer::open;
}

/// The positions on the edge's line where the straight paths of two sources may be equally long, ascending; -1 stands
/// for a position that does not exist. All positions of equal length are among them, and perhaps others. If the two
/// distances touch, they have half of the digits. `unit` is a power of two that brings the edge's length near 1, so
/// that its sixth powers stay in range.
std::array<double, 2> equidistant_positions(const EdgeSource& first, const EdgeSource& second, double unit);

/// Improves such a position by steps of Newton's method, inside (begin, end).
double refine_equidistant(const EdgeSource& first, const EdgeSource& second, double begin, double end, double position);

/// The lower envelope of the sources' distances along one edge, which gives the nearest source at each position. The
/// sources of the edge's ends reach all of it, so that there is no gap.
/// Cost: O(k^2) for k sources at worst; k is seldom above 8.
class EdgeEnvelope {
 public:
  /// An interval of the edge on which one source is the nearest. It begins where the segment before it ends.
  struct Segment {
    double end;           ///< mesh units
    std::int32_t source;  ///< index
    double most = 0;      ///< no distance of the source on the interval is larger
  };

  /// `sources` are those of DistanceField::collect, at least two. `length` is the length of the edge in mesh units, >
  /// 0.
  void build(const std::vector<EdgeSource>& sources, double length, const SymbolicOffset& offset);

  double length() const { return length_; }
  /// Ascending, up to `length`. Neighbours have different sources, but often the same generator.
  const std::vector<Segment>& segments() const { return segments_; }
  GeneratorId generator(const Segment& s) const { return sources_[s.source].generator; }
  /// All sources, with their symbolic offsets and within the edge.
  const std::vector<EdgeSource>& sources() const { return sources_; }

 private:
  double begin_of(std::vector<Segment>::const_iterator segment) const {
    return segment == segments_.begin() ? 0 : (segment - 1)->end;
  }
  bool is_end(const EdgeSource& s) const;
  bool is_reached(const EdgeSource& end) const;
  bool is_continuous() const;
  void insert(std::int32_t source);
  void fill(std::vector<Segment>::iterator gap, std::int32_t source, double low);
  void replace(std::vector<Segment>::iterator first, std::vector<Segment>::iterator last, std::int32_t source);
  /// Appends a piece, or extends the last piece.
  void append(const Segment& piece) {
    if (!pieces_.empty() && pieces_.back().source == piece.source) {
      pieces_.back().end = piece.end;
    } else {
      pieces_.push_back(piece);
    }
  }
  bool append_nearer(const Segment& old, std::int32_t source, double begin, double end);

  /// Stands for the source of an interval that no source reaches.
  static constexpr std::int32_t kNoSource = -1;

  std::vector<EdgeSource> sources_;
  std::vector<Segment> segments_;
  std::vector<Segment> pieces_;  // pieces that replace some segments when a source is inserted
  double length_ = 0;
  double unit_ = 1;    // for equidistant_positions
  double sliver_ = 0;  // width below which an interval can have no label of its own, mesh units
};

/// The distances of the generators along one edge. The distance of a generator is the length of the shortest path over
/// all its sources.
class EdgeDistances {
 public:
  /// Copies the sources of an edge. Cost: O(k log k) for k sources.
  void build(const std::vector<EdgeSource>& sources) { sources_.build(sources); }

  /// Length of the shortest path from generator g to t; infinity if g has no source.
  /// Cost: O(log k + sources of g), most of them without a square root.
  double at(GeneratorId g, double t) const;

 private:
  SourcesByGenerator<EdgeSource> sources_;
};

/// Finds the crossings of edge after edge.
/// Properties of the result: (1) crossings ascend, lie strictly between 0 and 1, and keep a distance from each other
/// and from the ends; (2) they form a chain of generators from the label of the first end to that of the last, whatever
/// the distances are.
class EdgeCrossings {
 public:
  /// Appends all crossings of edge e, whose ends have the labels `first` and `last`.
  void append_all(const EdgeEnvelope& envelope, EdgeId e, GeneratorId first, GeneratorId last,
                  std::vector<Crossing>& crossings);

  /// Appends a single crossing, between different labels of the ends: where their two generators are equally far, if
  /// there is such a point, whichever generators are nearest between them.
  void append_single(const EdgeEnvelope& envelope, EdgeId e, GeneratorId first, GeneratorId last,
                     std::vector<Crossing>& crossings);

 private:
  /// A part of the edge with one label, up to the beginning of the next interval.
  struct LabelInterval {
    double begin;  // mesh units
    GeneratorId generator;
  };

  /// A position where two generators may be equally far, and the interval around it to search.
  struct Guess {
    double low, position, high;
  };

  void enter(const EdgeEnvelope& envelope);
  void find_label_intervals(const EdgeEnvelope& envelope, GeneratorId first, GeneratorId last);

  bool is_gap(const LabelInterval& interval, double end, GeneratorId before) const;
  double find_equidistant(GeneratorId a, GeneratorId b, const Guess& guess) const;

  double length_ = 0;  // length of the edge
  EdgeDistances distances_;
  std::vector<LabelInterval> intervals_;
};

}  // namespace gvd
