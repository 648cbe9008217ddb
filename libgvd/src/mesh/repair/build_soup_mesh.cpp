// A soup of polygons becomes a manifold mesh: examined, cleaned, triangulated, oriented, cut apart and assembled.
//
// The steps are those of repair_steps.hpp, in the order of `build_mesh` at the end. Welding comes first, because all
// later steps know vertices by their numbers alone. Faces are oriented before edges are cut, because the inside of the
// surface decides which faces of an edge stay together. A step that finds nothing changes nothing and logs nothing.
// Under DefectPolicy::error the log throws at the first defect.
//
// The steps on components are here: a breadth-first search gives each face of a component the orientation that its
// neighbours ask for, relative to the first face; the majority decides. A face that would need both belongs to a
// surface with one side only. The largest component is that of the largest area; of equal ones the first is kept.
// Invariant: a soup of triangles without a defect becomes the mesh with the same vertices and faces in the same order.
// Edges of three or more faces connect no component. They are cut apart later, when all faces that they join are
// oriented.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "gvd/text.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace gvd {
namespace {

/// Faces that are connected through edges of two faces, in the order of a breadth-first search from the first one.
struct OrientedComponent {
  std::vector<std::int32_t> faces;
  std::int32_t flipped = 0;    // number of `faces` with the opposite orientation of the first
  std::int32_t conflict = -1;  // a face that would need both orientations
};

/// Finds the component of `start`. Sets side[f] to 0 where f has the orientation of `start`, to 1 where the opposite
/// one.
OrientedComponent walk_component(const WorkFaces& work, std::int32_t start, std::vector<signed char>& side) {
  OrientedComponent component;
  component.faces.push_back(start);
  side[start] = 0;
  for (std::size_t i = 0; i < component.faces.size(); ++i) {
    const std::int32_t f = component.faces[i];
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::int32_t twin = work.twin[h];
      if (twin < 0) continue;
      const bool same_direction = work.from(h) == work.from(twin);
      const signed char wanted = same_direction ? !side[f] : side[f];
      signed char& other = side[twin / 3];
      if (other < 0) {
        other = wanted;
        component.flipped += wanted;
        component.faces.push_back(twin / 3);
      } else if (other != wanted && component.conflict < 0) {
        component.conflict = std::max(f, twin / 3);
      }
    }
  }
  return component;
}

/// Reverses a face by swapping its last two corners: its halfedges 0, 1, 2 become 2, 1, 0.
void flip(WorkFaces& work, std::int32_t f) {
  auto& corners = work.faces[f];
  std::swap(corners[1], corners[2]);
  std::swap(work.twin[3 * f], work.twin[3 * f + 2]);
  for (const std::int32_t moved : {3 * f, 3 * f + 2}) {
    if (work.twin[moved] >= 0) work.twin[work.twin[moved]] = moved;
  }
}

[[noreturn]] void refuse_one_sided(const WorkFaces& work, const OrientedComponent& component) {
  const std::int32_t first = *std::min_element(component.faces.begin(), component.faces.end());
  const std::int32_t origin = work.origin[first];
  refuse_soup(
      fmt::format("the component of face {} has only one side, like a Moebius strip (seen at face {}): cut it open",
                  origin, work.origin[component.conflict]),
      origin);
}

struct Orientations {
  std::vector<char> to_flip;    // per face
  std::vector<char> one_sided;  // per face whether its component has one side only
};

Orientations find_orientations(const WorkFaces& work, DefectPolicy policy) {
  Orientations result{std::vector<char>(work.faces.size(), 0), std::vector<char>(work.faces.size(), 0)};
  std::vector<signed char> side(work.faces.size(), -1);
  for (std::int32_t start = 0; start < work.face_count(); ++start) {
    if (side[start] >= 0) continue;
    const OrientedComponent component = walk_component(work, start, side);
    if (component.conflict >= 0) {
      if (policy != DefectPolicy::largest) refuse_one_sided(work, component);
      for (const std::int32_t f : component.faces) result.one_sided[f] = 1;
      continue;
    }
    const bool against_first = 2 * std::size_t(component.flipped) > component.faces.size();
    for (const std::int32_t f : component.faces) result.to_flip[f] = (side[f] == 1) != against_first;
  }
  return result;
}

struct Component {
  std::int32_t first_face;
  double twice_area = 0;  // square mesh units
};

double twice_area(const WorkFaces& work, std::int32_t f, const std::vector<Vec3>& positions) {
  const auto& [a, b, c] = work.faces[f];
  const auto at = [&](std::int32_t v) -> const Vec3& { return positions[v]; };
  return (at(b) - at(a)).cross(at(c) - at(a)).stableNorm();
}

/// A triangle counts as one without area if its height is at most this fraction of its longest side. Dimensionless. Ten
/// times the rounding error of a position on the side.
constexpr double kHeightWithoutArea = 1e-15;

/// Whether a face counts as one without area: the same faces as `count_faces_below` counts in the finished mesh.
///
/// Nearly all faces pass a test that needs no root and no scaling: its bound is at least twice the one on twice the
/// area, since 2 (|ab|^2 + |ac|^2) is at least the square of each side, bc too. Where squares underflow, the smallest
/// normal number holds the test back.
bool is_without_area(const WorkFaces& work, std::int32_t f) {
  const auto& [a, b, c] = work.faces[f];
  const Vec3 ab = work.positions[b] - work.positions[a], ac = work.positions[c] - work.positions[a];
  const double bound = 4 * kHeightWithoutArea * (ab.squaredNorm() + ac.squaredNorm());
  const double squared = ab.cross(ac).squaredNorm();
  if (squared > bound * bound + std::numeric_limits<double>::min()) return false;
  const double longest =
      std::max({ab.stableNorm(), ac.stableNorm(), (work.positions[c] - work.positions[b]).stableNorm()});
  return twice_area(work, f, work.positions) <= kHeightWithoutArea * longest * longest;
}

/// The components in the order of their first faces. Fills `component`, the number of each face's component.
std::vector<Component> find_components(const WorkFaces& work, const std::vector<Vec3>& positions,
                                       std::vector<std::int32_t>& component) {
  component.assign(work.faces.size(), -1);
  std::vector<Component> components;
  std::vector<std::int32_t> stack;
  for (std::int32_t start = 0; start < work.face_count(); ++start) {
    if (component[start] >= 0) continue;
    components.push_back({start});
    component[start] = std::int32_t(components.size() - 1);
    stack.push_back(start);
    while (!stack.empty()) {
      const std::int32_t f = stack.back();
      stack.pop_back();
      components.back().twice_area += twice_area(work, f, positions);
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
        const std::int32_t twin = work.twin[h];
        if (twin < 0 || component[twin / 3] >= 0) continue;
        component[twin / 3] = component[start];
        stack.push_back(twin / 3);
      }
    }
  }
  return components;
}

/// Drops all faces but those of the components with a 1 in `kept`.
void keep_faces(WorkFaces& work, const std::vector<std::int32_t>& component, const std::vector<char>& kept) {
  std::vector<std::int32_t> renumbered(work.faces.size(), -1);
  std::int32_t count = 0;
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (kept[component[f]]) renumbered[f] = count++;
  }
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    const std::int32_t to = renumbered[f];
    if (to < 0) continue;
    work.faces[to] = work.faces[f];
    work.origin[to] = work.origin[f];
    for (int i = 0; i < 3; ++i) {
      const std::int32_t twin = work.twin[3 * f + i];
      work.twin[3 * to + i] = twin < 0 ? -1 : 3 * renumbered[twin / 3] + twin % 3;
    }
  }
  work.faces.resize(count);
  work.origin.resize(count);
  work.twin.resize(3 * count);
}

constexpr std::array<std::string_view, 12> kKindNames = {
    "unwelded_vertices", "zero_length_edges",        "degenerate_faces",  "duplicate_faces",
    "crossing_quads",    "inconsistent_orientation", "nonmanifold_edges", "nonmanifold_vertices",
    "unused_vertices",   "dropped_components",       "one_sided_edges",   "zero_area_components"};

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

/// Refuses an appearance that is not that of the soup's corners and polygons. Readers never make one.
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

/// A triangle whose height is at most this fraction of its longest side has no shape that distances could depend on.
/// Its corners are rounded by up to 2^-53 of the side, so that the height is off by one part in 128 or more. A tube was
/// stretched until half of its triangles were at most 1.8e-14 high: the lengths of three sets of bisectors were off by
/// .2 to .6 %; at 1.8e-15 they were off by 7 to 17 %. Dimensionless.
constexpr double kHeightWithoutShape = 0x1p-46;

std::vector<char> find_used_vertices(const WorkFaces& work) {
  std::vector<char> used(work.positions.size(), 0);
  for (const auto& face : work.faces) {
    for (const std::int32_t v : face) used[v] = 1;
  }
  return used;
}

/// Logs the vertices in no polygon of the soup. Vertices that lost their faces by a repair do not count.
void log_unused_vertices(const PolygonSoup& soup, DefectLog& log) {
  const std::vector<char> used = find_used_vertices(soup);
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

/// Number of faces whose height is at most this fraction of their longest side.
std::int64_t count_faces_below(const Mesh& mesh, double height) {
  return std::count_if(mesh.faces().begin(), mesh.faces().end(), [&](FaceId f) {
    const auto& [length, twice_area] = mesh.shape(f);
    const double longest = *std::max_element(length.begin(), length.end());
    return twice_area <= height * longest * longest;
  });
}

/// Refuses a mesh of which most triangles have no shape. Single ones are common, and only hold the surface together.
/// Those of area 0 are not counted: they are degenerate as they stand, and not by rounding.
void require_shapes(const Mesh& mesh) {
  const std::int64_t without = count_faces_below(mesh, kHeightWithoutShape) - count_faces_below(mesh, 0);
  if (2 * without <= mesh.face_count()) return;
  double shortest = kInfinity;
  for (const EdgeId e : mesh.edges()) shortest = std::min(shortest, mesh.length(e));
  throw Error(
      ErrorCode::precondition,
      fmt::format("rounding hides the shape of {} of {}: heights are below {:.1g} of the longest sides, and edges "
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
    report.messages.push_back(fmt::format("{} no area (three points on a line): kept, they hold the surface together",
                                          counted(report.zero_area_faces, "triangle has", "triangles have")));
  }
  examine_open_edges(checked, soup.weld_tolerance);
}

}  // namespace

EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count) {
  EdgeTable nonmanifold_edges;
  work.twin.assign(work.halfedge_count(), -1);
  visit_edges(work.faces, vertex_count, [&](const EdgeHalfedges& edge) {
    if (edge.size() > 2) nonmanifold_edges.push_back(edge.list());
    if (edge.size() == 2) work.link(edge[0], edge[1]);
  });
  return nonmanifold_edges;
}

std::vector<char> orient_faces(WorkFaces& work, EdgeTable& nonmanifold_edges, DefectLog& log) {
  Orientations orientations = find_orientations(work, log.policy());
  const std::vector<char>& to_flip = orientations.to_flip;
  std::int64_t count = 0;
  std::int32_t first = -1;
  std::int32_t last = -1;
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (!to_flip[f]) continue;
    flip(work, f);
    if (first < 0) first = work.origin[f];
    count += work.origin[f] != last;  // several triangles of one polygon count once
    last = work.origin[f];
  }
  for (std::vector<std::int32_t>& halfedges : nonmanifold_edges) {
    for (std::int32_t& h : halfedges) {
      if (to_flip[h / 3]) h = 3 * (h / 3) + 2 - h % 3;
    }
  }
  log.add(DefectKind::inconsistent_orientation, count, first,
          fmt::format("{}, first face {}",
                      counted(count, "face is against the orientation of most of its component",
                              "faces are against the orientation of most of their component"),
                      first),
          "flipped");
  return std::move(orientations.one_sided);
}

void drop_zero_area_components(WorkFaces& work, DefectLog& log) {
  std::vector<char> without_area(work.faces.size());
  for (std::int32_t f = 0; f < work.face_count(); ++f) without_area[f] = is_without_area(work, f);
  if (std::count(without_area.begin(), without_area.end(), 1) == 0) return;
  std::vector<std::int32_t> component;
  const std::vector<Component> components = find_components(work, work.positions, component);
  std::vector<char> has_area(components.size(), 0);
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (!without_area[f]) has_area[component[f]] = 1;
  }
  const std::int64_t count = std::count(has_area.begin(), has_area.end(), 0);
  if (count == 0 || count == std::ssize(components)) return;
  const auto dropped = std::find(has_area.begin(), has_area.end(), 0) - has_area.begin();
  const std::int32_t first = work.origin[components[dropped].first_face];
  keep_faces(work, component, has_area);
  log.add(DefectKind::zero_area_components, count, first,
          fmt::format("{} of faces without area only, first the one of face {}",
                      counted(count, "component consists", "components consist"), first),
          "removed");
}

void keep_largest_component(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& one_sided,
                            DefectLog& log) {
  if (log.policy() != DefectPolicy::largest) return;
  std::vector<std::int32_t> component;
  const std::vector<Component> components = find_components(work, positions, component);
  const auto largest = std::ranges::max_element(components, {}, &Component::twice_area);
  const std::int32_t face = work.origin[largest->first_face];
  if (one_sided[largest->first_face]) {
    refuse_soup(
        fmt::format("the largest component, that of face {}, has only one side, like a Moebius strip: cut it open",
                    face),
        face);
  }
  const auto kept = largest - components.begin();
  const std::int32_t dropped = components[kept == 0 && components.size() > 1 ? 1 : 0].first_face;
  const std::int32_t first = work.origin[dropped];
  std::vector<char> is_kept(components.size(), 0);
  is_kept[std::size_t(kept)] = 1;
  keep_faces(work, component, is_kept);
  const std::int64_t count = std::ssize(components) - 1;
  log.add(DefectKind::dropped_components, count, first,
          fmt::format("{} smaller than the largest, first the one of face {}",
                      counted(count, "component is", "components are"), first),
          "removed");
}

std::string_view name_of(DefectKind kind) { return kKindNames[static_cast<int>(kind)]; }

std::int64_t DefectReport::count(DefectKind kind) const {
  const auto found = std::ranges::find(defects, kind, &Defect::kind);
  return found == defects.end() ? 0 : found->count;
}

void DefectLog::add_asked(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& message) {
  if (count == 0) return;
  report_.defects.push_back({kind, count, first, message});
  report_.messages.push_back(message);
}

void DefectLog::add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what,
                    const std::string& action) {
  if (count == 0) return;
  if (policy_ == DefectPolicy::error)
    refuse_soup(what + ": repair the mesh\1+, or allow its repair with |on_defect=repair\2", first);
  add_asked(kind, count, first, what + ": " + action);
}

namespace {

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
