#include "diagram/lonely_runs.hpp"

#include <algorithm>

namespace gvd {

std::vector<EdgeId> find_lonely_runs(const Mesh& mesh, const NearestLabels& labels, const Crossings& crossings) {
  // A run inside an edge lies between crossing i - 1 and crossing i; it is anchored when a face of the edge shows its
  // cell at a corner, or in an anchored run of another edge.
  const auto& items = crossings.items();
  std::vector<char> anchored(items.size(), 0);
  const auto shows_in_face = [&](HalfedgeId h, GeneratorId g) {
    if (!h.valid()) return false;
    for (const VertexId v : mesh.vertices(Mesh::face(h))) {
      if (labels.label[v] == g) return true;
    }
    for (const HalfedgeId side : {Mesh::next(h), Mesh::previous(h)}) {
      const EdgeId e = mesh.edge(side);
      const std::int32_t first = crossings.first(e).value();
      for (std::int32_t k = first + 1; k < first + crossings.count(e); ++k) {
        if (items[static_cast<std::size_t>(k)].before == g && anchored[static_cast<std::size_t>(k)]) return true;
      }
    }
    return false;
  };
  std::vector<std::size_t> runs;
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (items[i - 1].edge == items[i].edge) runs.push_back(i);
  }
  for (std::size_t before = runs.size() + 1; runs.size() < before;) {
    before = runs.size();
    std::erase_if(runs, [&](std::size_t i) {
      const HalfedgeId h = mesh.halfedge(items[i].edge);
      anchored[i] = shows_in_face(h, items[i].before) || shows_in_face(mesh.twin(h), items[i].before);
      return anchored[i] != 0;
    });
  }
  std::vector<EdgeId> lonely;
  for (const std::size_t i : runs) {
    if (lonely.empty() || lonely.back() != items[i].edge) lonely.push_back(items[i].edge);
  }
  return lonely;
}

}  // namespace gvd
