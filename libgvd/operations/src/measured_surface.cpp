// The surface that distances are measured on. On the separated mesh, distances respect regions by themselves. A border
// belongs to the regions on both of its sides: a point there is seen once from each connected part, and the least
// distance counts.

#include "gvd/measured_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gvd/text.hpp"

namespace gvd {

MeasuredSurface::MeasuredSurface(const CheckedMesh& input, const GivenRegions& given, Observer& observer)
    : input_(input) {
  if (!given.are_given()) return;
  regions_ = as_step(observer, "regions", [&] { return find_regions(input, given, observer).regions; });
  separated_ = as_step(observer, "separate", [&] { return separate_regions(input.mesh, regions_); });
  const std::int64_t left_out = left_out_faces();
  observer.note(
      fmt::format("inside {}{}", counted(regions(), "region", "regions"),
                  left_out == 0 ? "" : fmt::format("; {} left out", counted(left_out, "face is", "faces are"))));
}

std::int64_t MeasuredSurface::regions() const {
  const std::set<std::int32_t> numbers(regions_.begin(), regions_.end());
  return std::ranges::count_if(numbers, [](std::int32_t region) { return region >= 0; });
}

std::int64_t MeasuredSurface::left_out_faces() const {
  return std::ranges::count_if(regions_, [](std::int32_t region) { return region < 0; });
}

PlacedPoints MeasuredSurface::place(const std::vector<SurfacePoint>& points) const {
  PlacedPoints placed;
  std::vector<SurfacePoint> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto add = [&](const SurfacePoint& view) {
      placed.places.push_back(view);
      placed.point.push_back(std::int32_t(i));
    };
    if (!is_parted()) {
      add(points[i]);
      continue;
    }
    // Views from one part are one point of the separated mesh: the first of them stands for all.
    seen.clear();
    for (const SurfacePoint& view : find_views(input_.mesh, points[i])) {
      if (regions_[view.face] < 0) continue;
      const SurfacePoint place = canonical(separated_.mesh, view);
      if (std::ranges::find(seen, place) != seen.end()) continue;
      seen.push_back(place);
      add(view);
    }
  }
  return placed;
}

}  // namespace gvd
