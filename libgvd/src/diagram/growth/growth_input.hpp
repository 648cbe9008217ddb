#pragma once

#include <array>
#include <optional>

#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/generator_table.hpp"
#include "gvd/front.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// What all steps of the growth tracer read: overlapping distances and the labels chosen from them.
struct GrowthInput {
  const WorkingMesh& working;
  const GeneratorTable& table;  ///< of fast marching (section 4.1), or of windows
  const NearestLabels& labels;
  Front front;

  const Mesh& mesh() const { return working.mesh(); }
};

/// Distances of generator g at the corners of f, mesh units. Where the tables have none, the distance along an edge
/// from another corner of f; infinity where no corner has one.
std::array<double, 3> corner_distances(const GrowthInput& input, FaceId f, GeneratorId g);

/// The same, where the tables have all three; else nothing.
std::optional<std::array<double, 3>> table_distances(const GrowthInput& input, FaceId f, GeneratorId g);

}  // namespace gvd
