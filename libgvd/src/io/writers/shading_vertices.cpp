#include "io/writers/shading_vertices.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd::io {
namespace {

/// cos(40 degrees), as on the page of --view: curved surfaces look smooth, creases sharp.
constexpr double kCreaseCosine = 0.7660444431189780;
constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();

class Splitter {
 public:
  Splitter(const Mesh& mesh, const IdVector<FaceId, GeneratorId>* label) : mesh_(mesh), label_(label) {
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) face_normal_.push_back(face_normal(mesh, FaceId(f)));
    of_corner_.resize(static_cast<std::size_t>(mesh.halfedge_count()));
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) split(VertexId(v));
  }

  /// Numbers the vertices by region, in the order in which its faces use them.
  ShadingVertices run(const std::vector<Region>& regions) {
    ShadingVertices result;
    std::vector<std::uint32_t> number(split_.size(), kUnseen);
    result.of_corner.resize(of_corner_.size());
    for (const Region& region : regions) {
      result.first.push_back(static_cast<std::uint32_t>(result.vertices.size()));
      for (const FaceId f : region.faces) {
        for (int i = 0; i < 3; ++i) {
          const std::uint32_t index = of_corner_[Mesh::halfedge(f, i)];
          if (number[index] == kUnseen) {
            number[index] = static_cast<std::uint32_t>(result.vertices.size());
            result.vertices.push_back(split_[index]);
          }
          result.of_corner[Mesh::halfedge(f, i)] = number[index];
        }
      }
    }
    result.first.push_back(static_cast<std::uint32_t>(result.vertices.size()));
    return result;
  }

 private:
  bool same_region(HalfedgeId g, HalfedgeId h) const {
    return label_ == nullptr || (*label_)[Mesh::face(g)] == (*label_)[Mesh::face(h)];
  }

  /// A face without area is no crease.
  bool is_crease(HalfedgeId g, HalfedgeId h) const {
    const Vec3 &m = face_normal_[Mesh::face(g)], &n = face_normal_[Mesh::face(h)];
    return !m.isZero(0) && !n.isZero(0) && m.dot(n) < kCreaseCosine;
  }

  /// Turns a closed ring so that it begins behind a crease or, where there is none, behind a border between regions:
  /// what lies together in the ring lies together in the list.
  void begin_at_break() {
    const auto turn_to = [this](auto is_break) {
      for (std::size_t i = 0; i < ring_.size(); ++i) {
        if (!is_break(ring_[(i + ring_.size() - 1) % ring_.size()], ring_[i])) continue;
        std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(i), ring_.end());
        return true;
      }
      return false;
    };
    if (turn_to([this](HalfedgeId g, HalfedgeId h) { return is_crease(g, h); })) return;
    turn_to([this](HalfedgeId g, HalfedgeId h) { return !same_region(g, h); });
  }

  Eigen::Vector3f mean_normal(std::size_t first, std::size_t last) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = first; i < last; ++i)
      sum += corner_angle(mesh_, ring_[i]) * face_normal_[Mesh::face(ring_[i])];
    const Vec3 unit = sum.stableNormalized();
    return unit.isZero(0) ? Eigen::Vector3f(0, 0, 1) : Eigen::Vector3f(unit.cast<float>());
  }

  void split(VertexId v) {
    ring_.clear();
    for_each_outgoing(mesh_, v, [this](HalfedgeId h) { ring_.push_back(h); });
    if (!mesh_.is_boundary(v)) begin_at_break();
    for (std::size_t first = 0, last = 0; first < ring_.size(); first = last) {
      for (last = first + 1; last < ring_.size() && !is_crease(ring_[last - 1], ring_[last]);) ++last;
      const Eigen::Vector3f normal = mean_normal(first, last);
      for (std::size_t i = first; i < last; ++i) {
        if (i == first || !same_region(ring_[i - 1], ring_[i])) split_.push_back({v, normal});
        of_corner_[ring_[i]] = static_cast<std::uint32_t>(split_.size()) - 1;
      }
    }
  }

  const Mesh& mesh_;
  const IdVector<FaceId, GeneratorId>* label_;
  IdVector<FaceId, Vec3> face_normal_;
  std::vector<ShadingVertex> split_;  ///< by vertex
  IdVector<HalfedgeId, std::uint32_t> of_corner_;
  std::vector<HalfedgeId> ring_;  ///< of one vertex, counter-clockwise
};

}  // namespace

ShadingVertices split_shading_vertices(const Mesh& mesh, const IdVector<FaceId, GeneratorId>* label,
                                       const std::vector<Region>& regions) {
  return Splitter(mesh, label).run(regions);
}

}  // namespace gvd::io
