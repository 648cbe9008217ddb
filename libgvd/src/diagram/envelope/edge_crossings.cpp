#include "diagram/envelope/edge_crossings.hpp"

#include <algorithm>
#include <cmath>

#include "base/roots.hpp"

namespace gvd {
namespace {

/// Distance between crossings and the ends of their edge, as a fraction of it: above the snapping of surface points.
constexpr double kEndGap = 2e-12;

/// Shortest label interval, as a fraction of its edge: several times what lies between two crossings at least. The
/// points of a cell lost by this are as near to the neighbouring cell, within twice the interval's length.
constexpr double kShortestExactInterval = 5 * kEndGap;

/// Two distances that differ by less than this fraction of themselves are equal. A bracket narrower than this fraction
/// of the edge is a point.
constexpr double kEqual = 1e-14;

}  // namespace

/// Whether an interval after one of `before` is only a gap between two windows of `before`: they end at rays past a
/// vertex, and rays unfolded over hundreds of thin faces are rounded. The interval is real if its generator is nearer
/// than the paths of `before` that follow the edge from its windows.
bool EdgeCrossings::is_gap(const LabelInterval& interval, double end, GeneratorId before) const {
  const double middle = 0.5 * (interval.begin + end);
  return distances_.at(before, middle) <= distances_.at(interval.generator, middle);
}

/// The position near the guess where generators a, nearer at `low`, and b, nearer at `high`, are equally far. The guess
/// itself where the distances contradict this.
double EdgeCrossings::find_equidistant(GeneratorId a, GeneratorId b, const Guess& guess) const {
  const auto difference = [&](double t) { return distances_.at(a, t) - distances_.at(b, t); };
  const double t = guess.position, at_a = distances_.at(a, t), here = at_a - distances_.at(b, t);
  if (std::abs(here) <= kEqual * std::abs(at_a)) return t;
  const double from = here < 0 ? t : guess.low, to = here < 0 ? guess.high : t;
  const double at_from = here < 0 ? here : difference(from), at_to = here < 0 ? difference(to) : here;
  if (!(at_from < 0 && at_to > 0)) return t;
  return find_root({from, to, at_from, at_to}, kEqual * length_, difference);
}

/// Finds the label intervals, from the label of the first end to that of the last, without those that are too short.
void EdgeCrossings::find_label_intervals(const EdgeEnvelope& envelope, GeneratorId first, GeneratorId last) {
  intervals_.assign(1, {0, first});
  const auto& segments = envelope.segments();
  const double least = kShortestExactInterval * length_;
  double begin = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const GeneratorId g = envelope.generator(segments[i]);
    while (i + 1 < segments.size() && envelope.generator(segments[i + 1]) == g) ++i;
    const double end = segments[i].end;
    const GeneratorId before = intervals_.back().generator;
    if (g != before && end - begin >= least && !is_gap({begin, g}, end, before)) {
      intervals_.push_back({begin, g});
    }
    begin = end;
  }
  if (intervals_.back().generator == last) return;
  // The last interval is too short, or a tie: it begins where its generator is as near as the one before.
  intervals_.push_back({length_, last});
}

void EdgeCrossings::append_all(const EdgeEnvelope& envelope, EdgeId e, GeneratorId first, GeneratorId last,
                               std::vector<Crossing>& crossings) {
  const auto& segments = envelope.segments();
  const auto is_first = [&](const EdgeEnvelope::Segment& s) { return envelope.generator(s) == first; };
  if (first == last && std::all_of(segments.begin(), segments.end(), is_first)) return;
  enter(envelope);
  find_label_intervals(envelope, first, last);
  double before = kEndGap;
  for (std::size_t i = 1; i < intervals_.size(); ++i) {
    const LabelInterval &previous = intervals_[i - 1], &own = intervals_[i];
    const double high = i + 1 < intervals_.size() ? intervals_[i + 1].begin : length_;
    const double t = find_equidistant(previous.generator, own.generator, {previous.begin, own.begin, high}) / length_;
    // Where intervals were dropped, rounding can bring two positions out of order.
    const double most = 1 - kEndGap * static_cast<double>(intervals_.size() - i);
    before = std::clamp(t, before, most);
    crossings.push_back({e, before, previous.generator, own.generator});
    before = std::min(before + kEndGap, most);
  }
}

void EdgeCrossings::append_single(const EdgeEnvelope& envelope, EdgeId e, GeneratorId first, GeneratorId last,
                                  std::vector<Crossing>& crossings) {
  enter(envelope);
  const auto clearance = [&](double t) { return distances_.at(last, t) - distances_.at(first, t); };
  // One of the two may be nearer on all of the edge: by a tie at the other's end, or because the other's cell is cut
  // off there. Then the crossing lies at that end.
  double t = clearance(0) <= 0 ? 0 : 1;
  if (clearance(0) > 0 && clearance(length_) < 0) {
    t = find_equidistant(first, last, {0, 0.5 * length_, length_}) / length_;
  }
  crossings.push_back({e, std::clamp(t, kEndGap, 1 - kEndGap), first, last});
}

void EdgeCrossings::enter(const EdgeEnvelope& envelope) {
  length_ = envelope.length();
  distances_.build(envelope.sources());
}

}  // namespace gvd
