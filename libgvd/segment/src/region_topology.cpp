// Decides whether changes of labels keep the topology of the regions, for a single face and for many faces together.
//
// The open region of a label consists of its faces, the edges between them, and the vertices that only they surround.
// If a face with one neighbour of its label leaves the region, F - E + V changes by -1 + 1. With two neighbours it
// changes by -1 + 2 - 1, if the corner between the two sides was inside. In every other case the region falls apart or
// a hole opens. A face that joins is the reverse of this. Many faces together, such as a ring, may be allowed to change
// although no order of single steps is. Then their faces, edges and vertices are counted before and after. Nothing else
// changes, so equal sums mean equal Euler characteristics; a search decides whether the regions are still connected.
#include "region_topology.hpp"

#include <algorithm>
#include <utility>

namespace gvd {

bool RegionSearch::connects(std::span<const FaceId> targets) {
  last_search_.resize(label_.size(), 0);
  const std::int32_t search = ++searches_;
  std::vector<FaceId> missing(targets.begin(), targets.end());
  std::ranges::sort(missing);
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  std::size_t found = 0;
  queue_.assign(1, missing[0]);
  last_search_[missing[0]] = search;
  for (std::size_t k = 0; k < queue_.size(); ++k, ++visited_faces_) {
    const FaceId f = queue_[k];
    found += std::ranges::binary_search(missing, f);
    if (found == missing.size()) return true;
    for_each_adjacent_face(mesh_, f, [&](FaceId g) {
      if (last_search_[g] == search || label_[g] != label_[f]) return;
      last_search_[g] = search;
      queue_.push_back(g);
    });
  }
  return false;
}

namespace {

/// The sides of a face across which a label lies.
struct LabelSides {
  int count = 0;
  int with = 0;     // the last side with the label
  int without = 0;  // the last side without it
};

LabelSides find_sides(const Mesh& mesh, const FaceLabelling& label, FaceId f, GeneratorId g) {
  LabelSides sides;
  for (int corner = 0; corner < 3; ++corner) {
    const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
    const bool same = twin.valid() && label[Mesh::face(twin)] == g;
    sides.count += same;
    (same ? sides.with : sides.without) = corner;
  }
  return sides;
}

}  // namespace

/// Faces that change together, the elements at them, and the counts of the labels there.
struct RegionTopology::Patch {
  std::vector<FaceId> faces;                  // ascending
  std::vector<VertexId> vertices;             // ascending
  std::map<GeneratorId, std::int32_t> euler;  // F - E + V of each label, over the elements of the faces
  // Number of groups of consecutive faces with the label around the vertex.
  std::map<std::pair<VertexId, GeneratorId>, int> parts;

  Patch(const Mesh& mesh, std::span<const FaceChange> changes) {
    for (const FaceChange& change : changes) {
      faces.push_back(change.face);
      for (const VertexId v : mesh.vertices(change.face)) vertices.push_back(v);
    }
    std::ranges::sort(faces);
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  bool holds(FaceId f) const { return std::ranges::binary_search(faces, f); }
};

RegionTopology::Fan RegionTopology::count_faces_round(VertexId v, GeneratorId g) {
  Fan fan;
  auto large = large_fans_.find(v);
  if (large == large_fans_.end()) {
    const auto count = [&](FaceId f) {
      fan.with_label += label_[f] == g;
      return ++fan.faces <= kLongestFan;
    };
    if (for_each_face_round(mesh_, v, count)) return fan;
    large = large_fans_.try_emplace(v).first;
    for_each_face_round(mesh_, v, [&](FaceId f) { return ++large->second[label_[f]] > 0; });
  }
  fan = {};
  for (const auto& [label, faces] : large->second) {
    fan.faces += faces;
    if (label == g) fan.with_label = faces;
  }
  return fan;
}

bool RegionTopology::allows(FaceId f, GeneratorId to) {
  const GeneratorId from = label_[f];
  const auto opposite = [&](int side) { return mesh_.opposite(Mesh::halfedge(f, side)); };
  const LabelSides left = find_sides(mesh_, label_, f, from), joined = find_sides(mesh_, label_, f, to);
  if (left.count == 0 || left.count == 3 || joined.count == 0) return false;
  if (left.count == 2) {
    const VertexId v = opposite(left.without);
    if (mesh_.is_boundary(v)) return false;
    const Fan fan = count_faces_round(v, from);
    if (fan.with_label != fan.faces) return false;
  }
  if (joined.count == 1) return count_faces_round(opposite(joined.with), to).with_label == 0;
  const VertexId v = opposite(joined.without);
  if (mesh_.is_boundary(v)) return false;
  const Fan fan = count_faces_round(v, to);
  return fan.with_label == fan.faces - 1;
}

void RegionTopology::relabel(FaceId f, GeneratorId to) {
  const GeneratorId from = std::exchange(label_[f], to);
  if (large_fans_.empty()) return;
  for (const VertexId v : mesh_.vertices(f)) {
    const auto found = large_fans_.find(v);
    if (found == large_fans_.end()) continue;
    --found->second[from];
    ++found->second[to];
  }
}

bool RegionTopology::relabel_together(std::span<const FaceChange> changes) {
  if (search_.visited_faces() > kMostSearches * mesh_.face_count()) return false;
  Patch before(mesh_, changes);
  const auto is_small = [&](VertexId v) {
    int faces = 0;
    return for_each_face_round(mesh_, v, [&](FaceId) { return ++faces <= kLongestFan; });
  };
  if (!std::ranges::all_of(before.vertices, is_small)) return false;
  Patch after = before;
  describe(before);
  std::vector<FaceChange> undo;
  for (const auto& [f, to] : changes) {
    undo.push_back({f, label_[f]});
    relabel(f, to);
    before.euler.try_emplace(to, 0);
  }
  describe(after);
  for (const auto& [g, euler] : before.euler) after.euler.try_emplace(g, 0);
  const auto is_no_more = [&](const auto& part) {
    const auto found = before.parts.find(part.first);
    return part.second <= 1 || (found != before.parts.end() && part.second <= found->second);
  };
  if (after.euler == before.euler && std::ranges::all_of(after.parts, is_no_more) && is_connected(after)) return true;
  for (const auto& [f, from] : undo) relabel(f, from);
  return false;
}

/// Counts the elements of each label in the patch for the present labels.
void RegionTopology::describe(Patch& patch) const {
  for (const FaceId f : patch.faces) {
    ++patch.euler[label_[f]];
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const HalfedgeId twin = mesh_.twin(h);
      if (!twin.valid() || label_[Mesh::face(twin)] != label_[f]) continue;
      if (h < twin || !patch.holds(Mesh::face(twin))) --patch.euler[label_[f]];
    }
  }
  for (const VertexId v : patch.vertices) {
    GeneratorId last;
    int parts = 0;
    const GeneratorId first = label_[Mesh::face(mesh_.halfedge(v))];
    for_each_face_round(mesh_, v, [&](FaceId f) {
      if (parts == 0 || label_[f] != last) ++parts, ++patch.parts[{v, label_[f]}];
      last = label_[f];
      return true;
    });
    if (mesh_.is_boundary(v)) continue;
    if (parts == 1) ++patch.euler[first];
    if (parts > 1 && first == last) --patch.parts[{v, first}];  // the last group continues in the first one
  }
}

/// Whether for each label of the patch, its faces in and beside the patch are connected, and there is at least one.
bool RegionTopology::is_connected(const Patch& patch) {
  std::map<GeneratorId, std::vector<FaceId>> inside, beside;
  for (const FaceId f : patch.faces) {
    inside[label_[f]].push_back(f);
    for_each_adjacent_face(mesh_, f, [&](FaceId g) {
      if (!patch.holds(g)) beside[label_[g]].push_back(g);
    });
  }
  return std::ranges::all_of(patch.euler, [&](const auto& label) {
    std::vector<FaceId>& faces = beside[label.first];
    if (faces.empty()) return false;
    faces.insert(faces.end(), inside[label.first].begin(), inside[label.first].end());
    return search_.connects(faces);
  });
}

}  // namespace gvd
