#include "diagram/graph/disconnected_intervals.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/union_find.hpp"

namespace gvd {
namespace {

/// The runs inside of edges, grouped by the pieces that common faces make of them.
class IntervalGroups {
 public:
  IntervalGroups(const Mesh& mesh, const NearestLabels& labels, const Crossings& crossings)
      : mesh_(mesh), labels_(labels), crossings_(crossings), items_(crossings.items()), groups_(items_.size()) {
    std::vector<FaceId> faces;
    for (std::size_t i = 1; i < items_.size(); ++i) {
      if (!is_run(i)) continue;
      const HalfedgeId h = mesh_.halfedge(items_[i].edge), twin = mesh_.twin(h);
      faces.push_back(Mesh::face(h));
      if (twin.valid()) faces.push_back(Mesh::face(twin));
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const FaceId f : faces) join_in_face(f);
  }

  /// The run between crossings i - 1 and i.
  bool is_run(std::size_t i) const { return items_[i - 1].edge == items_[i].edge; }
  /// Whether common faces join it to a corner.
  bool is_anchored(std::size_t i) { return groups_.find(static_cast<std::int32_t>(i)) == kCorners; }

 private:
  /// Stands for the corners: no run has number 0.
  static constexpr std::int32_t kCorners = 0;

  void join_in_face(FaceId f) {
    shown_.clear();
    for (const VertexId v : mesh_.vertices(f)) shown_.emplace_back(labels_.label[v], kCorners);
    for (int corner = 0; corner < 3; ++corner) {
      const EdgeId e = mesh_.edge(Mesh::halfedge(f, corner));
      if (!crossings_.first(e).valid()) continue;
      for (std::size_t k = crossings_.first(e).index() + 1; k < items_.size() && items_[k].edge == e; ++k) {
        shown_.emplace_back(items_[k].before, static_cast<std::int32_t>(k));
      }
    }
    std::sort(shown_.begin(), shown_.end());
    for (std::size_t i = 1; i < shown_.size(); ++i) {
      if (shown_[i - 1].first == shown_[i].first) groups_.unite(shown_[i - 1].second, shown_[i].second);
    }
  }

  const Mesh& mesh_;
  const NearestLabels& labels_;
  const Crossings& crossings_;
  const std::vector<Crossing>& items_;
  UnionFind groups_;                                         // of runs, each by the number of the crossing at its end
  std::vector<std::pair<GeneratorId, std::int32_t>> shown_;  // of the face at work
};

}  // namespace

std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings) {
  IntervalGroups groups(mesh, labels, crossings);
  const auto& items = crossings.items();
  std::vector<EdgeId> lonely;
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (!groups.is_run(i) || groups.is_anchored(i)) continue;
    if (lonely.empty() || lonely.back() != items[i].edge) lonely.push_back(items[i].edge);
  }
  return lonely;
}

}  // namespace gvd
