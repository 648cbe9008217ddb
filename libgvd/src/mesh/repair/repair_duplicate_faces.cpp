#include "mesh/repair/repair_duplicate_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "gvd/counted.hpp"

namespace gvd {
namespace {

// Hashes a vertex to 64 bits (the finalizer of splitmix64). A sum of hashes does not depend on the order of the
// corners.
std::uint64_t hash(std::int32_t v) {
  std::uint64_t x = static_cast<std::uint64_t>(v) + 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

// The corners from the smallest one in the direction of its smaller neighbour: equal for a polygon and its reverse.
std::vector<std::int32_t> canonical_corners(std::span<const std::int32_t> polygon) {
  std::vector<std::int32_t> corners(polygon.begin(), polygon.end());
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if (corners.back() < corners[1]) std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

struct Keyed {
  std::uint64_t key;
  std::int32_t polygon;
  bool operator<(const Keyed& other) const { return std::tie(key, polygon) < std::tie(other.key, other.polygon); }
};

std::uint64_t key_of(std::span<const std::int32_t> polygon) {
  std::uint64_t key = polygon.size();
  for (const std::int32_t v : polygon) key += hash(v);
  return key;
}

// Groups the polygons by their smallest corner. Calls visit(polygons, ascending) for each group of two or more.
template <class Visit>
void visit_buckets(const WorkPolygons& polygons, std::size_t vertex_count, const Visit& visit) {
  const auto smallest_corner = [&](std::size_t p) {
    const auto polygon = polygons.polygon(p);
    return static_cast<std::size_t>(*std::min_element(polygon.begin(), polygon.end()));
  };
  std::vector<std::size_t> first(vertex_count + 1, 0);
  for (std::size_t p = 0; p < polygons.count(); ++p) ++first[smallest_corner(p) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::int32_t> sorted(polygons.count());
  for (std::size_t p = 0; p < polygons.count(); ++p) {
    sorted[first[smallest_corner(p)]++] = static_cast<std::int32_t>(p);
  }
  // Now first[v] is where the bucket of v ends.
  for (std::size_t v = 0, begin = 0; v < vertex_count; begin = first[v++]) {
    if (first[v] - begin > 1) visit(std::span(sorted.data() + begin, first[v] - begin));
  }
}

// Two faces back to back that no other face touches are a flat closed surface. They are kept.
bool is_pillow(const WorkPolygons& polygons, std::int32_t a, std::int32_t b, const std::vector<std::int32_t>& degree) {
  const auto first = polygons.polygon(static_cast<std::size_t>(a));
  const auto second = polygons.polygon(static_cast<std::size_t>(b));
  const auto alone = [&](std::int32_t v) { return degree[v] == 2; };
  if (!std::all_of(first.begin(), first.end(), alone)) return false;
  const auto at = std::find(second.begin(), second.end(), first[0]) - second.begin();
  const auto next = second[static_cast<std::size_t>(at + 1) % second.size()];
  return next != first[1];  // the same direction would make them copies
}

// Marks the duplicates among polygons with the same key, which are given in ascending order.
void mark_group(const WorkPolygons& polygons, std::span<const Keyed> group, const std::vector<std::int32_t>& degree,
                std::vector<char>& drop) {
  struct Canonical {
    std::vector<std::int32_t> corners;
    std::int32_t polygon;
  };
  std::vector<Canonical> sorted;
  for (const Keyed& entry : group) {
    sorted.push_back({canonical_corners(polygons.polygon(static_cast<std::size_t>(entry.polygon))), entry.polygon});
  }
  std::sort(sorted.begin(), sorted.end(), [](const Canonical& a, const Canonical& b) {
    return std::tie(a.corners, a.polygon) < std::tie(b.corners, b.polygon);
  });
  std::size_t first = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].corners != sorted[first].corners) {
      first = i;
    } else if (!is_pillow(polygons, sorted[first].polygon, sorted[i].polygon, degree)) {
      drop[sorted[i].polygon] = 1;
    }
  }
}

// Per polygon 1 where it is a duplicate.
std::vector<char> find_duplicates(const WorkPolygons& polygons, std::size_t vertex_count) {
  std::vector<std::int32_t> degree(vertex_count, 0);
  for (const std::int32_t v : polygons.corners) ++degree[v];
  std::vector<char> drop(polygons.count(), 0);
  std::vector<Keyed> keyed;
  visit_buckets(polygons, vertex_count, [&](std::span<const std::int32_t> bucket) {
    keyed.clear();
    for (const std::int32_t p : bucket) keyed.push_back({key_of(polygons.polygon(static_cast<std::size_t>(p))), p});
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t begin = 0; begin < keyed.size();) {
      std::size_t end = begin + 1;
      while (end < keyed.size() && keyed[end].key == keyed[begin].key) ++end;
      if (end - begin > 1) mark_group(polygons, {keyed.data() + begin, end - begin}, degree, drop);
      begin = end;
    }
  });
  return drop;
}

}  // namespace

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
