// Finds out by components why no path joins two faces.
//
// If sheets met at a non-manifold edge or vertex of the input, the repair gave them copies of its vertices. Copies
// refer to the same vertex of the input, so components that share an edge or a vertex of the input were connected
// before the repair.

#include "gvd/barriers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/union_find.hpp"

namespace gvd {
namespace {

/// Unites components with equal keys, which are neighbours in the sorted list.
template <class Key>
void unite_equal(std::vector<std::pair<Key, std::int32_t>> keyed, UnionFind& sets) {
  std::sort(keyed.begin(), keyed.end());
  for (std::size_t i = 1; i < keyed.size(); ++i) {
    if (keyed[i - 1].first == keyed[i].first) sets.unite(keyed[i - 1].second, keyed[i].second);
  }
}

/// For each vertex of the mesh, whether other vertices stand for the same vertex of the input.
IdVector<VertexId, char> find_copies(const CheckedMesh& input) {
  std::vector<std::int32_t> count(input.mesh_vertex.size());
  for (const std::int32_t of_input : input.input_vertex) count[std::size_t(std::max(of_input, 0))] += of_input >= 0;
  IdVector<VertexId, char> is_copy;
  for (const std::int32_t of_input : input.input_vertex) {
    is_copy.push_back(of_input >= 0 && count[std::size_t(of_input)] > 1 ? 1 : 0);
  }
  return is_copy;
}

}  // namespace

Barriers::Barriers(const CheckedMesh& input) : component_(compute_face_components(input.mesh)) {
  const Mesh& mesh = input.mesh;
  const auto components =
      std::size_t(component_.empty() ? 0 : 1 + *std::max_element(component_.begin(), component_.end()));
  const IdVector<VertexId, char> is_copy = find_copies(input);
  std::vector<std::pair<std::pair<std::int32_t, std::int32_t>, std::int32_t>> edges;
  std::vector<std::pair<std::int32_t, std::int32_t>> points;
  for (const HalfedgeId h : mesh.halfedges()) {
    const VertexId a = mesh.from(h), b = mesh.to(h);
    if (!is_copy[a]) continue;
    points.emplace_back(input.input_vertex[a], component_[Mesh::face(h)]);
    if (!is_copy[b]) continue;
    edges.emplace_back(std::minmax({input.input_vertex[a], input.input_vertex[b]}), component_[Mesh::face(h)]);
  }
  UnionFind sets(components);
  const auto list_sets = [&] {
    std::vector<std::int32_t> set_of;
    for (std::size_t i = 0; i < components; ++i) set_of.push_back(sets.find(std::int32_t(i)));
    return set_of;
  };
  unite_equal(std::move(edges), sets);
  by_edges_ = list_sets();
  unite_equal(std::move(points), sets);
  by_points_ = list_sets();
}

Barriers::Origin Barriers::from(const std::vector<FaceId>& faces) const {
  const std::vector<char> none(by_edges_.size(), 0);
  Origin origin{none, none, none};
  for (const FaceId f : faces) {
    const auto component = std::size_t(component_[f]);
    origin.components[component] = 1;
    origin.by_edges[std::size_t(by_edges_[component])] = 1;
    origin.by_points[std::size_t(by_points_[component])] = 1;
  }
  return origin;
}

Barrier Barriers::between(const Origin& origin, FaceId f) const {
  const auto component = std::size_t(component_[f]);
  if (origin.components[component]) return Barrier::inside;
  if (origin.by_edges[std::size_t(by_edges_[component])]) return Barrier::cut_edge;
  if (origin.by_points[std::size_t(by_points_[component])]) return Barrier::cut_vertex;
  return Barrier::component;
}

std::string describe(Barrier barrier, const std::string& inside) {
  constexpr std::array kWords{"in no face",
                              "left out by \1within\2 or \1mask\2",
                              "",
                              "beyond a non-manifold edge, where sheets were cut apart",
                              "beyond a non-manifold vertex, where sheets were cut apart",
                              "in another component"};  // in the order of Barrier
  static_assert(kWords.size() == std::size_t(Barrier::component) + 1);
  return barrier == Barrier::inside ? inside : kWords[static_cast<std::size_t>(barrier)];
}

std::string BarrierCounts::describe(const std::string& inside) const {
  std::vector<std::string> numbered, words;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i] == 0) continue;
    words.push_back(gvd::describe(static_cast<Barrier>(i), inside));
    numbered.push_back(fmt::format("{} {}", counts_[i], words.back()));
  }
  return words.size() == 1 ? words.front() : fmt::format("{}", fmt::join(numbered, "; "));
}

}  // namespace gvd
