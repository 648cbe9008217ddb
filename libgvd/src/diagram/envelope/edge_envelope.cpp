#include "diagram/envelope/edge_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagram/envelope/compare_sources.hpp"

namespace gvd {

void EdgeEnvelope::build(const std::vector<EdgeSource>& sources, double length, const SymbolicOffset& offset) {
  sources_ = sources;
  length_ = length;
  unit_ = std::ldexp(1.0, -std::ilogb(length));
  for (EdgeSource& s : sources_) {
    s.offset += offset.of(s.generator);
    s.begin = std::max(s.begin, 0.0);
    s.end = std::min(s.end, length);
  }
  segments_.assign(1, {length, 0});
  for (std::size_t i = 1; i < sources_.size(); ++i) insert(static_cast<std::int32_t>(i));
}

double EdgeEnvelope::distance(GeneratorId g, double t) const {
  double least = std::numeric_limits<double>::infinity();
  for (const EdgeSource& s : sources_) {
    if (s.generator == g) least = std::min(least, s.distance(t));
  }
  return least;
}

void EdgeEnvelope::append(double end, std::int32_t source) {
  if (!pieces_.empty() && pieces_.back().source == source) {
    pieces_.back().end = end;
  } else {
    pieces_.push_back({end, source});
  }
}

/// Gives `source` the parts of its interval on which it is nearer than all before.
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
    is_nearer |= append_nearer(next->source, source, low, high);
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

/// Appends the nearer one of two sources from `begin` to `end`. Returns whether that is the new one anywhere.
bool EdgeEnvelope::append_nearer(std::int32_t old_source, std::int32_t source, double begin, double end) {
  const EdgeSource &o = sources_[static_cast<std::size_t>(old_source)], &s = sources_[static_cast<std::size_t>(source)];
  const Nearer nearer = compare_sources(o, s, begin, end);
  if (nearer == Nearer::open) return append_nearer_pieces(old_source, source, begin, end);
  append(end, nearer == Nearer::first ? old_source : source);
  return nearer == Nearer::second;
}

/// The same, piece by piece between the positions where the two are equally far.
bool EdgeEnvelope::append_nearer_pieces(std::int32_t old_source, std::int32_t source, double begin, double end) {
  const EdgeSource &o = sources_[static_cast<std::size_t>(old_source)], &s = sources_[static_cast<std::size_t>(source)];
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
