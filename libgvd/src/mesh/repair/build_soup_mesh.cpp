#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "gvd/counted.hpp"
#include "gvd/soup.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/examine_soup.hpp"
#include "mesh/repair/pair_halfedges.hpp"
#include "mesh/repair/repair_components.hpp"
#include "mesh/repair/repair_degenerate_faces.hpp"
#include "mesh/repair/repair_duplicate_faces.hpp"
#include "mesh/repair/repair_nonmanifold_edges.hpp"
#include "mesh/repair/repair_nonmanifold_vertices.hpp"
#include "mesh/repair/repair_orientation.hpp"
#include "mesh/repair/repair_touching_edges.hpp"
#include "mesh/repair/repair_welding.hpp"
#include "mesh/repair/triangulate_soup.hpp"

namespace gvd {
namespace {

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

// Vertices in no polygon of the soup. Those that lost their faces by a repair do not count.
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
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
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
  std::int64_t count = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    double longest = 0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, mesh.length(Mesh::halfedge(FaceId(f), i)));
    count += 2 * mesh.area(FaceId(f)) <= kHeightWithoutArea * longest * longest;
  }
  return count;
}

// Boundary vertices at the position of another boundary vertex that comes from another vertex of the input.
std::int64_t count_coincident_vertices(const CheckedMesh& checked) {
  using Entry = std::tuple<double, double, double, std::int32_t>;
  std::vector<Entry> entries;
  for (std::int32_t i = 0; i < checked.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (!checked.mesh.is_boundary(v) || checked.input_vertex[v] < 0) continue;
    const Vec3& p = checked.mesh.position(v);
    entries.emplace_back(p.x(), p.y(), p.z(), checked.input_vertex[v]);
  }
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  const auto same = [](const Entry& a, const Entry& b) {
    return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b) && std::get<2>(a) == std::get<2>(b);
  };
  std::int64_t count = 0;
  for (std::size_t i = 1; i < entries.size(); ++i) count += same(entries[i - 1], entries[i]);
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

CheckedMesh build_mesh(const PolygonSoup& soup, DefectPolicy policy) {
  examine_soup(soup);
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
