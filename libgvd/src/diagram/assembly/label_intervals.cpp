#include "diagram/assembly/label_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace gvd {
namespace {

/// A path that enters this near to a crossing, as a fraction of the edge, may belong to the cell on either side of it.
constexpr double kNearCrossing = 1e-9;

}  // namespace

void LabelIntervals::unite_by_paths() {
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    const auto entry = distances_.entry(boundary_[i].next, middle_of_interval(i));
    if (!entry) return;
    const int entered = interval_at(*entry);
    if (boundary_[entered].next == boundary_[i].next) unite(entered, static_cast<int>(i));
  }
}

/// The interval that contains a position on the boundary, counted as corner + t.
int LabelIntervals::interval_at(double position) const {
  const auto after = std::upper_bound(boundary_.begin(), boundary_.end(), position,
                                      [](double p, const BoundaryCrossing& c) { return p < c.corner + c.t; });
  const auto i = static_cast<std::size_t>(after - boundary_.begin());
  return static_cast<int>((i + boundary_.size() - 1) % boundary_.size());
}

/// The point halfway along interval i on the boundary.
Bary LabelIntervals::middle_of_interval(std::size_t i) const {
  const double begin = position(i), end = position((i + 1) % boundary_.size());
  const double half = 0.5 * (begin + end + (end > begin ? 0 : 3));
  const double middle = half < 3 ? half : half - 3;
  const auto corner = std::min<std::size_t>(static_cast<std::size_t>(middle), 2);
  Bary bary{0, 0, 0};
  bary[corner] = 1 - (middle - static_cast<double>(corner));
  bary[(corner + 1) % 3] = middle - static_cast<double>(corner);
  return bary;
}

bool LabelIntervals::path_enters_through(int interval, const Bary& p) {
  const auto entry = distances_.entry(boundary_[interval].next, p);
  if (!entry) return false;
  const auto belongs = [&](std::size_t other) { return are_one_piece(static_cast<int>(other), interval); };
  const auto n = boundary_.size(), entered = static_cast<std::size_t>(interval_at(*entry));
  if (belongs(entered)) return true;
  // Over crossings that are as near as rounding, in both directions.
  for (std::size_t i = entered; is_near_crossing(*entry, i); i = (i + n - 1) % n) {
    if (belongs((i + n - 1) % n)) return true;
    if (i == (entered + 1) % n) break;
  }
  for (std::size_t i = (entered + 1) % n; is_near_crossing(*entry, i); i = (i + 1) % n) {
    if (belongs(i)) return true;
    if (i == entered) break;
  }
  return false;
}

bool LabelIntervals::is_near_crossing(double position, std::size_t i) const {
  const double distance = std::abs(position - this->position(i));
  return std::min(distance, 3 - distance) <= std::max(kNearCrossing, distances_.crossing_error(boundary_[i]));
}

}  // namespace gvd
