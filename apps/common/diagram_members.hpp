#pragma once

#include <ostream>
#include <string>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

// Parts of the JSON that commands write.
namespace gvd::app {

/// The diagram as `gvd-diagram/1`, without its last brace: open for more members.
std::string open_diagram(const Mesh& mesh, const Diagram& diagram);

/// `{"face":f,"bary":[a,b,c]`, without its last brace: open for more members.
std::string open_point(const SurfacePoint& point);

/// The number, or null where it is not finite.
std::string json_number(double value);

/// Writes an array; `format_item` gives the text of each item, and `before` stands before it, such as a line break.
/// `end` closes an array that is not empty.
template <class Items, class FormatItem>
void write_array(std::ostream& out, const Items& items, const char* before, FormatItem format_item,
                 const char* end = "]") {
  const char* separator = "[";
  for (const auto& item : items) {
    out << separator << before << format_item(item);
    separator = ",";
  }
  out << (separator[0] == '[' ? "[]" : end);
}

/// Writes `"vertices":[[x,y,z]],"faces":[[a,b,c]]`, one element a line.
void write_mesh_members(std::ostream& out, const Mesh& mesh);

/// Flushes and checks the stream. Throws Error{unwritable_output}.
void finish(std::ostream& out);

}  // namespace gvd::app
