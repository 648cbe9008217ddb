#include <deque>

#include "adjacent_faces.hpp"
#include "assign_missing_faces.hpp"
#include "face_shares.hpp"
#include "gvd/segment.hpp"
#include "gvd/surface_point.hpp"
#include "label_components.hpp"
#include "smooth_borders.hpp"

namespace gvd {
namespace {

class Segmenter {
 public:
  Segmenter(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram), shares_(diagram) {}

  Segmentation run(const SegmentOptions& options) {
    label_by_area();
    release_minor_components();
    label_released_faces();
    assign_missing_faces(mesh_, diagram_, shares_, result_);
    if (options.labels == FaceLabels::smooth) smooth_borders(mesh_, diagram_, shares_, result_);
    return std::move(result_);
  }

 private:
  GeneratorId& label(FaceId f) { return result_.face_label[f]; }

  void label_by_area() {
    result_.face_label = diagram_.face_label;
    for (const FaceShare& share : shares_.all()) {
      if (!label(share.face).valid()) label(share.face) = share.generator;  // the largest share of a face comes first
    }
  }

  /// Takes the label from all faces outside of their label's main component: the one with a face of the generator, or
  /// else the one with the largest area.
  void release_minor_components() {
    const LabelComponents found = find_label_components(mesh_, result_.face_label);
    const std::vector<char> holds_generator = mark_components_of_generators(found);
    const auto beats = [&](std::size_t a, std::size_t b) {
      return holds_generator[a] != holds_generator[b] ? holds_generator[a] != 0
                                                      : found.components[a].area > found.components[b].area;
    };
    std::vector<std::int32_t> main(diagram_.generators.size(), -1);
    for (std::size_t i = 0; i < found.components.size(); ++i) {
      std::int32_t& best = main[found.components[i].label.index()];
      if (best < 0 || beats(i, static_cast<std::size_t>(best))) best = static_cast<std::int32_t>(i);
    }
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      if (label(f).valid() && main[label(f).index()] != found.component[f]) {
        label(f) = GeneratorId();
        released_.push_back(f);
      }
    }
  }

  std::vector<char> mark_components_of_generators(const LabelComponents& found) {
    std::vector<char> marked(found.components.size(), 0);
    for (std::size_t i = 0; i < diagram_.generators.size(); ++i) {
      for (const FaceId f : faces_around(mesh_, diagram_.generators[i])) {
        if (label(f) == GeneratorId(i)) {
          marked[found.component[f]] = 1;
        }
      }
    }
    return marked;
  }

  bool has_labelled_neighbour(FaceId f) {
    bool found = false;
    for_each_adjacent_face(mesh_, f, [&](FaceId g) { found = found || label(g).valid(); });
    return found;
  }

  /// Breadth-first from the labelled faces. Each released face takes the label of an adjacent face, so every label
  /// stays connected.
  void label_released_faces() {
    IdVector<FaceId, char> is_waiting(result_.face_label.size(), 0);
    std::deque<FaceId> queue;
    for (const FaceId f : released_) {
      is_waiting[f] = !has_labelled_neighbour(f);
      if (!is_waiting[f]) queue.push_back(f);
    }
    for (; !queue.empty(); queue.pop_front()) {
      const FaceId f = queue.front();
      label(f) = best_adjacent_label(f);
      ++result_.moved_faces;
      for_each_adjacent_face(mesh_, f, [&](FaceId g) {
        if (!is_waiting[g]) return;
        is_waiting[g] = 0;
        queue.push_back(g);
      });
    }
  }

  /// The adjacent label with the largest share of the face, the smallest id among equals.
  GeneratorId best_adjacent_label(FaceId f) {
    GeneratorId best;
    for_each_adjacent_face(mesh_, f, [&](FaceId g) {
      const GeneratorId other = label(g);
      if (!other.valid()) return;
      const double gain = best.valid() ? shares_.fraction(f, other) - shares_.fraction(f, best) : 1;
      if (gain > 0 || (gain == 0 && other < best)) best = other;
    });
    return best;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  FaceShares shares_;
  std::vector<FaceId> released_;
  Segmentation result_;
};

}  // namespace

Segmentation segment_faces(const Mesh& mesh, const Diagram& diagram, const SegmentOptions& options) {
  check_belongs(mesh, diagram);
  return Segmenter(mesh, diagram).run(options);
}

}  // namespace gvd
