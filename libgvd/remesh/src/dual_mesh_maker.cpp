#include "dual_mesh_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/self_intersections.hpp"
#include "placement/with_positions.hpp"

namespace gvd {
namespace {

std::vector<Vec3> positions_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> positions;
  for (const SurfacePoint& p : points) positions.push_back(position(mesh, p));
  return positions;
}

/// Up to this round, flipped triangles are looked for only where the dual has no other defect. The repair of the others
/// often removes them. A remesh that takes more rounds would repair the two kinds in turns. Nine of ten
/// remeshes end before.
constexpr std::int32_t kRoundsWithoutFlips = 12;

}  // namespace

std::vector<DualDefect> DualMeshMaker::build(const DualMesh& dual) {
  std::vector<DualDefect> defects = find_dual_defects(dual);
  if (!defects.empty()) return defects;
  build_mesh(dual);
  for (const FaceId f : find_flipped_faces(mesh_, result_.mesh, result_.generators, result_.face_points)) {
    defects.push_back(triangle_defect(dual, f.index(), "is flipped"));
  }
  return defects;
}

std::vector<DualDefect> DualMeshMaker::place(const DualMesh& dual) {
  PlacementOptions options = options_.placement;
  options.threads = options_.diagram.threads;
  if (options.method != Placement::generator) {
    const auto positions = place_vertices(mesh_, result_.diagram, result_.mesh, result_.face_points, options);
    result_.mesh = with_positions(result_.mesh, positions);
  }
  return find_intersections(dual);
}

/// Those that leave no mesh to build, and in late rounds flipped triangles beside them.
std::vector<DualDefect> DualMeshMaker::find_dual_defects(const DualMesh& dual) const {
  std::vector<DualDefect> defects = check_dual(mesh_, result_.diagram);
  if (!defects.empty() && result_.rounds <= kRoundsWithoutFlips) return defects;
  if (!defects.empty()) {
    for (const std::size_t i : find_flipped_triangles(mesh_, result_.diagram, dual)) {
      defects.push_back(triangle_defect(dual, i, "is flipped"));
    }
    return defects;
  }
  for (std::size_t i = 0; i < dual.faces.size(); ++i) {
    if (has_coincident_corners(dual.faces[i])) defects.push_back(triangle_defect(dual, i, "has an edge of length 0"));
  }
  return defects;
}

/// Of the placed mesh: its vertices may have left the intersections that there were at the generators.
std::vector<DualDefect> DualMeshMaker::find_intersections(const DualMesh& dual) const {
  if (options_.allow_intersections) return {};
  const int threads = options_.diagram.threads;
  const std::vector<FacePair> pairs = find_self_intersections(result_.mesh, threads);
  const std::vector<FacePair> inherited = find_inherited(mesh_, result_.mesh, pairs, threads);
  std::vector<DualDefect> defects;
  for (const FacePair& pair : pairs) {
    if (std::binary_search(inherited.begin(), inherited.end(), pair)) continue;
    for (const auto& [f, g] : {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)}) {
      const auto& [a, b, c] = dual.faces[g.index()];
      defects.push_back(triangle_defect(
          dual, f.index(), fmt::format("intersects that of {}, {} and {}", a.value(), b.value(), c.value()),
          DualProperty::no_self_intersection));
    }
  }
  return defects;
}

/// Generators on the two sides of a slit can have the same position while they are far apart on the surface.
bool DualMeshMaker::has_coincident_corners(const std::array<GeneratorId, 3>& face) const {
  const auto at = [&](std::size_t corner) { return position(mesh_, result_.generators[face[corner].index()]); };
  return at(0) == at(1) || at(1) == at(2) || at(2) == at(0);
}

void DualMeshMaker::build_mesh(const DualMesh& dual) {
  std::vector<std::array<VertexId, 3>> faces;
  result_.face_points.clear();
  for (std::size_t i = 0; i < dual.faces.size(); ++i) {
    const auto& [a, b, c] = dual.faces[i];
    faces.push_back({VertexId(a.value()), VertexId(b.value()), VertexId(c.value())});
    result_.face_points.push_back(result_.diagram.branch_points[dual.branch_points[i]].point);
  }
  try {
    result_.mesh = Mesh(positions_of(mesh_, result_.generators), std::move(faces));
  } catch (const Error& error) {
    throw Error(ErrorCode::no_valid_result,
                std::string("the dual of the generators is not a manifold mesh: ") + error.what() +
                    "; move or remove generators",
                error.element());
  }
}

DualDefect DualMeshMaker::triangle_defect(const DualMesh& dual, std::size_t face, const std::string& what,
                                          DualProperty property) const {
  DualDefect defect;
  defect.property = property;
  defect.branch_point = dual.branch_points[face];
  const auto& [a, b, c] = dual.faces[face];
  defect.cells = {a, b, c};
  const Vec3& at = result_.diagram.branch_points[defect.branch_point].position;
  defect.message =
      fmt::format("({}) the triangle of the generators {}, {} and {} {}, near ({:.6g}, {:.6g}, {:.6g})",
                  static_cast<int>(property), a.value(), b.value(), c.value(), what, at.x(), at.y(), at.z());
  return defect;
}

}  // namespace gvd
