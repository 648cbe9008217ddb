// Curves of equal distance inside a face, in closed form.
//
// Idea: in the plane of a face, each source reaches a convex region within a level: a part of a disc round its image,
// as far as the opening lets straight paths through, and discs round the opening's ends beside it; behind a segment of
// a curve, a half-plane. The points within the level form the union of these regions. A curve of equal distance
// therefore follows the boundary of one region until it enters another region, at a corner, or leaves the face. It can
// turn only where the circles and lines of two boundaries intersect; between two such places, one point tells what
// happens.
// Most sources can't come near an arc, as the tangent plane of their distance at the arc's middle shows; the remaining
// sources are the arc's rivals. On fine meshes, few arcs have rivals other than the source of the next arc.
// The crossings of the sides are given. If rounding keeps a curve from ending at one of them, the face is cut in two,
// and both triangles share the crossings on the cut. In a triangle as small as the tolerance, crossings may be joined
// in any way. A curve that closes inside a face surrounds a hole in the union. There is no hole if at most two regions
// matter, if all regions contain a common corner, or if the distance rises in one direction; any other triangle is cut
// in two.
// Source: the union of discs is that of alpha shapes (Edelsbrunner, The union of balls and its dual shape, 1995).
// Invariant: the states of a triangle's corners and the crossings of its sides agree, so that crossings alternate. The
// crossings of a segment are found once, and both triangles beside it share them.
#include "geodesic/windows/face_contours.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "geodesic/nearest_source.hpp"
#include "geodesic/windows/path_directions.hpp"
#include "geodesic/windows/window_geometry.hpp"

namespace gvd {
namespace {

/// Bound on the rounding error of distances and positions, relative to the level and the face. Distances have a
/// relative error of 1e-13.
constexpr double kRounding = 1e-12;

/// The share of the tolerance that chords of arcs may take.
constexpr double kChordShare = 0.9;

/// The share of the tolerance by which the end of a curve may miss the crossing that it is joined to. Distances change
/// at most as fast as points move, so the joining piece is off by no more.
constexpr double kJoinShare = 0.05;

/// A corner at which a curve turns by more than an angle with this sine is always one of its points, even if a chord
/// could pass it by.
constexpr double kSharpCorner = 0.03;

/// If the turn from one arc to the arc of the next source has at most this sine, the curve continues smoothly there.
/// The way is checked in any case: this only saves looking at the part of a boundary that turns away at once.
constexpr double kSmooth = 1e-6;

/// Straight paths that pass an arc at more than this distance, relative to the longest side, don't reach it. This is
/// far above the rounding error of paths, so that the next window is always seen from the end of an arc.
constexpr double kSeen = 1e-9;

}  // namespace

void FaceContours::enter(const FaceLayout& layout, std::span<const FaceSource> sources) {
  layout_ = &layout;
  sources_ = sources;
  longest_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest_ = std::max(longest_, (layout.corner[(i + 1) % 3] - layout.corner[i]).norm());
  }
  stack_.clear();
  for (std::size_t i = 0; i < sources.size(); ++i) stack_.push_back({std::int32_t(i), {}, 0});
  const Range kept = keep_relevant(layout.corner, {0, stack_.size()}, kInfinity);
  of_face_.assign(stack_.begin() + std::ptrdiff_t(kept.begin), stack_.end());
  // A corner to which a window brings its distance adds nothing: no path over it is shorter than the window's own.
  std::array<double, 3> by_windows{kInfinity, kInfinity, kInfinity};
  for (const Candidate& c : of_face_) {
    if (sources[c.source].is_corner()) continue;
    for (std::size_t i = 0; i < 3; ++i) by_windows[i] = std::min(by_windows[i], c.at_corner[i]);
  }
  // Such corners are kept apart, because paths round the ends of openings at a corner are paths over it.
  beaten_corners_.clear();
  std::erase_if(of_face_, [&](const Candidate& c) {
    const FaceSource& s = sources[c.source];
    const auto i = std::ranges::find(layout.corner, s.image) - layout.corner.begin();
    const bool is_beaten = s.is_corner() && i < 3 && by_windows[i] <= s.offset + kRounding * (s.offset + longest_);
    if (is_beaten) beaten_corners_.push_back(c.source);
    return is_beaten;
  });
}

void FaceContours::trace(double level, const std::array<bool, 3>& is_near, std::span<const SideCrossing> crossings,
                         std::vector<FaceContour>& found) {
  level_ = level;
  rounding_ = kRounding * (level + longest_);
  chord_ = std::max(kChordShare * tolerance_, rounding_);
  join_ = std::max(kJoinShare * tolerance_, 2 * rounding_);
  stack_.clear();
  for (const Candidate& c : of_face_) {
    if (c.lowest <= level + join_) stack_.push_back(c);
  }
  pieces_.clear();
  inner_.clear();
  side_crossings_ = std::int32_t(crossings.size());
  Triangle face{.corner = layout_->corner, .is_near = is_near, .crossings = {crossings.begin(), crossings.end()}};
  visit(face, {0, stack_.size()});
  join_pieces(crossings, found);
}

/// Makes a source the best one if its distance is less than the best distance so far.
void FaceContours::keep_nearer(std::int32_t source, const Vec2& p, std::int32_t& best, double& distance) const {
  FaceSource::Path path{distance, p};
  if (!take_nearer(sources_[source], p, path)) return;
  distance = path.distance;
  best = source;
}

/// The nearest source of some candidates; -1 if there are none.
std::int32_t FaceContours::nearest(const Range& candidates, const Vec2& p, double& distance) const {
  std::int32_t best = -1;
  distance = kInfinity;
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) keep_nearer(stack_[i].source, p, best, distance);
  return best;
}

/// Sets the unit vectors of the sides. Returns the length of the longest side.
double FaceContours::Triangle::set_sides() {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    side[i] = after(i) - corner[i];
    const double length = side[i].norm();
    side[i] /= length;
    longest = std::max(longest, length);
  }
  return longest;
}

void FaceContours::visit(Triangle& triangle, const Range& candidates) {
  const bool is_simple = has_no_hole(triangle, candidates);
  if (triangle.set_sides() <= chord_) {
    pair(triangle);
  } else if (!triangle.crossings.empty() ? !(is_simple && follow_all(triangle, candidates))
                                         : triangle.is_near[0] && !is_simple) {
    split(triangle, candidates);
  }
}

/// Pushes on the stack the candidates that may be the nearest source somewhere in a triangle, at a distance of at most
/// the level. Returns their range.
FaceContours::Range FaceContours::keep_relevant(const std::array<Vec2, 3>& corner, const Range& candidates,
                                                double level) {
  const Vec2 centre = (corner[0] + corner[1] + corner[2]) / 3;
  double radius = 0, least = kInfinity;
  double beaten = kInfinity;  // a source that is farther everywhere is never the nearest
  for (const Vec2& c : corner) radius = std::max(radius, (c - centre).norm());
  const std::size_t begin = stack_.size();
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) {
    Candidate c{stack_[i].source, {}, 0};
    const FaceSource& s = sources_[c.source];
    const FaceSource::Path path = s.shortest_path(centre);
    if (path.distance > least + 2 * radius + kRounding * (least + longest_)) continue;
    least = std::min(least, path.distance);
    // Distances of one source are convex, so the tangent plane in the middle bounds them from below.
    const Vec2 last = centre - path.from;
    const double length = last.norm();
    const auto rise = [&](const Vec2& p) { return last.dot(p - centre) / length; };
    c.lowest =
        path.distance -
        (length > kRounding * longest_ ? -std::min({rise(corner[0]), rise(corner[1]), rise(corner[2])}) : radius);
    if (c.lowest > level + join_) continue;
    for (std::size_t k = 0; k < 3; ++k) c.at_corner[k] = s.distance(corner[k]);
    beaten = std::min(beaten, c.most() + kRounding * (c.most() + longest_));
    stack_.push_back(c);
  }
  stack_.erase(std::remove_if(stack_.begin() + std::ptrdiff_t(begin), stack_.end(),
                              [&](const Candidate& c) { return c.lowest > beaten; }),
               stack_.end());
  return {begin, stack_.size()};
}

/// Whether the union of the regions certainly has no hole inside the triangle. Two convex regions never enclose a hole.
/// The union of convex regions with a common point is star-shaped. And inside a hole, the distance has a maximum.
bool FaceContours::has_no_hole(const Triangle& triangle, const Range& candidates) const {
  const std::span<const Candidate> all(stack_.data() + candidates.begin, candidates.end - candidates.begin);
  if (all.size() <= 2) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::ranges::all_of(all, [&](const Candidate& c) { return c.at_corner[i] <= level_; })) return true;
  }
  return std::ranges::any_of(all, [&](const Candidate& c) { return c.most() <= level_; }) ||
         rises_one_way(triangle, candidates);
}

/// The directions of the paths to points of the triangle. Behind a vertex where paths bend, paths round the end of an
/// opening count, too, at the corners to which they are the shortest.
std::vector<Directions> FaceContours::list_directions(const Triangle& triangle, const Range& candidates) const {
  std::vector<Directions> found;
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) {
    if (const auto own = directions_of(sources_[stack_[i].source], triangle.corner)) found.push_back(*own);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto best = std::min_element(
        stack_.begin() + std::ptrdiff_t(candidates.begin), stack_.begin() + std::ptrdiff_t(candidates.end),
        [&](const Candidate& a, const Candidate& b) { return a.at_corner[k] < b.at_corner[k]; });
    const FaceSource& s = sources_[best->source];
    if (s.is_corner()) continue;
    if (const Vec2 last = direction_of(s, triangle.corner[k]); !last.isZero(0)) found.push_back({last, last});
  }
  return found;
}

/// Whether all paths to points of the triangle have a component in a common direction. Then the distance has no maximum
/// inside.
bool FaceContours::rises_one_way(const Triangle& triangle, const Range& candidates) const {
  const std::vector<Directions> found = list_directions(triangle, candidates);
  if (found.empty()) return true;
  Directions all = found.front();
  for (const Directions& own : found) {
    all.include(own.right);
    all.include(own.left);
  }
  return all.is_below_half_turn() && std::ranges::all_of(found, [&](const Directions& own) {
           return own.is_below_half_turn() && all.contains(own.left) && all.contains(own.right);
         });
}

bool FaceContours::follow_all(const Triangle& triangle, const Range& candidates) {
  const std::size_t before = pieces_.size();
  is_taken_.assign(triangle.crossings.size(), false);
  for (const SideCrossing& start : triangle.crossings) {
    if (!start.leaves) continue;
    FaceContour piece{start.id, FaceContour::kClosed, {}};
    if (!follow(triangle, candidates, start, piece)) {
      pieces_.resize(before);
      return false;
    }
    pieces_.push_back(std::move(piece));
  }
  return true;
}

/// Follows the boundary of the union from a crossing through the triangle. Returns false if rounding prevents it.
bool FaceContours::follow(const Triangle& triangle, const Range& candidates, const SideCrossing& start,
                          FaceContour& piece) {
  double distance = kInfinity;
  Place place{nearest(candidates, start.at, distance), 0, start.at, 0};
  if (!(std::abs(distance - level_) <= join_)) return false;
  place.part = part_at(sources_[place.source], place.at);
  chain_.begin(start.at, chord_, rounding_);
  // Each part of each boundary is followed at most once, unless rounding leads in a circle.
  const std::size_t most = 4 * (candidates.end - candidates.begin) + 4;
  for (std::size_t step = 0; step < most; ++step) {
    if (carrier_of(sources_[place.source], place.part, level_).kind == Carrier::Kind::none) return false;
    const Place before = place;
    const Stop stop = advance(triangle, candidates, place);
    if (stop == Stop::leaves_triangle) return end_at_crossing(triangle, place, piece);
    bool is_corner = false;
    if (stop == Stop::enters_region) {
      const FaceSource &last = sources_[before.source], &next = sources_[place.source];
      is_corner = cross(direction_of(last, place.at), direction_of(next, place.at)) < -kSharpCorner;
      place.part = part_at(next, place.at);
    }
    chain_.add(place.at, place.off, is_corner);
    if (stop == Stop::part_ends && !pass_end(place)) return false;
  }
  return false;
}

/// Collects the sources that may be nearer than the level somewhere on a stretch of the boundary of the region of
/// source `of`.
void FaceContours::list_rivals(const Range& candidates, std::int32_t of, const StretchOfWay& stretch) {
  rivals_.clear();
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) {
    const std::int32_t other = stack_[i].source;
    // Paths round an end of an opening are no shorter than the straight ones of all sources and those over corners.
    const FaceSource& s = sources_[other];
    if (other != of && stretch.may_see(s, kSeen * longest_, level_ + longest_) &&
        stretch.may_reach(s, level_ + rounding_)) {
      rivals_.push_back(other);
    }
  }
  for (const std::int32_t corner : beaten_corners_) {
    if (corner != of && stretch.may_reach(sources_[corner], level_ + rounding_)) rivals_.push_back(corner);
  }
}

/// Collects the positions, ascending, at which a way up to `end` intersects boundaries of rivals in the triangle, and
/// `end` itself.
void FaceContours::list_stops(const Triangle& triangle, const ContourWay& way, double end) {
  stops_.clear();
  const auto stop_at = [&](const Vec2& p) {
    if (triangle.outside(p) > join_) return;
    const double t = way.position(p);
    if (t > 0 && t < end) stops_.push_back(t);
  };
  for (const std::int32_t other : rivals_) {
    for (std::size_t part = 0; part < 3; ++part) {
      intersect(way.carrier(), carrier_of(sources_[other], part, level_), stop_at);
    }
  }
  std::ranges::sort(stops_);
  stops_.push_back(end);
}

/// Moves the place to where the part of the region's boundary ends, leaves the triangle, or enters the region of
/// another source, which then becomes the place's source. Adds the points before it to the chain.
FaceContours::Stop FaceContours::advance(const Triangle& triangle, const Range& candidates, Place& place) {
  const ContourWay way(sources_[place.source], place.part, level_, place.at);
  const Exit exit = find_exit(triangle, way);
  list_rivals(candidates, place.source, StretchOfWay(way, exit.at));
  list_stops(triangle, way, exit.at);
  double at = 0;
  Stop stop = exit.leaves_triangle ? Stop::leaves_triangle : Stop::part_ends;
  for (const double next : stops_) {
    if (rivals_.empty()) break;
    const Vec2 middle = way.at(0.5 * (at + next));
    std::int32_t nearest = -1;
    double distance = level_ - rounding_;
    for (const std::int32_t other : rivals_) keep_nearer(other, middle, nearest, distance);
    if (nearest >= 0) {
      stop = Stop::enters_region;
      place.source = nearest;
      break;
    }
    at = next;
  }
  if (stop != Stop::enters_region) at = exit.at;
  const int chords = way.chords(at, chord_);
  place.off = way.sagitta(at / chords);
  for (int i = 1; i < chords; ++i) chain_.add(way.at(at * i / chords), place.off, false);
  place.at = way.at(at);
  return stop;
}

/// How far a way stays in the triangle, and whether it leaves the triangle there. It may touch a side before.
FaceContours::Exit FaceContours::find_exit(const Triangle& triangle, const ContourWay& way) {
  stops_.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    intersect(way.carrier(), Carrier::line(triangle.corner[i], triangle.side[i]), [&](const Vec2& p) {
      if (triangle.outside(p) > join_) return;  // on the line of a side, but beyond the side
      const double t = way.position(p);
      if (t > 0 && t < way.end()) stops_.push_back(t);
    });
  }
  std::ranges::sort(stops_);
  stops_.push_back(way.end());
  double at = 0;
  for (const double next : stops_) {
    if (triangle.outside(way.at(0.5 * (at + next))) > rounding_) return {at, true};
    at = next;
  }
  return {at, false};
}

/// Continues from the end of a part of a boundary: with the source behind the same end of the opening if its boundary
/// continues there, otherwise with the next part. Returns false if there is none.
bool FaceContours::pass_end(Place& place) const {
  const FaceSource& s = sources_[place.source];
  if (place.part == 2 || s.is_corner()) return false;
  ++place.part;
  if (place.part == 1) return true;
  const Vec2 ahead = turned_left(direction_of(s, place.at));
  for (const std::int32_t other : rivals_) {
    const FaceSource& next = sources_[other];
    const FaceSource::Path path = next.shortest_path(place.at);
    const std::size_t part = part_at(next, place.at);
    const Vec2 last = place.at - path.from;
    if (path.distance > level_ + rounding_ || part == 2 || last.dot(ahead) > kSmooth * last.norm()) continue;
    place.source = other;
    // Two windows share the path through their common end, up to rounding.
    const double sine = next.beside(place.at, next.end) / (next.end - place.at).norm();
    place.part = part == 0 && sine <= kGrazingAngle * (next.is_parallel() ? 1 : level_ - next.offset) ? 1 : part;
    return true;
  }
  return true;
}

/// The crossing nearest to `exit`, within the tolerance of joints, at which no curve ends yet.
std::optional<std::size_t> FaceContours::crossing_at(const Triangle& triangle, const Vec2& exit) const {
  std::optional<std::size_t> best;
  double least = join_;
  for (std::size_t i = 0; i < triangle.crossings.size(); ++i) {
    const double off = is_open(triangle, i) ? (triangle.crossings[i].at - exit).norm() : kInfinity;
    if (!(off <= least)) continue;
    least = off;
    best = i;
  }
  return best;
}

/// The first crossing that the chords between the points pass and at which no curve ends yet. The points behind it are
/// removed.
std::optional<std::size_t> FaceContours::cut_at_passed_crossing(const Triangle& triangle,
                                                                std::vector<Vec2>& points) const {
  for (std::size_t k = 1; k < points.size(); ++k) {
    const PlaneSegment chord{points[k - 1], points[k]};
    for (std::size_t i = 0; i < triangle.crossings.size(); ++i) {
      if (!is_open(triangle, i) || distance_to_segment(chord, triangle.crossings[i].at) > join_) continue;
      points.resize(k + 1);
      return i;
    }
  }
  return std::nullopt;
}

/// Ends a curve at the crossing where it leaves the triangle. If the curve runs along a side, which is on the level,
/// rounding decides where the crossings are, and the curve ends at a crossing that it has passed.
bool FaceContours::end_at_crossing(const Triangle& triangle, const Place& exit, FaceContour& piece) {
  std::vector<Vec2>& points = chain_.points();
  std::optional<std::size_t> end = crossing_at(triangle, exit.at);
  if (end) {
    chain_.add(triangle.crossings[*end].at, exit.off, true);
  } else {
    points.push_back(exit.at);
    end = cut_at_passed_crossing(triangle, points);
  }
  if (!end) return false;
  is_taken_[*end] = true;
  piece.to = triangle.crossings[*end].id;
  // The first and the last point are crossings. The piece stores the points between them.
  if (points.size() > 2) piece.points.assign(points.begin() + 1, points.end() - 1);
  while (!piece.points.empty() && (piece.points.back() - triangle.crossings[*end].at).norm() <= rounding_) {
    piece.points.pop_back();
  }
  return true;
}

/// Joins the crossings of a triangle by straight pieces that don't cross each other.
void FaceContours::pair(const Triangle& triangle) {
  const std::size_t n = triangle.crossings.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (triangle.crossings[i].leaves)
      pieces_.push_back({triangle.crossings[i].id, triangle.crossings[(i + n - 1) % n].id, {}});
  }
}

/// Cuts a triangle in two, through the middle of its longest side.
void FaceContours::split(const Triangle& triangle, const Range& candidates) {
  std::size_t first = 0;
  const auto length = [&](std::size_t i) { return (triangle.after(i) - triangle.corner[i]).squaredNorm(); };
  for (std::size_t i = 1; i < 3; ++i) {
    if (length(i) > length(first)) first = i;
  }
  const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const Vec2 &a = triangle.corner[first], &b = triangle.corner[second], &c = triangle.corner[third];
  const Vec2 middle = 0.5 * (a + b), along = b - a;
  std::array<std::vector<SideCrossing>, 3> of_side;
  for (const SideCrossing& crossing : triangle.crossings) of_side[crossing.side].push_back(crossing);
  std::vector<SideCrossing>& halved = of_side[first];
  const auto beyond = std::find_if(halved.begin(), halved.end(), [&](const SideCrossing& crossing) {
    return (crossing.at - middle).dot(along) >= 0;
  });
  const bool near_middle = triangle.is_near[first] != ((beyond - halved.begin()) % 2 == 1);
  std::vector<SideCrossing> cut = cross_segment({middle, c}, near_middle, triangle.is_near[third], candidates);

  const auto take = [](Triangle& to, auto begin, auto end, std::int32_t side) {
    for (; begin != end; ++begin) {
      to.crossings.push_back(*begin);
      to.crossings.back().side = side;
    }
  };
  Triangle left{.corner = {a, middle, c},
                .is_near = {triangle.is_near[first], near_middle, triangle.is_near[third]},
                .crossings = {}};
  take(left, halved.begin(), beyond, 0);
  take(left, cut.begin(), cut.end(), 1);
  take(left, of_side[third].begin(), of_side[third].end(), 2);
  Triangle right{.corner = {middle, b, c},
                 .is_near = {near_middle, triangle.is_near[second], triangle.is_near[third]},
                 .crossings = {}};
  take(right, beyond, halved.end(), 0);
  take(right, of_side[second].begin(), of_side[second].end(), 1);
  for (SideCrossing& crossing : cut) crossing.leaves = !crossing.leaves;
  take(right, cut.rbegin(), cut.rend(), 2);
  for (Triangle* part : {&left, &right}) {
    const Range kept = keep_relevant(part->corner, candidates, level_);
    visit(*part, kept);
    stack_.resize(kept.begin);
  }
}

/// Finds the crossings of a segment between two triangles, in order from its beginning. They agree with the states of
/// its ends.
std::vector<SideCrossing> FaceContours::cross_segment(const PlaneSegment& segment, bool near_at_begin, bool near_at_end,
                                                      const Range& candidates) {
  const double length = (segment.to - segment.from).norm();
  const Carrier line = Carrier::line(segment.from, (segment.to - segment.from) / length);
  stops_.clear();
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) {
    for (std::size_t part = 0; part < 3; ++part) {
      intersect(line, carrier_of(sources_[stack_[i].source], part, level_), [&](const Vec2& p) {
        const double t = (p - line.at).dot(line.along);
        if (t > 0 && t < length) stops_.push_back(t);
      });
    }
  }
  std::ranges::sort(stops_);
  stops_.push_back(length);
  std::vector<SideCrossing> found;
  bool is_near = near_at_begin;
  const auto cross_to = [&](bool near, double t) {
    if (near == is_near) return;
    found.push_back({side_crossings_ + std::int32_t(inner_.size()), 0, line.at + t * line.along, is_near});
    inner_.push_back(found.back().at);
    is_near = near;
  };
  double at = 0;
  for (const double next : stops_) {
    if (next - at <= rounding_) continue;
    double distance = kInfinity;
    nearest(candidates, line.at + 0.5 * (at + next) * line.along, distance);
    cross_to(distance <= level_, at);
    at = next;
  }
  cross_to(near_at_end, length);
  return found;
}

/// Joins the pieces of all triangles to curves: first curves that begin at a crossing of a side, then closed curves.
void FaceContours::join_pieces(std::span<const SideCrossing> crossings, std::vector<FaceContour>& found) {
  if (inner_.empty()) {
    std::ranges::move(pieces_, std::back_inserter(found));
    return;
  }
  std::vector<std::int32_t> leaving(crossings.size() + inner_.size(), -1);
  for (std::size_t i = 0; i < pieces_.size(); ++i) leaving[pieces_[i].from] = std::int32_t(i);
  for (std::size_t begin = 0; begin < leaving.size(); ++begin) {
    if (leaving[begin] < 0) continue;
    const auto is_inner = [&](std::int32_t id) { return id >= side_crossings_; };
    const bool is_closed = is_inner(std::int32_t(begin));
    FaceContour curve{std::int32_t(begin), std::int32_t(begin), {}};
    const auto append = [&](const Vec2& p) {
      if (curve.points.empty() || (curve.points.back() - p).norm() > rounding_) curve.points.push_back(p);
    };
    do {
      if (is_inner(curve.to)) append(inner_[curve.to - side_crossings_]);
      const FaceContour& piece = pieces_[std::exchange(leaving[curve.to], -1)];
      for (const Vec2& p : piece.points) append(p);
      curve.to = piece.to;
    } while (is_inner(curve.to) && leaving[curve.to] >= 0);
    if (is_closed) curve.from = curve.to = FaceContour::kClosed;
    found.push_back(std::move(curve));
  }
}

}  // namespace gvd
