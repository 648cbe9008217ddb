#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// The reason why no path leads from a generator or source to a point.
enum class Barrier {
  no_face,     ///< the point is a vertex that no face uses
  left_out,    ///< the point lies in faces that --within or --mask leaves out
  inside,      ///< both are in the same component, separated by regions or by a largest distance
  cut_edge,    ///< the repair cut the two sheets apart at a non-manifold edge
  cut_vertex,  ///< the repair cut the two sheets apart at a non-manifold vertex
  component    ///< they are in different components, which had no vertex in common in the input either
};

/// Finds out why faces of a mesh are not connected.
class Barriers {
 public:
  /// Cost: O(n) for n faces, and O(k log k) for k copies of vertices that the repair made.
  explicit Barriers(const CheckedMesh& input);

  /// The sets of connected faces in which some given faces lie: a flag for each set.
  struct Origin {
    std::vector<char> components;  ///< by component of the mesh
    std::vector<char> by_edges;    ///< by set of components that shared non-manifold edges of the input
    std::vector<char> by_points;   ///< by set of components that shared non-manifold vertices of the input
  };
  /// The sets of the given faces. Cost: O(components and faces).
  Origin from(const std::vector<FaceId>& faces) const;

  /// The reason why no path leads from the faces of `origin` to f: the weakest barrier that applies. Cost: O(1).
  Barrier between(const Origin& origin, FaceId f) const;

 private:
  IdVector<FaceId, std::int32_t> component_;
  std::vector<std::int32_t> by_edges_, by_points_;  // for each component, the set to which it belongs
};

/// Counts the points behind each barrier, for a note.
class BarrierCounts {
 public:
  void add(Barrier barrier) { ++counts_[static_cast<std::size_t>(barrier)]; }

  /// For a single barrier "in another component"; for several with their counts, "3 in no face; 2 in another
  /// component". `inside`: the words for Barrier::inside.
  std::string describe(const std::string& inside) const;

 private:
  std::array<std::int64_t, 6> counts_{};
};

/// Describes a barrier in words that can follow "it is".
std::string describe(Barrier barrier, const std::string& inside);

}  // namespace gvd
