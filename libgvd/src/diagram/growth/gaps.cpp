#include "diagram/growth/gaps.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Generators that make a face part of a gap. The paper calls a face with three of them a branching triangle, but
/// counts only the labels of its corners (section 3).
constexpr int kGapGenerators = 3;

bool has_competitors(const GeneratorTable& table, FaceId f) {
  if (!table.reached(f) || table.entry(f.value()).next < 0) return false;
  int count = 0;
  table.for_each(f, [&](const TableEntry& e) { count += e.dominated ? 0 : 1; });
  return count >= kGapGenerators;
}

}  // namespace

bool Gap::contains(FaceId f) const { return std::binary_search(faces.begin(), faces.end(), f); }

std::vector<Gap> connect_gaps(const Mesh& mesh, const std::function<bool(FaceId)>& is_in_gap) {
  std::vector<char> visited(static_cast<std::size_t>(mesh.face_count()), 0);
  std::vector<Gap> gaps;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    if (visited[FaceId(i).index()] || !is_in_gap(FaceId(i))) continue;
    Gap gap;
    gap.faces.push_back(FaceId(i));
    visited[FaceId(i).index()] = 1;
    for (std::size_t k = 0; k < gap.faces.size(); ++k) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh.twin(Mesh::halfedge(gap.faces[k], corner));
        if (!twin.valid() || visited[Mesh::face(twin).index()] || !is_in_gap(Mesh::face(twin))) continue;
        visited[Mesh::face(twin).index()] = 1;
        gap.faces.push_back(Mesh::face(twin));
      }
    }
    std::sort(gap.faces.begin(), gap.faces.end());
    gaps.push_back(std::move(gap));
  }
  return gaps;
}

std::vector<Gap> find_gaps(const Mesh& mesh, const GeneratorTable& table) {
  return connect_gaps(mesh, [&](FaceId f) { return has_competitors(table, f); });
}

}  // namespace gvd
