#pragma once

#include <vector>

#include "diagram/envelope/edge_distances.hpp"
#include "diagram/envelope/edge_envelope.hpp"
#include "diagram/graph/crossings.hpp"

namespace gvd {

/// The crossings of an edge: where the lower envelope of its sources passes from one generator to another.
///
/// Properties of the result: (1) ascending, strictly between 0 and 1, and apart from each other and from the ends;
/// (2) a chain of generators from the label of the first end to that of the last, whatever the sources say.
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

  double length_ = 0;  // of the edge
  EdgeDistances distances_;
  std::vector<LabelInterval> intervals_;
};

}  // namespace gvd
