// Turns a soup of polygons into a manifold mesh: examines, cleans, triangulates, orients, cuts apart and assembles it.
//
// `build_repaired` near the end lists the steps in order. Each step has a file of its own and is deterministic. Welding
// comes first, because all later steps identify vertices by their numbers alone. Faces are oriented before edges are
// cut, because the inside of the surface decides which faces of an edge stay together. A step that finds no defect
// changes nothing and logs nothing. Under DefectPolicy::error the log throws at the first defect.
// Invariant: a soup of triangles without a defect becomes a mesh with the same vertices and faces in the same order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "gvd/text.hpp"
#include "mesh/repair/carry_appearance.hpp"
#include "mesh/repair/clean_polygons.hpp"
#include "mesh/repair/cut_apart.hpp"
#include "mesh/repair/cut_twists.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/examine_open_edges.hpp"
#include "mesh/repair/soup_components.hpp"
#include "mesh/repair/triangulate_soup.hpp"
#include "mesh/repair/work_faces.hpp"
#include "mesh/submesh.hpp"

namespace gvd {
namespace {

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
  if (extent == 0) refuse_soup("all vertices are at the same position, that of vertex 0: there is no surface", 0);
  if (extent < kSmallestExtent) {
    refuse_soup(fmt::format("the whole mesh is smaller than {:g}; scale it up", kSmallestExtent), 0);
  }
}

/// Refuses an appearance whose arrays do not match the soup's corners and polygons. Readers never make one.
void examine_appearance(const PolygonSoup& soup) {
  const auto& [texture, material, materials, files, unread] = soup.appearance;
  const bool is_whole = (texture.empty() || texture.size() == soup.corners.size()) &&
                        (material.empty() || material.size() == soup.polygon_count());
  if (!is_whole) refuse_soup("the soup has no texture coordinate for each corner, or no material for each face", -1);
  const std::int64_t names = std::ssize(materials);
  const auto is_known = [names](std::int32_t m) { return m >= -1 && m < names; };
  if (!std::all_of(material.begin(), material.end(), is_known)) refuse_soup("a material of the soup has no name", -1);
}

void examine_polygons(const PolygonSoup& soup) {
  if (soup.first_corner.empty() || soup.first_corner.front() != 0 || soup.first_corner.back() != soup.corners.size()) {
    refuse_soup("the soup's first_corner does not span its corners", -1);
  }
  if (soup.polygon_count() == 0) refuse_soup("the mesh has no face; give it at least one", -1);
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

/// Rounding decides the shape of a triangle whose height is at most this fraction of its longest side: its corners are
/// rounded by up to 2^-53 of the side, so the height is off by one part in 128 or more. On a stretched tube with half
/// of its triangles below 1.8e-14, lengths of bisectors were off by up to .6 %; at 1.8e-15, by up to 17 %.
/// Dimensionless.
constexpr double kHeightWithoutShape = 0x1p-46;

/// Logs the vertices that no polygon of the soup uses. Vertices that lost their faces in the repair do not count.
void log_unused_vertices(const PolygonSoup& soup, DefectLog& log) {
  const std::vector<char> used = find_used_vertices(soup);
  const std::int64_t count = std::count(used.begin(), used.end(), 0);
  const std::int64_t first = std::find(used.begin(), used.end(), 0) - used.begin();
  log.add(DefectKind::unused_vertices, count, first,
          fmt::format("{} in no face, first vertex {}", counted(count, "vertex is", "vertices are"), first), "removed");
}

CheckedMesh assemble(WorkFaces work, const std::vector<std::int32_t>& weld) {
  std::vector<std::array<VertexId, 3>> faces;
  faces.reserve(work.faces.size());
  for (const auto& [a, b, c] : work.faces) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  const KeptVertices kept = drop_unused_vertices(work.positions.size(), faces);
  CheckedMesh checked;
  std::vector<Vec3> positions;
  positions.reserve(kept.before.size());
  checked.input_vertex.reserve(kept.before.size());
  for (const VertexId v : kept.before) {
    checked.input_vertex.push_back(work.source[v.index()]);
    positions.push_back(work.positions[v.index()]);
  }
  checked.mesh_vertex.reserve(weld.size());
  for (const std::int32_t v : weld) checked.mesh_vertex.push_back(kept.after[VertexId(v)]);
  checked.input_polygon = IdVector<FaceId, std::int32_t>(std::move(work.origin));
  work = {};  // frees its memory
  checked.mesh = Mesh(std::move(positions), std::move(faces));
  return checked;
}

/// Number of faces whose height is at most this fraction of their longest side.
std::int64_t count_faces_below(const Mesh& mesh, double height) {
  return std::count_if(mesh.faces().begin(), mesh.faces().end(), [&](FaceId f) {
    const auto& [length, twice_area] = mesh.shape(f);
    const double longest = *std::max_element(length.begin(), length.end());
    return twice_area <= height * longest * longest;
  });
}

/// Refuses a mesh if rounding decides the shape of most triangles. A few such triangles are common, and only hold the
/// surface together. Triangles of area 0 do not count, because they are degenerate in the input and not by rounding.
void require_shapes(const Mesh& mesh) {
  const std::int64_t without = count_faces_below(mesh, kHeightWithoutShape) - count_faces_below(mesh, 0);
  if (2 * without <= mesh.face_count()) return;
  double shortest = kInfinity;
  for (const EdgeId e : mesh.edges()) shortest = std::min(shortest, mesh.length(e));
  throw Error(
      ErrorCode::precondition,
      fmt::format("rounding decides the shape of {} of {}: heights are below {:.1g} of the longest sides, and edges "
                  "from {:.3g} to {:.3g} long; scale the axes until they have similar extents",
                  without, counted(mesh.face_count(), "triangle", "triangles"), kHeightWithoutShape, shortest,
                  longest_edge(mesh)));
}

void add_remarks(CheckedMesh& checked, const PolygonSoup& soup) {
  DefectReport& report = checked.defects;
  report.zero_area_faces = count_faces_below(checked.mesh, kHeightWithoutArea);
  if (report.split_edges > 0) {
    report.messages.push_back(fmt::format("{} along which the surface touches itself: cut by new vertices on them",
                                          counted(report.split_edges, "edge", "edges")));
  }
  if (report.zero_area_faces > 0) {
    report.messages.push_back(
        fmt::format("{} no area (three points on a line): kept, because they hold the surface together",
                    counted(report.zero_area_faces, "triangle has", "triangles have")));
  }
  examine_open_edges(checked, soup.weld_tolerance);
}

CheckedMesh build_repaired(const PolygonSoup& soup, DefectPolicy policy) {
  examine_polygons(soup);
  examine_positions(soup);
  examine_appearance(soup);
  DefectLog log(policy);
  log.report().messages = soup.notes;
  const std::vector<std::int32_t> weld = weld_vertices(soup, log);
  WorkPolygons polygons = remove_degenerate_faces(soup, weld, log);
  remove_duplicate_faces(polygons, soup.positions.size(), log);
  WorkFaces work = triangulate_polygons(std::move(polygons), soup.positions, log);
  EdgeTable nonmanifold_edges = pair_halfedges(work, soup.positions.size());
  const std::vector<std::int32_t> twisted = cut_twists(work, log);
  const std::vector<char> one_sided = orient_faces(work, nonmanifold_edges, log);
  std::vector<char> on_cut_edge = cut_edges(work, nonmanifold_edges, soup.positions, one_sided, log);
  for (const std::int32_t v : twisted) on_cut_edge[v] = 1;
  keep_largest_component(work, soup.positions, one_sided, log);
  cut_vertices(work, soup.positions, on_cut_edge, log);
  split_touching_edges(work, log);
  drop_zero_area_components(work, log);
  log_unused_vertices(soup, log);
  CheckedMesh checked = assemble(std::move(work), weld);
  require_shapes(checked.mesh);
  checked.defects = std::move(log.report());
  checked.appearance = carry_appearance(soup, checked);
  add_remarks(checked, soup);
  return checked;
}

}  // namespace

CheckedMesh build_mesh(const PolygonSoup& soup, DefectPolicy policy, std::string_view name) {
  try {
    return build_repaired(soup, policy);
  } catch (const Error& error) {
    if (name.empty()) throw;
    throw error.at(name);
  }
}

CheckedMesh as_input(Mesh mesh) {
  CheckedMesh checked;
  checked.mesh = std::move(mesh);
  for (const VertexId v : checked.mesh.vertices()) {
    checked.mesh_vertex.push_back(v);
    checked.input_vertex.push_back(v.value());
  }
  for (const FaceId f : checked.mesh.faces()) checked.input_polygon.push_back(f.value());
  return checked;
}

}  // namespace gvd
