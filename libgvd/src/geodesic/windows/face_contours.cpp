// Curves of equal distance inside a face, in closed form.
//
// Idea: in the plane of a face, each source reaches a convex region within a level: a part of a disc round its image,
// as far as the opening lets straight paths through, and discs round the opening's ends beside it; behind a segment of
// a curve, a half-plane. What lies within the level is their union. So a curve of equal distance follows the boundary
// of one region until it enters another one, at a corner, or leaves the face. It can turn only where the
// circles and lines of two boundaries intersect; between two such places, one point tells what happens.
// On fine meshes a few chords do: they are tried first, and ChordCheck tells whether they are near enough.
// The sides' crossings are given. Where rounding keeps a curve from ending at one of them, the face is cut in two, and
// both cells share the crossings on the cut. In a cell as small as the tolerance, any way to join them will do.
// A curve that closes inside a face surrounds a hole in the union. There is none where at most two regions matter,
// where all contain a common corner, or where the distance rises in one direction; other cells are cut in two.
// Source: the union of discs is that of alpha shapes (Edelsbrunner, The union of balls and its dual shape, 1995).
// Invariant: the states of a cell's corners and the crossings of its sides agree, so that crossings alternate. A
// segment's crossings are found once, and both cells beside it have them.
#include "geodesic/windows/face_contours.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "geodesic/windows/path_directions.hpp"

namespace gvd {
namespace {

/// Rounding of distances and positions, relative to level and face: distances are right to 1e-13.
constexpr double kRounding = 1e-12;

/// The share of the tolerance that chords of arcs take.
constexpr double kChordShare = 0.9;

/// The share of the tolerance by which the end of a curve may miss the crossing that it is joined to. Distances change
/// at most as fast as points move, so the joining piece is off by no more.
constexpr double kJoinShare = 0.05;

/// Circles whose common chord has a negative square touch, up to this fraction of the radius' square. A point too many
/// costs only time: it is tried, and the curve does not turn there.
constexpr double kTouching = 1e-9;

/// Chords of an arc turn by this angle at most, radians, so that a small circle is no triangle.
constexpr double kWidestChord = std::numbers::pi / 6;

/// A curve is halved so often before its arcs are followed. Most faces of fine meshes need two to eight chords; sixteen
/// halvings close in on a corner that was not found until the chord over it is near enough.
constexpr int kMostChordHalvings = 16;

/// Sine of the turn from which on a corner is looked for.
constexpr double kSharpCorner = 0.03;

/// A point beside the level is moved onto it at most so often. Once is enough unless another source is nearer there.
constexpr int kMostMoves = 4;

constexpr double kFullTurn = 2 * std::numbers::pi;  // radians

/// The angle from a to b, counter-clockwise, in [0, 2 pi).
double turn(const Vec2& a, const Vec2& b) {
  const double angle = std::atan2(cross(a, b), a.dot(b));
  return angle < 0 ? angle + kFullTurn : angle;
}

double distance_to_segment(const PlaneSegment& segment, const Vec2& p) {
  const Vec2 way = segment.to - segment.from;
  const double square = way.squaredNorm();
  const double t = square > 0 ? std::clamp((p - segment.from).dot(way) / square, 0.0, 1.0) : 0;
  return (p - segment.from - t * way).norm();
}

}  // namespace

/// A part of a region's boundary, from a place on it to its end, by angle or length.
class FaceContours::PartOfWay {
 public:
  PartOfWay(const Region& region, std::size_t part, const Vec2& at) : carrier_(region.part[part]), from_(at) {
    const FaceSource& s = *region.source;
    if (carrier_.kind == Carrier::Kind::line) {
      // Along the front, to the path through the left end.
      end_ = std::max(0.0, (s.begin - at).dot(carrier_.along));
      return;
    }
    start_ = at - carrier_.at;
    angle_ = std::atan2(start_.y(), start_.x());
    if (s.is_corner || part == 2) {
      end_ = s.is_corner ? kFullTurn : std::numbers::pi;
      return;
    }
    const Vec2 through_end = s.is_parallel() ? s.image : Vec2((part == 0 ? s.end : s.begin) - s.image);
    end_ = turn(start_, through_end);
    if (end_ > std::numbers::pi) end_ = 0;  // rounding: already there
  }

  double end() const { return end_; }
  Vec2 at(double t) const {
    if (carrier_.kind == Carrier::Kind::line) return from_ + t * carrier_.along;
    return carrier_.at + carrier_.radius * unit_vector(angle_ + t);
  }
  double position(const Vec2& p) const {
    return carrier_.kind == Carrier::Kind::line ? (p - from_).dot(carrier_.along) : turn(start_, p - carrier_.at);
  }
  /// Number of chords up to t that stay so near to the arc.
  int chords(double t, double sagitta) const {
    if (carrier_.kind == Carrier::Kind::line) return 1;
    const double widest = 2 * std::acos(std::max(0.0, 1 - sagitta / carrier_.radius));
    return std::max(1, int(std::ceil(t / std::min(widest, kWidestChord))));
  }

 private:
  const Carrier& carrier_;
  Vec2 from_, start_ = Vec2::Zero();
  double angle_ = 0, end_ = 0;
};

/// Calls visit(p) for the common points of two carriers, or their nearest ones where they almost touch.
template <class Visit>
void FaceContours::intersect(const Carrier& a, const Carrier& b, const Visit& visit) {
  using Kind = Carrier::Kind;
  if (a.kind == Kind::none || b.kind == Kind::none) return;
  if (a.kind == Kind::line && b.kind == Kind::line) {
    const double denominator = cross(a.along, b.along);
    if (denominator != 0) visit(Vec2(a.at + cross(b.at - a.at, b.along) / denominator * a.along));
    return;
  }
  if (b.kind == Kind::line) return intersect(b, a, visit);
  // A line and a circle, or two circles, which intersect where the first one and the line of their chord do. `foot` is
  // the chord's middle, `along` its direction.
  const bool is_line = a.kind == Kind::line;
  const Vec2 way = b.at - a.at;
  const double square_apart = way.squaredNorm(), sum = a.radius + b.radius, difference = a.radius - b.radius;
  if (!is_line) {  // most circles are far apart, or one is inside the other
    const double slack = kTouching * sum * sum;
    if (square_apart == 0 || square_apart > sum * sum + slack || square_apart < difference * difference - slack) return;
  }
  const double apart = std::sqrt(square_apart);
  const Vec2 along = is_line ? a.along : Vec2(turned_left(way) / apart);
  const double radius = is_line ? b.radius : a.radius;
  const double from_centre = is_line ? cross(a.along, way) : 0.5 * (apart + difference * (sum / apart));
  const double square = (radius - from_centre) * (radius + from_centre);
  if (!(square >= -kTouching * radius * radius)) return;
  const Vec2 foot = is_line ? Vec2(a.at + way.dot(along) * along) : Vec2(a.at + from_centre / apart * way);
  const double half = std::sqrt(std::max(0.0, square));
  visit(Vec2(foot - half * along));
  visit(Vec2(foot + half * along));
}

void FaceContours::enter(const FaceLayout& layout, std::span<const FaceSource> sources) {
  layout_ = &layout;
  longest_ = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest_ = std::max(longest_, (layout.corner[(i + 1) % 3] - layout.corner[i]).norm());
  }
  // A corner to which a window brings its distance adds nothing: no path over it is shorter than the window's own.
  sources_.clear();
  for (const FaceSource& s : sources) {
    const double known = s.offset + kRounding * (s.offset + longest_);
    const bool is_beaten = s.is_corner && std::ranges::any_of(sources, [&](const FaceSource& other) {
                             return !other.is_corner && other.distance(s.image) <= known;
                           });
    if (!is_beaten) sources_.push_back(s);
  }
}

void FaceContours::trace(double level, const std::array<bool, 3>& is_near, std::span<const SideCrossing> crossings,
                         std::vector<FaceContour>& found) {
  level_ = level;
  rounding_ = kRounding * (level + longest_);
  chord_ = std::max(kChordShare * tolerance_, rounding_);
  join_ = std::max(kJoinShare * tolerance_, 2 * rounding_);
  regions_.clear();
  stack_.clear();
  for (const FaceSource& s : sources_) {
    Region region{&s, {}};
    region.part[1] = s.is_parallel()
                         ? Carrier::line(s.begin + (level - s.distance_begin) * s.image, turned_left(s.image))
                         : Carrier::circle(s.image, level - s.offset);
    if (!s.is_corner) {
      region.part[0] = Carrier::circle(s.end, level - s.distance_end);
      region.part[2] = Carrier::circle(s.begin, level - s.distance_begin);
    }
    stack_.push_back(std::int32_t(regions_.size()));
    regions_.push_back(region);
  }
  pieces_.clear();
  inner_.clear();
  side_crossings_ = std::int32_t(crossings.size());
  visit({.corner = layout_->corner, .is_near = is_near, .crossings = {crossings.begin(), crossings.end()}},
        {0, stack_.size()});
  join_pieces(crossings, found);
}

/// The part of a region's boundary on which p lies.
std::size_t FaceContours::part_at(const Region& region, const Vec2& p) {
  const FaceSource& s = *region.source;
  if (s.is_corner || (s.beside(p, s.begin) >= 0 && s.beside(p, s.end) <= 0)) return 1;
  return s.beside(p, s.begin) < 0 ? 2 : 0;
}

/// The nearest source of some regions; -1 where there is none.
std::int32_t FaceContours::nearest(const Range& regions, const Vec2& p, double& distance) const {
  std::int32_t best = -1;
  distance = kInfinity;
  for (std::size_t i = regions.begin; i < regions.end; ++i) {
    // No path is shorter than the straight line from the image: mostly this tells, without a square root.
    const FaceSource& s = *regions_[stack_[i]].source;
    const double left = distance - s.offset;
    if (left <= 0 || (p - s.image).squaredNorm() >= left * left) continue;
    const double d = s.distance(p);
    if (!(d < distance)) continue;
    distance = d;
    best = stack_[i];
  }
  return best;
}

/// Returns the length of the longest one.
double FaceContours::Cell::set_sides() {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    side[i] = after(i) - corner[i];
    const double length = side[i].norm();
    side[i] /= length;
    longest = std::max(longest, length);
  }
  return longest;
}

void FaceContours::visit(Cell cell, const Range& candidates) {
  const Range regions = keep_relevant(cell, candidates);
  const bool is_simple = has_no_hole(cell, regions);
  if (cell.set_sides() <= chord_) {
    pair(cell);
  } else if (!cell.crossings.empty() ? !(is_simple && follow_all(cell, regions)) : cell.is_near[0] && !is_simple) {
    split(cell, regions);
  }
  stack_.resize(regions.begin);
}

/// The regions that reach the cell and may be the nearest in it. They are put on the stack.
FaceContours::Range FaceContours::keep_relevant(const Cell& cell, const Range& candidates) {
  const Vec2 centre = (cell.corner[0] + cell.corner[1] + cell.corner[2]) / 3;
  double radius = rounding_, least = kInfinity;
  for (const Vec2& corner : cell.corner) radius = std::max(radius, (corner - centre).norm() + rounding_);
  paths_.clear();
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) {
    paths_.push_back(regions_[stack_[i]].source->shortest_path(centre));
    least = std::min(least, paths_.back().distance);
  }
  // Distances of one source are convex, so the tangent plane in the middle bounds them from below.
  const auto lowest = [&](const FaceSource::Path& path) {
    const Vec2 last = centre - path.from;
    const double length = last.norm();
    if (!(length > rounding_)) return path.distance - radius;
    const auto rise = [&](const Vec2& corner) { return last.dot(corner - centre) / length; };
    return path.distance + std::min({rise(cell.corner[0]), rise(cell.corner[1]), rise(cell.corner[2])});
  };
  const std::size_t begin = stack_.size();
  for (std::size_t i = candidates.begin; i < candidates.end; ++i) {
    const FaceSource::Path& path = paths_[i - candidates.begin];
    if (path.distance <= least + 2 * radius && lowest(path) <= level_ + chord_ + join_) stack_.push_back(stack_[i]);
  }
  return {begin, stack_.size()};
}

/// Whether the regions' union surely has no hole inside the cell. Two convex regions never enclose one. Regions with a
/// common point are seen from there without a gap. And inside a hole the distance has a maximum.
bool FaceContours::has_no_hole(const Cell& cell, const Range& regions) const {
  if (regions.end - regions.begin <= 2) return true;
  const std::span<const std::int32_t> all(stack_.data() + regions.begin, regions.end - regions.begin);
  const auto holds = [&](std::int32_t r, const Vec2& p) { return regions_[r].source->distance(p) <= level_; };
  const auto is_common = [&](const Vec2& p) { return std::ranges::all_of(all, [&](auto r) { return holds(r, p); }); };
  const auto covers = [&](auto r) { return std::ranges::all_of(cell.corner, [&](auto& p) { return holds(r, p); }); };
  return std::ranges::any_of(cell.corner, is_common) || std::ranges::any_of(all, covers) ||
         rises_one_way(cell, regions);
}

/// The directions of the paths to points of the cell. Behind a vertex where paths bend, those round an opening's end
/// count: at the corners that they are the shortest to.
std::vector<Directions> FaceContours::list_directions(const Cell& cell, const Range& regions) const {
  std::vector<Directions> found;
  for (std::size_t i = regions.begin; i < regions.end; ++i) {
    if (const auto own = directions_of(*regions_[stack_[i]].source, cell.corner)) found.push_back(*own);
  }
  for (const Vec2& corner : cell.corner) {
    double distance = kInfinity;
    const FaceSource& s = *regions_[nearest(regions, corner, distance)].source;
    if (const Vec2 last = direction_of(s, corner); !s.is_corner && !last.isZero(0)) found.push_back({last, last});
  }
  return found;
}

/// Whether all paths to points of the cell have a component in one direction: then the distance has no maximum inside.
bool FaceContours::rises_one_way(const Cell& cell, const Range& regions) const {
  const std::vector<Directions> found = list_directions(cell, regions);
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

bool FaceContours::follow_all(const Cell& cell, const Range& regions) {
  const std::size_t before = pieces_.size();
  is_taken_.assign(cell.crossings.size(), false);
  for (const SideCrossing& start : cell.crossings) {
    if (!start.leaves) continue;
    FaceContour piece{start.id, FaceContour::kClosed, {}};
    if (cell.crossings.size() == 2) {
      const SideCrossing& end = cell.crossings[cell.crossings[0].leaves ? 1 : 0];
      piece.to = end.id;
      double distance = kInfinity;
      const CurvePoint from{start.at, nearest(regions, start.at, distance)},
          to{end.at, nearest(regions, end.at, distance)};
      if (add_chords(cell, regions, from, to, kMostChordHalvings, piece.points)) {
        pieces_.push_back(std::move(piece));
        continue;
      }
      piece.points.clear();
    }
    if (!follow(cell, regions, start, piece)) {
      pieces_.resize(before);
      return false;
    }
    pieces_.push_back(std::move(piece));
  }
  return true;
}

/// Adds the points between two points of a curve that needs no more than a few chords. Without arcs this is several
/// times as fast, and serves nearly all faces of fine meshes. False where chords may not be near enough to the level.
bool FaceContours::add_chords(const Cell& cell, const Range& regions, const CurvePoint& from, const CurvePoint& to,
                              int halvings, std::vector<Vec2>& points) {
  if (from.region < 0 || to.region < 0) return false;
  // The middle of a chord that is too long is mostly off the level: one distance tells.
  const Vec2 halfway = 0.5 * (from.at + to.at);
  double distance = kInfinity;
  const std::int32_t at_halfway = nearest(regions, halfway, distance);
  if (std::abs(distance - level_) <= chord_ && is_on_level(regions, {from.at, to.at})) return true;
  if (halvings == 0) return false;
  // On its two sides, a corner is a point of the one source and of the other.
  const auto go_on = [&](const CurvePoint& end, const CurvePoint& begin) {
    if (!add_chords(cell, regions, from, end, halvings - 1, points)) return false;
    points.push_back(end.at);
    return add_chords(cell, regions, begin, to, halvings - 1, points);
  };
  if (const auto corner = find_corner(cell, regions, from, to)) {
    return go_on({*corner, from.region}, {*corner, to.region});
  }
  const auto middle = find_on_level(cell, regions, {halfway, at_halfway}, distance);
  return middle && go_on(*middle, *middle);
}

/// Whether the distance surely stays as near to the level as a chord may be.
bool FaceContours::is_on_level(const Range& regions, const PlaneSegment& chord) {
  check_.begin(chord, level_ - chord_, level_ + chord_);
  for (std::size_t i = regions.begin; i < regions.end; ++i) {
    if (!check_.add(*regions_[stack_[i]].source)) return false;
  }
  return check_.is_covered(rounding_);
}

/// The corner between the two ends of a chord, where their nearest sources are equally near. None where it is blunt:
/// then any point between will do.
std::optional<Vec2> FaceContours::find_corner(const Cell& cell, const Range& regions, const CurvePoint& from,
                                              const CurvePoint& to) const {
  if (from.region == to.region) return std::nullopt;
  const Region &first = regions_[from.region], &second = regions_[to.region];
  if (cross(direction_of(*first.source, from.at), direction_of(*second.source, to.at)) > -kSharpCorner) {
    return std::nullopt;
  }
  double distance = kInfinity;
  std::optional<Vec2> corner;
  intersect(first.part[1], second.part[1], [&](const Vec2& p) {
    if (cell.outside(p) > rounding_) return;
    nearest(regions, p, distance);
    if (std::abs(distance - level_) <= rounding_) corner = p;
  });
  return corner;
}

/// The point on the level that a straight path leads to, from a point beside it or on to there. `distance`: of the
/// point. None outside the cell.
std::optional<FaceContours::CurvePoint> FaceContours::find_on_level(const Cell& cell, const Range& regions,
                                                                    CurvePoint p, double distance) const {
  for (int i = 0; i < kMostMoves; ++i) {
    if (p.region < 0 || cell.outside(p.at) > rounding_) return std::nullopt;
    if (std::abs(distance - level_) <= rounding_) return p;
    p.at += (level_ - distance) * direction_of(*regions_[p.region].source, p.at);
    p.region = nearest(regions, p.at, distance);
  }
  return std::nullopt;
}

/// Follows the boundary of the union from a crossing through the cell. False where rounding prevents it.
bool FaceContours::follow(const Cell& cell, const Range& regions, const SideCrossing& start, FaceContour& piece) {
  double distance = kInfinity;
  Place place{nearest(regions, start.at, distance), 0, start.at};
  if (!(std::abs(distance - level_) <= join_)) return false;
  place.part = part_at(regions_[place.region], place.at);
  // Each part of each boundary is followed at most once, unless rounding leads in a circle.
  const std::size_t most = 4 * (regions.end - regions.begin) + 4;
  for (std::size_t step = 0; step < most; ++step) {
    if (regions_[place.region].part[place.part].kind == Carrier::Kind::none) return false;
    const Stop stop = advance(cell, regions, place, piece.points);
    if (stop == Stop::leaves_cell) return end_at_crossing(cell, start.at, place.at, piece);
    append(piece.points, place.at);
    if (stop == Stop::part_ends) {
      if (place.part == 2 || regions_[place.region].source->is_corner) return false;
      ++place.part;
    } else {
      place.part = part_at(regions_[place.region], place.at);
    }
  }
  return false;
}

/// Goes on to where the part of the region's boundary ends, or leaves the cell, or enters another region: that one is
/// the place's region then. Appends the points before.
FaceContours::Stop FaceContours::advance(const Cell& cell, const Range& regions, Place& place,
                                         std::vector<Vec2>& points) {
  const Region& region = regions_[place.region];
  const PartOfWay way(region, place.part, place.at);
  stops_.clear();
  const auto add = [&](const Vec2& p) {
    if (cell.outside(p) > join_) return;  // most are: the curve leaves the cell before
    const double t = way.position(p);
    if (t > 0 && t < way.end()) stops_.push_back(t);
  };
  const Carrier& own = region.part[place.part];
  for (std::size_t i = 0; i < 3; ++i) {
    intersect(own, Carrier::line(cell.corner[i], cell.side[i]), add);
  }
  for (std::size_t i = regions.begin; i < regions.end; ++i) {
    if (stack_[i] == place.region) continue;
    for (const Carrier& other : regions_[stack_[i]].part) intersect(own, other, add);
  }
  std::ranges::sort(stops_);
  stops_.push_back(way.end());
  double at = 0;
  Stop stop = Stop::part_ends;
  for (const double next : stops_) {
    const Vec2 middle = way.at(0.5 * (at + next));
    double distance = kInfinity;
    const std::int32_t other = nearest(regions, middle, distance);
    if (cell.outside(middle) > rounding_) stop = Stop::leaves_cell;
    if (stop == Stop::part_ends && distance < level_ - rounding_) {
      stop = Stop::enters_region;
      place.region = other;
    }
    if (stop != Stop::part_ends) break;
    at = next;
  }
  const int chords = way.chords(at, chord_);
  for (int i = 1; i < chords; ++i) append(points, way.at(at * i / chords));
  place.at = way.at(at);
  return stop;
}

/// Ends a curve that leaves the cell at the crossing there. Where the curve runs along a side, which is on the level,
/// rounding decides where the crossings are: then it is one that the curve has passed.
bool FaceContours::end_at_crossing(const Cell& cell, const Vec2& start, const Vec2& exit, FaceContour& piece) {
  std::optional<std::size_t> best;
  const auto is_open = [&](std::size_t i) { return !cell.crossings[i].leaves && !is_taken_[i]; };
  double least = join_;
  for (std::size_t i = 0; i < cell.crossings.size(); ++i) {
    const double off = is_open(i) ? (cell.crossings[i].at - exit).norm() : kInfinity;
    if (!(off <= least)) continue;
    least = off;
    best = i;
  }
  std::vector<Vec2>& points = piece.points;
  for (std::size_t k = 0; !best && k <= points.size(); ++k) {
    const PlaneSegment segment{k == 0 ? start : points[k - 1], k == points.size() ? exit : points[k]};
    for (std::size_t i = 0; !best && i < cell.crossings.size(); ++i) {
      if (is_open(i) && distance_to_segment(segment, cell.crossings[i].at) <= join_) best = i;
    }
    if (best) points.resize(k);
  }
  if (!best) return false;
  is_taken_[*best] = true;
  piece.to = cell.crossings[*best].id;
  while (!points.empty() && (points.back() - cell.crossings[*best].at).norm() <= rounding_) points.pop_back();
  return true;
}

/// Joins the crossings of a cell by straight pieces. Curves do not cross each other.
void FaceContours::pair(const Cell& cell) {
  const std::size_t n = cell.crossings.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (cell.crossings[i].leaves) pieces_.push_back({cell.crossings[i].id, cell.crossings[(i + n - 1) % n].id, {}});
  }
}

/// Cuts a cell in two, from the middle of its longest side.
void FaceContours::split(const Cell& cell, const Range& regions) {
  std::size_t first = 0;
  const auto length = [&](std::size_t i) { return (cell.after(i) - cell.corner[i]).squaredNorm(); };
  for (std::size_t i = 1; i < 3; ++i) {
    if (length(i) > length(first)) first = i;
  }
  const std::size_t second = (first + 1) % 3, third = (first + 2) % 3;
  const Vec2 &a = cell.corner[first], &b = cell.corner[second], &c = cell.corner[third];
  const Vec2 middle = 0.5 * (a + b), along = b - a;
  std::array<std::vector<SideCrossing>, 3> of_side;
  for (const SideCrossing& crossing : cell.crossings) of_side[crossing.side].push_back(crossing);
  std::vector<SideCrossing>& halved = of_side[first];
  const auto beyond = std::find_if(halved.begin(), halved.end(), [&](const SideCrossing& crossing) {
    return (crossing.at - middle).dot(along) >= 0;
  });
  const bool near_middle = cell.is_near[first] != ((beyond - halved.begin()) % 2 == 1);
  std::vector<SideCrossing> cut = cross_segment({middle, c}, near_middle, cell.is_near[third], regions);

  const auto take = [](Cell& to, auto begin, auto end, std::int32_t side) {
    for (; begin != end; ++begin) {
      to.crossings.push_back(*begin);
      to.crossings.back().side = side;
    }
  };
  Cell left{
      .corner = {a, middle, c}, .is_near = {cell.is_near[first], near_middle, cell.is_near[third]}, .crossings = {}};
  take(left, halved.begin(), beyond, 0);
  take(left, cut.begin(), cut.end(), 1);
  take(left, of_side[third].begin(), of_side[third].end(), 2);
  Cell right{
      .corner = {middle, b, c}, .is_near = {near_middle, cell.is_near[second], cell.is_near[third]}, .crossings = {}};
  take(right, beyond, halved.end(), 0);
  take(right, of_side[second].begin(), of_side[second].end(), 1);
  for (SideCrossing& crossing : cut) crossing.leaves = !crossing.leaves;
  take(right, cut.rbegin(), cut.rend(), 2);
  visit(std::move(left), regions);
  visit(std::move(right), regions);
}

/// The crossings of a segment between two cells, from its begin on. They agree with the states of its ends.
std::vector<SideCrossing> FaceContours::cross_segment(const PlaneSegment& segment, bool near_at_begin, bool near_at_end,
                                                      const Range& regions) {
  const double length = (segment.to - segment.from).norm();
  const Carrier line = Carrier::line(segment.from, (segment.to - segment.from) / length);
  stops_.clear();
  for (std::size_t i = regions.begin; i < regions.end; ++i) {
    for (const Carrier& part : regions_[stack_[i]].part) {
      intersect(line, part, [&](const Vec2& p) {
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
    nearest(regions, line.at + 0.5 * (at + next) * line.along, distance);
    cross_to(distance <= level_, at);
    at = next;
  }
  cross_to(near_at_end, length);
  return found;
}

/// Joins the pieces of all cells to curves: those that begin at a crossing of a side, then the closed ones.
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
    do {
      if (is_inner(curve.to)) append(curve.points, inner_[curve.to - side_crossings_]);
      const FaceContour& piece = pieces_[std::exchange(leaving[curve.to], -1)];
      for (const Vec2& p : piece.points) append(curve.points, p);
      curve.to = piece.to;
    } while (is_inner(curve.to) && leaving[curve.to] >= 0);
    if (is_closed) curve.from = curve.to = FaceContour::kClosed;
    found.push_back(std::move(curve));
  }
}

}  // namespace gvd
