#pragma once

#include <optional>

#include "common/run.hpp"
#include "gvd/appearance.hpp"
#include "gvd/charts.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/option_list.hpp"
#include "gvd/segment.hpp"

// Regions as charts: cells that are discs, and texture coordinates for the pieces of the cut mesh.
namespace gvd::app {

struct ChartRequest {
  bool disc = false;           ///< generators are added until every cell is a disc
  std::optional<ChartMap> uv;  ///< of the texture coordinates; none: no coordinates
};

void describe(OptionList& list, ChartRequest& request);

/// Adds generators until every cell is a disc, and reports what was added.
Diagram make_cells_discs(Run& run, const Mesh& mesh, const Diagram& diagram);

/// Notes the regions of a mesh that are no discs although their cells are, and `why`.
void note_non_discs(Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, const char* why);

/// The texture coordinates of `cut` that are asked for, reported. Throws what `make_charts` throws, with the option
/// that helps.
Charts chart_regions(Run& run, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut,
                     const ChartRequest& request);

}  // namespace gvd::app
