#pragma once

#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "diagram/graph/nearest_labels.hpp"

namespace gvd {

/// What a tracer hands over: how the bisectors cross the edges and run through the faces of the working mesh.
struct TracedDiagram {
  NearestLabels labels;
  Crossings crossings;
  FaceDiagram faces;
  std::vector<VertexId> moved;                          ///< vertices whose label growth changed
  IdVector<GeneratorId, std::int32_t> cell_components;  ///< 1 where a cell is connected
};

}  // namespace gvd
