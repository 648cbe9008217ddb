#include "diagram/growth/weld_crossings.hpp"

#include <algorithm>

namespace gvd {

void weld_crossings(const std::vector<CrossingEstimate>& estimates, Crossings& crossings) {
  struct Mean {
    double sum = 0;
    int count = 0;
  };
  IdVector<CrossingId, Mean> means(crossings.size());
  for (const CrossingEstimate& e : estimates) {
    means[e.crossing].sum += e.t;
    ++means[e.crossing].count;
  }
  std::vector<Crossing>& items = crossings.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Mean& mean = means[CrossingId(static_cast<std::int64_t>(i))];
    if (mean.count == 0) continue;
    const bool follows = i > 0 && items[i - 1].edge == items[i].edge;
    const bool leads = i + 1 < items.size() && items[i + 1].edge == items[i].edge;
    const double low = (follows ? items[i - 1].t : 0) + kCrossingGap;
    const double high = (leads ? items[i + 1].t : 1) - kCrossingGap;
    if (low < high) items[i].t = std::clamp(mean.sum / mean.count, low, high);
  }
}

}  // namespace gvd
