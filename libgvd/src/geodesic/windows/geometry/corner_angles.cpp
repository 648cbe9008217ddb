#include "geodesic/windows/geometry/corner_angles.hpp"

#include <cmath>

#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {

CornerAngles::CornerAngles(const Mesh& mesh, const FaceFrames& frames, const ParallelChunks& parallel)
    : corner_(static_cast<std::size_t>(mesh.halfedge_count())), side_(corner_.size()) {
  const auto angle = [&](HalfedgeId h) {
    const FaceFrame& f = frames.frame[Mesh::face(h)];
    const auto i = static_cast<std::size_t>(Mesh::corner(h));
    return std::atan2(f.sine[i], f.cosine[i]);
  };
  const auto vertices = cut_into_chunks(static_cast<std::size_t>(mesh.vertex_count()), kScanChunk);
  parallel.run(vertices.size(), {steps::kDistances}, [&](std::size_t chunk) {
    for (std::size_t v = vertices[chunk].begin; v < vertices[chunk].end; ++v) {
      double sum = 0;
      for_each_outgoing(mesh, VertexId(static_cast<std::int64_t>(v)), [&](HalfedgeId h) {
        const double here = angle(h);
        side_[h] = Departure::of_side(sum);
        corner_[h] = Departure::of_angle(here);
        sum += here;
      });
    }
  });
}

}  // namespace gvd
