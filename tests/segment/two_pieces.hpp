#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// A diagram without pieces: every face belongs to generator 0.
inline Diagram make_whole_diagram(const Mesh& mesh, std::vector<SurfacePoint> generators) {
  Diagram diagram;
  diagram.generators = std::move(generators);
  diagram.face_label.assign(static_cast<std::size_t>(mesh.face_count()), GeneratorId(0));
  return diagram;
}

/// Cuts face f in two: the tip at corner 0, with the fraction t^2 of the area, belongs to `tip`, the rest to `rest`.
inline void cut_in_two(Diagram& diagram, FaceId f, double t, GeneratorId tip, GeneratorId rest) {
  diagram.face_label[f] = GeneratorId();
  diagram.pieces.push_back({f, tip, {{1, 0, 0}, {1 - t, t, 0}, {1 - t, 0, t}}});
  diagram.pieces.push_back({f, rest, {{1 - t, t, 0}, {0, 1, 0}, {0, 0, 1}, {1 - t, 0, t}}});
}

}  // namespace gvd::test
