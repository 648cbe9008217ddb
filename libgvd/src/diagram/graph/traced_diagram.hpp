#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "diagram/graph/nearest_labels.hpp"

namespace gvd {

/// The counts of a tracer; DiagramReport explains the fields.
struct TracerCounts {
  std::int64_t relabelled_vertices = 0;
  std::int64_t gaps = 0;
  std::int64_t gaps_grown = 0;
};

/// A face with an arc that lost points because it intersected itself or another arc.
struct StraightenedFace {
  FaceId face;
  double error;  ///< largest difference of the two distances along an arc of the face, mesh units
};

/// The result of a tracer: how the bisectors cross the edges and run through the faces of the working mesh.
struct TracedDiagram {
  NearestLabels labels;
  Crossings crossings;
  FaceDiagram faces{};
  std::vector<VertexId> moved{};                          ///< vertices that growth gave to another cell
  IdVector<GeneratorId, std::int32_t> cell_components{};  ///< number of components of each cell; 1 if it is connected
  TracerCounts counts{};
  std::vector<StraightenedFace> straightened{};  ///< ascending
  /// The labels and the crossings before some of them were replaced to connect cells; nothing if none were replaced.
  std::optional<NearestLabels> labels_before{};
  std::optional<Crossings> crossings_before{};

  /// The nearest generators of all vertices, before any vertex got another label to connect cells.
  const NearestLabels& nearest() const { return labels_before ? *labels_before : labels; }
  /// The crossings that the tracer found first, before any were replaced to connect cells.
  const Crossings& first_crossings() const { return crossings_before ? *crossings_before : crossings; }
};

}  // namespace gvd
