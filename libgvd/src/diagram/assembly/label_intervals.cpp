#include "diagram/assembly/label_intervals.hpp"

#include <algorithm>
#include <cmath>

namespace gvd {
namespace {

/// A path this near to a crossing, as a part of the edge, may belong to either of its cells.
constexpr double kNearCrossing = 1e-9;

}  // namespace

void LabelIntervals::unite_by_paths() {
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    const auto entry = distances_.entry(boundary_[i].next, middle_of_run(i));
    if (!entry) return;
    const int run = run_at(*entry);
    if (boundary_[static_cast<std::size_t>(run)].next == boundary_[i].next) unite(run, static_cast<int>(i));
  }
}

/// The run that contains a place on the boundary, counted as corner + t.
int LabelIntervals::run_at(double where) const {
  const auto after = std::upper_bound(boundary_.begin(), boundary_.end(), where,
                                      [](double w, const BoundaryCrossing& c) { return w < c.corner + c.t; });
  const auto i = static_cast<std::size_t>(after - boundary_.begin());
  return static_cast<int>((i + boundary_.size() - 1) % boundary_.size());
}

/// A point half way along run i on the boundary.
std::array<double, 3> LabelIntervals::middle_of_run(std::size_t i) const {
  const double begin = place(i), end = place((i + 1) % boundary_.size());
  const double half = 0.5 * (begin + end + (end > begin ? 0 : 3));
  const double where = half < 3 ? half : half - 3;
  const auto corner = std::min<std::size_t>(static_cast<std::size_t>(where), 2);
  std::array<double, 3> bary{0, 0, 0};
  bary[corner] = 1 - (where - static_cast<double>(corner));
  bary[(corner + 1) % 3] = where - static_cast<double>(corner);
  return bary;
}

bool LabelIntervals::path_enters_through(int run, const std::array<double, 3>& p) {
  const auto entry = distances_.entry(boundary_[static_cast<std::size_t>(run)].next, p);
  if (!entry) return false;
  const auto belongs = [&](std::size_t other) { return are_one_piece(static_cast<int>(other), run); };
  const auto n = boundary_.size(), entered = static_cast<std::size_t>(run_at(*entry));
  if (belongs(entered)) return true;
  // Where a crossing is as near as rounding, the path may as well come by the run beyond it.
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

bool LabelIntervals::is_near_crossing(double where, std::size_t i) const {
  const double apart = std::abs(where - place(i));
  return std::min(apart, 3 - apart) <= std::max(kNearCrossing, distances_.crossing_error(boundary_[i]));
}

}  // namespace gvd
