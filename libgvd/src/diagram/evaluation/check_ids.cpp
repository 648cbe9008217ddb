#include "diagram/evaluation/check_ids.hpp"

#include <algorithm>

namespace gvd {
namespace {

class IdCheck {
 public:
  IdCheck(const Mesh& mesh, const Diagram& diagram, Violations& violations)
      : mesh_(mesh), diagram_(diagram), violations_(violations) {}

  void run() {
    check_cells();
    check_labels();
    for (std::size_t i = 0; i < diagram_.bisectors.size(); ++i) check_bisector(i);
  }

 private:
  template <class IdType>
  static bool below(IdType id, std::size_t size) {
    return id.valid() && id.index() < size;
  }
  template <class Items, class Test>
  static bool all(const Items& items, Test test) {
    return std::all_of(items.begin(), items.end(), test);
  }
  bool is_cell(GeneratorId g) const { return below(g, diagram_.cells.size()); }
  bool is_cell_or_none(GeneratorId g) const { return !g.valid() || is_cell(g); }
  bool is_face(FaceId f) const { return below(f, static_cast<std::size_t>(mesh_.face_count())); }

  void check_cells() {
    const Diagram& d = diagram_;
    bool cells_fit = d.cells.size() == d.generators.size();
    for (std::size_t i = 0; i < d.cells.size(); ++i) cells_fit = cells_fit && d.cells.raw()[i].generator.index() == i;
    if (cells_fit && all(d.generators, [&](const SurfacePoint& p) { return is_face(p.face); })) return;
    violations_.add(1, "cells are not numbered like the generators, or a generator lies in no face of the mesh");
  }

  void check_labels() {
    const Diagram& d = diagram_;
    const auto is_label = [&](GeneratorId g) { return is_cell_or_none(g); };
    const auto is_piece = [&](const FacePiece& p) { return is_face(p.face) && is_cell(p.generator); };
    if (d.vertex_label.size() != static_cast<std::size_t>(mesh_.vertex_count()) ||
        d.vertex_distance.size() != d.vertex_label.size() ||
        d.face_label.size() != static_cast<std::size_t>(mesh_.face_count()) || !all(d.vertex_label, is_label) ||
        !all(d.face_label, is_label) || !all(d.pieces, is_piece)) {
      violations_.add(2,
                      "labels or pieces do not match the mesh in number, or name a cell or face that does not exist");
    }
  }

  void check_bisector(std::size_t i) {
    const Bisector& b = diagram_.bisectors.raw()[i];
    const auto is_end = [&](BranchPointId e) { return !e.valid() || below(e, diagram_.branch_points.size()); };
    if (!is_cell_or_none(b.left) || !is_cell_or_none(b.right) ||
        !all(b.points, [&](const SurfacePoint& p) { return is_face(p.face); })) {
      violations_.add(3, "bisector", i, "names a cell or face that does not exist");
    }
    if (!all(b.ends, is_end)) violations_.add(4, "bisector", i, "ends at a branch point that does not exist");
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  Violations& violations_;
};

}  // namespace

void check_ids(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  IdCheck(mesh, diagram, violations).run();
}

}  // namespace gvd
