#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"

namespace gvd {

/// Distance from one generator to one vertex. All faces round the vertex share it.
struct VertexDistance {
  double distance;        ///< mesh units, with the generator's symbolic offset
  GeneratorId generator;  ///< invalid in the first item of a vertex that no generator reaches
  std::int32_t next;      ///< index of the vertex's next item, or -1
  HalfedgeId via;         ///< halfedge opposite the vertex, in the triangle that gave the distance; invalid at the
                          ///< generator's own vertex, and at its neighbours where the distance is that along the edge
};

/// An entry of a triangle's generator table (section 4.1): a generator that may be nearest in a part of the triangle.
struct TableEntry {
  GeneratorId generator;  ///< invalid in the first entry of a triangle that no generator reaches
  FaceId face;
  std::array<std::int32_t, 3> corner;  ///< indices of the VertexDistances at the three corners
  std::int32_t next;                   ///< index of the face's next entry, or -1
  double processed_key;                ///< sum of the distances at the last propagation; infinity before the first
  bool dominated;                      ///< another generator is nearer at all three corners
};

/// The generator tables of all triangles and vertices.
///
/// Nearly every vertex and triangle has a single generator. The first item of each is therefore stored in an array at
/// the index of its vertex or face. Further items form a linked list behind all first items. Memory: about 60 bytes a
/// face.
class GeneratorTable {
 public:
  GeneratorTable(std::int32_t vertices, std::int32_t faces)
      : distances_(vertices, VertexDistance{0, GeneratorId(), -1, HalfedgeId()}),
        entries_(faces, TableEntry{GeneratorId(), FaceId(), {-1, -1, -1}, -1, 0, false}) {}

  VertexDistance& distance(std::int32_t index) { return distances_[index]; }
  const VertexDistance& distance(std::int32_t index) const { return distances_[index]; }
  TableEntry& entry(std::int32_t index) { return entries_[index]; }
  const TableEntry& entry(std::int32_t index) const { return entries_[index]; }

  /// Index of generator g's distance at v, or -1. Cost: O(generators that reach v).
  std::int32_t find(VertexId v, GeneratorId g) const { return find_in(distances_, v.value(), g); }
  /// Index of generator g's entry in f's table, or -1.
  std::int32_t find(FaceId f, GeneratorId g) const { return find_in(entries_, f.value(), g); }

  /// Adds an item that is not there yet, and returns its index. References to other items become invalid.
  std::int32_t add(VertexId v, GeneratorId g, double distance, HalfedgeId via) {
    return add_to(distances_, v.value(), VertexDistance{distance, g, -1, via});
  }
  std::int32_t add(FaceId f, GeneratorId g, const std::array<std::int32_t, 3>& corner, double key) {
    return add_to(entries_, f.value(), TableEntry{g, f, corner, -1, key, false});
  }

  /// Lowers generator g's distance at v to `distance`, or adds it, without a halfedge. Returns its index.
  std::int32_t lower(VertexId v, GeneratorId g, double distance) {
    const std::int32_t index = find(v, g);
    if (index < 0) return add(v, g, distance, HalfedgeId());
    distances_[index].distance = std::min(distances_[index].distance, distance);
    return index;
  }

  bool reached(VertexId v) const { return distances_[v.index()].generator.valid(); }
  bool reached(FaceId f) const { return entries_[f.index()].generator.valid(); }

  /// Calls visit(const VertexDistance&) for every generator that reaches v.
  template <class Visit>
  void for_each(VertexId v, Visit visit) const {
    if (!reached(v)) return;
    for (std::int32_t i = v.value(); i >= 0; i = distance(i).next) visit(distance(i));
  }
  /// Calls visit(const TableEntry&) for every entry of f's table.
  template <class Visit>
  void for_each(FaceId f, Visit visit) const {
    if (!reached(f)) return;
    for (std::int32_t i = f.value(); i >= 0; i = entry(i).next) visit(entry(i));
  }

  std::array<double, 3> corner_distances(const TableEntry& e) const {
    return {distance(e.corner[0]).distance, distance(e.corner[1]).distance, distance(e.corner[2]).distance};
  }
  std::size_t entry_count() const { return entries_.size(); }

 private:
  template <class T>
  static std::int32_t find_in(const std::vector<T>& items, std::int32_t head, GeneratorId g) {
    if (!items[head].generator.valid()) return -1;
    for (std::int32_t i = head; i >= 0; i = items[i].next) {
      if (items[i].generator == g) return i;
    }
    return -1;
  }
  template <class T>
  static std::int32_t add_to(std::vector<T>& items, std::int32_t head, const T& item) {
    T& first = items[head];
    if (!first.generator.valid()) {
      first = item;
      return head;
    }
    const auto index = static_cast<std::int32_t>(items.size());
    const std::int32_t second = first.next;
    first.next = index;
    items.push_back(item);
    items.back().next = second;
    return index;
  }

  std::vector<VertexDistance> distances_;
  std::vector<TableEntry> entries_;
};

}  // namespace gvd
