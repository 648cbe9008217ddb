#pragma once

#include <vector>

#include "gvd/ids.hpp"

namespace gvd::test {

/// One exact distance field a generator: [generator][vertex], mesh units, infinity where nothing reaches. From a
/// Reference, or `exact_vertex_fields` in support/exact_fields.hpp.
using DistanceFields = std::vector<std::vector<double>>;

/// How far a label's distance may be above the smallest one, relative to it: mirror symmetric meshes have vertices with
/// two nearest generators, and exact solvers differ by up to 5e-14.
inline constexpr double kLabelTolerance = 1e-9;

/// The nearest generator of every vertex, the least id among equals. Invalid where nothing reaches.
struct Nearest {
  IdVector<VertexId, GeneratorId> label;
  IdVector<VertexId, double> distance;  ///< mesh units; infinity where nothing reaches
};

/// The brute force that labels and distances are compared with. All fields have the same size.
Nearest compute_nearest(const DistanceFields& fields);

/// Whether `label` is a nearest generator of v within kLabelTolerance; where nothing reaches v, whether it is invalid.
bool is_right_label(const DistanceFields& fields, VertexId v, GeneratorId label);

/// The vertices whose label is wrong by that rule, ascending.
std::vector<VertexId> find_wrong_labels(const DistanceFields& fields, const IdVector<VertexId, GeneratorId>& labels);

}  // namespace gvd::test
