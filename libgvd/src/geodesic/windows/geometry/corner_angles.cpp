#include "geodesic/windows/geometry/corner_angles.hpp"

#include <cmath>

#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {

CornerAngles::CornerAngles(const Mesh& mesh, const FaceFrames& frames, const ParallelChunks& parallel)
    : mesh_(&mesh), corner_(static_cast<std::size_t>(mesh.halfedge_count())) {
  const auto faces = cut_into_chunks(static_cast<std::size_t>(mesh.face_count()), kScanChunk);
  parallel.run(faces.size(), {steps::kDistances}, [&](std::size_t chunk) {
    for (std::size_t i = faces[chunk].begin; i < faces[chunk].end; ++i) {
      const FaceId face(i);
      const FaceFrame& f = frames.frame[face];
      for (std::size_t k = 0; k < 3; ++k) {
        corner_[Mesh::halfedge(face, static_cast<int>(k))] = Departure::of_angle(std::atan2(f.sine[k], f.cosine[k]));
      }
    }
  });
}

Departure CornerAngles::side(HalfedgeId h) const {
  double sum = 0;
  for (HalfedgeId before = mesh_->halfedge(mesh_->from(h)); before != h; before = next_outgoing(*mesh_, before)) {
    sum += corner_[before].turned();
  }
  return Departure::of_side(sum);
}

}  // namespace gvd
