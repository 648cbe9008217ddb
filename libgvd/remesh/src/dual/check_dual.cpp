#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "gvd/dual.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

std::string format_position(const Vec3& p) { return fmt::format("near ({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z()); }

class DualChecker {
 public:
  DualChecker(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {}

  std::vector<DualDefect> run() {
    count_boundary_ends();
    check_components();
    check_discs();
    check_boundary_arcs();
    check_bisectors();
    check_pairs();
    check_branch_points();
    check_neighbours();
    check_different_cells();
    check_polygons();
    return std::move(defects_);
  }

 private:
  static std::int64_t to_id(std::size_t i) { return static_cast<std::int64_t>(i); }

  Vec3 generator_position(GeneratorId g) const { return position(mesh_, diagram_.generators[g.index()]); }
  std::string at_cell(GeneratorId g) const { return format_position(generator_position(g)); }
  Vec3 middle(const Bisector& b) const { return position(mesh_, b.points[b.points.size() / 2]); }

  void add_cell_defect(DualProperty property, GeneratorId g, const std::string& what) {
    DualDefect defect;
    defect.property = property;
    defect.message = fmt::format("({}) cell {} {}, {}", static_cast<int>(property), g.value(), what, at_cell(g));
    defect.cells = {g};
    defects_.push_back(std::move(defect));
  }

  void add_bisector_defect(DualProperty property, std::size_t i, const std::string& what) {
    const Bisector& b = diagram_.bisectors[BisectorId(to_id(i))];
    DualDefect defect;
    defect.property = property;
    const auto [first, second] = std::minmax(b.left, b.right);
    defect.message = fmt::format("({}) cells {} and {} {}, {}", static_cast<int>(property), first.value(),
                                 second.value(), what, format_position(middle(b)));
    defect.cells = {b.left, b.right};
    defect.bisector = BisectorId(to_id(i));
    defects_.push_back(std::move(defect));
  }

  void add_branch_defect(DualProperty property, BranchPointId b, const std::string& what) {
    const BranchPoint& branch = diagram_.branch_points[b];
    DualDefect defect;
    defect.property = property;
    defect.message = fmt::format("({}) {}, {}", static_cast<int>(property), what, format_position(branch.position));
    defect.cells = branch.generators;
    defect.branch_point = b;
    defects_.push_back(std::move(defect));
  }

  void count_boundary_ends() {
    boundary_ends_.assign(diagram_.generators.size(), 0);
    for (const Bisector& b : diagram_.bisectors) {
      if (b.closed) continue;
      for (const BranchPointId end : b.ends) {
        if (end.valid()) continue;
        ++boundary_ends_[b.left];
        ++boundary_ends_[b.right];
      }
    }
  }

  void check_components() {
    const auto component = compute_face_components(mesh_);
    std::int32_t count = 0;
    for (const std::int32_t c : component) count = std::max(count, c + 1);
    std::vector<char> reached(static_cast<std::size_t>(count), 0);
    for (const SurfacePoint& g : diagram_.generators) reached[component[g.face]] = 1;
    for (std::int32_t c = 0; c < count; ++c) {
      if (reached[c]) continue;
      DualDefect defect;
      defect.property = DualProperty::component_reached;
      defect.component = c;
      const FaceId f(std::find(component.begin(), component.end(), c) - component.begin());
      defect.message = fmt::format("(1) component {} of the mesh has no generator, {}", c,
                                   format_position(mesh_.position(mesh_.vertices(f)[0])));
      defects_.push_back(std::move(defect));
    }
  }

  void check_discs() {
    for (const Cell& c : diagram_.cells) {
      if (c.components == 1 && c.euler_characteristic == 1) continue;
      add_cell_defect(DualProperty::cell_is_disc, c.generator,
                      fmt::format("is not a disc (Euler characteristic {})", c.euler_characteristic));
    }
  }

  /// A boundary arc lies between two ends of bisectors on the boundary.
  void check_boundary_arcs() {
    for (const Cell& c : diagram_.cells) {
      if (boundary_ends_[c.generator] <= 2) continue;
      add_cell_defect(DualProperty::one_boundary_arc, c.generator,
                      fmt::format("touches the mesh's boundary in {} arcs", boundary_ends_[c.generator] / 2));
    }
  }

  void check_bisectors() {
    for (std::size_t i = 0; i < diagram_.bisectors.size(); ++i) {
      const Bisector& b = diagram_.bisectors[BisectorId(to_id(i))];
      if (b.closed) {
        add_bisector_defect(DualProperty::bisector_has_face, i, "share a closed bisector");
      } else if (!b.ends[0].valid() && !b.ends[1].valid()) {
        add_bisector_defect(DualProperty::bisector_has_face, i, "share a bisector from boundary to boundary");
      }
    }
  }

  void check_pairs() {
    std::map<std::pair<GeneratorId, GeneratorId>, int> count;
    for (std::size_t i = 0; i < diagram_.bisectors.size(); ++i) {
      const Bisector& b = diagram_.bisectors[BisectorId(to_id(i))];
      if (++count[std::minmax(b.left, b.right)] == 2) {
        add_bisector_defect(DualProperty::one_bisector, i, "share more than one bisector");
      }
    }
  }

  void check_branch_points() {
    std::map<std::vector<GeneratorId>, int> count;
    for (std::size_t i = 0; i < diagram_.branch_points.size(); ++i) {
      std::vector<GeneratorId> cells = diagram_.branch_points[BranchPointId(to_id(i))].generators;
      std::sort(cells.begin(), cells.end());
      if (++count[cells] != 2) continue;
      std::string names;
      for (const GeneratorId g : cells) names += fmt::format("{}{}", names.empty() ? "" : ", ", g.value());
      add_branch_defect(DualProperty::one_branch_point, BranchPointId(to_id(i)),
                        fmt::format("cells {} share more than one branch point", names));
    }
  }

  void check_neighbours() {
    for (const Cell& c : diagram_.cells) {
      const bool whole_component = c.neighbours.empty();
      const bool at_boundary = boundary_ends_[c.generator] > 0 || (whole_component && c.boundary_loops > 0);
      const std::size_t least = at_boundary ? 2 : 3;
      if (c.neighbours.size() >= least) continue;
      add_cell_defect(
          DualProperty::enough_neighbours, c.generator,
          fmt::format("has {} and needs {}", counted(std::ssize(c.neighbours), "neighbour", "neighbours"), least));
    }
  }

  void check_different_cells() {
    for (std::size_t i = 0; i < diagram_.branch_points.size(); ++i) {
      std::vector<GeneratorId> cells = diagram_.branch_points[BranchPointId(to_id(i))].generators;
      std::sort(cells.begin(), cells.end());
      const auto twice = std::adjacent_find(cells.begin(), cells.end());
      if (twice == cells.end()) continue;
      add_branch_defect(DualProperty::different_cells, BranchPointId(to_id(i)),
                        fmt::format("cell {} occurs twice at a branch point", twice->value()));
    }
  }

  void check_polygons() {
    std::size_t wanted = 0;
    for (const BranchPoint& b : diagram_.branch_points) wanted += b.generators.size() - 2;
    const DualMesh dual = build_dual(mesh_, diagram_);
    if (dual.faces.size() == wanted) return;
    std::vector<std::size_t> found(diagram_.branch_points.size(), 0);
    for (const BranchPointId b : dual.branch_points) ++found[b.index()];
    for (std::size_t i = 0; i < found.size(); ++i) {
      const BranchPointId b(to_id(i));
      const std::size_t corners = diagram_.branch_points[b].generators.size();
      if (found[i] == corners - 2) continue;
      add_branch_defect(DualProperty::polygon_fits, b,
                        fmt::format("the polygon of a branch point of {} cells can't be triangulated", corners));
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  IdVector<GeneratorId, std::int32_t> boundary_ends_;  // of each cell: ends of its bisectors on the mesh's boundary
  std::vector<DualDefect> defects_;
};

}  // namespace

std::vector<DualDefect> check_dual(const Mesh& mesh, const Diagram& diagram) {
  return DualChecker(mesh, diagram).run();
}

}  // namespace gvd
