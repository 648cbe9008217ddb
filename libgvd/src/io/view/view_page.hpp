#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/view.hpp"
#include "gvd/mesh.hpp"
#include "io/view/scene_entry.hpp"
#include "io/view/view_blobs.hpp"

namespace gvd::io {

/// Makes the manifest of a page from scenes that have been checked, and adds their arrays to `blobs`. Cost: as for the
/// scenes' entries.
nlohmann::json make_view_manifest(const std::vector<ViewScene>& scenes, const ViewFrame& frame,
                                  const ViewOptions& options, ViewBlobs& blobs);

/// Computes for each cell the integral of the squared distance to its generator, in mesh units to the fourth.
///
/// In each face the squared distance is a quadratic function of the barycentric coordinates. The distances of the
/// corners and the lengths of the edges give it: d^2 = sum b_i d_i^2 - sum b_i b_j l_ij^2. That is exact if straight
/// lines from one generator reach all three corners. Elsewhere, as in cut faces, whose corners may belong to other
/// generators, it is an approximation for pictures; `compute_cell_moments` of gvd/cell_moments.hpp is exact. Faces with
/// a corner that no generator reaches are left out.
/// Throws nothing. Cost: O(n).
IdVector<GeneratorId, double> compute_cell_energies(const Mesh& mesh, const Diagram& diagram);

/// Throws Error{precondition} if a scene has no faces, the size of an array does not match the mesh, or a value is out
/// of range. Cost: O(n).
void check_view_scene(const ViewScene& scene);

}  // namespace gvd::io
