#pragma once

#include <vector>

#include "comparator.hpp"
#include "gvd/error_measure.hpp"

namespace gvd::paper {

/// What exact distances say of a diagram: the same for all comparators and all methods of the library.
struct Judgement {
  ErrorMeasure error;             ///< E and its companions
  std::int64_t wrong_labels = 0;  ///< vertices with another label than a nearest generator, or without any
  std::int64_t labelled = 0;      ///< vertices that a generator reaches
};

/// Distances that differ by this fraction are equal: mirror-symmetric meshes have vertices with two nearest generators.
inline constexpr double kEquallyNear = 1e-9;

/// Exact distances by one `ExactField` for each generator. Points of one query share the field.
std::vector<std::vector<double>> compute_field_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries);

/// Judges diagrams of one mesh with one list of generators.
class Judge {
 public:
  /// The mesh must outlive this. Cost: one exact field for each generator, here and for each diagram.
  Judge(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

  Judgement judge(const Diagram& diagram) const;

 private:
  bool is_nearest(VertexId v, GeneratorId label) const;

  const Mesh& mesh_;
  std::vector<std::vector<double>> distances_;  // [generator][vertex]
  std::vector<double> least_;                   // [vertex]
};

}  // namespace gvd::paper
