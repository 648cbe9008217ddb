#pragma once

#include "geodesic/distance_field.hpp"
#include "geodesic/generator_table.hpp"

namespace gvd {

/// The distances of the adapted fast marching, as sources. Over every side of a face, the image of each generator is
/// unfolded from its distances at the side's two ends. The nearest of a generator's images is the one that its front
/// came from. This is the circle front, in place of the linear one of section 4.1.
class MarchedDistances final : public DistanceField {
 public:
  /// Both must outlive this object.
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
