// A soup of polygons becomes a manifold mesh: examined, cleaned, triangulated, oriented, cut apart and assembled.
//
// The steps are those of repair_steps.hpp, in the order of `build_mesh` at the end. Welding comes first, because all
// later steps know vertices by their numbers alone. Faces are oriented before edges are cut, because the inside of the
// surface decides which faces of an edge stay together. A step that finds nothing changes nothing and logs nothing.
// Under DefectPolicy::error the log throws at the first defect.
// Invariant: a soup of triangles without a defect becomes the mesh with the same vertices and faces in the same order.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gvd/text.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace gvd {
namespace {

constexpr std::array<std::string_view, 10> kKindNames = {
    "unwelded_vertices",        "zero_length_edges", "degenerate_faces",     "duplicate_faces", "crossing_quads",
    "inconsistent_orientation", "nonmanifold_edges", "nonmanifold_vertices", "unused_vertices", "dropped_components"};

void examine_positions(const PolygonSoup& soup) {
  if (soup.positions.empty()) refuse_soup("the soup has no vertices", -1);
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const Vec3& p = soup.positions[v];
    if (!p.allFinite()) refuse_soup(fmt::format("vertex {} has a coordinate that is not finite", v), v);
    if (p.cwiseAbs().maxCoeff() > kLargestCoordinate) {
      refuse_soup(fmt::format("vertex {} has a coordinate beyond {:g}; scale the mesh down", v, kLargestCoordinate), v);
    }
    box.extend(p);
  }
  const double extent = box.sizes().maxCoeff();
  if (extent == 0) refuse_soup("all vertices are at one position, that of vertex 0: there is no surface", 0);
  if (extent < kSmallestExtent) {
    refuse_soup(fmt::format("the whole mesh is smaller than {:g}; scale it up", kSmallestExtent), 0);
  }
}

void examine_polygons(const PolygonSoup& soup) {
  if (soup.first_corner.empty() || soup.first_corner.front() != 0 || soup.first_corner.back() != soup.corners.size()) {
    refuse_soup("the soup's first_corner does not span its corners", -1);
  }
  if (soup.polygon_count() == 0) refuse_soup("the soup has no face", -1);
  constexpr std::size_t kMost = 0x7fffffff;
  if (soup.positions.size() > kMost || soup.polygon_count() > kMost) {
    refuse_soup("the soup has more elements than 32-bit ids can count", -1);
  }
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    if (soup.first_corner[p] > soup.first_corner[p + 1] || soup.first_corner[p + 1] > soup.corners.size()) {
      refuse_soup(fmt::format("the soup's first_corner is out of order at face {}", p), p);
    }
    for (std::size_t c = soup.first_corner[p]; c < soup.first_corner[p + 1]; ++c) {
      const std::int32_t v = soup.corners[c];
      if (v < 0 || v >= std::ssize(soup.positions)) {
        refuse_soup(fmt::format("face {} refers to vertex {}, and there are {}", p, v, soup.positions.size()), p);
      }
    }
  }
}

/// A triangle counts as one without area if its height is at most this fraction of its longest side. Dimensionless. Ten
/// times the rounding error of a position on the side.
constexpr double kHeightWithoutArea = 1e-15;

std::vector<char> find_used_vertices(const WorkFaces& work) {
  std::vector<char> used(work.positions.size(), 0);
  for (const auto& face : work.faces) {
    for (const std::int32_t v : face) used[v] = 1;
  }
  return used;
}

/// Logs the vertices in no polygon of the soup. Vertices that lost their faces by a repair do not count.
void log_unused_vertices(const PolygonSoup& soup, DefectLog& log) {
  std::vector<char> used(soup.positions.size(), 0);
  for (const std::int32_t v : soup.corners) used[v] = 1;
  const std::int64_t count = std::count(used.begin(), used.end(), 0);
  const std::int64_t first = std::find(used.begin(), used.end(), 0) - used.begin();
  log.add(DefectKind::unused_vertices, count, first,
          fmt::format("{} in no face, first vertex {}", counted(count, "vertex is", "vertices are"), first), "removed");
}

CheckedMesh assemble(WorkFaces work, const std::vector<std::int32_t>& weld) {
  CheckedMesh checked;
  const std::vector<char> used = find_used_vertices(work);
  const auto count = std::count(used.begin(), used.end(), 1);
  std::vector<VertexId> renumbered(work.positions.size());
  std::vector<Vec3> positions;
  positions.reserve(count);
  checked.input_vertex.reserve(count);
  for (std::size_t v = 0; v < work.positions.size(); ++v) {
    if (!used[v]) continue;
    renumbered[v] = checked.input_vertex.push_back(work.source[v]);
    positions.push_back(work.positions[v]);
  }
  std::vector<std::array<VertexId, 3>> faces;
  faces.reserve(work.faces.size());
  for (const auto& [a, b, c] : work.faces) {
    faces.push_back({renumbered[a], renumbered[b], renumbered[c]});
  }
  checked.mesh_vertex.reserve(weld.size());
  for (const std::int32_t v : weld) checked.mesh_vertex.push_back(renumbered[v]);
  checked.input_polygon = IdVector<FaceId, std::int32_t>(std::move(work.origin));
  work = {};  // its memory
  checked.mesh = Mesh(std::move(positions), std::move(faces));
  return checked;
}

std::int64_t count_zero_area_faces(const Mesh& mesh) {
  return std::count_if(mesh.faces().begin(), mesh.faces().end(), [&](FaceId f) {
    const auto& [length, twice_area] = mesh.shape(f);
    const double longest = *std::max_element(length.begin(), length.end());
    return twice_area <= kHeightWithoutArea * longest * longest;
  });
}

/// Number of boundary vertices at the position of another boundary vertex that comes from another vertex of the input.
std::int64_t count_coincident_vertices(const CheckedMesh& checked) {
  std::vector<PlacedVertex> placed;
  for (const VertexId v : checked.mesh.vertices()) {
    if (!checked.mesh.is_boundary(v) || checked.input_vertex[v] < 0) continue;
    const Vec3& p = checked.mesh.position(v);
    placed.push_back({{p.x(), p.y(), p.z()}, checked.input_vertex[v]});
  }
  std::sort(placed.begin(), placed.end());
  placed.erase(std::unique(placed.begin(), placed.end()), placed.end());
  std::int64_t count = 0;
  for (std::size_t i = 1; i < placed.size(); ++i) count += placed[i - 1].first == placed[i].first;
  return count;
}

void add_remarks(CheckedMesh& checked) {
  DefectReport& report = checked.defects;
  report.zero_area_faces = count_zero_area_faces(checked.mesh);
  report.coincident_vertices = count_coincident_vertices(checked);
  if (report.split_edges > 0) {
    report.messages.push_back(fmt::format("{} along which the surface touches itself: cut by new vertices on them",
                                          counted(report.split_edges, "edge", "edges")));
  }
  if (report.zero_area_faces > 0) {
    report.messages.push_back(fmt::format("{} no area (three points on a line): kept, they hold the surface together",
                                          counted(report.zero_area_faces, "triangle has", "triangles have")));
  }
  if (report.coincident_vertices > 0) {
    report.messages.push_back(
        fmt::format("{} at the position of another one: not joined, the surface is open there",
                    counted(report.coincident_vertices, "boundary vertex is", "boundary vertices are")));
  }
}

}  // namespace

std::string_view name_of(DefectKind kind) { return kKindNames[static_cast<int>(kind)]; }

std::int64_t DefectReport::count(DefectKind kind) const {
  for (const Defect& defect : defects) {
    if (defect.kind == kind) return defect.count;
  }
  return 0;
}

void DefectLog::add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what,
                    const std::string& action) {
  if (count == 0) return;
  if (policy_ == DefectPolicy::error) refuse_soup(what + ": repair the mesh, or allow its repair", first);
  const std::string message = what + ": " + action;
  report_.defects.push_back({kind, count, first, message});
  report_.messages.push_back(message);
}

CheckedMesh build_mesh(const PolygonSoup& soup, DefectPolicy policy) {
  examine_polygons(soup);
  examine_positions(soup);
  DefectLog log(policy);
  log.report().messages = soup.notes;
  const std::vector<std::int32_t> weld = weld_vertices(soup, log);
  WorkPolygons polygons = remove_degenerate_faces(soup, weld, log);
  remove_duplicate_faces(polygons, soup.positions.size(), log);
  WorkFaces work = triangulate_polygons(std::move(polygons), soup.positions, log);
  EdgeTable nonmanifold_edges = pair_halfedges(work, soup.positions.size());
  const std::vector<char> one_sided = orient_faces(work, nonmanifold_edges, log);
  const std::vector<char> on_cut_edge = cut_edges(work, nonmanifold_edges, soup.positions, one_sided, log);
  keep_largest_component(work, soup.positions, one_sided, log);
  cut_vertices(work, soup.positions, on_cut_edge, log);
  split_touching_edges(work, log);
  log_unused_vertices(soup, log);
  CheckedMesh checked = assemble(std::move(work), weld);
  checked.defects = std::move(log.report());
  add_remarks(checked);
  return checked;
}

}  // namespace gvd
