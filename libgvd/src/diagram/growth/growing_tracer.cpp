#include "diagram/growth/growing_tracer.hpp"

#include <algorithm>
#include <cstdint>

#include "diagram/growth/assemble_faces.hpp"
#include "diagram/growth/install_gaps.hpp"

namespace gvd {
namespace {

/// The faces of grown gaps, ascending.
std::vector<FaceId> faces_of(const std::vector<ClosedGap>& closed) {
  std::vector<FaceId> faces;
  for (const ClosedGap& c : closed) faces.insert(faces.end(), c.gap.faces.begin(), c.gap.faces.end());
  std::sort(faces.begin(), faces.end());
  return faces;
}

}  // namespace

void GrowingTracer::close(const std::vector<Gap>& gaps, TracedDiagram& traced) const {
  const GrowthInput growth = input(traced.labels);
  const std::vector<ClosedGap> closed = grow_gaps(growth, traced.crossings, gaps, plan_, progress_);
  install_grown_gaps(mesh(), closed, traced);
  assemble_faces(growth, traced.crossings, faces_of(closed), traced.faces, progress_);
  std::stable_sort(traced.faces.arcs.begin(), traced.faces.arcs.end(),
                   [](const FaceArc& a, const FaceArc& b) { return a.face < b.face; });
  traced.counts.gaps = static_cast<std::int64_t>(gaps.size());
  traced.counts.gaps_grown = 0;
  for (const ClosedGap& c : closed) traced.counts.gaps_grown += static_cast<std::int64_t>(c.merged.size());
}

}  // namespace gvd
