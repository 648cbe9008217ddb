#pragma once

#include <memory>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"

namespace gvd::paper {

/// Integrals along the bisectors of a diagram that a reader of section 5.2 could also take for E. Square mesh units.
struct OtherErrors {
  /// As E, but by the distances of planar marching, linear in each face, instead of the exact ones.
  double by_marching = 0;
  /// As E, but S(p) is all generators that own a part of the face of p, not only the two of the bisector.
  double of_face = 0;
  /// Of the exact distance from the bisector's left generator: E where the other distance is missing.
  double distance = 0;
};

/// Measures them for diagrams of one mesh with one list of generators, which must outlive this.
class OtherJudge {
 public:
  /// Cost: an exact field and a march over the whole mesh for each generator.
  OtherJudge(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

  OtherErrors judge(const Diagram& diagram) const;

 private:
  using Owners = std::vector<std::vector<GeneratorId>>;

  Owners find_owners(const Diagram& diagram) const;
  double exact(GeneratorId g, const SurfacePoint& p) const { return exact_[g.index()].nearest(p).distance; }
  double march(GeneratorId g, const SurfacePoint& p) const;
  double find_spread(const std::vector<GeneratorId>& owners, const Bisector& bisector, const SurfacePoint& p) const;
  void add_segment(const Bisector& bisector, std::size_t i, const Owners& owners, OtherErrors& sum) const;

  const Mesh& mesh_;
  std::vector<ExactField> exact_;                    // [generator]
  std::vector<IdVector<VertexId, double>> marched_;  // [generator] by vertex
};

}  // namespace gvd::paper
