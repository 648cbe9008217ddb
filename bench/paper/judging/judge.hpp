#pragma once

#include <vector>

#include "comparator.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/exact_field.hpp"

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

}  // namespace gvd::paper
