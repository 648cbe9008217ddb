// Finds vertices on open edges that were probably meant to be joined: copies at the same place, or nearly so.
//
// Copies are found by sorting the vertices by their positions. The nearest two are found by a sweep along a direction
// in which hardly any two vertices are level. If vertices lie on curves, as on a boundary, or far apart on a surface,
// only few are within the least distance so far along this direction. The sweep ends without a result if there are too
// many.
#include "mesh/repair/examine_open_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/repair/clean_polygons.hpp"

namespace gvd {
namespace {

using Ends = std::pair<std::int32_t, std::int32_t>;

/// The input's vertices on the boundary, sorted by position. Copies that the repair made count once.
std::vector<PlacedVertex> place_boundary_vertices(const CheckedMesh& checked) {
  std::vector<PlacedVertex> placed;
  for (const VertexId v : checked.mesh.vertices()) {
    if (!checked.mesh.is_boundary(v) || checked.input_vertex[v] < 0) continue;
    const Vec3& p = checked.mesh.position(v);
    placed.push_back({{p.x(), p.y(), p.z()}, checked.input_vertex[v]});
  }
  std::sort(placed.begin(), placed.end());
  placed.erase(std::unique(placed.begin(), placed.end()), placed.end());
  return placed;
}

/// Number of `placed` vertices at the same position as their predecessor. They come from different vertices of the
/// input.
std::int64_t count_coincident_vertices(const std::vector<PlacedVertex>& placed) {
  std::int64_t count = 0;
  for (std::size_t i = 1; i < placed.size(); ++i) count += placed[i - 1].first == placed[i].first;
  return count;
}

/// Number of boundary edges that would get a partner if all vertices at the same position were welded. An edge is
/// identified by the first vertex at each of its ends. Edges between the same vertices of the input do not count,
/// because the repair cut them apart.
std::int64_t count_closable_edges(const CheckedMesh& checked, const std::vector<PlacedVertex>& placed) {
  const Mesh& mesh = checked.mesh;
  const auto first_at = [&](VertexId v) {
    const Vec3& p = mesh.position(v);
    const PlacedVertex least{{p.x(), p.y(), p.z()}, -1};
    return std::lower_bound(placed.begin(), placed.end(), least)->second;
  };
  std::vector<std::pair<Ends, Ends>> open;  // the ends after welding, and before
  for (const EdgeId e : mesh.edges()) {
    if (!mesh.is_boundary(e)) continue;
    const VertexId a = mesh.from(mesh.halfedge(e)), b = mesh.to(mesh.halfedge(e));
    if (checked.input_vertex[a] < 0 || checked.input_vertex[b] < 0) continue;
    open.emplace_back(std::minmax({first_at(a), first_at(b)}),
                      std::minmax({checked.input_vertex[a], checked.input_vertex[b]}));
  }
  std::sort(open.begin(), open.end());
  open.erase(std::unique(open.begin(), open.end()), open.end());
  std::int64_t count = 0;
  for (std::size_t begin = 0, end = 0; begin < open.size(); begin = end) {
    while (end < open.size() && open[end].first == open[begin].first) ++end;
    count += std::int64_t((end - begin) / 2 * 2);
  }
  return count;
}

/// The limit on comparisons in the sweep, for each vertex on average. Boundaries of models take about two.
constexpr std::size_t kMostComparisons = 64;

/// The distance of two vertices, mesh units.
struct VertexGap {
  double length = kInfinity;
  double squared = kInfinity;  // rounded as in `weld_soup`, which compares squares
};

/// Finds the least distance of two `placed` vertices that no edge joins. Returns nothing if there is no such pair, or
/// if the search would take too long. Cost: O(n log n).
std::optional<VertexGap> find_least_gap(const CheckedMesh& checked, const std::vector<PlacedVertex>& placed) {
  const Mesh& mesh = checked.mesh;
  std::vector<Ends> joined;
  for (const EdgeId e : mesh.edges()) {
    const VertexId a = mesh.from(mesh.halfedge(e)), b = mesh.to(mesh.halfedge(e));
    if (!mesh.is_boundary(a) || !mesh.is_boundary(b)) continue;
    joined.emplace_back(std::minmax({checked.input_vertex[a], checked.input_vertex[b]}));
  }
  std::sort(joined.begin(), joined.end());
  // A direction in which axes, diagonals and their planes are not level.
  const Vec3 direction = Vec3(1, 1.618, 2.618).normalized();
  const auto at = [&](std::size_t i) { return Vec3(placed[i].first[0], placed[i].first[1], placed[i].first[2]); };
  std::vector<std::pair<double, std::size_t>> along;
  for (std::size_t i = 0; i < placed.size(); ++i) along.emplace_back(direction.dot(at(i)), i);
  std::sort(along.begin(), along.end());
  VertexGap least;
  std::size_t comparisons = 0;
  for (std::size_t i = 0; i < along.size(); ++i) {
    for (std::size_t j = i + 1; j < along.size() && along[j].first - along[i].first < least.length; ++j) {
      if (++comparisons > kMostComparisons * placed.size()) return std::nullopt;
      const std::size_t a = along[i].second, b = along[j].second;
      const Vec3 between = at(a) - at(b);
      const VertexGap gap{between.stableNorm(), between.squaredNorm()};
      const Ends ends = std::minmax({placed[a].second, placed[b].second});
      if (gap.length < least.length && !std::binary_search(joined.begin(), joined.end(), ends)) least = gap;
    }
  }
  return least.length < kInfinity ? std::optional(least) : std::nullopt;
}

/// Formats a tolerance that joins the two vertices, which users can copy from the message: the length, rounded up to
/// six digits.
std::string format_joining(const VertexGap& gap) {
  const std::string digits = fmt::format("{:.5e}", gap.length);
  const std::int64_t exponent = parse_integer(digits.substr(digits.find('e') + 1)).value_or(0);
  const double half_step = 0.5 * parse_double(fmt::format("1e{}", exponent - 5)).value_or(0);
  for (double raised = gap.length;; raised += half_step) {
    std::string text = fmt::format("{:.6g}", raised);
    const double tolerance = parse_double(text).value_or(kInfinity);
    if (tolerance * tolerance >= gap.squared) return text;
  }
}

/// Says that welding within this tolerance joins nothing, and from which tolerance on it would join vertices.
std::string describe_vain_weld(const CheckedMesh& checked, const std::vector<PlacedVertex>& placed, double tolerance) {
  const std::string what =
      tolerance == 0 ? "welding joins nothing: no two vertices are at the same coordinates"
                     : fmt::format("welding within {:g} joins nothing: no two vertices are that close", tolerance);
  if (placed.empty()) return what + ", and no edge is open";
  const std::optional<VertexGap> gap = find_least_gap(checked, placed);
  if (!gap) return what;
  return fmt::format("{}; on open edges, the nearest two that no edge joins are {} apart", what, format_joining(*gap));
}

}  // namespace

void examine_open_edges(CheckedMesh& checked, std::optional<double> weld_tolerance) {
  DefectReport& report = checked.defects;
  const std::vector<PlacedVertex> placed = place_boundary_vertices(checked);
  report.coincident_vertices = count_coincident_vertices(placed);
  if (weld_tolerance && report.count(DefectKind::unwelded_vertices) == 0) {
    report.messages.push_back(describe_vain_weld(checked, placed, *weld_tolerance));
  }
  if (report.coincident_vertices == 0) return;
  report.closable_edges = count_closable_edges(checked, placed);
  report.messages.push_back(fmt::format(
      "{} at the position of another one: not joined, the surface is open there{}",
      counted(report.coincident_vertices, "boundary vertex is", "boundary vertices are"),
      report.closable_edges == 0
          ? ""
          : fmt::format("; \1weld\2 would close {}", counted(report.closable_edges, "open edge", "open edges"))));
}

}  // namespace gvd
