#pragma once

#include <cstddef>
#include <optional>

#include "common/run/run.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

// What gvd-segment notes and reports: the report's `results`, and its own members of `options`.
namespace gvd::app {

/// The options of gvd-segment alone.
struct OwnOptions {
  bool cut = false;
  std::optional<FaceLabels> labels;  ///< of whole faces

  SegmentOptions segment_options() const { return {labels.value_or(SegmentOptions().labels)}; }
};

void report_segment_options(Run& run, const OwnOptions& own);

/// Of a segmentation: moved, given and smoothed faces, and the generators without a face.
void report_segmentation(Run& run, const Segmentation& segmentation);

/// The length of the borders, and its ratio to that of the bisectors. Both in mesh units.
void report_borders(Run& run, double border_length, double bisector_length);

/// Of a cut mesh: the faces that were not cut.
void report_cut(Run& run, const CutMesh& cut);

/// The number of faces, those that no generator reaches, and the size of each of `count` regions.
void report_regions(Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count);

}  // namespace gvd::app
