#pragma once

#include <memory>
#include <vector>

#include "comparators.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd::paper {

/// What exact distances say of a diagram: the same for all comparators and all methods of the library.
struct Judgement {
  ErrorMeasure error;             ///< E and its companions
  double turning_angle = 0;       ///< by `sum_turning_angles`, radians
  std::int64_t wrong_labels = 0;  ///< vertices with another label than a nearest generator, or without any
  std::int64_t labelled = 0;      ///< vertices that a generator reaches
};

/// Distances that differ by this fraction are equal: mirror-symmetric meshes have vertices with two nearest generators.
inline constexpr double kEquallyNear = 1e-9;

/// Exact distances, by one `ExactField` for each query on the part of the mesh that the shortest paths can visit.
std::vector<std::vector<double>> compute_field_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries);

/// Judges diagrams of one mesh with one list of generators.
class Judge {
 public:
  /// The mesh must outlive this. Cost: one exact field of all generators.
  Judge(const Mesh& mesh, const std::vector<SurfacePoint>& generators) : mesh_(mesh), nearest_(mesh, generators) {}

  /// Cost: one exact field for each generator, round its cell.
  Judgement judge(const Diagram& diagram) const;

 private:
  std::int64_t count_wrong_labels(const Diagram& diagram) const;

  const Mesh& mesh_;
  ExactField nearest_;
};

/// The sum of the angles by which the bisectors turn at their inner points, radians: how much they zig-zag (figure 10
/// of the paper). Angles are measured with the two faces unfolded, so that a straight geodesic turns by 0; at a vertex
/// of the mesh they are those in space. Both senses count as positive. Throws Error{precondition} if consecutive points
/// share no face.
/// Cost: O(points).
double sum_turning_angles(const Mesh& mesh, const Diagram& diagram);

/// Integrals along the bisectors of a diagram that a reader of section 5.2 could also take for E. Square mesh units.
struct OtherErrors {
  /// As E, but by the distances of planar marching, linear in each face, instead of the exact ones.
  double by_marching = 0;
  /// As E, but by straight distances through space: 0 for RVD.
  double by_straight = 0;
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
  double straight(GeneratorId g, const SurfacePoint& p) const {
    return (position(mesh_, p) - positions_[g.index()]).norm();
  }
  /// Marched distances are linear in a face, as the paper takes them to be.
  double march(GeneratorId g, const SurfacePoint& p) const { return interpolate_at(mesh_, marched_[g.index()], p); }
  double find_spread(const std::vector<GeneratorId>& owners, const Bisector& bisector, const SurfacePoint& p) const;
  void add_segment(const Bisector& bisector, std::size_t i, const Owners& owners, OtherErrors& sum) const;

  const Mesh& mesh_;
  std::vector<ExactField> exact_;                    // [generator]
  std::vector<Vec3> positions_;                      // [generator]
  std::vector<IdVector<VertexId, double>> marched_;  // [generator] by vertex
};

}  // namespace gvd::paper
