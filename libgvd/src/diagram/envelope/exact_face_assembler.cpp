#include "diagram/envelope/exact_face_assembler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/barycentric.hpp"
#include "base/segment.hpp"
#include "diagram/assembly/face_assembly.hpp"
#include "diagram/envelope/erase_loops.hpp"

namespace gvd {
namespace {

/// A piece of less than no area, as a part of its face's, beyond rounding; and straight arcs that cross so far.
constexpr double kTurned = 1e-11;

/// Whether an inner point of an arc lies within the face. Where a bisector runs along a side, by a tie, or beyond it by
/// rounding, points that are looked for in the face come to lie on the side, and not on the bisector.
bool lies_inside(const FaceDistances::Bary& p) { return *std::min_element(p.begin(), p.end()) >= kInsideFace; }

}  // namespace

void ExactFaceAssembler::close(FaceId f) {
  FaceDiagram& faces = closed_.diagram;
  const Before before{faces.arcs.size(), faces.branches.size(), faces.points.size()};
  boundary_crossings(mesh_, crossings_, f, boundary_);
  distances_.enter(mesh_, f);
  assemble(f);
  for (std::size_t i = before.arcs; i < faces.arcs.size(); ++i) refine(faces.arcs[i]);
  bool straightened = false;
  while (FaceArc* arc = most_met(before)) {
    keep_apart(*arc);
    straightened = true;
  }
  if (boundary_.size() > 2 && are_turned(before)) {
    faces.arcs.resize(before.arcs);
    faces.branches.resize(before.branches);
    faces.points.resize(before.points);
    distances_.set_can_confirm(false);
    assemble(f);
    distances_.set_can_confirm(true);
    straightened = true;
  }
  closed_.straightened += straightened;
  measure_branches(before);
}

/// Where crossings meet, ties are decided as on the edges; bisectors bend as they are.
void ExactFaceAssembler::assemble(FaceId f) {
  distances_.set_symbolic_offsets(boundary_.size() > 2);
  assemble_face(f, boundary_, distances_, closed_.diagram);
  distances_.set_symbolic_offsets(false);
}

/// Of the bent arcs that meet others or themselves the one that does most; null where none does.
FaceArc* ExactFaceAssembler::most_met(const Before& before) {
  if (!may_meet(before)) return nullptr;
  outline(before);
  const auto& meetings = meetings_.find(segments_);
  if (meetings.empty()) return nullptr;
  std::vector<FaceArc>& arcs = closed_.diagram.arcs;
  std::vector<int> met(arcs.size() - before.arcs, 0);
  for (const auto& [first, second] : meetings) {
    ++met[static_cast<std::size_t>(first)];
    ++met[static_cast<std::size_t>(second)];
  }
  FaceArc* most = nullptr;
  int times = 0;
  for (std::size_t i = 0; i < met.size(); ++i) {
    FaceArc& arc = arcs[before.arcs + i];
    if (arc.point_count == 0 || met[i] <= times) continue;
    most = &arc;
    times = met[i];
  }
  return most;
}

/// Takes the loops out of an arc; one without loops becomes straight.
void ExactFaceAssembler::keep_apart(FaceArc& arc) {
  const auto inner = closed_.diagram.inner_points(arc);
  std::vector<FaceDistances::Bary> polyline{place(arc.begin)};
  polyline.insert(polyline.end(), inner.begin(), inner.end());
  polyline.push_back(place(arc.end));
  arc.point_count = 0;
  if (!erase_loops(polyline)) return;
  arc.point_count = static_cast<std::int32_t>(polyline.size()) - 2;
  std::copy(polyline.begin() + 1, polyline.end() - 1, closed_.diagram.points.begin() + arc.first_point);
}

/// Straight arcs of an assembly don't meet; and a lone arc has no room for it that goes on towards its end all the way.
bool ExactFaceAssembler::may_meet(const Before& before) const {
  const std::vector<FaceArc>& arcs = closed_.diagram.arcs;
  if (arcs.size() == before.arcs + 1) return !advances(arcs.back());
  return std::any_of(arcs.begin() + static_cast<std::ptrdiff_t>(before.arcs), arcs.end(),
                     [](const FaceArc& arc) { return arc.point_count > 0; });
}

/// Whether every piece of the arc leads towards its end.
bool ExactFaceAssembler::advances(const FaceArc& arc) const {
  if (arc.point_count < 2) return true;
  Vec2 last = affine_point(place(arc.begin));
  const Vec2 end = affine_point(place(arc.end)), chord = end - last;
  const auto goes_on = [&](const Vec2& p) { return (p - std::exchange(last, p)).dot(chord) > 0; };
  const auto inner = closed_.diagram.inner_points(arc);
  return std::all_of(inner.begin(), inner.end(), [&](const auto& p) { return goes_on(affine_point(p)); }) &&
         goes_on(end);
}

/// Puts the segments of the face's arcs into segments_.
void ExactFaceAssembler::outline(const Before& before) {
  const FaceDiagram& faces = closed_.diagram;
  segments_.clear();
  for (std::size_t i = before.arcs; i < faces.arcs.size(); ++i) {
    const FaceArc& arc = faces.arcs[i];
    Vec2 last = affine_point(place(arc.begin));
    const auto go_to = [&](const FaceDistances::Bary& p) {
      segments_.push_back({{last, affine_point(p)}, static_cast<std::int32_t>(i - before.arcs)});
      last = affine_point(p);
    };
    for (const FaceDistances::Bary& p : faces.inner_points(arc)) go_to(p);
    go_to(place(arc.end));
  }
}

/// Whether a piece is turned inside out, or straight arcs cross. True arcs don't; rounding can bring it about where
/// nearly everything is a tie. Straight arcs of the assembly's convex steps never do.
bool ExactFaceAssembler::are_turned(const Before& before) {
  const FaceDiagram& faces = closed_.diagram;
  segments_.clear();
  for (std::size_t i = before.arcs; i < faces.arcs.size(); ++i) {
    const FaceArc& arc = faces.arcs[i];
    if (arc.point_count == 0) segments_.push_back({{affine_point(place(arc.begin)), affine_point(place(arc.end))}, 0});
  }
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (intersect_beyond(segments_[i].line, segments_[j].line, kTurned)) return true;
    }
  }
  trace_pieces(boundary_, std::span(faces.arcs).subspan(before.arcs), faces, pieces_);
  return std::any_of(pieces_.pieces.begin(), pieces_.pieces.end(),
                     [](const WorkingPiece& piece) { return area_share(piece.corners) < -kTurned; });
}

FaceDistances::Bary ExactFaceAssembler::place(const ArcEnd& end) const {
  if (end.branch.valid()) return closed_.diagram.branches[end.branch].bary;
  return std::find_if(boundary_.begin(), boundary_.end(), [&](const auto& c) { return c.id == end.crossing; })->bary();
}

void ExactFaceAssembler::refine(FaceArc& arc) {
  std::vector<FaceDistances::Bary>& points = closed_.diagram.points;
  const std::size_t first = points.size();
  refiner_.refine(arc, place(arc.begin), place(arc.end), points);
  points.erase(std::remove_if(points.begin() + static_cast<std::ptrdiff_t>(first), points.end(),
                              [](const FaceDistances::Bary& p) { return !lies_inside(p); }),
               points.end());
  arc.first_point = static_cast<std::int32_t>(first);
  arc.point_count = static_cast<std::int32_t>(points.size() - first);
}

/// Distance of the new branch points to the generators that meet there: the least of the paths that the face knows.
/// They are equally long; but of a generator that nearly coincides with another, or nearly lies on a side, the face may
/// know a roundabout one only, or none.
void ExactFaceAssembler::measure_branches(const Before& before) {
  FaceDiagram& faces = closed_.diagram;
  for (std::size_t b = before.branches; b < faces.branches.size(); ++b) {
    const BranchPointId id(static_cast<std::int64_t>(b));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = before.arcs; a < faces.arcs.size(); ++a) {
      const FaceArc& arc = faces.arcs[a];
      if (arc.begin != at(id) && arc.end != at(id)) continue;
      least = std::min(least, distances_.at(arc.begin == at(id) ? arc.left : arc.right, faces.branches[id].bary));
    }
    faces.branches[id].distance = std::isfinite(least) ? least : distances_.nearest_of_all(faces.branches[id].bary);
  }
}

}  // namespace gvd
