// Closes the crossed faces outside of the gaps by their own crossings.
#include "diagram/growth/assemble_faces.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagram/assembly/face_assembly.hpp"
#include "diagram/assembly/form_distances.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Progress is reported after this many faces.
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

/// A face and the distance forms of the generators whose cells lie along its boundary.
struct FaceForms {
  const Mesh& mesh;
  FaceId face;
  Front front;
  std::vector<DistanceForm> forms;

  /// Distance of generator g at a point of the face, mesh units.
  double distance(GeneratorId g, const std::array<double, 3>& bary) const {
    const auto form = std::ranges::find(forms, g, &DistanceForm::generator);
    if (front == Front::planar) return form->at(bary);
    double squared = form->at(bary);
    for (int i = 0; i < 3; ++i) {
      const double length = mesh.length(Mesh::halfedge(face, i));
      squared -= bary[i] * bary[(i + 1) % 3] * length * length;
    }
    return std::sqrt(std::max(0.0, squared));
  }
};

/// Sets the distance of the branch points from `first_branch` on: the mean over the cells at each.
void measure_branches(const FaceForms& forms, std::size_t first_arc, std::size_t first_branch, FaceDiagram& diagram) {
  for (std::size_t b = first_branch; b < diagram.branches.size(); ++b) {
    const BranchPointId id(b);
    FaceBranch& branch = diagram.branches[id];
    double sum = 0;
    int arcs = 0;
    for (std::size_t a = first_arc; a < diagram.arcs.size(); ++a) {
      const FaceArc& arc = diagram.arcs[a];
      if (!arc.ends_at(at(id))) continue;
      sum += forms.distance(arc.left_from(at(id)), branch.bary);
      ++arcs;
    }
    branch.distance = sum / arcs;
  }
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
    if (boundary.size() == 2) {  // most faces: one arc, which depends on no distance
      diagram.arcs.push_back({f, at(boundary[0].id), at(boundary[1].id), boundary[0].previous, boundary[0].next});
      continue;
    }
    const FaceForms forms{input.mesh(), f, input.front, face_forms(input, f, boundary)};
    const std::size_t first_arc = diagram.arcs.size(), first_branch = diagram.branches.size();
    assemble_face(f, boundary, FormDistances(forms.forms), diagram);
    measure_branches(forms, first_arc, first_branch, diagram);
  }
}

}  // namespace gvd
