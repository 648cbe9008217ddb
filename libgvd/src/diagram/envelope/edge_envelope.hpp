#pragma once

#include <cstdint>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "geodesic/field/distance_field.hpp"

namespace gvd {

/// The least of the distances along one edge, piece by piece, and where it passes from one generator to another.
///
/// Every source is a branch of a hyperbola over its interval; two of them meet twice at the most. The ends' own sources
/// reach all of the edge, so that there is no gap.
/// Cost: O(k^2) for k sources at worst; k is seldom above 8.
class EdgeEnvelope {
 public:
  /// `sources` as DistanceField::collect gives them, at least two; `tie_step` is the symbolic offset between two
  /// generators that follow each other, mesh units.
  void build(const std::vector<EdgeSource>& sources, double length, double tie_step);

  /// Appends the crossings between different generators, ascending, with `first` and `last` as the labels of the ends.
  void append_crossings(EdgeId e, GeneratorId first, GeneratorId last, std::vector<Crossing>& crossings);

  /// Appends one crossing between two different labels of the ends, where their generators are equally far if there is
  /// such a place.
  void append_plain_crossing(EdgeId e, GeneratorId first, GeneratorId last, std::vector<Crossing>& crossings) const;

 private:
  struct Segment {
    double end;
    std::int32_t source;
  };
  struct Run {
    double begin;  // mesh units
    GeneratorId generator;
  };

  GeneratorId generator(const Segment& s) const { return sources_[static_cast<std::size_t>(s.source)].generator; }
  double straight(std::int32_t source, double t) const;
  double distance(GeneratorId g, double t) const;
  std::int32_t nearer(std::int32_t a, std::int32_t b, double t) const;
  void insert(std::int32_t source);
  void append(double end, std::int32_t source);
  bool compare(std::int32_t old_source, std::int32_t source, double begin, double end);
  double polish(std::int32_t a, std::int32_t b, double begin, double end, double t) const;
  void find_runs(GeneratorId first, GeneratorId last);
  bool is_gap(GeneratorId before, GeneratorId g, double begin, double end) const;
  double meeting(GeneratorId a, GeneratorId b, double low, double t, double high) const;

  std::vector<EdgeSource> sources_;
  std::vector<Segment> segments_;
  std::vector<Segment> pieces_;  // that a new source parts segments into
  std::vector<Run> runs_;
  double length_ = 0;
  double unit_ = 1;  // a power of two that brings the edge's length near 1: sixth powers of it stay in range
};

}  // namespace gvd
