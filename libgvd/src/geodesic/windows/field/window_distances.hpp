#pragma once

#include "geodesic/field/distance_field.hpp"
#include "geodesic/windows/field/window_field.hpp"

namespace gvd {

/// Exact distances on edges and in faces, from the windows that the propagation kept near bisectors.
class WindowDistances final : public DistanceField {
 public:
  /// Both have to outlive this.
  WindowDistances(const Mesh& mesh, const WindowField& field) : mesh_(mesh), field_(field) {}

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override;
  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override;
  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override;

 private:
  const Mesh& mesh_;
  const WindowField& field_;
};

}  // namespace gvd
