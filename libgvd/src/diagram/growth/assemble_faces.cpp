// Closes the crossed faces outside the gaps by their own crossings.
#include "diagram/growth/assemble_faces.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "diagram/assembly/face_assembly.hpp"
#include "diagram/assembly/form_distances.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Number of faces between two reports of progress.
constexpr std::size_t kFaceStride = 1 << 10;

/// The distance forms of the generators whose cells lie along a face's boundary, ascending by generator.
std::vector<DistanceForm> face_forms(const GrowthInput& input, FaceId f,
                                     const std::vector<BoundaryCrossing>& boundary) {
  std::set<GeneratorId> met;
  for (const BoundaryCrossing& c : boundary) met.insert(c.next);
  std::vector<DistanceForm> forms;
  for (const GeneratorId g : met) {
    DistanceForm form{g, corner_distances(input, f, g)};
    for (double& value : form.corner) value = form_value(input.front, value);
    forms.push_back(form);
  }
  return forms;
}

/// The distance, in mesh units, that a generator's form represents at a point of a face.
double distance_of(const GrowthInput& input, FaceId f, const DistanceForm& form, const Bary& bary) {
  double value = form.at(bary);
  if (input.front == Front::planar) return value;
  for (int i = 0; i < 3; ++i) {
    const double length = input.mesh().length(Mesh::halfedge(f, i));
    value -= bary[i] * bary[(i + 1) % 3] * length * length;
  }
  return std::sqrt(std::max(0.0, value));
}

}  // namespace

void assemble_faces(const GrowthInput& input, const Crossings& crossings, const std::vector<FaceId>& skipped,
                    FaceDiagram& diagram, const Progress& progress) {
  std::vector<BoundaryCrossing> boundary;
  const std::vector<FaceId> faces = crossed_faces(input.mesh(), crossings);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FaceId f = faces[i];
    if (i % kFaceStride == 0) report_progress(progress, steps::kAssembly, double(i) / double(faces.size()));
    if (std::binary_search(skipped.begin(), skipped.end(), f)) continue;
    boundary_crossings(input.mesh(), crossings, f, boundary);
    if (boundary.size() == 2) {  // most faces have one arc, which depends on no distance
      diagram.arcs.push_back({f, at(boundary[0].id), at(boundary[1].id), boundary[0].previous, boundary[0].next});
      continue;
    }
    const std::vector<DistanceForm> forms = face_forms(input, f, boundary);
    const FormDistances distances(forms);
    const std::size_t first_arc = diagram.arcs.size(), first_branch = diagram.branches.size();
    assemble_face(f, boundary, distances, diagram);
    for (BranchPointId b(first_branch); b < BranchPointId(diagram.branches.size()); b = BranchPointId(b.value() + 1)) {
      FaceBranch& branch = diagram.branches[b];
      double sum = 0;
      int arcs = 0;
      for (const FaceArc& arc : std::span(diagram.arcs).subspan(first_arc)) {
        if (!arc.ends_at(at(b))) continue;
        sum += distance_of(input, f, distances.form(arc.left_from(at(b))), branch.bary);
        ++arcs;
      }
      branch.distance = sum / arcs;
    }
  }
}

}  // namespace gvd
