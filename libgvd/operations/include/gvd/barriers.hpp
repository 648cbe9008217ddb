#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// Why no path leads from a generator or a source to a point.
enum class Barrier {
  no_face,     ///< the point is a vertex in no face
  left_out,    ///< by --within or --mask
  inside,      ///< both are in one component: regions or a largest distance part them
  cut_edge,    ///< the repair cut their sheets apart at a non-manifold edge
  cut_vertex,  ///< the same at a non-manifold vertex
  component    ///< they are in components that never met
};

/// Tells what lies between faces of a mesh.
class Barriers {
 public:
  /// Cost: O(n), and O(n log n) for n copies of vertices where the repair cut sheets apart.
  explicit Barriers(const CheckedMesh& input);

  /// Where some faces are: a flag for each set of connected faces.
  struct Origin {
    std::vector<char> components;  ///< of the mesh
    std::vector<char> by_edges;    ///< connected also by non-manifold edges
    std::vector<char> by_points;   ///< connected also by non-manifold vertices
  };
  /// Cost: O(components and faces).
  Origin from(const std::vector<FaceId>& faces) const;

  /// What lies between the nearest of these faces and f, which they do not reach. Cost: O(1).
  Barrier between(const Origin& origin, FaceId f) const;

 private:
  IdVector<FaceId, std::int32_t> component_;
  std::vector<std::int32_t> by_edges_, by_points_;  // of each component: the set that it belongs to
};

/// How many things are behind each barrier, for a note.
class BarrierCounts {
 public:
  void add(Barrier barrier) { ++counts_[static_cast<std::size_t>(barrier)]; }

  /// "in another component", or with the numbers of all where there are several: "3 in no face; 2 in another
  /// component". `inside`: words for Barrier::inside.
  std::string describe(const std::string& inside) const;

 private:
  std::array<std::int64_t, 6> counts_{};
};

/// One barrier in words that follow "it is".
std::string describe(Barrier barrier, const std::string& inside);

}  // namespace gvd
