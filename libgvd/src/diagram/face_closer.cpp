#include "diagram/face_closer.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "diagram/area_share.hpp"
#include "diagram/face_assembly.hpp"

namespace gvd {
namespace {

/// A piece of less than no area, as a part of its face's, beyond rounding.
constexpr double kTurned = 1e-11;

}  // namespace

void FaceCloser::close(FaceId f) {
  FaceDiagram& faces = closed_.diagram;
  const std::size_t arcs = faces.arcs.size(), branches = faces.branches.size(), points = faces.points.size();
  boundary_crossings(mesh_, crossings_, f, boundary_);
  metric_.enter(mesh_, f);
  assemble_face(f, boundary_, metric_, faces);
  for (std::size_t i = arcs; i < faces.arcs.size(); ++i) bend(faces.arcs[i]);
  if (boundary_.size() > 2 && arcs_cross(arcs)) {
    faces.arcs.resize(arcs);
    faces.branches.resize(branches);
    faces.points.resize(points);
    metric_.set_sure(false);
    assemble_face(f, boundary_, metric_, faces);
    metric_.set_sure(true);
    ++closed_.straightened;
  }
  measure_branches(arcs, branches);
}

/// Arcs that cross turn a piece inside out. True arcs don't; rounding can bring it about where nearly everything is a
/// tie. Straight arcs of the assembly's convex steps never cross.
bool FaceCloser::arcs_cross(std::size_t first_arc) {
  const FaceDiagram& faces = closed_.diagram;
  trace_pieces(boundary_, std::span(faces.arcs).subspan(first_arc), faces, pieces_);
  return std::any_of(pieces_.pieces.begin(), pieces_.pieces.end(),
                     [](const WorkingPiece& piece) { return area_share(piece.corners) < -kTurned; });
}

FaceMetric::Bary FaceCloser::place(const ArcEnd& end) const {
  if (end.branch.valid()) return closed_.diagram.branches[end.branch].bary;
  return std::find_if(boundary_.begin(), boundary_.end(), [&](const auto& c) { return c.id == end.crossing; })->bary();
}

void FaceCloser::bend(FaceArc& arc) {
  std::vector<FaceMetric::Bary>& points = closed_.diagram.points;
  const std::size_t first = points.size();
  bender_.bend(arc, place(arc.begin), place(arc.end), points);
  arc.first_point = static_cast<std::int32_t>(first);
  arc.point_count = static_cast<std::int32_t>(points.size() - first);
}

/// Mean distance of the new branch points to the generators that meet there.
void FaceCloser::measure_branches(std::size_t first_arc, std::size_t first_branch) {
  FaceDiagram& faces = closed_.diagram;
  for (std::size_t b = first_branch; b < faces.branches.size(); ++b) {
    const BranchPointId id(static_cast<std::int64_t>(b));
    double sum = 0;
    int arcs = 0;
    for (std::size_t a = first_arc; a < faces.arcs.size(); ++a) {
      const FaceArc& arc = faces.arcs[a];
      if (arc.begin != at(id) && arc.end != at(id)) continue;
      const double distance = metric_.at(arc.begin == at(id) ? arc.left : arc.right, faces.branches[id].bary);
      // Of a generator that nearly coincides with another, or nearly lies on a side, the face itself may know nothing.
      if (std::isinf(distance)) continue;
      sum += distance;
      ++arcs;
    }
    faces.branches[id].distance = arcs > 0 ? sum / arcs : metric_.nearest_of_all(faces.branches[id].bary);
  }
}

}  // namespace gvd
