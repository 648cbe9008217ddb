#include "diagram/envelope/edge_envelope.hpp"

#include <algorithm>
#include <cmath>

#include "diagram/envelope/compare_sources.hpp"

namespace gvd {
namespace {

/// The largest distance of a source on an interval, by its straight paths: a convex function has it at an end.
double most(const EdgeSource& source, double begin, double end) {
  return std::max(source.straight(begin), source.straight(end));
}

}  // namespace

void EdgeEnvelope::build(const std::vector<EdgeSource>& sources, double length, const SymbolicOffset& offset) {
  sources_ = sources;
  length_ = length;
  unit_ = std::ldexp(1.0, -std::ilogb(length));
  for (EdgeSource& s : sources_) {
    s.offset += offset.of(s.generator);
    s.begin = std::max(s.begin, 0.0);
    s.end = std::min(s.end, length);
  }
  segments_.assign(1, {length, 0, most(sources_[0], 0, length)});
  for (std::size_t i = 1; i < sources_.size(); ++i) insert(static_cast<std::int32_t>(i));
}

void EdgeEnvelope::append(double end, std::int32_t source) {
  if (!pieces_.empty() && pieces_.back().source == source) {
    pieces_.back().end = end;
  } else {
    pieces_.push_back({end, source, 0});
  }
}

/// Gives `source` the parts of its interval on which it is nearer than all before.
void EdgeEnvelope::insert(std::int32_t source) {
  const EdgeSource& s = sources_[source];
  if (!(s.begin < s.end)) return;
  const auto first =
      std::partition_point(segments_.begin(), segments_.end(), [&](const Segment& old) { return old.end <= s.begin; });
  // Most sources are farther than this anywhere, so that one square root settles them.
  const double least = s.straight(std::clamp(s.x, s.begin, s.end));
  auto next = first;
  while (next->most <= least && next->end < s.end) ++next;
  if (next->most <= least) return;
  pieces_.clear();
  if (s.begin > begin_of(first)) pieces_.push_back({s.begin, first->source, 0});
  bool is_nearer = false;
  double low = s.begin;
  for (next = first; low < s.end; ++next) {
    const double high = std::min(next->end, s.end);
    if (next->most <= least) {
      append(high, next->source);
    } else {
      is_nearer |= append_nearer(next->source, source, low, high);
    }
    if (high < next->end) append(next->end, next->source);
    low = high;
  }
  if (is_nearer) replace(first, next);
}

/// Puts the pieces in place of some segments.
void EdgeEnvelope::replace(std::vector<Segment>::iterator first, std::vector<Segment>::iterator last) {
  double begin = begin_of(first);
  for (Segment& piece : pieces_) {
    piece.most = most(sources_[piece.source], begin, piece.end);
    begin = piece.end;
  }
  const auto kept = std::min(last - first, static_cast<std::ptrdiff_t>(pieces_.size()));
  std::copy(pieces_.begin(), pieces_.begin() + kept, first);
  if (last - first > kept) segments_.erase(first + kept, last);
  segments_.insert(first + kept, pieces_.begin() + kept, pieces_.end());
}

/// Appends the nearer one of two sources from `begin` to `end`. Returns whether that is the new one anywhere.
bool EdgeEnvelope::append_nearer(std::int32_t old_source, std::int32_t source, double begin, double end) {
  const EdgeSource &o = sources_[old_source], &s = sources_[source];
  const Nearer nearer = compare_sources(o, s, begin, end);
  if (nearer == Nearer::open) return append_nearer_pieces(old_source, source, begin, end);
  append(end, nearer == Nearer::first ? old_source : source);
  return nearer == Nearer::second;
}

/// The same, piece by piece between the positions where the two are equally far.
bool EdgeEnvelope::append_nearer_pieces(std::int32_t old_source, std::int32_t source, double begin, double end) {
  const EdgeSource &o = sources_[old_source], &s = sources_[source];
  double from = begin;
  bool is_nearer = false;
  const auto append_to = [&](double to) {
    const std::int32_t winner = nearer(old_source, source, 0.5 * (from + to));
    append(to, winner);
    is_nearer |= winner == source;
    from = to;
  };
  for (const double root : equidistant_positions(o, s, unit_)) {
    if (!(root > from && root < end)) continue;
    // Between two sources of one generator the position has no effect on crossings.
    const double t = o.generator == s.generator ? root : refine_equidistant(o, s, from, end, root);
    if (t > from && t < end) append_to(t);
  }
  append_to(end);
  return is_nearer;
}

}  // namespace gvd
