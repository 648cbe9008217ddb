// Computes lower envelopes of functions that are linear over a triangle.
//
// The part of a function is initially the whole triangle, and is clipped by every other function that is the least
// somewhere. A needle that crosses hundreds of cells has as many functions, and most of them clip nothing: these are
// passed over several at a time.
#include "lower_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gvd/vec.hpp"

namespace gvd {
namespace {

/// The value of a - b at a point.
double difference(const std::array<double, 3>& a, const std::array<double, 3>& b, const Bary& at) {
  return at[0] * (a[0] - b[0]) + at[1] * (a[1] - b[1]) + at[2] * (a[2] - b[2]);
}

/// The point between a and b at which a linear function is 0. Its values at a and b must have different signs.
Bary zero_between(const Bary& a, double at_a, const Bary& b, double at_b) {
  const double t = at_a / (at_a - at_b);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

/// The number of functions that are compared with a part at a time, in a loop that compilers turn into vector code.
/// Fewer functions than that are not worth it.
constexpr std::size_t kBlock = 8;

/// Two functions count as equal if their values differ by less than this, relative to the values: a thousand times
/// their rounding.
constexpr double kSameFunction = 1e-12;

bool is_nowhere_less(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a[i] < b[i] - kSameFunction * std::abs(b[i])) return false;
  }
  return true;
}

void append_corner(const Bary& corner, std::size_t across, EnvelopePart& part) {
  part.corners.push_back(corner);
  part.across.push_back(across);
}

void set_to_triangle(EnvelopePart& part, std::size_t function) {
  part.function = function;
  part.corners.assign(kWholeTriangle.begin(), kWholeTriangle.end());
  part.across.assign(3, kTriangleSide);
}

}  // namespace

std::span<const EnvelopePart> LowerEnvelope::compute(const std::vector<std::array<double, 3>>& values) {
  list_candidates(values);
  std::size_t count = 0;
  for (std::size_t own = 0; own < candidates_.size(); ++own) {
    if (count == parts_.size()) parts_.emplace_back();
    EnvelopePart& part = parts_[count];
    set_to_triangle(part, candidates_[own]);
    for (std::size_t next = 0; next < candidates_.size() && part.corners.size() > 2; ++next) {
      if (are_many()) next = find_clipping(part, own, next);
      if (next < candidates_.size() && next != own) clip(values, part, candidates_[next]);
    }
    if (part.corners.size() > 2) ++count;
  }
  return {parts_.data(), count};
}

bool LowerEnvelope::are_many() const { return candidates_.size() >= kBlock; }

/// The first candidate, from number `from` on, that is not above the part's function everywhere on the part; their
/// number if there is none. `own` is the number of the part's function.
std::size_t LowerEnvelope::find_clipping(const EnvelopePart& part, std::size_t own, std::size_t from) const {
  const std::size_t count = candidates_.size();
  const auto& [at_a, at_b, at_c] = candidate_values_;
  for (; from < count; from += kBlock) {
    const std::size_t size = std::min(kBlock, count - from);
    std::array<double, kBlock> least;
    least.fill(kInfinity);
    for (const Bary& corner : part.corners) {
      for (std::size_t i = 0; i < size; ++i) {
        const double excess = corner[0] * (at_a[from + i] - at_a[own]) + corner[1] * (at_b[from + i] - at_b[own]) +
                              corner[2] * (at_c[from + i] - at_c[own]);
        least[i] = std::min(least[i], excess);
      }
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (!(least[i] > 0) && from + i != own) return from + i;
    }
  }
  return count;
}

void LowerEnvelope::list_candidates(const std::vector<Function>& values) {
  double least_maximum = kInfinity;
  for (const Function& f : values) least_maximum = std::min(least_maximum, *std::max_element(f.begin(), f.end()));
  candidates_.clear();
  for (std::size_t f = 0; f < values.size(); ++f) {
    if (*std::min_element(values[f].begin(), values[f].end()) > least_maximum) continue;
    const auto is_beaten_by = [&](std::size_t other) { return is_nowhere_less(values[f], values[other]); };
    if (std::any_of(candidates_.begin(), candidates_.end(), is_beaten_by)) continue;
    std::erase_if(candidates_, [&](std::size_t other) { return is_nowhere_less(values[other], values[f]); });
    candidates_.push_back(f);
  }
  for (std::size_t i = 0; i < 3 && are_many(); ++i) {
    candidate_values_[i].clear();
    for (const std::size_t f : candidates_) candidate_values_[i].push_back(values[f][i]);
  }
}

/// Cuts off the region in which function `other` is less (I. Sutherland and G. Hodgman, Reentrant polygon clipping,
/// 1974).
void LowerEnvelope::clip(const std::vector<Function>& values, EnvelopePart& part, std::size_t other) {
  const std::size_t n = part.corners.size();
  excess_.clear();
  for (const Bary& corner : part.corners) excess_.push_back(difference(values[other], values[part.function], corner));
  const auto is_inside = [&](std::size_t i) { return excess_[i] > 0 || (excess_[i] == 0 && part.function < other); };
  std::size_t inside = 0;
  for (std::size_t i = 0; i < n; ++i) inside += is_inside(i);
  if (inside == n) return;
  rest_.function = part.function;
  rest_.corners.clear();
  rest_.across.clear();
  for (std::size_t i = 0; i < n && inside > 0; ++i) {
    const std::size_t next = (i + 1) % n;
    if (is_inside(i)) append_corner(part.corners[i], part.across[i], rest_);
    if (is_inside(i) == is_inside(next)) continue;
    append_corner(zero_between(part.corners[i], excess_[i], part.corners[next], excess_[next]),
                  is_inside(i) ? other : part.across[i], rest_);
  }
  std::swap(part, rest_);
}

}  // namespace gvd
