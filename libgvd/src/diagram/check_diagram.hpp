#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

// The parts of `check_diagram`, in their order. Each of them adds its findings to `violations`.
namespace gvd {

/// The findings of a check, one line each: "(property) element id: what is wrong".
class Violations {
 public:
  void add(int property, const std::string& text) { lines_.push_back(fmt::format("({}) {}", property, text)); }
  void add(int property, const char* element, std::size_t id, const std::string& text) {
    lines_.push_back(fmt::format("({}) {} {}: {}", property, element, id, text));
  }

  bool empty() const { return lines_.empty(); }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

/// The faces of all components of the mesh that have a generator. Cells must cover them. Cost: O(n).
class ReachedFaces {
 public:
  /// Every generator must lie in a face of the mesh.
  ReachedFaces(const Mesh& mesh, const std::vector<SurfacePoint>& generators);

  bool contains(FaceId f) const { return has_generator_[component_[f]] != 0; }
  /// The Euler characteristic of all reached faces. `mesh` is the mesh of the constructor. Cost: O(n).
  std::int64_t euler_characteristic(const Mesh& mesh) const;

 private:
  IdVector<FaceId, std::int32_t> component_;
  std::vector<char> has_generator_;  // per component
};

/// Checks that all arrays have the sizes of the mesh, and that every id names an element of the mesh or of the diagram,
/// because the other checks look these ids up. Violations belong to properties (1) to (4) of `check_diagram`. Cost:
/// O(n).
void check_ids(const Mesh& mesh, const Diagram& diagram, Violations& violations);

/// Checks property (2) of `check_diagram`. Labels and pieces cover each reached face once. Cells have the area of their
/// faces and pieces. Vertices have the label of the faces and pieces at them. Expects valid ids. Cost: O(n).
void check_partition(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations);

/// Checks property (1) of `check_diagram`: every generator lies in its own cell, whose area is not negative.
/// Expects valid ids. Cost: O(n + p) for p corners of pieces.
void check_generators(const Mesh& mesh, const Diagram& diagram, Violations& violations);

/// Checks properties (3) to (5) of `check_diagram`: the points, sides and ends of bisectors, and the bisectors at each
/// branch point. Expects valid ids. Cost: O(k) for k points.
void check_bisectors(const Mesh& mesh, const Diagram& diagram, Violations& violations);

/// Checks properties (6) to (8) of `check_diagram`: components and Euler characteristics of the cells, Euler's formula
/// for the whole diagram, and the neighbours. Expects valid ids. Cost: O(n).
void check_topology(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations);

}  // namespace gvd
