// Sheets that met along a non-manifold edge of the input have copies of its vertices since the repair, and no path
// leads from one to the other. Copies are told by the vertex of the input that both stand for.

#include "common/cut_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "gvd/text.hpp"

namespace gvd::app {
namespace {

/// A side of a face, by the vertices of the input, the smaller one first.
struct Side {
  std::array<std::int32_t, 2> ends;
  std::array<std::int32_t, 2> copies;  ///< the vertices of the mesh that stand for them
  bool is_reached;
};

std::vector<Side> list_sides(const CheckedMesh& input, const std::function<Reach(FaceId)>& reach) {
  std::vector<Side> sides;
  for (const FaceId f : input.mesh.faces()) {
    const Reach found = reach(f);
    if (found == Reach::left_out) continue;
    const auto& corners = input.mesh.vertices(f);
    for (int k = 0; k < 3; ++k) {
      VertexId from = corners[k], to = corners[(k + 1) % 3];
      if (input.input_vertex[from] > input.input_vertex[to]) std::swap(from, to);
      if (input.input_vertex[from] < 0) continue;  // the midpoint of a split edge
      sides.push_back(
          {{input.input_vertex[from], input.input_vertex[to]}, {from.value(), to.value()}, found == Reach::reached});
    }
  }
  return sides;
}

/// Whether one of the sides is reached and another one, of other copies, is not.
bool are_torn(const Side* begin, const Side* end) {
  return std::any_of(begin, end, [&](const Side& a) {
    return std::any_of(begin, end,
                       [&](const Side& b) { return a.is_reached && !b.is_reached && a.copies != b.copies; });
  });
}

}  // namespace

std::string describe_cuts(const CheckedMesh& input, const std::function<Reach(FaceId)>& reach) {
  if (input.defects.count(DefectKind::nonmanifold_edges) == 0) return "";
  std::vector<Side> sides = list_sides(input, reach);
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.ends, a.is_reached, a.copies) < std::tie(b.ends, b.is_reached, b.copies);
  });
  std::int64_t count = 0;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].ends == sides[begin].ends) ++end;
    count += are_torn(sides.data() + begin, sides.data() + end);
  }
  if (count == 0) return "";
  return fmt::format("; sheets were cut apart at {}, and nothing passes from one to the other",
                     counted(count, "non-manifold edge", "non-manifold edges"));
}

}  // namespace gvd::app
