#include "diagram/envelope/visible_sources.hpp"

#include <algorithm>

#include "base/plane.hpp"

namespace gvd {

// A ray past an end of an opening separates the visible from the hidden points. In the band, the side of the ray
// depends on the position along it. The distance from the chord changes it by at most a bound.
void collect_visible_sources(std::span<const FaceSource> sources, const SearchBand& band,
                             std::vector<VisibleSource>& visible) {
  visible.clear();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const FaceSource& s : sources) {
    double first = -infinity, last = infinity;
    if (!s.is_corner && !band.is_all()) {
      const Vec2 start = band.from - s.image;
      for (const Vec2& ray : {Vec2(s.begin - s.image), Vec2(s.image - s.end)}) {
        // Points at position t may be visible where at_start + rate t + slack >= 0.
        const double at_start = cross(start, ray), rate = cross(band.along, ray);
        const double slack = band.width * std::abs(cross(band.across, ray));
        const double limit = -(at_start + slack) / rate;
        if (rate > 0) first = std::max(first, limit);
        if (rate < 0) last = std::min(last, limit);
      }
    }
    if (first <= std::min(last, band.length + band.width) && last >= -band.width) {
      visible.push_back({&s, first, last});
    }
  }
}

}  // namespace gvd
