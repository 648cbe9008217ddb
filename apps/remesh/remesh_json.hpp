#pragma once

#include <ostream>

#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"

namespace gvd::app {

/// Writes the diagram of all generators as `gvd-diagram/1` with one more member, `"remesh"`:
/// `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"face_points":[{"face","bary"}],"added"}`. Vertex i stands for
/// generator i, and is at it with Placement::generator.
/// The point of a face is its branch point, on `mesh`. Throws Error{unwritable_output}. Cost: O(n).
void write_remesh_json(std::ostream& out, const Mesh& mesh, const RemeshResult& result);

}  // namespace gvd::app
