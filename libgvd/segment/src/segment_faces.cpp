#include <algorithm>
#include <deque>

#include "face_shares.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

class Segmenter {
 public:
  Segmenter(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram), shares_(diagram) {}

  Segmentation run() {
    label_by_area();
    find_parts();
    free_all_but_main_parts();
    grow_into_free_faces();
    give_every_generator_a_face();
    return std::move(result_);
  }

 private:
  struct Part {
    GeneratorId label;
    double area = 0;
    bool holds_generator = false;
  };

  template <class Visit>
  void for_each_neighbour(FaceId f, Visit visit) const {
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId twin = mesh_.twin(Mesh::halfedge(f, corner));
      if (twin.valid()) visit(Mesh::face(twin));
    }
  }

  GeneratorId& label(FaceId f) { return result_.face_label[f]; }

  void label_by_area() {
    result_.face_label = diagram_.face_label;
    for (const FaceShare& share : shares_.all()) {
      if (!label(share.face).valid()) label(share.face) = share.generator;  // a face's largest share comes first
    }
  }

  /// The edge-connected parts of each label, numbered in the order of their first face.
  void find_parts() {
    part_.assign(result_.face_label.size(), -1);
    std::vector<FaceId> stack;
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId start(i);
      if (part_[start] >= 0 || !label(start).valid()) continue;
      const auto number = static_cast<std::int32_t>(parts_.size());
      parts_.push_back({label(start)});
      part_[start] = number;
      for (stack.assign(1, start); !stack.empty();) {
        const FaceId f = stack.back();
        stack.pop_back();
        parts_.back().area += mesh_.area(f);
        for_each_neighbour(f, [&](FaceId g) {
          if (part_[g] >= 0 || label(g) != label(f)) return;
          part_[g] = number;
          stack.push_back(g);
        });
      }
    }
  }

  void free_all_but_main_parts() {
    mark_parts_of_generators();
    std::vector<std::int32_t> main(diagram_.generators.size(), -1);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      std::int32_t& best = main[parts_[i].label.index()];
      if (best < 0 || beats(parts_[i], parts_[static_cast<std::size_t>(best)])) best = static_cast<std::int32_t>(i);
    }
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      if (label(f).valid() && main[label(f).index()] != part_[f]) {
        label(f) = GeneratorId();
        free_.push_back(f);
      }
    }
  }

  void mark_parts_of_generators() {
    for (std::size_t i = 0; i < diagram_.generators.size(); ++i) {
      for (const FaceId f : faces_around(mesh_, diagram_.generators[i])) {
        if (label(f) == GeneratorId(static_cast<std::int64_t>(i))) {
          parts_[static_cast<std::size_t>(part_[f])].holds_generator = true;
        }
      }
    }
  }

  static bool beats(const Part& a, const Part& b) {
    return a.holds_generator != b.holds_generator ? a.holds_generator : a.area > b.area;
  }

  /// Each free face takes the label of a neighbour, so every label stays connected.
  void grow_into_free_faces() {
    IdVector<FaceId, char> queued(result_.face_label.size(), 0);
    std::deque<FaceId> queue;
    const auto has_labelled_neighbour = [&](FaceId f) {
      bool found = false;
      for_each_neighbour(f, [&](FaceId g) { found = found || label(g).valid(); });
      return found;
    };
    IdVector<FaceId, char> is_free(result_.face_label.size(), 0);
    for (const FaceId f : free_) {
      is_free[f] = 1;
      if (!has_labelled_neighbour(f)) continue;
      queued[f] = 1;
      queue.push_back(f);
    }
    for (; !queue.empty(); queue.pop_front()) {
      const FaceId f = queue.front();
      label(f) = best_neighbour_label(f);
      ++result_.moved_faces;
      for_each_neighbour(f, [&](FaceId g) {
        if (!is_free[g] || queued[g]) return;
        queued[g] = 1;
        queue.push_back(g);
      });
    }
  }

  GeneratorId best_neighbour_label(FaceId f) {
    GeneratorId best;
    for_each_neighbour(f, [&](FaceId g) {
      const GeneratorId other = label(g);
      if (!other.valid()) return;
      const double gain = best.valid() ? shares_.part(f, other) - shares_.part(f, best) : 1;
      if (gain > 0 || (gain == 0 && other < best)) best = other;
    });
    return best;
  }

  void give_every_generator_a_face() {
    std::vector<std::int32_t> count(diagram_.generators.size(), 0);
    for (const GeneratorId g : result_.face_label) {
      if (g.valid()) ++count[g.index()];
    }
    const auto shares_by_generator = collect_shares(count);
    for (std::size_t i = 0; i < count.size(); ++i) {
      if (count[i] > 0) continue;
      const GeneratorId generator(static_cast<std::int64_t>(i));
      const FaceId face = find_face_to_give(shares_by_generator[i], count);
      if (!face.valid()) {
        result_.without_face.push_back(generator);
        continue;
      }
      --count[label(face).index()];
      ++count[i];
      label(face) = generator;
      ++result_.given_faces;
    }
  }

  /// For each generator without a face, where it could get one: the faces that it lies in, then those that its cell has
  /// a part of, the larger part first.
  std::vector<std::vector<FaceShare>> collect_shares(const std::vector<std::int32_t>& count) const {
    std::vector<std::vector<FaceShare>> collected(count.size());
    for (const FaceShare& share : shares_.all()) {
      if (count[share.generator.index()] == 0) collected[share.generator.index()].push_back(share);
    }
    for (std::size_t i = 0; i < collected.size(); ++i) {
      if (count[i] > 0) continue;
      const std::vector<FaceId> own = faces_around(mesh_, diagram_.generators[i]);
      const auto is_own = [&](const FaceShare& s) { return std::find(own.begin(), own.end(), s.face) != own.end(); };
      for (const FaceId f : own) {
        const auto here = [f](const FaceShare& s) { return s.face == f; };
        if (std::none_of(collected[i].begin(), collected[i].end(), here)) collected[i].push_back({f, {}, 0});
      }
      std::stable_sort(collected[i].begin(), collected[i].end(), [&](const FaceShare& a, const FaceShare& b) {
        return is_own(a) != is_own(b) ? is_own(a) : a.part > b.part;
      });
    }
    return collected;
  }

  FaceId find_face_to_give(const std::vector<FaceShare>& candidates, const std::vector<std::int32_t>& count) {
    for (const FaceShare& share : candidates) {
      const GeneratorId owner = label(share.face);
      if (owner.valid() && count[owner.index()] > 1 && stays_connected_without(share.face)) return share.face;
    }
    return FaceId();
  }

  /// Whether the neighbours of `face` under its label reach each other without it.
  bool stays_connected_without(FaceId face) {
    std::vector<FaceId> targets;
    for_each_neighbour(face, [&](FaceId g) {
      if (label(g) == label(face)) targets.push_back(g);
    });
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    if (targets.size() < 2) return true;
    // part_ is not needed any more: it serves as the mark of the last search that met a face.
    const std::int32_t mark = next_mark_--;
    std::size_t met = 0;
    part_[face] = mark;
    part_[targets[0]] = mark;
    for (std::deque<FaceId> queue{targets[0]}; !queue.empty(); queue.pop_front()) {
      const FaceId f = queue.front();
      met += std::find(targets.begin(), targets.end(), f) != targets.end();
      if (met == targets.size()) return true;
      for_each_neighbour(f, [&](FaceId g) {
        if (part_[g] == mark || label(g) != label(face)) return;
        part_[g] = mark;
        queue.push_back(g);
      });
    }
    return false;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  FaceShares shares_;
  IdVector<FaceId, std::int32_t> part_;
  std::vector<Part> parts_;
  std::vector<FaceId> free_;
  std::int32_t next_mark_ = -2;
  Segmentation result_;
};

}  // namespace

Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram) {
  check_belongs(mesh, diagram);
  return Segmenter(mesh, diagram).run();
}

}  // namespace gvd
