#include "assign_missing_faces.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "adjacent_faces.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

class FaceAssigner {
 public:
  FaceAssigner(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result)
      : mesh_(mesh), diagram_(diagram), shares_(shares), result_(result), count_(diagram.generators.size(), 0) {
    for (const GeneratorId g : result.face_label) {
      if (g.valid()) ++count_[g];
    }
  }

  void run() {
    const auto candidates = collect_candidates();
    for (std::size_t i = 0; i < count_.size(); ++i) {
      const GeneratorId generator(i);
      if (count_[generator] > 0) continue;
      const FaceId face = find_face(candidates[generator]);
      if (!face.valid()) {
        result_.without_face.push_back(generator);
        continue;
      }
      --count_[label(face)];
      ++count_[generator];
      result_.face_label[face] = generator;
      ++result_.given_faces;
    }
  }

 private:
  using Candidates = IdVector<GeneratorId, std::vector<FaceShare>>;

  GeneratorId label(FaceId f) const { return result_.face_label[f]; }

  Candidates collect_candidates() const {
    Candidates candidates(count_.size());
    for (const FaceShare& share : shares_.all()) {
      if (count_[share.generator] == 0) candidates[share.generator].push_back(share);
    }
    for (std::size_t i = 0; i < count_.size(); ++i) {
      const GeneratorId generator(i);
      if (count_[generator] == 0) sort_own_faces_first(diagram_.generators[i], candidates[generator]);
    }
    return candidates;
  }

  void sort_own_faces_first(const SurfacePoint& generator, std::vector<FaceShare>& candidates) const {
    const std::vector<FaceId> own = faces_around(mesh_, generator);
    const auto is_own = [&](const FaceShare& s) { return std::find(own.begin(), own.end(), s.face) != own.end(); };
    for (const FaceId f : own) {
      const auto here = [f](const FaceShare& s) { return s.face == f; };
      if (std::none_of(candidates.begin(), candidates.end(), here)) candidates.push_back({f, {}, 0});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [&](const FaceShare& a, const FaceShare& b) {
      return is_own(a) != is_own(b) ? is_own(a) : a.fraction > b.fraction;
    });
  }

  FaceId find_face(const std::vector<FaceShare>& candidates) {
    for (const FaceShare& share : candidates) {
      const GeneratorId generator = label(share.face);
      if (generator.valid() && count_[generator] > 1 && stays_connected_without(share.face)) return share.face;
    }
    return FaceId();
  }

  /// Whether the adjacent faces with the label of `face` are connected without it.
  bool stays_connected_without(FaceId face) {
    std::vector<FaceId> targets;
    for_each_adjacent_face(mesh_, face, [&](FaceId g) {
      if (label(g) == label(face)) targets.push_back(g);
    });
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    return targets.size() < 2 || search(face, targets);
  }

  /// Breadth-first search from the first target through the faces with the label of `avoided`, but not through
  /// `avoided` itself. Whether it finds all targets.
  bool search(FaceId avoided, const std::vector<FaceId>& targets) {
    if (visited_.empty()) visited_.assign(result_.face_label.size(), 0);
    const std::int32_t mark = ++searches_;
    std::size_t found = 0;
    visited_[avoided] = mark;
    visited_[targets[0]] = mark;
    for (std::deque<FaceId> queue{targets[0]}; !queue.empty(); queue.pop_front()) {
      const FaceId f = queue.front();
      found += std::find(targets.begin(), targets.end(), f) != targets.end();
      if (found == targets.size()) return true;
      for_each_adjacent_face(mesh_, f, [&](FaceId g) {
        if (visited_[g] == mark || label(g) != label(avoided)) return;
        visited_[g] = mark;
        queue.push_back(g);
      });
    }
    return false;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  const FaceShares& shares_;
  Segmentation& result_;
  IdVector<GeneratorId, std::int32_t> count_;  // faces of each label
  IdVector<FaceId, std::int32_t> visited_;     // the last search that visited each face
  std::int32_t searches_ = 0;
};

}  // namespace

void assign_missing_faces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result) {
  FaceAssigner(mesh, diagram, shares, result).run();
}

}  // namespace gvd
