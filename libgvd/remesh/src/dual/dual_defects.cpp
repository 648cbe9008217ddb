// Describes the defects of a dual by their property, what is wrong, and where.
#include "dual/dual_defects.hpp"

#include <fmt/format.h>

#include <utility>

namespace gvd {

DualDefect make_defect(DualProperty property, std::vector<GeneratorId> cells, const std::string& what, const Vec3& at) {
  DualDefect defect;
  defect.property = property;
  defect.message =
      fmt::format("({}) {}, near ({:.6g}, {:.6g}, {:.6g})", static_cast<int>(property), what, at.x(), at.y(), at.z());
  defect.cells = std::move(cells);
  return defect;
}

DualDefect triangle_defect(const Diagram& diagram, const DualMesh& dual, std::size_t triangle, const std::string& what,
                           DualProperty property) {
  const auto& [a, b, c] = dual.faces[triangle];
  const BranchPointId branch = dual.branch_points[triangle];
  const std::string whole =
      fmt::format("the triangle of the generators {}, {} and {} {}", a.value(), b.value(), c.value(), what);
  DualDefect defect = make_defect(property, {a, b, c}, whole, diagram.branch_points[branch].position);
  defect.branch_point = branch;
  return defect;
}

}  // namespace gvd
