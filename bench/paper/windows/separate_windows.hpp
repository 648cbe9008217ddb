#pragma once

#include <vector>

#include "geodesic/distance_field.hpp"
#include "geodesic/windows/window_field.hpp"

namespace gvd::paper {

/// Exact distances from one window propagation for each generator, over the whole mesh: no generator's windows are
/// pruned by the distances of another one.
class SeparateWindows final : public DistanceField {
 public:
  /// Runs the propagations, on one thread. The mesh must outlive this.
  /// Throws Error{precondition} if the windows of all generators would need more than kMostMemory.
  SeparateWindows(const Mesh& mesh, const std::vector<VertexId>& generators);

  /// Bytes that the windows may need.
  static constexpr double kMostMemory = 8e9;

  /// Of every vertex: the distance to its nearest generator, and that generator, the lower one where two are equal.
  const IdVector<VertexId, double>& distance() const { return distance_; }
  const IdVector<VertexId, GeneratorId>& label() const { return label_; }

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override;
  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override;
  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override;

 private:
  void take_nearest();
  bool can_win(const WindowField& field, VertexId v, double longest) const;
  bool can_win(const WindowField& field, EdgeId e) const;
  bool can_win(const WindowField& field, FaceId f) const;

  const Mesh& mesh_;
  std::vector<WindowField> fields_;  // [generator]
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, GeneratorId> label_;
};

}  // namespace gvd::paper
