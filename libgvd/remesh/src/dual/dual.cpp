// The dual of a diagram: its triangles, and the defects that keep them from being a proper mesh.
//
// Generators become vertices, bisectors edges and branch points faces. A branch point of k > 3 cells is a polygon,
// which is cut into k - 2 triangles. `check_dual` tests properties (1) to (9) of gvd/dual.hpp on the diagram itself. If
// they hold, the triangles form a simplicial complex with the topology of the surface; docs/developer/remesh.md
// explains why. If they do not, each defect names the cells around which a new generator helps. Source: H. Edelsbrunner
// and N. Shah, Triangulating topological spaces, 1997: the closed ball property.

#include "gvd/dual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/least.hpp"
#include "dual/dual_defects.hpp"
#include "gvd/quality.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// Pairs of cells with an edge of the dual, the smaller id first.
using DualEdges = std::set<std::pair<GeneratorId, GeneratorId>>;

/// The ear of a polygon with the best quality Q among those whose new edge is not an edge yet; the polygon's size if
/// there is none.
std::size_t best_ear(const std::vector<GeneratorId>& polygon, const std::vector<Vec3>& positions,
                     const DualEdges& edges) {
  const std::size_t n = polygon.size();
  Least<std::size_t> best{n};
  for (std::size_t i = 0; i < n; ++i) {
    const GeneratorId before = polygon[(i + n - 1) % n], after = polygon[(i + 1) % n];
    if (before == after || edges.count(std::minmax(before, after)) > 0) continue;
    const auto at = [&](GeneratorId g) -> const Vec3& { return positions[g.index()]; };
    best.offer(-compute_q(at(before), at(polygon[i]), at(after)), i);
  }
  return best.value;
}

/// Tests cells, bisectors and branch points one by one; the defects are sorted by property at the end.
class DualChecker {
 public:
  DualChecker(const Mesh& mesh, const Diagram& diagram, const DualMesh& dual)
      : mesh_(mesh),
        diagram_(diagram),
        boundary_ends_(diagram.generators.size(), 0),
        triangles_(diagram.branch_points.size(), 0) {
    for (const BranchPointId b : dual.branch_points) ++triangles_[b];
    for (const Bisector& b : diagram.bisectors) {
      if (b.closed) continue;
      for (const GeneratorId g : {b.left, b.right}) boundary_ends_[g] += !b.ends[0].valid() + !b.ends[1].valid();
    }
  }

  std::vector<DualDefect> run() {
    check_components();
    for (const Cell& cell : diagram_.cells) check(cell);
    for (const BisectorId b : diagram_.bisectors.ids()) check(b);
    for (const BranchPointId b : diagram_.branch_points.ids()) check(b);
    std::ranges::stable_sort(defects_, {}, &DualDefect::property);
    return std::move(defects_);
  }

 private:
  DualDefect& add(DualProperty property, std::vector<GeneratorId> cells, const std::string& what, const Vec3& at) {
    return defects_.emplace_back(make_defect(property, std::move(cells), what, at));
  }

  void check_components() {
    const auto component = compute_face_components(mesh_);
    std::set<std::int32_t> seen;  // components are numbered in the order of their first face
    for (const SurfacePoint& g : diagram_.generators) seen.insert(component[g.face]);
    for (const FaceId f : component.ids()) {
      const std::int32_t c = component[f];
      if (!seen.insert(c).second) continue;
      add(DualProperty::component_reached, {}, fmt::format("component {} of the mesh has no generator", c),
          mesh_.position(mesh_.vertices(f)[0]))
          .component = c;
    }
  }

  void check(const Cell& cell) {
    const GeneratorId g = cell.generator;
    const auto add_defect = [&](DualProperty property, const std::string& what) {
      add(property, {g}, fmt::format("cell {} {}", g.value(), what), position(mesh_, diagram_.generators[g.index()]));
    };
    if (!cell.is_disc()) {
      add_defect(DualProperty::cell_is_disc,
                 fmt::format("is not a disc (Euler characteristic {})", cell.euler_characteristic));
    }
    if (boundary_ends_[g] > 2) {  // a boundary arc lies between two ends of bisectors on the boundary
      add_defect(DualProperty::one_boundary_arc,
                 fmt::format("touches the mesh's boundary in {} arcs", boundary_ends_[g] / 2));
    }
    const bool is_whole_component = cell.neighbours.empty();
    const bool at_boundary = boundary_ends_[g] > 0 || (is_whole_component && cell.boundary_loops > 0);
    const std::size_t least = at_boundary ? 2 : 3;
    if (cell.neighbours.size() < least) {
      const std::string neighbours = counted(std::ssize(cell.neighbours), "neighbour", "neighbours");
      add_defect(DualProperty::enough_neighbours, fmt::format("has {} and needs {}", neighbours, least));
    }
  }

  void check(BisectorId id) {
    const Bisector& b = diagram_.bisectors[id];
    const std::pair<GeneratorId, GeneratorId> cells = std::minmax(b.left, b.right);
    const auto add_defect = [&](DualProperty property, const std::string& what) {
      add(property, {b.left, b.right},
          fmt::format("cells {} and {} {}", cells.first.value(), cells.second.value(), what),
          position(mesh_, b.points[b.points.size() / 2]))
          .bisector = id;
    };
    if (b.closed) {
      add_defect(DualProperty::bisector_has_face, "share a closed bisector");
    } else if (!b.ends[0].valid() && !b.ends[1].valid()) {
      add_defect(DualProperty::bisector_has_face, "share a bisector from boundary to boundary");
    }
    if (++bisectors_of_[cells] == 2) add_defect(DualProperty::one_bisector, "share more than one bisector");
  }

  void check(BranchPointId id) {
    const BranchPoint& branch = diagram_.branch_points[id];
    const auto add_defect = [&](DualProperty property, const std::string& what) {
      add(property, branch.generators, what, branch.position).branch_point = id;
    };
    std::vector<GeneratorId> cells = branch.generators;
    std::sort(cells.begin(), cells.end());
    if (++branch_points_of_[cells] == 2) {
      std::string names;
      for (const GeneratorId g : cells) names += fmt::format("{}{}", names.empty() ? "" : ", ", g.value());
      add_defect(DualProperty::one_branch_point, fmt::format("cells {} share more than one branch point", names));
    }
    if (const auto twice = std::adjacent_find(cells.begin(), cells.end()); twice != cells.end()) {
      add_defect(DualProperty::different_cells, fmt::format("cell {} occurs twice at a branch point", twice->value()));
    }
    if (triangles_[id] != cells.size() - 2) {
      add_defect(DualProperty::polygon_fits,
                 fmt::format("the polygon of a branch point of {} cells can't be triangulated", cells.size()));
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  IdVector<GeneratorId, std::int32_t> boundary_ends_;  // of each cell: ends of its bisectors on the mesh's boundary
  IdVector<BranchPointId, std::size_t> triangles_;     // of the dual at each branch point
  std::map<std::pair<GeneratorId, GeneratorId>, int> bisectors_of_;
  std::map<std::vector<GeneratorId>, int> branch_points_of_;
  std::vector<DualDefect> defects_;
};

}  // namespace

DualMesh build_dual(const Mesh& mesh, const Diagram& diagram) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& p : diagram.generators) positions.push_back(position(mesh, p));
  DualEdges edges;
  for (const Bisector& b : diagram.bisectors) edges.insert(std::minmax(b.left, b.right));
  DualMesh dual;
  const auto add = [&dual](BranchPointId b, const std::array<GeneratorId, 3>& face) {
    dual.faces.push_back(face);
    dual.branch_points.push_back(b);
  };
  for (const BranchPointId b : diagram.branch_points.ids()) {
    std::vector<GeneratorId> polygon = diagram.branch_points[b].generators;
    while (polygon.size() > 3) {
      const std::size_t n = polygon.size(), ear = best_ear(polygon, positions, edges);
      if (ear == n) break;
      const GeneratorId before = polygon[(ear + n - 1) % n], after = polygon[(ear + 1) % n];
      add(b, {before, polygon[ear], after});
      edges.insert(std::minmax(before, after));
      polygon.erase(polygon.begin() + std::ptrdiff_t(ear));
    }
    if (polygon.size() == 3) add(b, {polygon[0], polygon[1], polygon[2]});
  }
  return dual;
}

std::vector<DualDefect> check_dual(const Mesh& mesh, const Diagram& diagram, const DualMesh& dual) {
  return DualChecker(mesh, diagram, dual).run();
}

}  // namespace gvd
