#include "creases/follow_creases.hpp"

#include <cmath>

#include "creases/crease_gaps.hpp"
#include "repair/added_generators.hpp"

namespace gvd {

CreaseFollower::CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added)
    : mesh_(mesh), curves_(creases), max_added_(max_added) {
  for (const CreaseCurve& curve : creases) {
    for (const EdgeId e : curve.edges) length_ += mesh.length(mesh.halfedge(e));
  }
}

std::vector<SurfacePoint> CreaseFollower::propose(const Diagram& diagram) {
  if (curves_.empty()) return {};
  const std::vector<CreaseGap> gaps = CreaseGaps(mesh_, curves_, diagram).find();
  gap_length_ = 0;
  for (const CreaseGap& gap : gaps) gap_length_ += std::isfinite(gap.length) ? gap.length : 0;
  if (gaps.empty() || rounds_ >= kCreaseRounds || added_ >= max_added_) return {};
  ++rounds_;
  AddedGenerators added(mesh_, diagram.generators, static_cast<std::size_t>(max_added_ - added_));
  for (const CreaseGap& gap : gaps) added.add(gap.place);
  added_ += static_cast<std::int64_t>(added.size());
  return added.take();
}

}  // namespace gvd
