#include "mesh/repair/repair_degenerate_faces.hpp"

#include <fmt/format.h>

#include "base/counted.hpp"

namespace gvd {
namespace {

// Appends `v` to the polygon whose corners start at `begin`. A corner that repeats the one before it is dropped, and so
// is the spike b in a, b, a, which encloses no area.
void append_corner(std::vector<std::int32_t>& corners, std::size_t begin, std::int32_t v) {
  const std::size_t size = corners.size() - begin;
  if (size >= 1 && corners.back() == v) return;
  if (size >= 2 && corners[corners.size() - 2] == v) {
    corners.pop_back();
    return;
  }
  corners.push_back(v);
}

// Drops repeated corners and spikes where the end of the polygon meets its beginning.
void close_ends(std::vector<std::int32_t>& corners, std::size_t begin) {
  std::size_t first = begin;
  bool changed = true;
  while (changed && corners.size() - first >= 2) {
    changed = false;
    if (corners.back() == corners[first]) {
      corners.pop_back();
      changed = true;
    } else if (corners.size() - first >= 3 && corners[corners.size() - 2] == corners[first]) {
      corners.resize(corners.size() - 2);
      changed = true;
    } else if (corners.size() - first >= 3 && corners.back() == corners[first + 1]) {
      ++first;
      corners.pop_back();
      changed = true;
    }
  }
  corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(begin),
                corners.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace

WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log) {
  WorkPolygons work;
  work.corners.reserve(soup.corners.size());
  work.first_corner.reserve(soup.first_corner.size());
  work.origin.reserve(soup.polygon_count());
  std::int64_t dropped = 0;
  std::int64_t shortened = 0;
  std::int64_t first = -1;
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    const std::size_t begin = work.corners.size();
    for (const std::int32_t v : soup.polygon(p)) append_corner(work.corners, begin, weld[static_cast<std::size_t>(v)]);
    close_ends(work.corners, begin);
    const std::size_t left = work.corners.size() - begin;
    if (left == soup.polygon(p).size() && left >= 3) {
      work.close(static_cast<std::int32_t>(p));
      continue;
    }
    if (first < 0) first = static_cast<std::int64_t>(p);
    if (left >= 3) {
      ++shortened;
      work.close(static_cast<std::int32_t>(p));
    } else {
      ++dropped;
      work.corners.resize(begin);
    }
  }
  const std::string action = shortened == 0 ? "removed"
                             : dropped == 0
                                 ? "repeated corners taken out"
                                 : fmt::format("{} removed, repeated corners taken out of {}", dropped, shortened);
  log.add(DefectKind::degenerate_faces, dropped + shortened, first,
          fmt::format("{} degenerate (a corner repeats, or fewer than three), first face {}",
                      counted(dropped + shortened, "face is", "faces are"), first),
          action);
  if (work.count() == 0) refuse_soup("every face is degenerate, first face 0: there is no surface", 0);
  return work;
}

}  // namespace gvd
