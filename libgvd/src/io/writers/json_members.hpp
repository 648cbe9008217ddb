#pragma once

#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "io/writers/byte_writer.hpp"

// Members of the JSON documents that hold a diagram and what was made of it: a segmentation, a cut mesh or a remesh.
namespace gvd::io {

/// The diagram as `gvd-diagram/1`, without its last brace: open for more members. Cost: O(n) time, O(1) memory.
void print_open_diagram(ByteWriter& out, const Mesh& mesh, const Diagram& diagram);

/// `"vertices":[[x,y,z]],"faces":[[a,b,c]]`, one element a line.
void print_mesh_members(ByteWriter& out, const Mesh& mesh);

/// An array of elements, one a line without indent.
template <class Items, class Print>
void print_rows(ByteWriter& out, const Items& items, Print print) {
  print_array(out, items, print, {"\n", ",\n", ""});
}

}  // namespace gvd::io
