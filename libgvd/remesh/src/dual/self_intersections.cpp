// Pairs of faces of a mesh that intersect, and those that a remesh has from its surface.
//
// A tree of the faces' boxes finds the pairs that may intersect, and `faces_intersect` decides on each. The result is
// sorted, so that neither the tree nor the number of threads shows in it. Where the surface intersects itself, a remesh
// near it can't be free of intersections. A pair of its faces is therefore inherited if the box of their common part,
// with a margin, overlaps both boxes of an intersecting pair of the surface.

#include "gvd/self_intersections.hpp"

#include <algorithm>
#include <iterator>

#include "base/parallel_chunks.hpp"
#include "dual/dual_steps.hpp"

namespace gvd {
namespace {

/// The part of space in which a pair of faces intersects, with a margin.
Box3 common_box(const Mesh& mesh, const FacePair& pair) {
  const Box3 a = face_box(mesh, pair.first), b = face_box(mesh, pair.second);
  const Vec3 margin = Vec3::Constant(std::max(a.diagonal().norm(), b.diagonal().norm()) / 2);
  return {a.min().cwiseMax(b.min()) - margin, a.max().cwiseMin(b.max()) + margin};
}

/// The first faces of ascending pairs, each once.
std::vector<FaceId> first_faces(const std::vector<FacePair>& pairs) {
  std::vector<FaceId> faces;
  for (const FacePair& pair : pairs) {
    if (faces.empty() || faces.back() != pair.first) faces.push_back(pair.first);
  }
  return faces;
}

}  // namespace

std::vector<FacePair> find_self_intersections(const PlacedFaces& faces, int threads) {
  constexpr std::size_t kFacesPerChunk = 256;
  const FaceBoxes boxes(faces, faces.mesh.faces());
  const Progress none;
  const auto chunks = cut_into_chunks(faces.mesh.face_count(), kFacesPerChunk);
  auto pairs = ParallelChunks(threads, none).collect(chunks, {"self-intersections"}, [&](const Chunk& chunk) {
    std::vector<FacePair> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceId f(i);
      boxes.any_of(face_box(faces, f), [&](FaceId g) {
        if (f < g && faces_intersect(faces, f, g)) found.push_back({f, g});
        return false;
      });
    }
    return found;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<FacePair> find_self_intersections(const Mesh& mesh, int threads) {
  return find_self_intersections(PlacedFaces(mesh), threads);
}

std::vector<FacePair> find_inherited(const Mesh& surface, const std::vector<FacePair>& given, const Mesh& remesh,
                                     const std::vector<FacePair>& pairs) {
  const FaceBoxes firsts(surface, first_faces(given));
  const auto overlaps_partner = [&](FaceId first, const Box3& box) {
    const auto is_before = [](const FacePair& pair, FaceId f) { return pair.first < f; };
    auto pair = std::lower_bound(given.begin(), given.end(), first, is_before);
    for (; pair != given.end() && pair->first == first; ++pair) {
      if (box.intersects(face_box(surface, pair->second))) return true;
    }
    return false;
  };
  std::vector<FacePair> inherited;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(inherited), [&](const FacePair& pair) {
    const Box3 box = common_box(remesh, pair);
    return firsts.any_of(box, [&](FaceId first) { return overlaps_partner(first, box); });
  });
  return inherited;
}

std::vector<FacePair> find_inherited(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     int threads) {
  if (pairs.empty()) return {};
  return find_inherited(surface, find_self_intersections(surface, threads), remesh, pairs);
}

}  // namespace gvd
