#include "gvd/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"
#include "mesh/visit_edges.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse(const std::string& message, std::int64_t element) {
  throw Error(ErrorCode::precondition, message, element);
}

void check_indices(const std::vector<std::array<VertexId, 3>>& faces, std::size_t vertex_count) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const VertexId v : faces[f]) {
      if (!v.valid() || v.index() >= vertex_count) {
        refuse(fmt::format("face {} refers to vertex {}, and there are {}", f, v.value(), vertex_count),
               static_cast<std::int64_t>(f));
      }
    }
    const auto& [a, b, c] = faces[f];
    if (a == b || b == c || c == a) {
      refuse(fmt::format("face {} has the same vertex twice", f), static_cast<std::int64_t>(f));
    }
  }
}

void check_positions(const std::vector<Vec3>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!positions[v].allFinite()) {
      refuse(fmt::format("vertex {} has a coordinate that is not finite", v), static_cast<std::int64_t>(v));
    }
  }
}

std::string edge_name(const Mesh& mesh, HalfedgeId h) {
  return fmt::format("{}-{}", mesh.from(h).value(), mesh.to(h).value());
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

void Mesh::link_twins() {
  twin_.assign(static_cast<std::size_t>(halfedge_count()), HalfedgeId());
  const auto number = [](VertexId v) { return static_cast<std::uint64_t>(v.value()); };
  visit_edges(faces_, positions_.size(), number, [this](const EdgeHalfedges& edge) {
    const HalfedgeId h(edge[0]);
    if (edge.size() > 2) {
      refuse(fmt::format("edge {} has {} faces, first face {}", edge_name(*this, h), edge.size(), face(h).value()),
             face(h).value());
    }
    if (edge.size() == 1) return;
    const HalfedgeId twin(edge[1]);
    if (from(h) == from(twin)) {
      refuse(fmt::format("faces {} and {} run through edge {} in the same direction", face(h).value(),
                         face(twin).value(), edge_name(*this, h)),
             face(h).value());
    }
    twin_[h] = twin;
    twin_[twin] = h;
  });
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
    if (!vertex_halfedge_[v].valid()) refuse(fmt::format("vertex {} belongs to no face", i), i);
    std::int32_t visited = 0;
    for_each_outgoing(*this, v, [&](HalfedgeId) { ++visited; });
    if (visited != degree[v.index()]) {
      refuse(fmt::format("vertex {} joins several fans of faces", i), i);
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
      refuse(fmt::format("edge {} of face {} has length {}", edge_name(*this, h), face(h).value(),
                         length > 0 ? "infinity" : "0"),
             face(h).value());
    }
    sum += length;
  }
  mean_edge_length_ = edge_count() > 0 ? sum / edge_count() : 0;
  if (vertex_count() > 0) measure_bounds();
}

void Mesh::measure_bounds() {
  Vec3 low = positions_[VertexId(0)];
  Vec3 high = low;
  for (const Vec3& p : positions_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  bbox_diagonal_ = (high - low).stableNorm();
  largest_coordinate_ = std::max(high.maxCoeff(), -low.minCoeff());
}

// stableNorm scales first, so that the squares of very large or very small coordinates neither overflow nor underflow.
void Mesh::measure_face(FaceId f) {
  const auto& [a, b, c] = vertices(f);
  const Vec3 ab = position(b) - position(a), bc = position(c) - position(b), ca = position(a) - position(c);
  shape_[f] = {{ab.stableNorm(), bc.stableNorm(), ca.stableNorm()}, ab.cross(ca).stableNorm()};
}

}  // namespace gvd
