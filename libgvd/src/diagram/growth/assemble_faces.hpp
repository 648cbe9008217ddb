#pragma once

#include "diagram/assembly/distance_form.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Corner distances of generator g in f: what the march found; along an edge from another corner where it found
/// nothing.
std::array<double, 3> corner_distances(const Mesh& mesh, const GeneratorTable& table, const NearestLabels& labels,
                                       FaceId f, GeneratorId g);

/// What faces are assembled by: the tables of a march, the labels that came of it, and its front.
struct MarchedLabels {
  const Mesh& mesh;
  const GeneratorTable& table;
  const NearestLabels& labels;
  Front front;
};

/// The distance forms of the generators whose cells lie along a face's boundary, ascending by generator.
std::vector<DistanceForm> face_forms(const MarchedLabels& marched, FaceId f,
                                     const std::vector<BoundaryCrossing>& boundary);

/// Joins the crossings in every face but those in `skipped` (ascending), and appends the arcs and branch points to
/// `diagram`. Reports the last quarter of the step "bisectors". Cost: O(k) for k faces near bisectors.
void assemble_faces(const MarchedLabels& marched, const Crossings& crossings, const std::vector<FaceId>& skipped,
                    FaceDiagram& diagram, const Progress& progress = {});

}  // namespace gvd
