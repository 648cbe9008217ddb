#include "diagram/graph/disconnected_intervals.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/union_find.hpp"

namespace gvd {
namespace {

/// The label intervals inside of edges, in groups that common faces connect. An interval is known by the index of the
/// crossing at its end.
class IntervalGroups {
 public:
  IntervalGroups(const Mesh& mesh, const NearestLabels& labels, const Crossings& crossings)
      : mesh_(mesh), labels_(labels), crossings_(crossings), items_(crossings.items()), groups_(items_.size()) {
    std::vector<FaceId> faces;
    for (std::size_t i = 1; i < items_.size(); ++i) {
      if (!is_interval(i)) continue;
      const HalfedgeId h = mesh_.halfedge(items_[i].edge), twin = mesh_.twin(h);
      faces.push_back(Mesh::face(h));
      if (twin.valid()) faces.push_back(Mesh::face(twin));
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const FaceId f : faces) join_in_face(f);
  }

  /// Whether crossings i - 1 and i bound an interval.
  bool is_interval(std::size_t i) const { return items_[i - 1].edge == items_[i].edge; }
  /// Whether common faces connect the interval to a corner.
  bool is_anchored(std::size_t i) { return groups_.find(static_cast<std::int32_t>(i)) == kCorners; }

 private:
  /// Represents all corners: no interval has index 0.
  static constexpr std::int32_t kCorners = 0;

  void join_in_face(FaceId f) {
    in_face_.clear();
    for (const VertexId v : mesh_.vertices(f)) in_face_.emplace_back(labels_.label[v], kCorners);
    for (int corner = 0; corner < 3; ++corner) {
      const EdgeId e = mesh_.edge(Mesh::halfedge(f, corner));
      if (!crossings_.first(e).valid()) continue;
      for (std::size_t k = crossings_.first(e).index() + 1; k < items_.size() && items_[k].edge == e; ++k) {
        in_face_.emplace_back(items_[k].before, static_cast<std::int32_t>(k));
      }
    }
    std::sort(in_face_.begin(), in_face_.end());
    for (std::size_t i = 1; i < in_face_.size(); ++i) {
      if (in_face_[i - 1].first == in_face_[i].first) groups_.unite(in_face_[i - 1].second, in_face_[i].second);
    }
  }

  const Mesh& mesh_;
  const NearestLabels& labels_;
  const Crossings& crossings_;
  const std::vector<Crossing>& items_;
  UnionFind groups_;                                           // of intervals, and kCorners
  std::vector<std::pair<GeneratorId, std::int32_t>> in_face_;  // labels and intervals of the current face
};

}  // namespace

std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings) {
  IntervalGroups groups(mesh, labels, crossings);
  const auto& items = crossings.items();
  std::vector<EdgeId> edges;
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (!groups.is_interval(i) || groups.is_anchored(i)) continue;
    if (edges.empty() || edges.back() != items[i].edge) edges.push_back(items[i].edge);
  }
  return edges;
}

}  // namespace gvd
