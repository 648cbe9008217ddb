#pragma once

#include <cmath>
#include <string>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "io/writers/byte_writer.hpp"

namespace gvd::io {

/// The shortest digits that bring the same double back; null for infinity and NaN, which JSON does not have.
inline std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

inline void print_vector(ByteWriter& out, const Vec3& p) {
  out.print("[{},{},{}]", json_number(p.x()), json_number(p.y()), json_number(p.z()));
}

/// The members "face", "bary" and "position", without braces.
inline void print_point_members(ByteWriter& out, const SurfacePoint& point, const Vec3& position) {
  out.print("\"face\":{},\"bary\":[{},{},{}],\"position\":", point.face.value(), point.bary[0], point.bary[1],
            point.bary[2]);
  print_vector(out, position);
}

inline void print_point(ByteWriter& out, const Mesh& mesh, const SurfacePoint& point) {
  out.text("{");
  print_point_members(out, point, position(mesh, point));
  out.text("}");
}

/// An array: `print` prints each item on a line of its own.
template <class Items, class Print>
void print_lines(ByteWriter& out, const Items& items, Print print) {
  out.text("[");
  bool first = true;
  for (const auto& item : items) {
    out.text(first ? "\n  " : ",\n  ");
    first = false;
    print(item);
  }
  out.text(first ? "]" : "\n]");
}

/// An array: `print` prints the items, all on one line.
template <class Items, class Print>
void print_array(ByteWriter& out, const Items& items, Print print) {
  out.text("[");
  bool first = true;
  for (const auto& item : items) {
    if (!first) out.text(",");
    first = false;
    print(item);
  }
  out.text("]");
}

}  // namespace gvd::io
