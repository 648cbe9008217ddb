// Labels of a gap's vertices that follow from its crossings.
#include <utility>
#include <vector>

#include "diagram/growth/gap_labels.hpp"
#include "support/catch.hpp"
#include "support/hand_made_gaps.hpp"

namespace gvd::test_gap_labels {

using test::Fan;
using test::HandMade;
using test::TwoAcross;

using Moved = std::vector<std::pair<VertexId, GeneratorId>>;

std::optional<Moved> find_moved(const HandMade& x) {
  const Crossings crossings = x.crossings();
  return find_moved_labels(x.working, x.labels, GapEdges(x.mesh, crossings, x.gap, x.grown));
}

TEST_CASE("a gap of one face without crossings moves no label") {
  HandMade x;
  x.gap.faces = {Mesh::face(x.halfedge(HandMade::at(1, 1), HandMade::at(2, 1)))};
  CHECK(find_moved(x) == Moved{});
}

TEST_CASE("rim labels that no crossing separates contradict each other") {
  HandMade x;
  x.gap.faces = {Mesh::face(x.halfedge(HandMade::at(1, 1), HandMade::at(2, 1)))};
  x.label(HandMade::at(2, 1), 1);
  CHECK_FALSE(find_moved(x));
}

TEST_CASE("labels that agree with the crossings stay") {
  CHECK(find_moved(TwoAcross()) == Moved{});
  TwoAcross x;
  x.label(x.c, 1);  // an edge leads there in cell 2
  CHECK_FALSE(find_moved(x));
}

TEST_CASE("a vertex inside the gap takes the label of its edges, unless it is a generator's") {
  Fan moved;
  moved.cross({{moved.middle, moved.right},
               {moved.middle, moved.at(3, 2)},
               {moved.middle, moved.at(3, 3)},
               {moved.middle, moved.up}});
  CHECK(find_moved(moved) == Moved{{VertexId(moved.middle), GeneratorId(0)}});
  Fan generator(HandMade::at(2, 2));
  generator.cross({{generator.middle, generator.right},
                   {generator.middle, generator.at(3, 2)},
                   {generator.middle, generator.at(3, 3)},
                   {generator.middle, generator.up}});
  CHECK_FALSE(find_moved(generator));
}

TEST_CASE("an inner vertex whose edges say different labels contradicts itself") {
  Fan x;
  x.cross({{x.low, x.middle}});  // the bisector ends in the middle of the gap
  CHECK_FALSE(find_moved(x));
}

TEST_CASE("in a gap that is the whole mesh, the generator's label spreads to all vertices") {
  HandMade x(HandMade::at(4, 4));
  for (int f = 0; f < x.mesh.face_count(); ++f) x.gap.faces.emplace_back(f);
  CHECK(find_moved(x) == Moved{});
}

}  // namespace gvd::test_gap_labels
