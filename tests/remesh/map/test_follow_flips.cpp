// Points follow flips of edges one-to-one: there and back they are where they were, and borders stay.
#include <algorithm>

#include "map/follow_flips.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_follow_flips {

EdgeFlip find_flip(const Mesh& mesh, HalfedgeId h) {
  const HalfedgeId back = mesh.twin(h);
  return {Mesh::face(h), Mesh::face(back), mesh.from(h), mesh.to(h), mesh.opposite(h), mesh.opposite(back)};
}

/// The flip that takes back the edge; the two faces have then exchanged their ids.
EdgeFlip inverse(const EdgeFlip& flip) {
  return {flip.left, flip.right, flip.right_apex, flip.left_apex, flip.from, flip.to};
}

Mesh with_flips(const Mesh& mesh, const std::vector<EdgeFlip>& flips) {
  return {mesh.positions(), apply_flips(mesh.face_vertices(), flips)};
}

TEST_CASE("a point that follows a flip and its inverse is where it was, and one off the two faces stays") {
  const Mesh given = test::make_bumpy_sphere(2, 1);
  test::Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const EdgeFlip flip = find_flip(given, HalfedgeId(random.below(given.halfedge_count())));
    const Mesh mesh(given.positions(), undo_flips(given.face_vertices(), {flip}));
    const std::vector<EdgeFlip> once{flip}, twice{flip, inverse(flip)};
    const Mesh flipped = with_flips(mesh, once), back = with_flips(mesh, twice);
    const FlipFollower to(mesh, flipped, once), around(mesh, back, twice);
    for (const FaceId f : mesh.faces()) {
      const double a = random.real(0, 1), b = random.real(0, 1 - a);
      const SurfacePoint point = make_surface_point(f, {a, b, 1 - a - b}), moved = to.follow(point);
      const bool is_flipped = f == flip.left || f == flip.right;
      CHECK((moved.face == flip.left || moved.face == flip.right) == is_flipped);
      if (!is_flipped) CHECK(position(flipped, moved) == position(mesh, point));
      CHECK((position(back, around.follow(point)) - position(mesh, point)).norm() < 1e-12);
    }
  }
}

/// The point of a halfedge at t in [0, 1]: its start at 0, its end at 1.
SurfacePoint point_on(const Mesh& mesh, HalfedgeId h, double t) {
  if (t == 0) return vertex_point(mesh, mesh.from(h));
  return t == 1 ? vertex_point(mesh, mesh.to(h)) : edge_point(h, t);
}

TEST_CASE("vertices and the four sides stay where they are, and the diagonals' crossing is on both") {
  const Mesh given = test::make_grid(2, 2);
  HalfedgeId inner(0);
  while (!given.twin(inner).valid()) inner = HalfedgeId(inner.value() + 1);
  const EdgeFlip flip = find_flip(given, inner);
  const Mesh mesh(given.positions(), undo_flips(given.face_vertices(), {flip}));
  const std::vector<EdgeFlip> flips{flip};
  const Mesh flipped = with_flips(mesh, flips);
  const FlipFollower follower(mesh, flipped, flips);
  for (const FaceId f : {flip.left, flip.right}) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const bool is_diagonal =
          mesh.twin(h).valid() && Mesh::face(mesh.twin(h)) == (f == flip.left ? flip.right : flip.left);
      for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const SurfacePoint point = point_on(mesh, h, t);
        const SurfacePoint moved = follower.follow(point);
        if (!is_diagonal || t == 0 || t == 1) {
          CHECK((position(flipped, moved) - position(mesh, point)).norm() < 1e-15);
          CHECK(moved.kind() == point.kind());
        } else if (t == 0.5) {
          CHECK(moved.kind() == SurfacePoint::Kind::edge);
        }
      }
    }
  }
}

}  // namespace gvd::test_follow_flips
