#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/propagation/face_crossing.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "geodesic/windows/vertex_fan.hpp"

namespace gvd {

/// A generator, or a pseudo-source that a path has reached, that will send windows.
struct VertexEvent {
  VertexCopyId vertex;
  bool all_round;  ///< into all directions: a generator, or an ambiguous vertex
  VertexPath path;
};

/// The directions at a vertex of a curve, between two of its segments or between a segment and the boundary, in which
/// the vertex is the nearest point of the curve. They form at least a right angle with the segments. An invalid ray
/// stands for the boundary.
struct CurveSector {
  FanRay first, last;  ///< counter-clockwise
};

/// Sends windows from generators and pseudo-sources into the faces of one partition: in all directions, or only in
/// directions in which arriving shortest paths can continue (VertexFan).
class PseudoSources {
 public:
  /// All arguments must outlive this object.
  PseudoSources(const Mesh& mesh, const FaceFrames& frames, const MeshPartitions& partitions,
                const CornerAngles& angles, PartitionId own)
      : mesh_(mesh), frames_(frames), partitions_(partitions), angles_(angles), own_(own), fan_(frames) {}

  bool is_first_copy(VertexCopyId v) const { return v.value() < mesh_.vertex_count(); }

  /// Calls target.reach_vertex(VertexCopyId, const VertexPath&) for neighbours that the vertex reaches along a side,
  /// and target.enqueue_on_edge(const Window&, const WindowHistory&, const WindowEdge&) for windows.
  template <class Target>
  void send(const VertexEvent& event, Target& target) const {
    if (event.all_round) {
      send_all_round(event, target);
      return;
    }
    const FanRay left = fan_.straight_left(event.path.back), right = fan_.straight_right(event.path.back);
    if (frames_.kind[event.vertex] == VertexKind::saddle) {
      if (left.valid() && right.valid()) {
        send_between(event, left, right, target);
      } else {
        send_all_round(event, target);  // rounding hides the straight continuation
      }
    } else {
      if (left.valid()) send_between(event, left, {}, target);
      if (right.valid()) send_between(event, {}, right, target);
    }
  }

  /// Sends windows from a vertex of a curve, and paths along all edges there, so that each edge to which a window comes
  /// has distances at both ends, as FaceCrossing requires.
  template <class Target>
  void send_from_curve(VertexCopyId v, GeneratorId g, std::span<const CurveSector> sectors, Target& target) const {
    const VertexEvent event{v, false, {0, g, {}}};
    const HalfedgeId start = mesh_.halfedge(partitions_.vertex(v));
    HalfedgeId h = start;
    do {
      if (partitions_.of_halfedge(h) == own_) reach_along_sides(event.path, h, target);
      h = fan_.left_of(h);
    } while (h.valid() && h != start);
    for (const CurveSector& sector : sectors) send_between(event, sector.first, sector.last, target);
  }

 private:
  /// Sends paths along both sides of a face at the vertex that `outgoing` leaves.
  template <class Target>
  void reach_along_sides(const VertexPath& path, HalfedgeId outgoing, Target& target) const {
    const FaceFrame& f = fan_.face(outgoing);
    const std::size_t c = Mesh::corner(outgoing), p = (c + 1) % 3, q = (c + 2) % 3;
    const Rotation back{f.cosine[p], f.sine[p]};
    target.reach_vertex(f.vertex[p], {path.distance + f.length[c], path.generator, {Mesh::next(outgoing), back}});
    target.reach_vertex(f.vertex[q], {path.distance + f.length[q], path.generator, {Mesh::previous(outgoing), {}}});
  }

  template <class Target>
  void send_all_round(const VertexEvent& event, Target& target) const {
    const HalfedgeId start = mesh_.halfedge(partitions_.vertex(event.vertex));
    HalfedgeId h = start;
    do {
      send_into(event, {h, nullptr, nullptr}, target);
      h = fan_.left_of(h);
    } while (h.valid() && h != start);
  }

  /// Sends windows from `first` counter-clockwise to `last`; an invalid ray stands for the boundary.
  template <class Target>
  void send_between(const VertexEvent& event, const FanRay& first, const FanRay& last, Target& target) const {
    if (first.valid()) {
      for (HalfedgeId h = first.halfedge; h.valid(); h = fan_.left_of(h)) {
        const bool ends = last.valid() && h == last.halfedge;
        send_into(event, {h, h == first.halfedge ? &first.angle : nullptr, ends ? &last.angle : nullptr}, target);
        if (ends) return;
      }
    } else {
      for (HalfedgeId h = last.halfedge; h.valid(); h = fan_.right_of(h)) {
        send_into(event, {h, nullptr, h == last.halfedge ? &last.angle : nullptr}, target);
      }
    }
  }

  /// Sends a window through a sector of a face, and paths along the sides of the face that bound the sector. Does
  /// nothing for faces of other partitions, which the events of the vertex's copies there handle.
  template <class Target>
  void send_into(const VertexEvent& event, const FanSector& sector, Target& target) const {
    const HalfedgeId outgoing = sector.outgoing;
    if (partitions_.of_halfedge(outgoing) != own_) return;
    const FaceFrame& f = fan_.face(outgoing);
    const std::size_t c = Mesh::corner(outgoing), p = (c + 1) % 3, q = (c + 2) % 3;
    const HalfedgeId at_p = Mesh::next(outgoing), at_q = Mesh::previous(outgoing);
    const VertexPath& path = event.path;
    Departure to_p = path.departure, to_q = path.departure, through = path.departure;
    if (!angles_.empty() && !path.back.valid()) {  // a generator
      to_p = angles_.side(outgoing);
      to_q = to_p + angles_.corner(outgoing);
      through = to_p - angles_.corner(at_p);
    }
    if (!sector.first || sector.first->is_grazing()) {
      const Rotation back{f.cosine[p], f.sine[p]};
      target.reach_vertex(f.vertex[p], {path.distance + f.length[c], path.generator, {at_p, back}, to_p});
    }
    if (!sector.last || (fan_.corner(outgoing) - *sector.last).is_grazing()) {
      target.reach_vertex(f.vertex[q], {path.distance + f.length[q], path.generator, {at_q, {}}, to_q});
    }
    WindowHistory history{1, 0, Mesh::face(outgoing), through};
    if (!sector.last && is_flat(f.vertex[q])) history.joinable_ends |= WindowHistory::kAtBegin;
    if (!sector.first && is_flat(f.vertex[p])) history.joinable_ends |= WindowHistory::kAtEnd;
    target.enqueue_on_edge(window_from_vertex(f, sector, path), history, exit_edge(f, at_p, p, q));
  }

  bool is_flat(VertexCopyId v) const { return frames_.kind[v] == VertexKind::flat; }

  const Mesh& mesh_;
  const FaceFrames& frames_;
  const MeshPartitions& partitions_;
  const CornerAngles& angles_;
  PartitionId own_;
  VertexFan fan_;
};

}  // namespace gvd
