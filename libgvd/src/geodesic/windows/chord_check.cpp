// Bounds of the distance on a straight piece inside a face.
//
// Idea: along a line, the paths of one source are not longer than a limit on one interval, and its ends follow in
// closed form. So does the least length. No path is too short, and the intervals cover the chord: then the least of all
// lengths is between the limits on all of it.
// Source: intervals of windows, as in Mitchell, Mount and Papadimitriou (1987).
// Invariant: each part is one of paths of the surface: straight where the image sees the chord through the opening,
// round an end of the opening beside that.
#include "geodesic/windows/chord_check.hpp"

#include <algorithm>
#include <cmath>

namespace gvd {

void ChordCheck::begin(const PlaneSegment& chord, double least, double most) {
  chord_ = chord;
  way_ = chord.to - chord.from;
  square_ = way_.squaredNorm();
  least_ = least;
  most_ = most;
  parts_.clear();
}

bool ChordCheck::add(const FaceSource& s) {
  if (s.is_corner) return add_paths_from(s.image, s.offset, {});
  Part straight, round_begin, round_end;
  const double at_begin = s.beside(chord_.from, s.begin), past_begin = s.beside(chord_.to, s.begin) - at_begin;
  const double at_end = s.beside(chord_.from, s.end), past_end = s.beside(chord_.to, s.end) - at_end;
  straight.clip(at_begin, past_begin);
  straight.clip(-at_end, -past_end);
  round_begin.clip(-at_begin, -past_begin);
  round_end.clip(at_end, past_end);
  return (s.is_parallel() ? add_parallel_paths(s, straight) : add_paths_from(s.image, s.offset, straight)) &&
         add_paths_from(s.begin, s.distance_begin, round_begin) && add_paths_from(s.end, s.distance_end, round_end);
}

bool ChordCheck::add_paths_from(const Vec2& point, double offset, Part part) {
  if (part.begin > part.end) return true;
  const Vec2 ray = chord_.from - point;
  const double foot = -ray.dot(way_) / square_, most = most_ - offset, least = least_ - offset;
  const double square_depth = (ray + foot * way_).squaredNorm();  // of the point, from the chord's line
  if (most < 0 || square_depth > most * most) return true;
  const double beside = foot - std::clamp(foot, part.begin, part.end);
  if (least > 0 && square_depth + beside * beside * square_ < least * least) return false;
  const double half = std::sqrt((most * most - square_depth) / square_);
  part.begin = std::max(part.begin, foot - half);
  part.end = std::min(part.end, foot + half);
  if (part.begin <= part.end) parts_.push_back(part);
  return true;
}

bool ChordCheck::add_parallel_paths(const FaceSource& s, Part part) {
  if (part.begin > part.end) return true;
  const double at_from = s.straight_parallel(chord_.from), rise = s.image.dot(way_);
  if (std::min(at_from + part.begin * rise, at_from + part.end * rise) < least_) return false;
  part.clip(most_ - at_from, -rise);
  if (part.begin <= part.end) parts_.push_back(part);
  return true;
}

bool ChordCheck::is_covered(double seam) {
  std::ranges::sort(parts_, {}, &Part::begin);
  double covered = 0;
  const double gap = seam / std::sqrt(square_);
  for (const Part& part : parts_) {
    if (part.begin > covered + gap) return false;
    covered = std::max(covered, part.end);
  }
  return covered >= 1 - gap;
}

}  // namespace gvd
