#pragma once

#include <array>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

using Triangle = std::array<Vec3, 3>;

/// A face with the positions of its corners. Two faces share the corners that have the same ids.
struct PlacedFace {
  std::array<VertexId, 3> ids;
  Triangle corners;
};

/// The faces of a mesh with its vertices at given positions, which may differ from its own. Refers to both.
struct PlacedFaces {
  PlacedFaces(const Mesh& faces) : PlacedFaces(faces, faces.positions()) {}  // NOLINT: a mesh is one
  PlacedFaces(const Mesh& faces, const std::vector<Vec3>& at) : mesh(faces), positions(at) {}

  Triangle corners(FaceId f) const {
    const auto& [a, b, c] = mesh.vertices(f);
    return {positions[a.index()], positions[b.index()], positions[c.index()]};
  }

  PlacedFace at(FaceId f) const { return {mesh.vertices(f), corners(f)}; }

  const Mesh& mesh;
  const std::vector<Vec3>& positions;
};

/// A closed box whose sides are parallel to the axes, mesh units.
using Box3 = Eigen::AlignedBox3d;

/// The bounding box of a face, without rounding.
inline Box3 face_box(const PlacedFaces& faces, FaceId f) {
  const Triangle t = faces.corners(f);
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

/// A balanced tree of the bounding boxes of faces.
class FaceBoxes {
 public:
  /// The boxes of these faces, each listed once. Cost: O(k log k) for k of them.
  template <class Faces>
  FaceBoxes(const PlacedFaces& placed, const Faces& faces) {
    std::vector<Entry> entries;
    for (const FaceId f : faces) entries.push_back({face_box(placed, f), f});
    tree_.init(entries.begin(), entries.end());
  }

  /// Whether holds(f) is true for a face whose box overlaps this box. The search ends with the first one. Cost: as a
  /// rule O(log n), and the calls.
  template <class Holds>
  bool any_of(const Box3& box, const Holds& holds) const {
    Search<Holds> search{box, holds};
    Eigen::BVIntersect(tree_, search);
    return search.found;
  }

 private:
  struct Entry {
    Box3 box;
    FaceId face;

    friend Box3 bounding_box(const Entry& entry) { return entry.box; }
  };

  /// The query that Eigen's tree runs.
  template <class Holds>
  struct Search {
    const Box3& box;
    const Holds& holds;
    bool found = false;

    bool intersectVolume(const Box3& volume) const { return volume.intersects(box); }
    bool intersectObject(const Entry& entry) { return found = entry.box.intersects(box) && holds(entry.face); }
  };

  Eigen::KdBVH<double, 3, Entry> tree_;
};

}  // namespace gvd
