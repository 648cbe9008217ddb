#include <algorithm>
#include <set>
#include <utility>

#include "gvd/dual.hpp"
#include "gvd/quality.hpp"

namespace gvd {
namespace {

class DualBuilder {
 public:
  DualBuilder(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {
    for (const Bisector& b : diagram.bisectors) edges_.insert(std::minmax(b.left, b.right));
  }

  DualMesh build() {
    for (std::size_t i = 0; i < diagram_.branch_points.size(); ++i) {
      const BranchPointId b(i);
      cut(b, diagram_.branch_points[b].generators);
    }
    return std::move(dual_);
  }

 private:
  Vec3 position_of(GeneratorId g) const { return position(mesh_, diagram_.generators[g.index()]); }

  void cut(BranchPointId b, std::vector<GeneratorId> polygon) {
    while (polygon.size() > 3) {
      const std::size_t ear = best_ear(polygon);
      if (ear == polygon.size()) return;
      const std::size_t n = polygon.size();
      add(b, {polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]});
      edges_.insert(std::minmax(polygon[(ear + n - 1) % n], polygon[(ear + 1) % n]));
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    if (polygon.size() == 3) add(b, {polygon[0], polygon[1], polygon[2]});
  }

  /// The ear with the best quality Q among those whose new edge is not an edge yet; the polygon's size if there is
  /// none.
  std::size_t best_ear(const std::vector<GeneratorId>& polygon) const {
    const std::size_t n = polygon.size();
    std::size_t best = n;
    double best_q = -1;
    for (std::size_t i = 0; i < n; ++i) {
      const GeneratorId before = polygon[(i + n - 1) % n], after = polygon[(i + 1) % n];
      if (before == after || edges_.count(std::minmax(before, after)) > 0) continue;
      const double q = compute_q(position_of(before), position_of(polygon[i]), position_of(after));
      if (q > best_q) {
        best_q = q;
        best = i;
      }
    }
    return best;
  }

  void add(BranchPointId b, const std::array<GeneratorId, 3>& face) {
    dual_.faces.push_back(face);
    dual_.branch_points.push_back(b);
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::set<std::pair<GeneratorId, GeneratorId>> edges_;  // of the dual so far, smaller id first
  DualMesh dual_;
};

}  // namespace

DualMesh build_dual(const Mesh& mesh, const Diagram& diagram) { return DualBuilder(mesh, diagram).build(); }

}  // namespace gvd
