#pragma once

#include <cstdint>

#include "gvd/diagram.hpp"

namespace gvd::test {

inline bool same(const BranchPoint& a, const BranchPoint& b) {
  return a.point == b.point && a.position == b.position && a.generators == b.generators && a.distance == b.distance;
}

inline bool same(const Bisector& a, const Bisector& b) {
  return a.left == b.left && a.right == b.right && a.closed == b.closed && a.ends == b.ends && a.points == b.points;
}

inline bool same(const Cell& a, const Cell& b) {
  return a.generator == b.generator && a.area == b.area && a.euler_characteristic == b.euler_characteristic &&
         a.components == b.components && a.boundary_loops == b.boundary_loops && a.neighbours == b.neighbours;
}

inline bool same(const FacePiece& a, const FacePiece& b) {
  return a.face == b.face && a.generator == b.generator && a.corners == b.corners;
}

inline bool same(const DiagramReport& a, const DiagramReport& b) {
  return a.propagation_events == b.propagation_events && a.table_entries == b.table_entries &&
         a.relabelled_vertices == b.relabelled_vertices && a.gaps == b.gaps && a.gaps_grown == b.gaps_grown &&
         a.gaps_assembled == b.gaps_assembled && a.straightened_faces == b.straightened_faces &&
         a.unresolved_ends == b.unresolved_ends;
}

template <class Items>
bool same_items(const Items& a, const Items& b) {
  if (a.size() != b.size()) return false;
  for (auto i = a.begin(), j = b.begin(); i != a.end(); ++i, ++j) {
    if (!same(*i, *j)) return false;
  }
  return true;
}

/// Whether two diagrams agree in every field, to the last bit.
inline bool same_diagram(const Diagram& a, const Diagram& b) {
  return a.generators == b.generators && a.vertex_label == b.vertex_label && a.vertex_distance == b.vertex_distance &&
         same_items(a.branch_points, b.branch_points) && same_items(a.bisectors, b.bisectors) &&
         same_items(a.cells, b.cells) && a.face_label == b.face_label && same_items(a.pieces, b.pieces) &&
         a.length == b.length && same(a.report, b.report);
}

/// Whether two diagrams agree in all but lengths: labels, incidences, faces of branch points and, unless these may
/// differ, numbers of points.
enum class PointCounts : std::uint8_t { equal, any };
inline bool same_topology(const Diagram& a, const Diagram& b, PointCounts counts = PointCounts::equal) {
  const auto agree = [](const auto& x, const auto& y, auto equal) {
    if (x.size() != y.size()) return false;
    for (auto i = x.begin(), j = y.begin(); i != x.end(); ++i, ++j) {
      if (!equal(*i, *j)) return false;
    }
    return true;
  };
  return a.vertex_label == b.vertex_label && a.face_label == b.face_label &&
         agree(a.branch_points, b.branch_points,
               [](const BranchPoint& x, const BranchPoint& y) {
                 return x.point.face == y.point.face && x.generators == y.generators;
               }) &&
         agree(a.bisectors, b.bisectors,
               [counts](const Bisector& x, const Bisector& y) {
                 return x.left == y.left && x.right == y.right && x.closed == y.closed && x.ends == y.ends &&
                        (counts == PointCounts::any || x.points.size() == y.points.size());
               }) &&
         agree(a.cells, b.cells, [](const Cell& x, const Cell& y) {
           return x.euler_characteristic == y.euler_characteristic && x.boundary_loops == y.boundary_loops &&
                  x.neighbours == y.neighbours;
         });
}

}  // namespace gvd::test
