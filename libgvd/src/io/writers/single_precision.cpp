#include "io/writers/single_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "gvd/error.hpp"

namespace gvd::io {

void check_single_precision(const Mesh& mesh, std::string_view format) {
  const double largest = mesh.largest_coordinate();
  using Float = std::numeric_limits<float>;
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorCode::unwritable_output,
                fmt::format("{} holds 32-bit floats, and {}; choose PLY, OBJ, OFF or VTP", format, why));
  };
  if (largest > Float::max()) refuse(fmt::format("the coordinate {} is too large for one", largest));
  // The distance of neighbouring floats at the largest coordinate: a smaller mesh would collapse.
  const double step = std::max<double>(largest * Float::epsilon(), Float::min());
  if (mesh.bbox_diagonal() <= step) {
    refuse(fmt::format("a mesh of size {} at the coordinate {} is smaller than the step between two of them",
                       mesh.bbox_diagonal(), largest));
  }
}

}  // namespace gvd::io
