#include <algorithm>

#include "base/parallel_chunks.hpp"
#include "gvd/self_intersections.hpp"
#include "intersection/face_boxes.hpp"
#include "intersection/faces_intersect.hpp"

namespace gvd {

std::vector<FacePair> find_self_intersections(const Mesh& mesh, int threads) {
  constexpr std::size_t kFacesPerChunk = 256;
  const FaceBoxes boxes(mesh);
  const Progress none;
  const auto chunks = cut_into_chunks(static_cast<std::size_t>(mesh.face_count()), kFacesPerChunk);
  auto pairs = ParallelChunks(threads, none).collect(chunks, {"self-intersections"}, [&](const Chunk& chunk) {
    std::vector<FacePair> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceId f(i);
      boxes.visit(face_box(mesh, f), [&](FaceId g) {
        if (f < g && faces_intersect(mesh, f, g)) found.push_back({f, g});
      });
    }
    return found;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace gvd
