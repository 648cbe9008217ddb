#include <algorithm>
#include <set>

#include "diagram/graph/face_diagram.hpp"
#include "support/assembled_face.hpp"
#include "support/catch.hpp"

namespace gvd::test_face_pieces {

using test::AssembledFace;

TEST_CASE("an arc cuts a corner off: a triangle and a quadrilateral, counter-clockwise") {
  const AssembledFace face({{0, 0.5, 1}, {1, 0.5, 0}}, test::flat_forms(2));
  const auto [pieces, piece_of_interval] = face.pieces();
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].generator == GeneratorId(1));
  CHECK(pieces[0].corners.size() == 3);
  CHECK(area_share(pieces[0].corners) == Approx(0.25));
  CHECK(piece_of_interval == std::vector<int>{0, 1});
  CHECK(pieces[1].generator == GeneratorId(0));
  CHECK(pieces[1].corners.size() == 4);
  CHECK(area_share(pieces[1].corners) == Approx(0.75));
}

TEST_CASE("an arc between two crossings of one edge: one piece goes all the way round") {
  const AssembledFace face({{1, 0.25, 1}, {1, 0.75, 0}}, test::flat_forms(2));
  const auto [pieces, piece_of_interval] = face.pieces();
  REQUIRE(pieces.size() == 2);
  CHECK(area_share(pieces[0].corners) == Approx(0).margin(1e-15));
  CHECK(area_share(pieces[1].corners) == Approx(1));
  CHECK(pieces[1].corners.size() == 5);
}

TEST_CASE("a cell with two intervals is one piece when they are united, and two when they are not") {
  const std::vector<test::BoundaryInterval> intervals{{0, 0.3, 1}, {0, 0.7, 0}, {1, 0.4, 1}, {1, 0.8, 0}};
  const AssembledFace united(intervals, {test::form(0, 1, 1, 1), test::form(1, 2, 2, 2)});
  const auto [pieces, piece_of_interval] = united.pieces();
  REQUIRE(pieces.size() == 3);
  CHECK(piece_of_interval[1] == piece_of_interval[3]);
  CHECK(pieces[piece_of_interval[1]].generator == GeneratorId(0));
  CHECK(std::set<int>(piece_of_interval.begin(), piece_of_interval.end()).size() == 3);
}

TEST_CASE("a branch point is a corner of its three pieces") {
  const AssembledFace face({{0, 0.5, 1}, {1, 0.5, 2}, {2, 0.5, 0}},
                           {test::form(0, 0, 1, 1), test::form(1, 1, 0, 1), test::form(2, 1, 1, 0)});
  const auto [pieces, piece_of_interval] = face.pieces();
  REQUIRE(pieces.size() == 3);
  const auto& bary = face.diagram.branches[BranchPointId(0)].bary;
  for (const WorkingPiece& piece : pieces) {
    CHECK(std::count(piece.corners.begin(), piece.corners.end(), bary) == 1);
    CHECK(area_share(piece.corners) == Approx(1.0 / 3));
  }
}

TEST_CASE("arcs may be listed in any order and from either end") {
  const std::vector<test::BoundaryInterval> intervals{{0, 0.25, 1}, {0, 0.75, 2}, {1, 0.5, 3}, {2, 0.5, 0}};
  const AssembledFace face(intervals, test::flat_forms(4));
  std::vector<FaceArc> turned(face.diagram.arcs.rbegin(), face.diagram.arcs.rend());
  for (FaceArc& arc : turned) {
    std::swap(arc.begin, arc.end);
    std::swap(arc.left, arc.right);
  }
  const auto first = face.pieces(), again = face.pieces_of(turned);
  CHECK(first.piece_of_interval == again.piece_of_interval);
  REQUIRE(first.pieces.size() == again.pieces.size());
  for (std::size_t i = 0; i < first.pieces.size(); ++i) {
    CHECK(first.pieces[i].generator == again.pieces[i].generator);
    CHECK(first.pieces[i].corners == again.pieces[i].corners);
  }
}

}  // namespace gvd::test_face_pieces
