#include "support/section.hpp"

#include "gvd/surface_point.hpp"

namespace gvd::test {

std::optional<Bisector> make_section(const Mesh& mesh, const Vec3& normal, double offset, GeneratorId left,
                                     GeneratorId right) {
  const auto height = [&](VertexId v) { return normal.dot(mesh.position(v)) - offset; };
  const auto rises = [&](HalfedgeId h) { return height(mesh.from(h)) < 0 && height(mesh.to(h)) >= 0; };
  const auto falls = [&](HalfedgeId h) { return height(mesh.from(h)) >= 0 && height(mesh.to(h)) < 0; };
  const auto crossing = [&](HalfedgeId h) {
    const double from = height(mesh.from(h)), to = height(mesh.to(h));
    const double t = from / (from - to);
    return edge_point(h, t);
  };
  HalfedgeId start;
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!rises(h) || (start.valid() && mesh.twin(h).valid())) continue;
    start = h;
    if (!mesh.twin(h).valid()) break;  // an open curve must start at the boundary
  }
  if (!start.valid()) return std::nullopt;
  Bisector bisector{left, right, true, {}, {}};
  HalfedgeId h = start;
  do {
    bisector.points.push_back(crossing(h));
    HalfedgeId out = Mesh::next(h);
    if (!falls(out)) out = Mesh::next(out);
    h = mesh.twin(out);
    if (h.valid()) continue;
    bisector.points.push_back(crossing(out));
    bisector.closed = false;
  } while (h.valid() && h != start);
  return bisector;
}

}  // namespace gvd::test
