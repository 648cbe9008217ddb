#include "creases/follow_creases.hpp"

#include <algorithm>

#include "creases/crease_gaps.hpp"
#include "repair/added_generators.hpp"

namespace gvd {
namespace {

/// Of the gaps that wait for a corner, or of the others.
void add_places(const std::vector<CreaseGap>& gaps, bool waits, AddedGenerators& added) {
  for (const CreaseGap& gap : gaps) {
    if (gap.waits != waits) continue;
    for (const SurfacePoint& place : gap.places) added.add(place);
  }
}

}  // namespace

CreaseFollower::CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added,
                               double spacing)
    : mesh_(mesh), curves_(creases), max_added_(max_added), spacing_(spacing) {
  for (const CreaseCurve& curve : creases) {
    for (const EdgeId e : curve.edges) length_ += mesh.length(mesh.halfedge(e));
  }
}

std::vector<SurfacePoint> CreaseFollower::propose(const Diagram& diagram, std::int64_t may_add) {
  if (curves_.empty()) return {};
  const std::vector<CreaseGap> gaps = CreaseGaps(mesh_, curves_, diagram, spacing_).find();
  double sum = 0;
  for (const CreaseGap& gap : gaps) sum += gap.length;
  gap_length_ = std::min(sum, length_);  // rounding alone can make the sum larger
  const std::int64_t most = std::min(may_add, max_added_ - added_);
  if (gaps.empty() || rounds_ >= kCreaseRounds || most <= 0) return {};
  ++rounds_;
  AddedGenerators added(mesh_, diagram.generators, static_cast<std::size_t>(most));
  // Where no corner takes a generator, one is too near to it. Then nothing is to be waited for.
  for (const bool waits : {false, true}) {
    if (added.size() == 0) add_places(gaps, waits, added);
  }
  added_ += static_cast<std::int64_t>(added.size());
  return added.take();
}

}  // namespace gvd
