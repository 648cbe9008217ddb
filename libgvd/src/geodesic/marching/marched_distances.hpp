#pragma once

#include "geodesic/field/distance_field.hpp"
#include "geodesic/field/generator_table.hpp"

namespace gvd {

/// The distances of the adapted fast marching, as sources: over every side a generator's point source is unfolded from
/// its distances at the two ends (section 4.1's circle front). Several may hold a generator; the nearest is the one
/// that the front came from.
class MarchedDistances final : public DistanceField {
 public:
  /// Both have to outlive this.
  MarchedDistances(const Mesh& mesh, const GeneratorTable& table) : mesh_(mesh), table_(table) {}

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override;
  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override;
  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override;

 private:
  const VertexDistance& nearest(VertexId v) const;

  const Mesh& mesh_;
  const GeneratorTable& table_;
};

}  // namespace gvd
