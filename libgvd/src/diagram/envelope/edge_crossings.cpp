// The crossings of one edge: where the lower envelope of its sources' distances passes from one generator to another.
//
// The distance of a source is a branch of a hyperbola over its interval, and two such distances are equal in at most
// two points. Sources are inserted one by one; most are settled without a square root, because convexity bounds them.
// The envelope uses straight paths only. The crossings are then found from the shortest paths of the two generators, so
// that rounding at the end of a window has no effect. Whatever the distances are, the result is a chain of labels from
// one end of the edge to the other.
// Source: not in the paper, which interpolates distances along edges (section 4.2).
#include "diagram/envelope/edge_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/roots.hpp"
#include "geodesic/windows/window.hpp"

namespace gvd {
namespace {

constexpr int kPolishSteps = 4;

/// The largest distance of a source on an interval, by its straight paths. A convex function takes it at an end.
double most(const EdgeSource& source, double begin, double end) {
  return std::max(source.straight(begin), source.straight(end));
}

/// Least distance of crossings from each other and from the ends of their edge, as a fraction of the edge. It is above
/// the snapping of surface points.
constexpr double kEndGap = 2e-12;

/// Length of the shortest label interval, as a fraction of its edge. It is several times the least distance of two
/// crossings. The points that a cell loses by it are as near to the neighbouring cell's generator, within twice the
/// interval's length.
constexpr double kShortestExactInterval = 5 * kEndGap;

/// Two distances that differ by less than this fraction of themselves count as equal, and a bracket narrower than this
/// fraction of the edge counts as a point.
constexpr double kEqual = 1e-14;

/// `equidistant_positions` for a first source, or two sources, with parallel paths. Lengths of parallel paths are
/// linear, so that the equation is quadratic, or linear if both sources have parallel paths.
std::array<double, 2> equidistant_to_parallel(const EdgeSource& parallel, const EdgeSource& other, double unit) {
  if (other.is_parallel()) {
    const double t = (other.offset - parallel.offset) / (parallel.x - other.x);
    return {std::isfinite(t) ? t : -1, -1};
  }
  // sqrt(s^2 + depth^2) = level + slope s, squared, with positions s from the foot of the image.
  const double slope = parallel.x, depth = other.depth * unit;
  const double level = (parallel.straight(other.x) - other.offset) * unit;
  auto roots = quadratic_roots((1 - slope) * (1 + slope), -level * slope, (depth - level) * (depth + level));
  for (double& root : roots) root = std::isfinite(root) ? other.x + root / unit : -1;
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return roots;
}

}  // namespace

std::array<double, 2> equidistant_positions(const EdgeSource& first, const EdgeSource& second, double unit) {
  if (first.is_parallel()) [[unlikely]]
    return equidistant_to_parallel(first, second, unit);
  if (second.is_parallel()) [[unlikely]]
    return equidistant_to_parallel(second, first, unit);
  // The roots of sqrt(B) = sqrt(A) + c, with B - A - c^2 = slope t + rest, squared twice. Roots that only the squared
  // equation has do no harm, because the same source is nearer on both sides of them. Positions are measured from the
  // foot of the first image: if both images are much nearer to each other than to the start of the edge, squares of
  // distances from the start would hide their difference.
  const double c = (first.offset - second.offset) * unit, apart = (second.x - first.x) * unit;
  const double first_depth = first.depth * unit, second_depth = second.depth * unit;
  const double slope = -2 * apart;
  const double rest = apart * apart + (second_depth - first_depth) * (second_depth + first_depth) - c * c;
  if (c == 0) return {slope != 0 ? first.x - rest / slope / unit : -1, -1};
  // With different feet, positions are measured from where slope t + rest is 0. There is one root on either side, and
  // nothing cancels even if the roots are very near each other, as for two sources that tie at an end of the edge
  // except for their symbolic offsets.
  const bool has_centre = std::abs(slope) > 2 * std::abs(c);
  const double centre = has_centre ? -rest / slope : 0, far = centre * centre + first_depth * first_depth;
  const double square = (slope - 2 * c) * (slope + 2 * c), half = has_centre ? -4 * c * c * centre : slope * rest;
  const double constant = has_centre ? -4 * c * c * far : (rest - 2 * c * first_depth) * (rest + 2 * c * first_depth);
  auto roots = quadratic_roots(square, half, constant);
  for (double& root : roots) root = std::isfinite(root) ? first.x + (centre + root) / unit : -1;
  if (roots[0] > roots[1]) std::swap(roots[0], roots[1]);
  return roots;
}

double refine_equidistant(const EdgeSource& first, const EdgeSource& second, double begin, double end,
                          double position) {
  double t = position, to_first = first.straight(t), to_second = second.straight(t), error = to_first - to_second;
  for (int step = 0; step < kPolishSteps && error != 0; ++step) {
    const double next = t - error / (first.slope(t, to_first) - second.slope(t, to_second));
    if (!(next > begin && next < end)) break;
    to_first = first.straight(next);
    to_second = second.straight(next);
    const double after = to_first - to_second;
    if (!(std::abs(after) < std::abs(error))) break;
    t = next;
    error = after;
  }
  return t;
}

// The paths from the edge's ends come last. They are seldom the nearest anywhere, but tie with the windows that reach
// the ends.
void EdgeEnvelope::build(const std::vector<EdgeSource>& sources, double length, const SymbolicOffset& offset) {
  sources_ = sources;
  length_ = length;
  unit_ = std::ldexp(1.0, -std::ilogb(length));
  sliver_ = kShortestExactInterval * length;
  segments_.assign(1, {length, kNoSource, kInfinity});
  for (std::int32_t i = 0; i < std::ssize(sources_); ++i) {
    EdgeSource& s = sources_[i];
    s.offset += offset.of(s.generator);
    s.begin = std::max(s.begin, 0.0);
    s.end = std::min(s.end, length);
    if (!is_end(s)) insert(i);
  }
  const bool is_continuous = this->is_continuous();
  for (std::int32_t i = 0; i < std::ssize(sources_); ++i) {
    if (is_end(sources_[i]) && !(is_continuous && is_reached(sources_[i]))) insert(i);
  }
  // A gap that is as wide as a sliver, up to rounding, may remain.
  std::erase_if(segments_, [](const Segment& s) { return s.source == kNoSource; });
  segments_.back().end = length;
}

bool EdgeEnvelope::is_end(const EdgeSource& s) const { return s.depth == 0 && (s.x == 0 || s.x == length_); }

/// Whether each segment has a source and begins, up to rounding, with the distance at which the segment before it ends.
/// If so, no distance is longer than the distance at another point plus the way along the edge from there.
bool EdgeEnvelope::is_continuous() const {
  const Segment* before = nullptr;
  for (const Segment& s : segments_) {
    if (s.source == kNoSource) return false;
    if (before != nullptr) {
      const double last = sources_[before->source].straight(before->end),
                   next = sources_[s.source].straight(before->end);
      if (std::abs(next - last) > kSameImage * last) return false;
    }
    before = &s;
  }
  return true;
}

/// Whether the segment at the end of the edge where a source lies has a path from the same generator to that end that
/// is as short as the source's.
bool EdgeEnvelope::is_reached(const EdgeSource& end) const {
  const EdgeSource& s = sources_[(end.x == 0 ? segments_.front() : segments_.back()).source];
  return s.generator == end.generator && s.straight(end.x) <= end.offset * (1 + kSameImage);
}

/// Gives `source` the parts of its interval on which it is nearer than all sources before. Ends of the interval that by
/// rounding lie beside ends of segments are moved there, so that no gap remains between windows.
void EdgeEnvelope::insert(std::int32_t source) {
  const EdgeSource& s = sources_[source];
  const auto first = std::partition_point(segments_.begin(), segments_.end(),
                                          [&](const Segment& old) { return old.end <= s.begin + sliver_; });
  if (!(s.begin < s.end) || first == segments_.end()) return;
  // Most sources are farther than the segments' sources everywhere, so that this one square root settles them.
  const double least = s.least();
  const double begin = begin_of(first), last = s.end - sliver_;
  auto next = first;
  while (next->most <= least && next->end < last) ++next;
  if (next->most <= least) return;
  double low = s.begin > begin + sliver_ ? s.begin : begin;
  if (!(low < last)) return;
  if (first->source == kNoSource && last <= first->end) return fill(first, source, low);
  pieces_.clear();
  if (low > begin) pieces_.push_back({low, first->source, first->most});
  bool is_nearer = false;
  for (next = first; low < last; ++next) {
    const double high = next->end <= s.end + sliver_ ? next->end : s.end;
    if (next->most <= least) {
      append({high, next->source, next->most});
    } else {
      is_nearer |= append_nearer(*next, source, low, high);
    }
    if (high < next->end) append(*next);
    low = high;
  }
  if (is_nearer) replace(first, next, source);
}

/// Gives `source` its interval, from `low` on, in a segment without a source.
void EdgeEnvelope::fill(std::vector<Segment>::iterator gap, std::int32_t source, double low) {
  const double begin = begin_of(gap), end = sources_[source].end;
  const double high = gap->end <= end + sliver_ ? gap->end : end;
  const Segment filled{high, source, most(sources_[source], low, high)};
  if (high < gap->end) {
    gap = segments_.insert(gap, filled);
  } else {
    *gap = filled;
  }
  if (low > begin) segments_.insert(gap, {low, kNoSource, kInfinity});
}

/// Replaces some segments by the pieces, among which those of `source` are new.
void EdgeEnvelope::replace(std::vector<Segment>::iterator first, std::vector<Segment>::iterator last,
                           std::int32_t source) {
  double begin = begin_of(first);
  for (Segment& piece : pieces_) {
    if (piece.source == source) piece.most = most(sources_[source], begin, piece.end);
    begin = piece.end;
  }
  const auto kept = std::min(last - first, static_cast<std::ptrdiff_t>(pieces_.size()));
  std::copy(pieces_.begin(), pieces_.begin() + kept, first);
  if (last - first > kept) segments_.erase(first + kept, last);
  segments_.insert(first + kept, pieces_.begin() + kept, pieces_.end());
}

/// Appends the nearer of two sources from `begin` to `end`. If the nearer source may change, this goes piece by piece
/// between the positions where the two are equally far. Returns whether the new source is nearer anywhere.
bool EdgeEnvelope::append_nearer(const Segment& old, std::int32_t source, double begin, double end) {
  if (old.source == kNoSource) {
    append({end, source});
    return true;
  }
  const EdgeSource &o = sources_[old.source], &s = sources_[source];
  const Nearer nearer = compare_sources(o, s, begin, end);
  if (nearer != Nearer::open) {
    append(nearer == Nearer::first ? Segment{end, old.source, old.most} : Segment{end, source});
    return nearer == Nearer::second;
  }
  double from = begin;
  bool is_nearer = false;
  const auto append_to = [&](double to) {
    const double middle = 0.5 * (from + to);
    const bool wins = s.straight(middle) < o.straight(middle);
    append(wins ? Segment{to, source} : Segment{to, old.source, old.most});
    is_nearer |= wins;
    from = to;
  };
  for (const double root : equidistant_positions(o, s, unit_)) {
    if (!(root > from && root < end)) continue;
    // Between two sources of the same generator, the position has no effect on crossings.
    const double t = o.generator == s.generator ? root : refine_equidistant(o, s, from, end, root);
    if (t > from && t < end) append_to(t);
  }
  append_to(end);
  return is_nearer;
}

double EdgeDistances::at(GeneratorId g, double t) const {
  double least = kInfinity;
  for (const EdgeSource& source : sources_.of(g)) {
    // No path of a source is shorter than the straight one. This test costs no square root.
    const double rest = least - source.offset, along = t - source.x;
    if (source.is_parallel()) [[unlikely]] {
      least = std::min(least, source.distance(t));
    } else if (rest > 0 && along * along + source.depth * source.depth < rest * rest) {
      least = std::min(least, source.distance(t));
    }
  }
  return least;
}

/// Whether an interval after one of `before` is only a gap between two windows of `before`. Windows end at rays past a
/// vertex, and rays that are unfolded over hundreds of thin faces are rounded. The interval is real if its generator is
/// nearer than the paths of `before` that follow the edge from its windows.
bool EdgeCrossings::is_gap(const LabelInterval& interval, double end, GeneratorId before) const {
  const double middle = 0.5 * (interval.begin + end);
  return distances_.at(before, middle) <= distances_.at(interval.generator, middle);
}

/// The position near the guess where generator a, which is nearer at `low`, and generator b, which is nearer at `high`,
/// are equally far. The guess itself if the distances contradict this.
double EdgeCrossings::find_equidistant(GeneratorId a, GeneratorId b, const Guess& guess) const {
  const auto difference = [&](double t) { return distances_.at(a, t) - distances_.at(b, t); };
  const double t = guess.position, at_a = distances_.at(a, t), here = at_a - distances_.at(b, t);
  if (std::abs(here) <= kEqual * std::abs(at_a)) return t;
  const double from = here < 0 ? t : guess.low, to = here < 0 ? guess.high : t;
  const double at_from = here < 0 ? here : difference(from), at_to = here < 0 ? difference(to) : here;
  if (!(at_from < 0 && at_to > 0)) return t;
  return find_root({from, to, at_from, at_to}, kEqual * length_, difference);
}

/// Finds the label intervals, from the label of the first end to that of the last, and leaves out intervals that are
/// too short.
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
    if (g != before && end - begin >= least && !is_gap({begin, g}, end, before)) intervals_.push_back({begin, g});
    begin = end;
  }
  // If the last interval is too short, or a tie, it begins where its generator is as near as the generator before it.
  if (intervals_.back().generator != last) intervals_.push_back({length_, last});
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
    // If intervals were left out, two positions can be out of order by rounding.
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
  // One of the two may be nearer on the whole edge, by a tie at the other's end, or because the other's cell is cut off
  // there. Then the crossing lies at that end.
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
