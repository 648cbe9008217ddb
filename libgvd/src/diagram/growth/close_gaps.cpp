#include "diagram/growth/close_gaps.hpp"

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

void close_gaps(const GrowthInput& input, const std::vector<Gap>& gaps, const GapGrowthPlan& plan,
                TracedDiagram& traced, const Progress& progress) {
  const std::vector<ClosedGap> closed = grow_gaps(input, traced.crossings, gaps, plan, progress);
  install_grown_gaps(input.mesh(), closed, traced);
  assemble_faces(input, traced.crossings, faces_of(closed), traced.faces, progress);
  std::stable_sort(traced.faces.arcs.begin(), traced.faces.arcs.end(),
                   [](const FaceArc& a, const FaceArc& b) { return a.face < b.face; });
  traced.counts.gaps = static_cast<std::int64_t>(gaps.size());
  traced.counts.gaps_grown = 0;
  for (const ClosedGap& c : closed) traced.counts.gaps_grown += static_cast<std::int64_t>(c.merged.size());
}

}  // namespace gvd
