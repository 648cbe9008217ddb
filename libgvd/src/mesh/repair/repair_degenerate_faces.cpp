#include "mesh/repair/repair_degenerate_faces.hpp"

#include <fmt/format.h>

#include "gvd/counted.hpp"

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

struct Counts {
  std::int64_t dropped = 0;
  std::int64_t shortened = 0;
  std::int64_t first = -1;  // polygon of the soup
};

// Appends polygon p of the soup to `work` unless fewer than three corners are left.
void append_polygon(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, std::size_t p, WorkPolygons& work,
                    Counts& counts) {
  const std::size_t begin = work.corners.size();
  for (const std::int32_t v : soup.polygon(p)) append_corner(work.corners, begin, weld[v]);
  close_ends(work.corners, begin);
  const std::size_t left = work.corners.size() - begin;
  const bool is_kept = left >= 3;
  if (!is_kept || left < soup.polygon(p).size()) {
    if (counts.first < 0) counts.first = static_cast<std::int64_t>(p);
    ++(is_kept ? counts.shortened : counts.dropped);
  }
  if (is_kept) {
    work.close(static_cast<std::int32_t>(p));
  } else {
    work.corners.resize(begin);
  }
}

std::string action_of(const Counts& counts) {
  if (counts.shortened == 0) return "removed";
  if (counts.dropped == 0) return "repeated corners taken out";
  return fmt::format("{} removed, repeated corners taken out of {}", counts.dropped, counts.shortened);
}

}  // namespace

WorkPolygons remove_degenerate_faces(const PolygonSoup& soup, const std::vector<std::int32_t>& weld, DefectLog& log) {
  WorkPolygons work;
  work.corners.reserve(soup.corners.size());
  work.first_corner.reserve(soup.first_corner.size());
  work.origin.reserve(soup.polygon_count());
  Counts counts;
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) append_polygon(soup, weld, p, work, counts);
  const std::int64_t count = counts.dropped + counts.shortened;
  log.add(DefectKind::degenerate_faces, count, counts.first,
          fmt::format("{} degenerate (a corner repeats, or fewer than three), first face {}",
                      counted(count, "face is", "faces are"), counts.first),
          action_of(counts));
  if (work.count() == 0) refuse_soup("every face is degenerate, first face 0: there is no surface", 0);
  return work;
}

}  // namespace gvd
