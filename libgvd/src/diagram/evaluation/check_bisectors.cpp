#include "diagram/evaluation/check_bisectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

bool share_face(const Mesh& mesh, const SurfacePoint& p, const SurfacePoint& q) {
  const auto faces_p = faces_around(mesh, p), faces_q = faces_around(mesh, q);
  return std::find_first_of(faces_p.begin(), faces_p.end(), faces_q.begin(), faces_q.end()) != faces_p.end();
}

void check_points(const Mesh& mesh, const Bisector& b, std::size_t i, Violations& violations) {
  const std::size_t n = b.points.size();
  for (std::size_t k = 0; k + (b.closed ? 0 : 1) < n; ++k) {
    if (share_face(mesh, b.points[k], b.points[(k + 1) % n])) continue;
    violations.add(3, "bisector", i, fmt::format("its points {} and {} have no face in common", k, (k + 1) % n));
    return;
  }
}

void check_ends(const Mesh& mesh, const Bisector& b, std::size_t i, Violations& violations) {
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    const SurfacePoint& p = end == 0 ? b.points.front() : b.points.back();
    if (b.closed || b.ends[end].valid() || is_on_boundary(mesh, p)) continue;
    violations.add(4, "bisector", i, "ends neither at a branch point nor on the boundary of the mesh");
  }
}

/// For every branch point the cells whose sector begins at a bisector that ends there.
IdVector<BranchPointId, std::vector<GeneratorId>> cells_at_branch_points(const Diagram& diagram) {
  IdVector<BranchPointId, std::vector<GeneratorId>> cells(diagram.branch_points.size());
  for (const Bisector& b : diagram.bisectors) {
    if (b.ends[0].valid()) cells[b.ends[0]].push_back(b.right);
    if (b.ends[1].valid()) cells[b.ends[1]].push_back(b.left);
  }
  return cells;
}

void check_branch_points(const Diagram& diagram, Violations& violations) {
  auto cells = cells_at_branch_points(diagram);
  for (std::size_t i = 0; i < diagram.branch_points.size(); ++i) {
    const BranchPointId id(i);
    auto named = diagram.branch_points[id].generators;
    if (cells[id].size() < 3) violations.add(5, "branch point", i, "fewer than three bisectors end at it");
    std::sort(named.begin(), named.end());
    std::sort(cells[id].begin(), cells[id].end());
    if (named != cells[id]) violations.add(5, "branch point", i, "its generators are not those of its bisectors");
  }
}

}  // namespace

void check_bisectors(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  for (std::size_t i = 0; i < diagram.bisectors.size(); ++i) {
    const Bisector& b = diagram.bisectors[BisectorId(i)];
    if (b.points.size() < 2 || !b.left.valid() || !b.right.valid() || b.left == b.right) {
      violations.add(3, "bisector", i, "does not separate two cells, or has fewer than two points");
      continue;
    }
    check_points(mesh, b, i, violations);
    check_ends(mesh, b, i, violations);
  }
  check_branch_points(diagram, violations);
}

}  // namespace gvd
