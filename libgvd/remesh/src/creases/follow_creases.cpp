#include "creases/follow_creases.hpp"

#include <algorithm>

#include "creases/crease_gaps.hpp"
#include "repair/added_generators.hpp"

namespace gvd {

CreaseFollower::CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added)
    : mesh_(mesh), curves_(creases), max_added_(max_added) {
  for (const CreaseCurve& curve : creases) {
    for (const EdgeId e : curve.edges) length_ += mesh.length(mesh.halfedge(e));
  }
}

std::vector<SurfacePoint> CreaseFollower::propose(const Diagram& diagram, std::int64_t may_add) {
  if (curves_.empty()) return {};
  const std::vector<CreaseGap> gaps = CreaseGaps(mesh_, curves_, diagram).find();
  double sum = 0;
  for (const CreaseGap& gap : gaps) sum += gap.length;
  gap_length_ = std::min(sum, length_);  // rounding alone can make the sum larger
  const std::int64_t most = std::min(may_add, max_added_ - added_);
  if (gaps.empty() || rounds_ >= kCreaseRounds || most <= 0) return {};
  ++rounds_;
  AddedGenerators added(mesh_, diagram.generators, static_cast<std::size_t>(most));
  for (const CreaseGap& gap : gaps) {
    for (const SurfacePoint& place : gap.places) added.add(place);
  }
  added_ += static_cast<std::int64_t>(added.size());
  return added.take();
}

}  // namespace gvd
