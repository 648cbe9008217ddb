#include "diagram/envelope/exact_face_assembler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagram/assembly/face_assembly.hpp"

namespace gvd {
namespace {

/// Samples of a segment in a face whose error is measured.
constexpr int kErrorSamples = 16;

/// Whether an inner point of an arc lies inside the face. A bisector can follow a side, by a tie, or lie beyond it by
/// rounding. Then the search in the face ends on the side, and not on the bisector.
bool is_inside(const Bary& p) { return *std::min_element(p.begin(), p.end()) >= kInsideFace; }

}  // namespace

void ExactFaceAssembler::assemble(FaceId f) {
  OpenFace face(result_.diagram, boundary_);
  boundary_crossings(mesh_, crossings_, f, boundary_);
  distances_.enter(mesh_, f);
  join_crossings(f);
  for (FaceArc& arc : face.arcs()) refine(face, arc);
  distances_.set_symbolic_offsets(false);
  bool straightened = separator_.separate(face);
  if (boundary_.size() > 2 && separator_.is_inverted(face)) {
    face.clear();
    distances_.set_can_confirm(false);
    join_crossings(f);
    distances_.set_symbolic_offsets(false);
    distances_.set_can_confirm(true);
    straightened = true;
  }
  if (straightened) {
    ++result_.straightened;
    result_.straightened_error = std::max(result_.straightened_error, largest_error(face));
  }
  measure_branches(face);
}

/// Joins the crossings by straight arcs. Ties between branch points are decided as on the edges, by the symbolic
/// offsets. These stay set for the refinement: between generators that nearly coincide they turn bisectors, and arcs
/// that ended without them would intersect.
void ExactFaceAssembler::join_crossings(FaceId f) {
  distances_.set_symbolic_offsets(boundary_.size() > 2);
  assemble_face(f, boundary_, distances_, result_.diagram);
}

void ExactFaceAssembler::refine(const OpenFace& face, FaceArc& arc) {
  std::vector<Bary>& points = result_.diagram.points;
  const std::size_t first = points.size();
  refiner_.refine(arc, face.position(arc.begin), face.position(arc.end), points);
  points.erase(std::remove_if(points.begin() + static_cast<std::ptrdiff_t>(first), points.end(),
                              [](const Bary& p) { return !is_inside(p); }),
               points.end());
  arc.first_point = static_cast<std::int32_t>(first);
  arc.point_count = static_cast<std::int32_t>(points.size() - first);
}

/// Sets the distance of the branch points to the generators round them: the shortest of the paths that the face knows.
/// All of them are equally long, with one exception. Of a generator that nearly coincides with another one, or nearly
/// lies on a side, the face may only know a longer path, or none.
void ExactFaceAssembler::measure_branches(const OpenFace& face) {
  IdVector<BranchPointId, FaceBranch>& branches = result_.diagram.branches;
  for (BranchPointId id = face.first_branch(); id < face.end_branch(); id = BranchPointId(id.value() + 1)) {
    double least = std::numeric_limits<double>::infinity();
    for (const FaceArc& arc : face.arcs()) {
      if (arc.begin != at(id) && arc.end != at(id)) continue;
      least = std::min(least, distances_.at(arc.begin == at(id) ? arc.left : arc.right, branches[id].bary));
    }
    branches[id].distance = std::isfinite(least) ? least : distances_.nearest_of_all(branches[id].bary);
  }
}

/// The largest difference of the distances to an arc's two generators, at samples of all arcs of the face.
double ExactFaceAssembler::largest_error(const OpenFace& face) const {
  double largest = 0;
  for (const FaceArc& arc : face.arcs()) {
    Bary from = face.position(arc.begin);
    const auto follow = [&](const Bary& to) {
      for (int k = 1; k <= kErrorSamples; ++k) {
        const Bary p = mix(from, to, static_cast<double>(k) / kErrorSamples);
        const double error = std::abs(distances_.at(arc.left, p) - distances_.at(arc.right, p));
        if (std::isfinite(error)) largest = std::max(largest, error);
      }
      from = to;
    };
    for (const Bary& p : face.inner_points(arc)) follow(p);
    follow(face.position(arc.end));
  }
  return largest;
}

}  // namespace gvd
