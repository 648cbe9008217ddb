// Cleans the polygons of a soup: welds vertices at the same position, and removes degenerate and duplicate polygons.
//
// An STL's triangles share no vertices, so all vertices at the same position become one. In other formats two vertices
// at the same position may be intended, and only the two ends of a polygon edge of length 0 are welded. Duplicates are
// found by an order-independent hash of their corners, then compared in a canonical order.
// Two faces back to back that touch no other face are a closed surface without volume, and are kept.
// Source: the hash of a corner is the finalizer of splitmix64 (Steele, Lea and Flood, 2014).
// Invariant: the polygons keep their order, and the remaining corners of each polygon keep theirs.
#include "mesh/repair/clean_polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/union_find.hpp"
#include "gvd/text.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {
namespace {

/// For each used vertex, the first used vertex at its position. Unused vertices are not joined. Positions are compared
/// as numbers, so that -0 equals 0.
std::vector<std::int32_t> weld_all(const PolygonSoup& soup) {
  const std::vector<char> used = find_used_vertices(soup);
  std::vector<std::int32_t> weld(soup.positions.size());
  std::vector<PlacedVertex> sorted;
  sorted.reserve(weld.size());
  for (std::int32_t v = 0; v < std::ssize(weld); ++v) {
    const Vec3& p = soup.positions[v];
    weld[v] = v;
    if (used[v]) sorted.emplace_back(std::array{p.x(), p.y(), p.z()}, v);
  }
  std::sort(sorted.begin(), sorted.end());
  std::size_t leader = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[leader].first) leader = i;
    weld[sorted[i].second] = sorted[leader].second;
  }
  return weld;
}

struct ZeroEdges {
  std::int64_t count = 0;  // number of vertices welded to another vertex
  std::int64_t polygon = -1;
  std::int32_t a = -1, b = -1;
};

ZeroEdges unite_zero_edges(const PolygonSoup& soup, UnionFind& welded) {
  ZeroEdges zero;
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    const auto polygon = soup.polygon(p);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::int32_t a = polygon[i];
      const std::int32_t b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
      if (a == b || soup.positions[a] != soup.positions[b] || welded.find(a) == welded.find(b)) continue;
      welded.unite(a, b);
      if (zero.count++ == 0) zero = {1, std::int64_t(p), a, b};
    }
  }
  return zero;
}

/// Appends `v` to the polygon whose corners start at `begin`. Drops a corner that repeats the corner before it, and the
/// spike b in a, b, a, which encloses no area.
void append_corner(std::vector<std::int32_t>& corners, std::size_t begin, std::int32_t v) {
  const std::size_t size = corners.size() - begin;
  if (size >= 1 && corners.back() == v) return;
  if (size >= 2 && corners[corners.size() - 2] == v) {
    corners.pop_back();
    return;
  }
  corners.push_back(v);
}

/// Drops repeated corners and spikes between the end of the polygon and its beginning.
void close_ends(std::vector<std::int32_t>& corners, std::size_t begin) {
  std::size_t first = begin;
  bool changed = true;
  while (changed && corners.size() - first >= 2) {
    changed = true;
    const bool has_three = corners.size() - first >= 3;
    if (corners.back() == corners[first]) {
      corners.pop_back();
    } else if (has_three && corners[corners.size() - 2] == corners[first]) {
      corners.resize(corners.size() - 2);
    } else if (has_three && corners.back() == corners[first + 1]) {
      ++first;
      corners.pop_back();
    } else {
      changed = false;
    }
  }
  corners.erase(corners.begin() + std::ptrdiff_t(begin), corners.begin() + std::ptrdiff_t(first));
}

struct CleanedPolygons {
  std::int64_t dropped = 0;
  std::int64_t shortened = 0;
  std::int64_t first = -1;  // polygon of the soup
};

/// Appends polygon p of the soup to `work` if at least three corners remain.
void append_polygon(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, std::int32_t p, WorkPolygons& work,
                    CleanedPolygons& counts) {
  const std::size_t begin = work.corners.size();
  for (const std::int32_t v : soup.polygon(p)) append_corner(work.corners, begin, weld[v]);
  close_ends(work.corners, begin);
  const std::size_t left = work.corners.size() - begin;
  const bool is_kept = left >= 3;
  if (!is_kept || left < soup.polygon(p).size()) {
    if (counts.first < 0) counts.first = p;
    ++(is_kept ? counts.shortened : counts.dropped);
  }
  if (is_kept) {
    work.close(p);
  } else {
    work.corners.resize(begin);
  }
}

std::string action_of(const CleanedPolygons& counts) {
  if (counts.shortened == 0) return "removed";
  if (counts.dropped == 0) return "repeated corners removed";
  return fmt::format("{} removed, repeated corners removed from {}", counts.dropped, counts.shortened);
}

/// Hashes a vertex to 64 bits (the finalizer of splitmix64).
std::uint64_t hash(std::int32_t v) {
  std::uint64_t x = std::uint64_t(v) + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// The number of corners plus a sum of hashes, which does not depend on the order of the corners.
std::uint64_t key_of(std::span<const std::int32_t> polygon) {
  std::uint64_t key = polygon.size();
  for (const std::int32_t v : polygon) key += hash(v);
  return key;
}

/// The corners in canonical order, which begins with the smallest corner and continues with its smaller neighbour. It
/// is the same for a polygon and its reverse.
std::vector<std::int32_t> canonical_corners(std::span<const std::int32_t> polygon) {
  std::vector<std::int32_t> corners(polygon.begin(), polygon.end());
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if (corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

/// Whether two faces lie back to back and touch no other face. They are then a flat closed surface, and are kept.
bool is_pillow(const WorkPolygons& polygons, std::int32_t a, std::int32_t b, const std::vector<std::int32_t>& degree) {
  const auto first = polygons.polygon(a), second = polygons.polygon(b);
  const auto alone = [&](std::int32_t v) { return degree[v] == 2; };
  if (!std::all_of(first.begin(), first.end(), alone)) return false;
  const auto at = std::find(second.begin(), second.end(), first[0]) - second.begin();
  const auto next = second[std::size_t(at + 1) % second.size()];
  return next != first[1];  // with the same direction they would be copies
}

using Keyed = std::pair<std::uint64_t, std::int32_t>;  // a key and its polygon

/// Marks the duplicates among polygons with the same key, which are given in ascending order.
void mark_group(const WorkPolygons& polygons, std::span<const Keyed> group, const std::vector<std::int32_t>& degree,
                std::vector<char>& drop) {
  std::vector<std::pair<std::vector<std::int32_t>, std::int32_t>> sorted;  // polygons by their canonical corners
  for (const auto& [key, p] : group) sorted.emplace_back(canonical_corners(polygons.polygon(p)), p);
  std::sort(sorted.begin(), sorted.end());
  std::size_t first = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[first].first) {
      first = i;
    } else if (!is_pillow(polygons, sorted[first].second, sorted[i].second, degree)) {
      drop[sorted[i].second] = 1;
    }
  }
}

/// Returns 1 for each polygon that is a duplicate, and 0 for all others.
std::vector<char> find_duplicates(const WorkPolygons& polygons, std::size_t vertex_count) {
  std::vector<std::int32_t> degree(vertex_count, 0);
  for (const std::int32_t v : polygons.corners) ++degree[v];
  std::vector<Keyed> keyed;
  keyed.reserve(polygons.count());
  for (std::size_t p = 0; p < polygons.count(); ++p) keyed.emplace_back(key_of(polygons.polygon(p)), p);
  std::sort(keyed.begin(), keyed.end());
  std::vector<char> drop(polygons.count(), 0);
  for (std::size_t begin = 0; begin < keyed.size();) {
    std::size_t end = begin + 1;
    while (end < keyed.size() && keyed[end].first == keyed[begin].first) ++end;
    if (end - begin > 1) mark_group(polygons, {keyed.data() + begin, end - begin}, degree, drop);
    begin = end;
  }
  return drop;
}

}  // namespace

std::vector<char> find_used_vertices(const PolygonSoup& soup) {
  std::vector<char> used(soup.positions.size(), 0);
  for (const std::int32_t v : soup.corners) {
    if (v >= 0 && v < std::ssize(used)) used[v] = 1;
  }
  return used;
}

std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log) {
  if (soup.unwelded) {
    std::vector<std::int32_t> weld = weld_all(soup);
    std::int64_t count = 0, first = -1;
    for (std::int64_t v = 0; v < std::ssize(weld); ++v) {
      if (weld[v] != v && count++ == 0) first = v;
    }
    if (soup.weld_tolerance) {
      log.add_asked(DefectKind::unwelded_vertices, count, first,
                    fmt::format("{} welded to others {}, first vertex {}", counted(count, "vertex is", "vertices are"),
                                *soup.weld_tolerance == 0 ? "at the same coordinates"
                                                          : fmt::format("within {:g}", *soup.weld_tolerance),
                                first));
      return weld;
    }
    log.add(DefectKind::unwelded_vertices, count, first,
            fmt::format("{} not welded, first vertex {}", counted(count, "vertex is", "vertices are"), first),
            "welded to the others at the same coordinates");
    return weld;
  }
  UnionFind welded(soup.positions.size());
  const ZeroEdges zero = unite_zero_edges(soup, welded);
  log.add(DefectKind::zero_length_edges, zero.count, zero.polygon,
          fmt::format("{} of length 0, first the one between vertices {} and {} in face {}",
                      counted(zero.count, "edge", "edges"), zero.a, zero.b, zero.polygon),
          "their ends welded");
  std::vector<std::int32_t> weld(welded.size());
  for (std::int32_t v = 0; v < std::ssize(weld); ++v) weld[v] = welded.find(v);
  return weld;
}

WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log) {
  WorkPolygons work;
  work.corners.reserve(soup.corners.size());
  work.first_corner.reserve(soup.first_corner.size());
  work.origin.reserve(soup.polygon_count());
  CleanedPolygons counts;
  for (std::int32_t p = 0; p < std::ssize(soup.first_corner) - 1; ++p) append_polygon(soup, weld, p, work, counts);
  const std::int64_t count = counts.dropped + counts.shortened;
  log.add(DefectKind::degenerate_faces, count, counts.first,
          fmt::format("{} degenerate (a corner repeats, or fewer than three), first face {}",
                      counted(count, "face is", "faces are"), counts.first),
          action_of(counts));
  if (work.count() == 0) refuse_soup("every face is degenerate, first face 0: there is no surface", 0);
  return work;
}

void remove_duplicate_faces(WorkPolygons& polygons, std::size_t vertex_count, DefectLog& log) {
  const std::vector<char> drop = find_duplicates(polygons, vertex_count);
  const auto first_dropped = std::find(drop.begin(), drop.end(), 1);
  if (first_dropped == drop.end()) return;
  const std::int64_t first = polygons.origin[first_dropped - drop.begin()];
  const std::int64_t count = std::count(drop.begin(), drop.end(), 1);
  log.add(DefectKind::duplicate_faces, count, first,
          fmt::format("{} the corners of another one, first face {}", counted(count, "face has", "faces have"), first),
          "removed");
  WorkPolygons kept;
  kept.corners.reserve(polygons.corners.size());
  for (std::size_t p = 0; p < polygons.count(); ++p) {
    if (drop[p]) continue;
    const auto corners = polygons.polygon(p);
    kept.corners.insert(kept.corners.end(), corners.begin(), corners.end());
    kept.close(polygons.origin[p]);
  }
  polygons = std::move(kept);
}

}  // namespace gvd
