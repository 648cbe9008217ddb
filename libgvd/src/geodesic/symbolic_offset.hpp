#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "gvd/ids.hpp"

namespace gvd {

/// A tiny distance that depends on a generator's id and decides ties. Every tie between distances is decided here.
///
/// On symmetric models, two generators may be equally far from every point of an edge or a face. Rounding would decide
/// such a tie differently from point to point. If every distance of generator g is longer by of(g), the generator with
/// the lower id wins everywhere.
/// Properties: (1) of(g) grows with g by `step`; (2) of(g) is at most the scale of the factory that made it, for each of
/// its generators; (3) without a step it is 0 for every generator.
struct SymbolicOffset {
  double step = 0;         ///< between generators that follow each other by id, mesh units, >= 0
  std::int32_t first = 0;  ///< the offset of generator 0, in steps

  double of(GeneratorId g) const { return (g.value() + first) * step; }

  /// Largest offset of a marched distance, in mean edge lengths. It stays in the distances until they are returned. It
  /// is far above rounding, which is 1e-16 times a distance of up to 1e5 edges, and far below any visible length.
  static constexpr double kOfMeanEdge = 1e-9;
  static SymbolicOffset of_marching(double mean_edge_length, std::size_t generators) {
    return {kOfMeanEdge * mean_edge_length / double(generators), 1};
  }

  /// Largest offset of a source in an envelope, as a fraction of the bounding box's diagonal. It is a tenth of the
  /// error that a crossing may have (1e-12 of the diagonal) and, where generators are few, far above rounding.
  static constexpr double kOfDiagonal = 1e-13;
  /// The step is the same for all numbers of generators up to the next power of two, so that adding a generator mostly
  /// leaves the crossings of the others as they are.
  static SymbolicOffset of_envelope(double bbox_diagonal, std::size_t generators) {
    return {kOfDiagonal * bbox_diagonal / double(std::bit_ceil(generators)), 0};
  }
};

}  // namespace gvd
