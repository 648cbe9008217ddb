// Keeps the arcs of a face from intersecting after their refinement.
//
// The straight arcs of an assembly don't intersect, but refined arcs may, where rounding decides. A tree of bounding
// boxes finds all segments that may intersect (may_intersect). Then arcs are simplified one after the other: the arc
// with the most intersections loses its loops, or all of its inner points. In the end all arcs would be straight, so
// this ends, and a face's arcs are disjoint whatever the distances are.
#include "diagram/envelope/separate_arcs.hpp"

#include "base/sort_unique.hpp"

namespace gvd {
namespace {

/// Largest number of points of a polyline for which O(n^2) is cheap. A longer polyline is the result of rounding, with
/// a loop at every other point.
constexpr std::size_t kMostPoints = 1000;

PlaneSegment segment(const Bary& from, const Bary& to) { return {affine_point(from), affine_point(to)}; }

/// The intersection of two segments; the beginning of the second segment if they are collinear.
Bary intersection_point(const Bary& from, const Bary& to, const Bary& begin, const Bary& end) {
  const PlaneSegment s = segment(from, to), o = segment(begin, end);
  const double t = intersect_lines(s.from, s.to - s.from, o.from, o.to - o.from).t;
  return t > 0 && t < 1 ? mix(begin, end, t) : begin;
}

/// Erases the loops that one pass along the polyline finds. Returns false if there are none.
bool erase_once(std::vector<Bary>& polyline) {
  const std::size_t n = polyline.size();
  std::vector<Bary> kept{polyline.front()};
  for (std::size_t i = 1; i < n; ++i) {
    const Bary from = kept.back(), to = polyline[i];
    std::size_t last = n;  // beginning of the last segment that intersects the one to point i
    for (std::size_t j = i + 1; j + 1 < n; ++j) {
      if (may_intersect(segment(from, to), segment(polyline[j], polyline[j + 1]))) last = j;
    }
    if (last == n) {
      kept.push_back(to);
    } else {
      kept.push_back(intersection_point(from, to, polyline[last], polyline[last + 1]));
      i = last;  // continue with the end of that segment
    }
  }
  const bool erased = kept.size() < n;
  polyline = std::move(kept);
  return erased;
}

/// The largest negative area of a piece, as a fraction of the face's area, and the largest overlap of straight arcs, as
/// twice an area in barycentric coordinates, that count as rounding.
constexpr double kInverted = 1e-11;

/// Whether every segment of the arc leads towards its end.
bool advances(const OpenFace& face, const FaceArc& arc) {
  if (arc.point_count < 2) return true;
  Vec2 last = affine_point(face.position(arc.begin));
  const Vec2 end = affine_point(face.position(arc.end)), chord = end - last;
  const auto is_forward = [&](const Vec2& p) { return (p - std::exchange(last, p)).dot(chord) > 0; };
  const auto inner = face.inner_points(arc);
  return std::all_of(inner.begin(), inner.end(), [&](const Bary& p) { return is_forward(affine_point(p)); }) &&
         is_forward(end);
}

/// A quick test, which is false only if no arcs intersect. A single arc can only intersect itself.
bool can_intersect(const OpenFace& face) {
  const auto arcs = face.arcs();
  if (arcs.size() == 1) return !advances(face, arcs.front());
  return std::any_of(arcs.begin(), arcs.end(), [](const FaceArc& arc) { return arc.point_count > 0; });
}

/// Erases the loops of an arc; an arc without loops becomes straight.
void simplify(OpenFace& face, FaceArc& arc) {
  const auto inner = face.inner_points(arc);
  std::vector<Bary> polyline{face.position(arc.begin)};
  polyline.insert(polyline.end(), inner.begin(), inner.end());
  polyline.push_back(face.position(arc.end));
  arc.point_count = 0;
  if (!erase_loops(polyline)) return;
  arc.point_count = static_cast<std::int32_t>(polyline.size()) - 2;
  std::copy(polyline.begin() + 1, polyline.end() - 1, inner.begin());
}

}  // namespace

const std::vector<ArcIntersections::Pair>& ArcIntersections::find(const std::vector<ArcSegment>& segments) {
  found_.clear();
  if (segments.empty()) return found_;
  boxes_.build(segments.size(),
               [&](std::size_t i) { return bounding_box(segments[i].line.from, segments[i].line.to); });
  boxes_.visit_overlaps([&](std::size_t i, std::size_t j) {
    const ArcSegment &s = segments[i], &o = segments[j];
    if (may_intersect(s.line, o.line)) found_.emplace_back(std::min(s.arc, o.arc), std::max(s.arc, o.arc));
  });
  sort_unique(found_);
  return found_;
}

bool erase_loops(std::vector<Bary>& polyline) {
  if (polyline.size() > kMostPoints || !erase_once(polyline)) return false;
  while (erase_once(polyline)) {
    // Rounded intersections may form new loops. Every pass leaves fewer points, so that this ends.
  }
  return true;
}

bool ArcSeparator::separate(OpenFace& face) {
  bool changed = false;
  while (FaceArc* arc = most_intersecting(face)) {
    simplify(face, *arc);
    changed = true;
  }
  return changed;
}

/// The arc with inner points that intersects the most arcs, where an intersection with itself counts twice; null if no
/// arcs intersect.
FaceArc* ArcSeparator::most_intersecting(OpenFace& face) {
  if (!can_intersect(face)) return nullptr;
  collect_segments(face);
  const auto& pairs = intersections_.find(segments_);
  if (pairs.empty()) return nullptr;
  const auto arcs = face.arcs();
  std::vector<int> counts(arcs.size(), 0);
  for (const auto& [first, second] : pairs) {
    ++counts[first];
    ++counts[second];
  }
  FaceArc* most = nullptr;
  int most_count = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (arcs[i].point_count == 0 || counts[i] <= most_count) continue;
    most = &arcs[i];
    most_count = counts[i];
  }
  return most;
}

void ArcSeparator::collect_segments(const OpenFace& face) {
  segments_.clear();
  const auto arcs = face.arcs();
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    Vec2 last = affine_point(face.position(arcs[i].begin));
    const auto append = [&](const Bary& p) {
      segments_.push_back({{last, affine_point(p)}, static_cast<std::int32_t>(i)});
      last = affine_point(p);
    };
    for (const Bary& p : face.inner_points(arcs[i])) append(p);
    append(face.position(arcs[i].end));
  }
}

bool ArcSeparator::is_inverted(const OpenFace& face) {
  straight_.clear();
  for (const FaceArc& arc : face.arcs()) {
    if (arc.point_count > 0) continue;
    straight_.push_back({affine_point(face.position(arc.begin)), affine_point(face.position(arc.end))});
  }
  for (std::size_t i = 0; i < straight_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (intersect_beyond(straight_[i], straight_[j], kInverted)) return true;
    }
  }
  trace_pieces(face.boundary(), face.arcs(), face.diagram(), pieces_);
  return std::any_of(pieces_.pieces.begin(), pieces_.pieces.end(),
                     [](const WorkingPiece& piece) { return area_share(piece.corners) < -kInverted; });
}

}  // namespace gvd
