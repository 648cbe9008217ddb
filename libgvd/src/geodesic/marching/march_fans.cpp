// A copy of the mesh's fans for marches, in the order of a space-filling curve.
//
// Idea: a grid of 1024 cells along each axis divides the bounding box. Vertices are sorted by the Morton code of their
// cell, and by id in a cell.
// Source: Morton, A computer oriented geodetic data base, 1966.
// Invariant: the order only decides where a vertex lies in memory. Marches break ties by vertex ids.
#include "geodesic/marching/march_fans.hpp"

#include <Eigen/Geometry>
#include <array>
#include <utility>

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Bits of a cell's coordinate. Three coordinates take 30 bits of a 32-bit code.
constexpr int kAxisBits = 10;
constexpr std::uint64_t kAxisCells = std::uint64_t{1} << kAxisBits;

/// Stands in place of the area if a spoke has no face.
constexpr double kNoFace = -1;

/// Vertices between two reports of progress: some milliseconds.
constexpr std::size_t kProgressStride = std::size_t{1} << 14;

/// Moves bits 0 .. 9 of x to bits 0, 3 .. 27.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 16) & 0x030000FF;
  x = (x | x << 8) & 0x0300F00F;
  x = (x | x << 4) & 0x030C30C3;
  return (x | x << 2) & 0x09249249;
}

/// A key for each vertex: the Morton code of its cell above the 32 bits of its id.
std::vector<std::uint64_t> compute_keys(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions()) box.extend(p);
  const double extent = box.sizes().maxCoeff();
  std::vector<std::uint64_t> keys;
  keys.reserve(mesh.vertex_count());
  for (const VertexId v : mesh.vertices()) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // This is below kAxisCells in spite of rounding. It is not a number if the extent overflows, and counts as 0
      // then.
      const double cell = (mesh.position(v)[axis] - box.min()[axis]) / extent * (double(kAxisCells) - 0.5);
      code |= spread_bits(cell > 0 ? static_cast<std::uint64_t>(cell) : 0) << axis;
    }
    keys.push_back(code << 32 | v.index());
  }
  return keys;
}

/// Sorts keys whose ids ascend, by their codes: digit by digit, each pass stable.
void sort_by_code(std::vector<std::uint64_t>& keys) {
  std::vector<std::uint64_t> sorted(keys.size());
  for (int shift = 32; shift < 32 + 3 * kAxisBits; shift += kAxisBits) {
    const auto digit = [&](std::uint64_t key) { return key >> shift & (kAxisCells - 1); };
    std::array<std::size_t, kAxisCells + 1> start{};
    for (const std::uint64_t key : keys) ++start[digit(key) + 1];
    for (std::size_t i = 0; i < kAxisCells; ++i) start[i + 1] += start[i];
    for (const std::uint64_t key : keys) sorted[start[digit(key)]++] = key;
    std::swap(keys, sorted);
  }
}

}  // namespace

MarchFans::MarchFans(const Mesh& mesh, const Progress& progress) : place_(mesh.vertex_count()) {
  vertex_.reserve(mesh.vertex_count());
  std::vector<std::uint64_t> keys = compute_keys(mesh);
  sort_by_code(keys);
  for (const std::uint64_t key : keys) {
    const VertexId v{static_cast<std::uint32_t>(key)};
    place_[v] = vertex_.push_back(v);
  }
  spokes_.reserve(std::size_t(mesh.halfedge_count()) + mesh.vertex_count());
  first_.reserve(mesh.vertex_count() + 1);
  for (const VertexId v : vertex_) {
    if (first_.size() % kProgressStride == 0) report_progress(progress, "sampling", 0);
    first_.push_back(static_cast<std::uint32_t>(spokes_.size()));
    HalfedgeId last;
    for_each_outgoing(mesh, v, [&](HalfedgeId h) {
      const FaceShape& shape = mesh.shape(Mesh::face(h));
      const int i = Mesh::corner(h);
      spokes_.push_back({place_[mesh.to(h)], shape.length[i], shape.length[(i + 1) % 3], shape.twice_area});
      last = Mesh::previous(h);
    });
    if (mesh.is_boundary(v)) spokes_.push_back({place_[mesh.from(last)], mesh.length(last), 0, kNoFace});
  }
  first_.push_back(static_cast<std::uint32_t>(spokes_.size()));
}

}  // namespace gvd
