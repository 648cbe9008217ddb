#pragma once

#include <cstddef>

#include "common/run/run.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

// What gvd-segment notes and reports: the report's `results`, and `options.cut`.
namespace gvd::app {

void report_segment_options(Run& run, bool cut);

/// Of a segmentation: moved and given faces, and the generators without a face.
void report_segmentation(Run& run, const Segmentation& segmentation);

/// Of a cut mesh: the faces that were not cut.
void report_cut(Run& run, const CutMesh& cut);

/// The number of faces, those that no generator reaches, and the size of each of `count` regions.
void report_regions(Run& run, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t count);

}  // namespace gvd::app
