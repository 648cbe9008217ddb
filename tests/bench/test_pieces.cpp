#include "base/barycentric.hpp"
#include "bench/pieces_of_faces.hpp"
#include "pieces.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_pieces {

using namespace paper;

TEST_CASE("a line cuts a face into two parts that share its ends") {
  const LinearForm form{1, -1, -3};
  const Polygon here = clip_polygon(whole_face(), form, true);
  const Polygon there = clip_polygon(whole_face(), {-1, 1, 3}, false);
  REQUIRE(here.size() == 3);
  REQUIRE(there.size() == 4);
  CHECK(area_share(here) == Approx(0.125));
  CHECK(area_share(here) + area_share(there) == Approx(1));
  CHECK(here[1] == Bary{0.5, 0.5, 0});
  CHECK(here[2][2] == 0.25);
  CHECK(here[2][1] == 0);
}

TEST_CASE("a polygon on one side of a line stays whole or vanishes") {
  CHECK(clip_polygon(whole_face(), {1, 2, 3}, false).size() == 3);
  CHECK(clip_polygon(whole_face(), {-1, -2, -3}, true).empty());
  CHECK(clip_polygon(whole_face(), {0, 0, 1}, false).size() == 3);
  CHECK(clip_polygon(whole_face(), {0, 0, -1}, true).empty());
}

TEST_CASE("only one of two generators has a face that is equally near to both") {
  CHECK(clip_polygon(whole_face(), {0, 0, 0}, true).size() == 3);
  CHECK(clip_polygon(whole_face(), {0, 0, 0}, false).empty());
}

TEST_CASE("a line through a corner cuts no sliver off by rounding") {
  const Polygon part = clip_polygon(whole_face(), {1e-16, 1, -1}, false);
  REQUIRE(part.size() == 3);
  CHECK(area_share(part) == Approx(0.5));
}

TEST_CASE("whole faces have a contact at each inner edge") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    int inner = 0;
    for (int e = 0; e < mesh.edge_count(); ++e) inner += mesh.is_boundary(EdgeId(e)) ? 0 : 1;
    const auto contacts = find_contacts(mesh, test::whole_faces(mesh, [](FaceId) { return 0; }));
    CHECK(int(contacts.size()) == inner);
  }
}

TEST_CASE("the two parts of a cut face have a contact along the cut, the first one on its left") {
  const Mesh mesh = test::make_triangle();
  const LinearForm form{1, -1, -1}, negated{-1, 1, 1};
  const Pieces pieces{{FaceId(0), GeneratorId(0), clip_polygon(whole_face(), form, true)},
                      {FaceId(0), GeneratorId(1), clip_polygon(whole_face(), negated, false)}};
  const auto contacts = find_contacts(mesh, pieces);
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].left == 0);
  CHECK(contacts[0].right == 1);
  CHECK(contacts[0].begin == std::array<double, 3>{0.5, 0.5, 0});
  CHECK(contacts[0].end == std::array<double, 3>{0.5, 0, 0.5});
}

TEST_CASE("a long side has a contact with each of the shorter ones along it") {
  const Mesh mesh = test::make_triangle();
  const LinearForm form{1, -1, -1}, negated{-1, 1, 1}, half{0, 1, -1}, other_half{0, -1, 1};
  const Polygon rest = clip_polygon(whole_face(), negated, false);
  const Pieces pieces{{FaceId(0), GeneratorId(0), clip_polygon(whole_face(), form, true)},
                      {FaceId(0), GeneratorId(1), clip_polygon(rest, half, true)},
                      {FaceId(0), GeneratorId(2), clip_polygon(rest, other_half, true)}};
  const auto contacts = find_contacts(mesh, pieces);
  REQUIRE(contacts.size() == 3);
  CHECK(contacts[0].right == 1);
  CHECK(contacts[1].right == 2);
  CHECK(contacts[0].end == contacts[1].begin);
}

TEST_CASE("pieces of two faces have a contact where they touch, and none where they do not") {
  const Mesh mesh = test::make_grid(1, 1);
  // Both faces are cut across the diagonal in its middle, seen from either side.
  const auto cut = [&](FaceId f, int sign) {
    LinearForm form{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.position(mesh.vertices(f)[i]);
      form[i] = sign * (p.x() + p.y() - 1);
    }
    return clip_polygon(whole_face(), form, true);
  };
  const Pieces pieces{{FaceId(0), GeneratorId(0), cut(FaceId(0), 1)},
                      {FaceId(0), GeneratorId(1), cut(FaceId(0), -1)},
                      {FaceId(1), GeneratorId(0), cut(FaceId(1), 1)},
                      {FaceId(1), GeneratorId(1), cut(FaceId(1), -1)}};
  const auto contacts = find_contacts(mesh, pieces);
  REQUIRE(contacts.size() == 4);
  int same = 0;
  for (const Contact& c : contacts) same += c.right - c.left == 2 ? 1 : 0;
  CHECK(same == 2);
}

}  // namespace gvd::test_pieces
