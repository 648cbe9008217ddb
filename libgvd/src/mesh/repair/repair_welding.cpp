#include "mesh/repair/repair_welding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/union_find.hpp"
#include "gvd/counted.hpp"

namespace gvd {
namespace {

// Compared as numbers: -0 equals 0.
bool same_position(const Vec3& a, const Vec3& b) { return a == b; }

std::vector<std::int32_t> identity(std::size_t size) {
  std::vector<std::int32_t> table(size);
  std::iota(table.begin(), table.end(), 0);
  return table;
}

// Per vertex the first one at its position.
std::vector<std::int32_t> weld_all(const PolygonSoup& soup) {
  struct Entry {
    double x, y, z;
    std::int32_t vertex;
  };
  std::vector<Entry> entries;
  entries.reserve(soup.positions.size());
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const Vec3& p = soup.positions[v];
    entries.push_back({p.x(), p.y(), p.z(), static_cast<std::int32_t>(v)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.x, a.y, a.z, a.vertex) < std::tie(b.x, b.y, b.z, b.vertex);
  });
  std::vector<std::int32_t> weld = identity(soup.positions.size());
  std::size_t leader = 0;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    const Entry& a = entries[leader];
    const Entry& b = entries[i];
    if (a.x == b.x && a.y == b.y && a.z == b.z) {
      weld[b.vertex] = a.vertex;
    } else {
      leader = i;
    }
  }
  return weld;
}

struct ZeroEdges {
  std::int64_t count = 0;  // number of vertices that were welded to another one
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
      if (a == b || !same_position(soup.positions[a], soup.positions[b])) {
        continue;
      }
      if (welded.find(a) == welded.find(b)) continue;
      welded.unite(a, b);
      if (zero.count++ == 0) zero = {1, static_cast<std::int64_t>(p), a, b};
    }
  }
  return zero;
}

}  // namespace

std::vector<std::int32_t> weld_vertices(const PolygonSoup& soup, DefectLog& log) {
  if (soup.unwelded) {
    std::vector<std::int32_t> weld = weld_all(soup);
    std::int64_t count = 0;
    std::int64_t first = -1;
    for (std::size_t v = 0; v < weld.size(); ++v) {
      if (weld[v] == static_cast<std::int32_t>(v)) continue;
      if (count++ == 0) first = static_cast<std::int64_t>(v);
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
  std::vector<std::int32_t> weld;
  weld.reserve(welded.size());
  for (std::size_t v = 0; v < welded.size(); ++v) weld.push_back(welded.find(static_cast<std::int32_t>(v)));
  return weld;
}

}  // namespace gvd
