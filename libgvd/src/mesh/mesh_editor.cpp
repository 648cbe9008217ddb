// Splits and flips on the flat arrays of a built mesh.
//
// Each operation first reads the twins and edges outside of the faces that it rewrites, then writes the faces, then
// links their halfedges again.
// A split of an edge is a split of the face on each of its sides, so that the boundary needs no case of its own.
// Invariant: at a boundary vertex, the stored halfedge is the boundary one, as the walk in vertex_ring.hpp needs it;
// `set_halfedge` restores that for every vertex of the rewritten faces. Faces that an operation leaves keep their ids.
#include "mesh/mesh_editor.hpp"

#include <array>
#include <tuple>

#include "mesh/vertex_ring.hpp"

namespace gvd {

FaceId MeshEditor::add_face() {
  for (int i = 0; i < 3; ++i) {
    mesh_.twin_.push_back(HalfedgeId());
    mesh_.halfedge_edge_.push_back(EdgeId());
  }
  mesh_.shape_.push_back({});
  return mesh_.faces_.push_back({});
}

void MeshEditor::link(HalfedgeId h, HalfedgeId t, EdgeId e) {
  mesh_.twin_[h] = t;
  mesh_.halfedge_edge_[h] = e;
  mesh_.edge_halfedge_[e] = h;
  if (t.valid()) {
    mesh_.twin_[t] = h;
    mesh_.halfedge_edge_[t] = e;
  }
}

void MeshEditor::set_halfedge(VertexId v, HalfedgeId h) {
  const HalfedgeId start = h;
  for (HalfedgeId before = previous_outgoing(mesh_, h); before.valid(); before = previous_outgoing(mesh_, h)) {
    h = before;
    if (h == start) break;
  }
  mesh_.vertex_halfedge_[v] = h;
}

VertexId MeshEditor::split_face(FaceId f, const Vec3& position) {
  const auto [a, b, c] = mesh_.vertices(f);
  const HalfedgeId ab = Mesh::halfedge(f, 0), bc = Mesh::halfedge(f, 1), ca = Mesh::halfedge(f, 2);
  const HalfedgeId twin_bc = mesh_.twin(bc), twin_ca = mesh_.twin(ca);
  const EdgeId edge_bc = mesh_.edge(bc), edge_ca = mesh_.edge(ca);
  const VertexId v = add_vertex(position);
  const FaceId g = add_face(), k = add_face();
  set_face(f, a, b, v);
  set_face(g, b, c, v);
  set_face(k, c, a, v);
  link(Mesh::halfedge(g, 0), twin_bc, edge_bc);
  link(Mesh::halfedge(k, 0), twin_ca, edge_ca);
  const std::array<EdgeId, 3> spokes{add_edge(), add_edge(), add_edge()};
  link(Mesh::halfedge(f, 1), Mesh::halfedge(g, 2), spokes[0]);
  link(Mesh::halfedge(g, 1), Mesh::halfedge(k, 2), spokes[1]);
  link(Mesh::halfedge(k, 1), Mesh::halfedge(f, 2), spokes[2]);
  set_halfedge(v, Mesh::halfedge(f, 2));
  set_halfedge(a, ab);
  set_halfedge(b, Mesh::halfedge(g, 0));
  set_halfedge(c, Mesh::halfedge(k, 0));
  return v;
}

std::pair<HalfedgeId, HalfedgeId> MeshEditor::split_side(HalfedgeId side, VertexId v) {
  const FaceId f = Mesh::face(side);
  const VertexId p = mesh_.from(side), q = mesh_.to(side), r = mesh_.opposite(side);
  const HalfedgeId qr = Mesh::next(side), rp = Mesh::previous(side);
  const HalfedgeId twin_qr = mesh_.twin(qr), twin_rp = mesh_.twin(rp);
  const EdgeId edge_qr = mesh_.edge(qr), edge_rp = mesh_.edge(rp);
  const FaceId g = add_face();
  set_face(f, p, v, r);
  set_face(g, v, q, r);
  link(Mesh::halfedge(f, 2), twin_rp, edge_rp);
  link(Mesh::halfedge(g, 1), twin_qr, edge_qr);
  const EdgeId edge_vr = add_edge();
  link(Mesh::halfedge(f, 1), Mesh::halfedge(g, 2), edge_vr);
  return {Mesh::halfedge(f, 0), Mesh::halfedge(g, 0)};
}

VertexId MeshEditor::split_edge(HalfedgeId h, const Vec3& position) {
  const HalfedgeId t = mesh_.twin(h);
  const EdgeId edge_av = mesh_.edge(h);
  const EdgeId edge_vb = add_edge();
  const VertexId a = mesh_.from(h), b = mesh_.to(h), v = add_vertex(position);
  const VertexId c = mesh_.opposite(h);
  const VertexId d = t.valid() ? mesh_.opposite(t) : VertexId();
  const auto [av, vb] = split_side(h, v);
  HalfedgeId va, bv;
  if (t.valid()) std::tie(bv, va) = split_side(t, v);
  link(av, va, edge_av);
  link(vb, bv, edge_vb);
  set_halfedge(v, vb);
  set_halfedge(a, av);
  set_halfedge(b, Mesh::next(vb));
  set_halfedge(c, Mesh::previous(av));
  if (d.valid()) set_halfedge(d, Mesh::previous(bv));
  return v;
}

void MeshEditor::flip_edge(HalfedgeId h) {
  const HalfedgeId t = mesh_.twin(h);
  const FaceId f = Mesh::face(h), g = Mesh::face(t);
  const VertexId a = mesh_.from(h), b = mesh_.to(h), c = mesh_.opposite(h), d = mesh_.opposite(t);
  const HalfedgeId bc = Mesh::next(h), ca = Mesh::previous(h), ad = Mesh::next(t), db = Mesh::previous(t);
  struct Side {
    HalfedgeId twin;
    EdgeId edge;
  };
  const auto side = [&](HalfedgeId x) { return Side{mesh_.twin(x), mesh_.edge(x)}; };
  const Side side_bc = side(bc), side_ca = side(ca), side_ad = side(ad), side_db = side(db);
  const EdgeId diagonal = mesh_.edge(h);
  set_face(f, d, b, c);
  set_face(g, c, a, d);
  link(Mesh::halfedge(f, 0), side_db.twin, side_db.edge);
  link(Mesh::halfedge(f, 1), side_bc.twin, side_bc.edge);
  link(Mesh::halfedge(g, 0), side_ca.twin, side_ca.edge);
  link(Mesh::halfedge(g, 1), side_ad.twin, side_ad.edge);
  link(Mesh::halfedge(f, 2), Mesh::halfedge(g, 2), diagonal);
  set_halfedge(a, Mesh::halfedge(g, 1));
  set_halfedge(b, Mesh::halfedge(f, 1));
  set_halfedge(c, Mesh::halfedge(g, 0));
  set_halfedge(d, Mesh::halfedge(f, 0));
}

}  // namespace gvd
