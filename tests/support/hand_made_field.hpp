#pragma once

#include <vector>

#include "geodesic/distance_field.hpp"

namespace gvd::test {

/// Sources by hand, the same on every edge and in every face.
class HandMadeField final : public DistanceField {
 public:
  explicit HandMadeField(std::vector<FaceSource> sources) : sources_(std::move(sources)) {}

  std::vector<EdgeId> contested_edges(const ParallelChunks&) const override { return {}; }
  void collect(EdgeId, std::vector<EdgeSource>& sources) const override { sources.clear(); }
  void collect(FaceId, const FaceLayout&, std::vector<FaceSource>& sources) const override { sources = sources_; }

 private:
  std::vector<FaceSource> sources_;
};

/// The ends of an opening, as FaceSource has them.
struct Opening {
  Vec2 begin, end;
};

/// Straight paths from `image`, at `offset` from the generator, that enter through an opening on side i of face 0.
inline FaceSource through_side(int generator, int i, const Vec2& image, const Opening& opening, double offset) {
  const auto& [begin, end] = opening;
  return {image,
          begin,
          end,
          offset,
          GeneratorId(generator),
          Mesh::halfedge(FaceId(0), i),
          FaceSource::Kind::window,
          offset + (begin - image).norm(),
          offset + (end - image).norm()};
}

/// Paths from corner i of face 0, which lies at `corner`.
inline FaceSource from_corner(int generator, int i, const Vec2& corner, double distance) {
  return FaceSource::corner(corner, distance, GeneratorId(generator), Mesh::halfedge(FaceId(0), i));
}

}  // namespace gvd::test
