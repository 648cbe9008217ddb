#include "diagram/envelope/edge_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "base/find_root.hpp"

namespace gvd {
namespace {

/// Shortest label interval, as a fraction of its edge. A shorter one is a rounding error where windows end. The points
/// of a cell lost by this are as near to the neighbouring cell, within twice the interval's length.
constexpr double kShortestExactInterval = 1e-9;

/// Widest gap between two windows, as a fraction of the edge. Windows end at rays past a vertex, and rays unfolded over
/// hundreds of thin faces are off by up to 1e-9 of the edge.
constexpr double kWidestGap = 1e-6;

/// Distance between crossings and the ends of their edge, as a fraction of it: above the snapping of surface points.
constexpr double kEndGap = 2e-12;

/// Two distances that differ by less than this fraction of themselves are equal. A bracket narrower than this fraction
/// of the edge is a point.
constexpr double kEqual = 1e-14;

/// Whether the interval of g after one of `before` is only a gap that rounding left between two windows of `before`. It
/// is real if g is nearer than the paths of `before` that follow the edge from its windows.
bool is_gap(const EdgeEnvelope& envelope, GeneratorId before, GeneratorId g, double begin, double end) {
  if (end - begin > kWidestGap * envelope.length()) return false;
  const double middle = 0.5 * (begin + end);
  return envelope.distance(before, middle) <= envelope.distance(g, middle);
}

/// A position where two generators may be equally far, and the interval around it to search.
struct Guess {
  double low, position, high;
};

/// The position near the guess where generators a, nearer at `low`, and b, nearer at `high`, are equally far. The guess
/// itself where the distances contradict this.
double find_equidistant(const EdgeEnvelope& envelope, GeneratorId a, GeneratorId b, const Guess& guess) {
  const auto difference = [&](double t) { return envelope.distance(a, t) - envelope.distance(b, t); };
  const double t = guess.position, here = difference(t);
  if (std::abs(here) <= kEqual * std::abs(envelope.distance(a, t))) return t;
  const double from = here < 0 ? t : guess.low, to = here < 0 ? guess.high : t;
  const double at_from = difference(from), at_to = difference(to);
  if (!(at_from < 0 && at_to > 0)) return t;
  return find_root({from, to, at_from, at_to}, kEqual * envelope.length(), difference);
}

}  // namespace

/// Finds the label intervals, from the label of the first end to that of the last, without those that are too short.
void EdgeCrossings::find_label_intervals(const EdgeEnvelope& envelope, GeneratorId first, GeneratorId last) {
  intervals_.assign(1, {0, first});
  const auto& segments = envelope.segments();
  const double least = kShortestExactInterval * envelope.length();
  double begin = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const GeneratorId g = envelope.generator(segments[i]);
    while (i + 1 < segments.size() && envelope.generator(segments[i + 1]) == g) ++i;
    const double end = segments[i].end;
    const GeneratorId before = intervals_.back().generator;
    if (g != before && end - begin >= least && !is_gap(envelope, before, g, begin, end)) {
      intervals_.push_back({begin, g});
    }
    begin = end;
  }
  if (intervals_.back().generator == last) return;
  // The last interval is too short, or a tie: it begins where its generator is as near as the one before.
  intervals_.push_back({envelope.length(), last});
}

void EdgeCrossings::append_all(const EdgeEnvelope& envelope, EdgeId e, GeneratorId first, GeneratorId last,
                               std::vector<Crossing>& crossings) {
  find_label_intervals(envelope, first, last);
  const double length = envelope.length();
  double before = kEndGap;
  for (std::size_t i = 1; i < intervals_.size(); ++i) {
    const LabelInterval &previous = intervals_[i - 1], &own = intervals_[i];
    const double high = i + 1 < intervals_.size() ? intervals_[i + 1].begin : length;
    const double t =
        find_equidistant(envelope, previous.generator, own.generator, {previous.begin, own.begin, high}) / length;
    // Where intervals were dropped, rounding can bring two positions out of order.
    const double most = 1 - kEndGap * static_cast<double>(intervals_.size() - i);
    before = std::clamp(t, before, most);
    crossings.push_back({e, before, previous.generator, own.generator});
    before = std::min(before + kEndGap, most);
  }
}

void EdgeCrossings::append_single(const EdgeEnvelope& envelope, EdgeId e, GeneratorId first, GeneratorId last,
                                  std::vector<Crossing>& crossings) {
  const double length = envelope.length();
  const auto clearance = [&](double t) { return envelope.distance(last, t) - envelope.distance(first, t); };
  // One of the two may be nearer on all of the edge: by a tie at the other's end, or because the other's cell is cut
  // off there. Then the crossing lies at that end.
  double t = clearance(0) <= 0 ? 0 : 1;
  if (clearance(0) > 0 && clearance(length) < 0) {
    t = find_equidistant(envelope, first, last, {0, 0.5 * length, length}) / length;
  }
  crossings.push_back({e, std::clamp(t, kEndGap, 1 - kEndGap), first, last});
}

}  // namespace gvd
