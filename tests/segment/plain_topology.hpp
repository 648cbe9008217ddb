#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// The topology of the faces with one label, counted from all faces, edges and vertices.
struct RegionTopology {
  int faces = 0;
  int components = 0;
  int euler_characteristic = 0;  ///< of the open region: its faces, and what only they surround

  bool operator==(const RegionTopology&) const = default;
};

namespace detail {

using Labels = IdVector<FaceId, GeneratorId>;

inline int count_components(const Mesh& mesh, const Labels& label, GeneratorId g) {
  IdVector<FaceId, char> seen(label.size(), 0);
  int components = 0;
  for (int i = 0; i < mesh.face_count(); ++i) {
    if (label[FaceId(i)] != g || seen[FaceId(i)]) continue;
    ++components;
    seen[FaceId(i)] = 1;
    for (std::vector<FaceId> stack{FaceId(i)}; !stack.empty();) {
      const FaceId f = stack.back();
      stack.pop_back();
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
        if (!twin.valid() || label[Mesh::face(twin)] != g || seen[Mesh::face(twin)]) continue;
        seen[Mesh::face(twin)] = 1;
        stack.push_back(Mesh::face(twin));
      }
    }
  }
  return components;
}

}  // namespace detail

/// Of every label that a face has.
inline std::map<GeneratorId, RegionTopology> find_topology(const Mesh& mesh, const detail::Labels& label) {
  std::map<GeneratorId, RegionTopology> regions;
  std::map<VertexId, std::set<GeneratorId>> around;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId twin = mesh.twin(HalfedgeId(h));
    const GeneratorId g = label[Mesh::face(HalfedgeId(h))];
    around[mesh.from(HalfedgeId(h))].insert(g);
    const bool inner = twin.valid() && label[Mesh::face(twin)] == g;
    if (inner && HalfedgeId(h) < twin) --regions[g].euler_characteristic;
  }
  for (const GeneratorId g : label) ++regions[g].faces, ++regions[g].euler_characteristic;
  for (const auto& [v, labels] : around) {
    if (labels.size() == 1 && !mesh.is_boundary(v)) ++regions[*labels.begin()].euler_characteristic;
  }
  for (auto& [g, region] : regions) region.components = detail::count_components(mesh, label, g);
  return regions;
}

/// The parts into which each label's faces round each vertex fall.
inline std::map<std::pair<VertexId, GeneratorId>, int> count_parts(const Mesh& mesh, const detail::Labels& label) {
  std::map<std::pair<VertexId, GeneratorId>, int> parts;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId twin = mesh.twin(HalfedgeId(h));
    const GeneratorId g = label[Mesh::face(HalfedgeId(h))];
    if (twin.valid() && label[Mesh::face(twin)] == g) continue;
    ++parts[{mesh.from(HalfedgeId(h)), g}];  // each part has one side with the vertex at its beginning
  }
  return parts;
}

/// Whether the labels differ as RegionTopology allows, from its definition.
inline bool has_same_topology(const Mesh& mesh, const detail::Labels& before, const detail::Labels& after) {
  auto old_regions = find_topology(mesh, before), regions = find_topology(mesh, after);
  if (old_regions.size() != regions.size()) return false;
  for (auto& [g, region] : regions) {
    if (region.components != old_regions[g].components) return false;
    if (region.euler_characteristic != old_regions[g].euler_characteristic) return false;
  }
  auto old_parts = count_parts(mesh, before);
  for (const auto& [at, parts] : count_parts(mesh, after)) {
    if (parts > std::max(1, old_parts[at])) return false;
  }
  return true;
}

}  // namespace gvd::test
