#include "diagram/envelope/edge_envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gvd {
namespace {

/// A run shorter than this part of its edge is rounding, of a place where windows meet: what is lost is a sliver whose
/// points are as near to the neighbouring cell, within twice its length.
constexpr double kShortestInterval = 1e-9;

/// Gaps between windows are narrower than this part of their edge: windows end where rays pass a vertex, and rays that
/// were unfolded over hundreds of thin faces are off by up to 1e-9 of the edge.
constexpr double kWidestGap = 1e-6;

/// Crossings keep this distance from the ends of their edge, as a part of it: above the snapping of surface points.
constexpr double kEndGap = 2e-12;

/// Two distances that differ by less than this part of themselves meet.
constexpr double kMeeting = 1e-14;

constexpr int kMeetingSteps = 100;

/// A straight path from a source to a point of the edge.
struct Reach {
  double along, straight, distance;
  Reach(const EdgeSource& s, double t)
      : along(t - s.x), straight(std::sqrt(along * along + s.depth * s.depth)), distance(s.offset + straight) {}
  /// How fast the distance grows along the edge.
  double slope() const { return straight > 0 ? along / straight : 0; }
};

/// Whether a source that is above another one at both ends of an interval is above it in between: both distances are
/// convex, so the one lies above its two tangents, and the other one below its chord.
bool is_above(const Reach& begin, const Reach& end, const Reach& other_begin, const Reach& other_end, double width) {
  const double first = begin.slope(), last = end.slope();
  if (!(last > first)) return true;
  const double meet = (begin.distance - end.distance + last * width) / (last - first);
  const double chord = other_begin.distance + (other_end.distance - other_begin.distance) * (meet / width);
  return begin.distance + first * meet > chord;
}

/// Where along the edge two sources are equally far, times `unit`, ascending; -1 stands for no place. The roots of
/// sqrt(A) = sqrt(B) + c with A - B = slope t + rest, squared twice; some lie outside of the edge. Roots that only the
/// squares have do no harm: the pieces on their two sides go to the same source.
std::array<double, 2> roots_of_squares(const EdgeSource& o, const EdgeSource& s, double unit) {
  const double c = (o.offset - s.offset) * unit;
  const double o_x = o.x * unit, s_x = s.x * unit, o_depth = o.depth * unit, s_depth = s.depth * unit;
  const double slope = 2 * (o_x - s_x);
  const double rest = (s_x - o_x) * (s_x + o_x) + (s_depth - o_depth) * (s_depth + o_depth) - c * c;
  std::array<double, 2> roots{-1, -1};
  if (c == 0) {
    if (slope != 0) roots[0] = -rest / slope;
  } else {
    const double square = (slope - 2 * c) * (slope + 2 * c), half = slope * rest + 4 * c * c * o_x;
    const double constant = rest * rest - 4 * c * c * (o_x * o_x + o_depth * o_depth);
    // Rounding can make the discriminant of a double root negative.
    const double root = std::sqrt(std::max(0.0, half * half - square * constant));
    const double q = -(half + std::copysign(root, half));
    if (square != 0) roots[0] = q / square;
    if (q != 0) roots[1] = constant / q;
    if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  }
  return roots;
}

}  // namespace

void EdgeEnvelope::build(const std::vector<EdgeSource>& sources, double length, double tie_step) {
  sources_ = sources;
  length_ = length;
  unit_ = std::ldexp(1.0, -std::ilogb(length));
  for (EdgeSource& s : sources_) {
    s.offset += tie_step * static_cast<double>(s.generator.value());
    s.begin = std::max(s.begin, 0.0);
    s.end = std::min(s.end, length);
  }
  segments_.assign(1, {length, 0});
  for (std::size_t i = 1; i < sources_.size(); ++i) insert(static_cast<std::int32_t>(i));
}

double EdgeEnvelope::straight(std::int32_t source, double t) const {
  return sources_[static_cast<std::size_t>(source)].straight(t);
}

double EdgeEnvelope::distance(GeneratorId g, double t) const {
  double least = std::numeric_limits<double>::infinity();
  for (const EdgeSource& s : sources_) {
    if (s.generator == g) least = std::min(least, s.distance(t));
  }
  return least;
}

std::int32_t EdgeEnvelope::nearer(std::int32_t a, std::int32_t b, double t) const {
  return straight(b, t) < straight(a, t) ? b : a;
}

void EdgeEnvelope::append(double end, std::int32_t source) {
  if (!pieces_.empty() && pieces_.back().source == source) {
    pieces_.back().end = end;
  } else {
    pieces_.push_back({end, source});
  }
}

/// Takes the part of the edge that `source` reaches and is nearer on.
void EdgeEnvelope::insert(std::int32_t source) {
  const double begin = sources_[static_cast<std::size_t>(source)].begin;
  const double end = sources_[static_cast<std::size_t>(source)].end;
  if (!(begin < end)) return;
  const auto first = std::find_if(segments_.begin(), segments_.end(), [&](const Segment& s) { return s.end > begin; });
  pieces_.clear();
  if (begin > (first == segments_.begin() ? 0 : (first - 1)->end)) pieces_.push_back({begin, first->source});
  bool is_nearer = false;
  double low = begin;
  auto next = first;
  while (low < end) {
    const double high = std::min(next->end, end);
    is_nearer |= compare(next->source, source, low, high);
    if (high < next->end) append(next->end, next->source);
    low = high;
    ++next;
  }
  if (!is_nearer) return;
  const auto kept = std::min(next - first, static_cast<std::ptrdiff_t>(pieces_.size()));
  std::copy(pieces_.begin(), pieces_.begin() + kept, first);
  if (next - first > kept) segments_.erase(first + kept, next);
  segments_.insert(first + kept, pieces_.begin() + kept, pieces_.end());
}

/// Appends the lower one of two sources, piece by piece, from `begin` to `end`. Whether the new one is lower anywhere.
bool EdgeEnvelope::compare(std::int32_t old_source, std::int32_t source, double begin, double end) {
  const EdgeSource &o = sources_[static_cast<std::size_t>(old_source)], &s = sources_[static_cast<std::size_t>(source)];
  const Reach s_begin(s, begin), s_end(s, end), o_begin(o, begin), o_end(o, end);
  const double at_begin = s_begin.distance - o_begin.distance, at_end = s_end.distance - o_end.distance;
  if (at_begin > 0 && at_end > 0 && is_above(s_begin, s_end, o_begin, o_end, end - begin)) {
    append(end, old_source);
    return false;
  }
  if (at_begin < 0 && at_end < 0 && is_above(o_begin, o_end, s_begin, s_end, end - begin)) {
    append(end, source);
    return true;
  }
  double from = begin;
  bool is_nearer = false;
  const auto take = [&](double to) {
    const std::int32_t winner = nearer(old_source, source, 0.5 * (from + to));
    append(to, winner);
    is_nearer |= winner == source;
    from = to;
  };
  for (const double scaled : roots_of_squares(o, s, unit_)) {
    const double root = scaled / unit_;
    if (!(root > from && root < end)) continue;
    // Between two windows of one generator the place shows nowhere.
    const double t = o.generator == s.generator ? root : polish(old_source, source, from, end, root);
    if (!(t > from && t < end)) continue;
    take(t);
  }
  take(end);
  return is_nearer;
}

/// Newton's steps towards the place near t where two sources are equally far.
double EdgeEnvelope::polish(std::int32_t a, std::int32_t b, double begin, double end, double t) const {
  const EdgeSource &s = sources_[static_cast<std::size_t>(a)], &o = sources_[static_cast<std::size_t>(b)];
  double error = s.straight(t) - o.straight(t);
  for (int step = 0; step < 4 && error != 0; ++step) {
    const double slope = (t - s.x) / (s.straight(t) - s.offset) - (t - o.x) / (o.straight(t) - o.offset);
    const double next = t - error / slope;
    if (!(next > begin && next < end)) break;
    const double after = s.straight(next) - o.straight(next);
    if (!(std::abs(after) < std::abs(error))) break;
    t = next;
    error = after;
  }
  return t;
}

/// Runs of one generator, from the label of the one end to that of the other, without those that are too short.
void EdgeEnvelope::find_runs(GeneratorId first, GeneratorId last) {
  runs_.assign(1, {0, first});
  const double least = kShortestInterval * length_;
  double begin = 0;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const GeneratorId g = generator(segments_[i]);
    while (i + 1 < segments_.size() && generator(segments_[i + 1]) == g) ++i;
    const double end = segments_[i].end;
    if (g != runs_.back().generator && end - begin >= least && !is_gap(runs_.back().generator, g, begin, end)) {
      runs_.push_back({begin, g});
    }
    begin = end;
  }
  if (runs_.back().generator == last) return;
  // The last run is too short to be seen, or a tie: it begins where its generator is as near as the one before.
  runs_.push_back({length_, last});
}

/// Between two windows of one generator that should meet, rounding leaves gaps, where another generator shows. A run so
/// short is real only if it is nearer than the paths that go on along the edge from the windows before it.
bool EdgeEnvelope::is_gap(GeneratorId before, GeneratorId g, double begin, double end) const {
  if (end - begin > kWidestGap * length_) return false;
  const double middle = 0.5 * (begin + end);
  return distance(before, middle) <= distance(g, middle);
}

/// Where generators a and b are equally far, near t and between low and high: t itself where they are, and also where
/// they never are.
double EdgeEnvelope::meeting(GeneratorId a, GeneratorId b, double low, double t, double high) const {
  const auto error = [&](double at) { return distance(a, at) - distance(b, at); };
  const double here = error(t);
  if (std::abs(here) <= kMeeting * std::abs(distance(a, t))) return t;
  // a leads at `low`, b at `high`, if all is well.
  double from = here < 0 ? t : low, to = here < 0 ? high : t;
  double at_from = error(from), at_to = error(to);
  if (!(at_from < 0 && at_to > 0)) return t;
  for (int step = 0; step < kMeetingSteps && to - from > kMeeting * length_; ++step) {
    double middle = from - at_from * (to - from) / (at_to - at_from);
    if (step % 3 == 2 || !(middle > from && middle < to)) middle = 0.5 * (from + to);
    const double value = error(middle);
    if (value == 0) return middle;
    (value < 0 ? from : to) = middle;
    (value < 0 ? at_from : at_to) = value;
  }
  return 0.5 * (from + to);
}

void EdgeEnvelope::append_plain_crossing(EdgeId e, GeneratorId first, GeneratorId last,
                                         std::vector<Crossing>& crossings) const {
  // Where the one is nearer all along, by a tie at the end of the other or because that one's cell is cut off there,
  // the crossing lies at that end.
  const auto lead = [&](double t) { return distance(last, t) - distance(first, t); };
  double t = lead(0) <= 0 ? 0 : 1;
  if (lead(0) > 0 && lead(length_) < 0) t = meeting(first, last, 0, 0.5 * length_, length_) / length_;
  crossings.push_back({e, std::clamp(t, kEndGap, 1 - kEndGap), first, last});
}

void EdgeEnvelope::append_crossings(EdgeId e, GeneratorId first, GeneratorId last, std::vector<Crossing>& crossings) {
  find_runs(first, last);
  double before = kEndGap;
  for (std::size_t i = 1; i < runs_.size(); ++i) {
    const double low = runs_[i - 1].begin, high = i + 1 < runs_.size() ? runs_[i + 1].begin : length_;
    const double t = meeting(runs_[i - 1].generator, runs_[i].generator, low, runs_[i].begin, high) / length_;
    // Runs that were dropped can bring two meetings out of order, by rounding.
    const double room = kEndGap * static_cast<double>(runs_.size() - i);
    before = std::clamp(t, before, 1 - room);
    crossings.push_back({e, before, runs_[i - 1].generator, runs_[i].generator});
    before = std::min(before + kEndGap, 1 - room);
  }
}

}  // namespace gvd
