// The surface of gvd-distance. On the separated mesh, distances respect regions by themselves. A border belongs to the
// regions on both of its sides: a point there is seen once from each connected part, and the least distance counts.

#include "distance/measured_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "gvd/text.hpp"

namespace gvd::app {

MeasuredSurface::MeasuredSurface(Run& run, const CheckedMesh& input, const RegionFiles& files) : input_(input) {
  if (!files.are_given()) return;
  regions_ = run.timed("regions", [&] { return read_regions(run, input, files).regions; });
  separated_ = run.timed("separate", [&] { return separate_regions(input.mesh, regions_); });
  const auto is_left_out = [](std::int32_t region) { return region < 0; };
  const auto left_out = std::ranges::count_if(regions_, is_left_out);
  std::set<std::int32_t> numbers(regions_.begin(), regions_.end());
  const auto regions = std::ranges::count_if(numbers, [&](std::int32_t region) { return !is_left_out(region); });
  run.report().results()["within"] = {{"regions", regions}, {"left_out_faces", left_out}};
  run.console().note(
      fmt::format("inside {}{}", counted(regions, "region", "regions"),
                  left_out == 0 ? "" : fmt::format("; {} left out", counted(left_out, "face is", "faces are"))));
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

}  // namespace gvd::app
