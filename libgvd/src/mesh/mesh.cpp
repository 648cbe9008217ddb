#include "gvd/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "gvd/error.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse(const std::string& message, std::int64_t element) {
  throw Error(ErrorCode::precondition, message, element);
}

void check_indices(const std::vector<std::array<VertexId, 3>>& faces, std::size_t vertex_count) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const VertexId v : faces[f]) {
      if (!v.valid() || v.index() >= vertex_count) {
        refuse("face " + std::to_string(f) + " refers to vertex " + std::to_string(v.value()) + ", and there are " +
                   std::to_string(vertex_count) + " vertices",
               static_cast<std::int64_t>(f));
      }
    }
    const auto& [a, b, c] = faces[f];
    if (a == b || b == c || c == a) {
      refuse("face " + std::to_string(f) + " has the same vertex twice", static_cast<std::int64_t>(f));
    }
  }
}

void check_positions(const std::vector<Vec3>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!positions[v].allFinite()) {
      refuse("vertex " + std::to_string(v) + " has a coordinate that is not finite", static_cast<std::int64_t>(v));
    }
  }
}

}  // namespace

Mesh::Mesh(std::vector<Vec3> positions, std::vector<std::array<VertexId, 3>> faces) {
  check_positions(positions);
  check_indices(faces, positions.size());
  positions_ = IdVector<VertexId, Vec3>(std::move(positions));
  faces_ = IdVector<FaceId, std::array<VertexId, 3>>(std::move(faces));
  link_twins();
  number_edges();
  find_vertex_halfedges();
  measure();
}

// Pairs the halfedges by a counting sort on their smaller vertex, then a short sort within each bucket: O(n) memory,
// and O(n) time where degrees are bounded.
void Mesh::link_twins() {
  const std::int32_t n = halfedge_count();
  std::vector<std::int32_t> first(positions_.size() + 1, 0);
  const auto low = [&](HalfedgeId h) { return std::min(from(h), to(h)); };
  const auto high = [&](HalfedgeId h) { return std::max(from(h), to(h)); };
  for (std::int32_t i = 0; i < n; ++i) ++first[low(HalfedgeId(i)).index() + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<HalfedgeId> bucketed(static_cast<std::size_t>(n));
  std::vector<std::int32_t> cursor(first.begin(), first.end() - 1);
  for (std::int32_t i = 0; i < n; ++i) {
    const HalfedgeId h(i);
    bucketed[static_cast<std::size_t>(cursor[low(h).index()]++)] = h;
  }
  twin_.assign(static_cast<std::size_t>(n), HalfedgeId());
  for (std::size_t v = 0; v < positions_.size(); ++v) {
    const auto begin = bucketed.begin() + first[v];
    const auto end = bucketed.begin() + first[v + 1];
    std::sort(begin, end, [&](HalfedgeId a, HalfedgeId b) { return std::pair(high(a), a) < std::pair(high(b), b); });
    for (auto it = begin; it != end;) {
      const auto group_end = std::find_if(it, end, [&](HalfedgeId h) { return high(h) != high(*it); });
      const std::string name = std::to_string(from(*it).value()) + "-" + std::to_string(to(*it).value());
      if (group_end - it > 2) {
        refuse("edge " + name + " has " + std::to_string(group_end - it) + " faces, first face " +
                   std::to_string(face(*it).value()),
               face(*it).value());
      }
      if (group_end - it == 2) {
        if (from(it[0]) == from(it[1])) {
          refuse("faces " + std::to_string(face(it[0]).value()) + " and " + std::to_string(face(it[1]).value()) +
                     " run through edge " + name + " in the same direction",
                 face(it[0]).value());
        }
        twin_[it[0]] = it[1];
        twin_[it[1]] = it[0];
      }
      it = group_end;
    }
  }
}

void Mesh::number_edges() {
  halfedge_edge_.assign(static_cast<std::size_t>(halfedge_count()), EdgeId());
  edge_halfedge_.reserve(static_cast<std::size_t>(halfedge_count()) / 2);
  for (std::int32_t i = 0; i < halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (halfedge_edge_[h].valid()) continue;
    const EdgeId e = edge_halfedge_.push_back(h);
    halfedge_edge_[h] = e;
    if (twin_[h].valid()) halfedge_edge_[twin_[h]] = e;
  }
}

void Mesh::find_vertex_halfedges() {
  vertex_halfedge_.assign(positions_.size(), HalfedgeId());
  std::vector<std::int32_t> degree(positions_.size(), 0);
  for (std::int32_t i = 0; i < halfedge_count(); ++i) {
    const HalfedgeId h(i);
    ++degree[from(h).index()];
    HalfedgeId& chosen = vertex_halfedge_[from(h)];
    if (!chosen.valid() || (!twin_[h].valid() && twin_[chosen].valid())) chosen = h;
  }
  for (std::int32_t i = 0; i < vertex_count(); ++i) {
    const VertexId v(i);
    const HalfedgeId start = vertex_halfedge_[v];
    if (!start.valid()) refuse("vertex " + std::to_string(i) + " belongs to no face", i);
    std::int32_t visited = 0;
    HalfedgeId h = start;
    do {
      ++visited;
      h = twin_[previous(h)];
    } while (h.valid() && h != start);
    if (visited != degree[v.index()]) {
      refuse("vertex " + std::to_string(i) + " joins several fans of faces", i);
    }
  }
}

void Mesh::measure() {
  shape_.resize(faces_.size());
  for (std::int32_t f = 0; f < face_count(); ++f) measure_face(FaceId(f));
  double sum = 0;
  for (std::int32_t i = 0; i < edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = halfedge(e);
    const double length = this->length(e);
    if (!(length > 0) || !std::isfinite(length)) {
      refuse("edge " + std::to_string(from(h).value()) + "-" + std::to_string(to(h).value()) + " of face " +
                 std::to_string(face(h).value()) + " has length " + (length > 0 ? "infinity" : "0"),
             face(h).value());
    }
    sum += length;
  }
  mean_edge_length_ = edge_count() > 0 ? sum / edge_count() : 0;
  if (vertex_count() == 0) return;
  Vec3 low = positions_[VertexId(0)];
  Vec3 high = low;
  for (const Vec3& p : positions_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  bbox_diagonal_ = (high - low).stableNorm();
}

// stableNorm: the squares of very large or very small coordinates neither overflow nor vanish.
void Mesh::measure_face(FaceId f) {
  const auto& [a, b, c] = vertices(f);
  const Vec3 ab = position(b) - position(a), bc = position(c) - position(b), ca = position(a) - position(c);
  shape_[f] = {{ab.stableNorm(), bc.stableNorm(), ca.stableNorm()}, ab.cross(ca).stableNorm()};
}

}  // namespace gvd
