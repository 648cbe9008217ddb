#pragma once

#include <ostream>
#include <string>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

// Members that a command adds to the JSON of a diagram, and parts of other JSON that commands write.
namespace gvd::app {

/// The diagram as `gvd-diagram/1`, without its last brace: open for more members.
std::string open_diagram(const Mesh& mesh, const Diagram& diagram);

/// `{"face":f,"bary":[a,b,c]`, without its last brace: open for more members.
std::string open_point(const SurfacePoint& point);

/// Writes `"vertices":[[x,y,z]],"faces":[[a,b,c]]`, one element a line.
void write_mesh_members(std::ostream& out, const Mesh& mesh);

/// Flushes and checks the stream. Throws Error{unwritable_output}.
void finish(std::ostream& out);

}  // namespace gvd::app
