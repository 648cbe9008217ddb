#include <algorithm>
#include <cmath>
#include <limits>

#include "base/plane.hpp"
#include "diagram/assembly/face_assembly.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "support/assembled_face.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"

namespace gvd::test_face_assembly {

using test::AssembledFace;
using test::BoundaryInterval;

/// Every crossing ends one arc, with the two cells on the correct sides; every branch point ends three.
void require_complete(const AssembledFace& face) {
  for (const BoundaryCrossing& c : face.boundary) {
    int ends = 0;
    for (const FaceArc& arc : face.diagram.arcs) {
      REQUIRE(arc.left != arc.right);
      // Looking from the boundary into the face, the label before the crossing is on the left.
      if (arc.begin == at(c.id)) REQUIRE((++ends && arc.left == c.previous && arc.right == c.next));
      if (arc.end == at(c.id)) REQUIRE((++ends && arc.left == c.next && arc.right == c.previous));
    }
    REQUIRE(ends == 1);
  }
  for (std::size_t b = 0; b < face.diagram.branches.size(); ++b) {
    const BranchPointId id(b);
    std::vector<GeneratorId> cells;
    for (const FaceArc& arc : face.diagram.arcs) {
      if (arc.begin == at(id)) cells.push_back(arc.left);
      if (arc.end == at(id)) cells.push_back(arc.right);
    }
    REQUIRE(cells.size() == 3);
    REQUIRE((cells[0] != cells[1] && cells[1] != cells[2] && cells[2] != cells[0]));
    for (const double coordinate : face.diagram.branches[id].bary) REQUIRE(coordinate >= -1e-12);
  }
}

/// No two arcs cross, beyond rounding.
void require_apart(const AssembledFace& face) {
  const auto& arcs = face.diagram.arcs;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t j = i + 1; j < arcs.size(); ++j) {
      const PlaneSegment a{affine_point(face.position(arcs[i].begin)), affine_point(face.position(arcs[i].end))};
      const PlaneSegment b{affine_point(face.position(arcs[j].begin)), affine_point(face.position(arcs[j].end))};
      REQUIRE_FALSE(intersect_beyond(a, b, 1e-12));
    }
  }
}

/// The pieces cover the face once, and each label interval belongs to one piece of its own cell.
void require_partition(const AssembledFace& face) {
  double sum = 0;
  const auto [pieces, piece_of_interval] = face.pieces();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double area = area_share(pieces[i].corners);
    REQUIRE(area >= -1e-12);
    sum += area;
    REQUIRE(std::count(piece_of_interval.begin(), piece_of_interval.end(), static_cast<int>(i)) > 0);
  }
  REQUIRE(piece_of_interval.size() == face.boundary.size());
  for (std::size_t i = 0; i < face.boundary.size(); ++i) {
    REQUIRE(face.boundary[i].next == pieces.at(static_cast<std::size_t>(piece_of_interval[i])).generator);
  }
  REQUIRE(sum == Approx(1).epsilon(1e-12));
}

void require_sound(const AssembledFace& face) {
  require_complete(face);
  require_apart(face);
  require_partition(face);
}

TEST_CASE("no crossing: nothing is added") {
  FaceDiagram diagram;
  const std::vector<DistanceForm> forms;
  assemble_face(FaceId(0), {}, FormDistances(forms), diagram);
  CHECK(diagram.arcs.empty());
  CHECK(diagram.branches.empty());
}

TEST_CASE("two crossings make one arc") {
  for (const auto& intervals : {std::vector<BoundaryInterval>{{0, 0.5, 1}, {1, 0.5, 0}},
                                {{0, 0.2, 1}, {0, 0.7, 0}},
                                {{2, 0.3, 0}, {2, 0.31, 1}}}) {
    const AssembledFace face(intervals, test::flat_forms(2));
    require_sound(face);
    CHECK(face.diagram.arcs.size() == 1);
    CHECK(face.diagram.branches.empty());
  }
}

TEST_CASE("three crossings make a branch point where the three forms agree") {
  // Each generator is nearest at its own corner: the forms agree in the centre of gravity.
  const std::vector<DistanceForm> forms{test::form(0, 0, 1, 1), test::form(1, 1, 0, 1), test::form(2, 1, 1, 0)};
  const AssembledFace face({{0, 0.5, 1}, {1, 0.5, 2}, {2, 0.5, 0}}, forms);
  require_sound(face);
  REQUIRE(face.diagram.branches.size() == 1);
  for (const double coordinate : face.diagram.branches[BranchPointId(0)].bary) CHECK(coordinate == Approx(1.0 / 3));
}

TEST_CASE("a branch point guessed outside of the face is placed inside") {
  const std::vector<DistanceForm> forms{test::form(0, 0, 5, 1), test::form(1, 1, 0.9, 1), test::form(2, 1, 1.2, 0)};
  const AssembledFace face({{0, 0.5, 1}, {1, 0.5, 2}, {2, 0.5, 0}}, forms);
  require_sound(face);
  for (const double coordinate : face.diagram.branches[BranchPointId(0)].bary) CHECK(coordinate >= 1e-6);
}

TEST_CASE("four crossings of two cells: the cell that is nearer in the middle is united") {
  const std::vector<BoundaryInterval> intervals{{0, 0.3, 1}, {0, 0.7, 0}, {1, 0.4, 1}, {1, 0.8, 0}};
  for (const int near : {0, 1}) {
    const std::vector<DistanceForm> forms{test::form(0, near == 0 ? 1 : 2, near == 0 ? 1 : 2, near == 0 ? 1 : 2),
                                          test::form(1, 1.5, 1.5, 1.5)};
    const AssembledFace face(intervals, forms);
    require_sound(face);
    CHECK(face.diagram.arcs.size() == 2);
    CHECK(face.diagram.branches.empty());
    const auto [pieces, piece_of_interval] = face.pieces();
    CHECK(std::count_if(pieces.begin(), pieces.end(),
                        [&](const auto& p) { return p.generator == GeneratorId(near); }) == 1);
  }
}

TEST_CASE("four, five and six crossings of as many cells make two, three and four branch points") {
  const std::vector<BoundaryInterval> positions{{0, 0.25, 0}, {0, 0.75, 0}, {1, 0.25, 0},
                                                {1, 0.75, 0}, {2, 0.25, 0}, {2, 0.75, 0}};
  for (std::size_t k = 4; k <= 6; ++k) {
    std::vector<BoundaryInterval> intervals(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(k));
    for (std::size_t i = 0; i < k; ++i) intervals[i].next = static_cast<int>(i);
    const AssembledFace face(intervals, test::flat_forms(static_cast<int>(k)));
    require_sound(face);
    CHECK(face.diagram.branches.size() == k - 2);
    CHECK(face.diagram.arcs.size() == 2 * k - 3);
  }
}

TEST_CASE("cells without equidistant points get branch points between their corners, and pieces with area") {
  std::vector<DistanceForm> parallel;  // equally far nowhere
  for (int g = 0; g < 5; ++g) parallel.push_back(test::form(g, g, g, g));
  const AssembledFace face({{0, 0.3, 1}, {0, 0.7, 2}, {1, 0.5, 3}, {2, 0.3, 4}, {2, 0.7, 0}}, parallel);
  require_sound(face);
  CHECK(face.diagram.branches.size() == 3);
  for (const WorkingPiece& piece : face.pieces().pieces) CHECK(area_share(piece.corners) > 1e-3);
}

TEST_CASE("a cell between two intervals of another one: a, b, a, c") {
  const std::vector<BoundaryInterval> intervals{{0, 0.3, 1}, {0, 0.7, 0}, {1, 0.4, 2}, {1, 0.8, 0}};
  const std::vector<DistanceForm> near{test::form(0, 0, 0, 0), test::form(1, 1, 1, 1), test::form(2, 1, 1, 1)};
  const AssembledFace united(intervals, near);
  require_sound(united);
  CHECK(united.diagram.branches.empty());
  const std::vector<DistanceForm> far{test::form(0, 2, 2, 2), test::form(1, 1, 1, 1.1), test::form(2, 1.1, 1, 1)};
  const AssembledFace split(intervals, far);
  require_sound(split);
  CHECK(split.diagram.branches.size() == 2);
}

TEST_CASE("all crossings on one edge") {
  for (int k = 2; k <= 6; ++k) {
    for (int corner = 0; corner < 3; ++corner) {
      std::vector<BoundaryInterval> intervals;
      for (int i = 0; i < k; ++i) intervals.push_back({corner, 0.1 + 0.8 * i / k, (i + 1) % k});
      require_sound(AssembledFace(intervals, test::flat_forms(k)));
    }
  }
}

TEST_CASE("crossings at their least distance from a corner and from each other") {
  const double g = kCrossingGap;
  require_sound(AssembledFace({{0, g, 1}, {2, 1 - g, 0}}, test::flat_forms(2)));
  require_sound(AssembledFace({{0, g, 1}, {0, 2 * g, 2}, {0, 3 * g, 0}}, test::flat_forms(3)));
  require_sound(AssembledFace({{0, 1 - g, 1}, {1, g, 2}, {1, 2 * g, 3}, {2, 0.5, 0}}, test::flat_forms(4)));
}

TEST_CASE("forms that are equal, infinite, huge or not a number: still complete") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<BoundaryInterval>> all{
      {{0, 0.3, 1}, {0, 0.7, 2}, {1, 0.4, 1}, {1, 0.8, 3}, {2, 0.5, 0}},
      {{0, 0.3, 1},
       {0, 0.7, 0},
       {1, 0.4, 1},
       {1, 0.8, 0}},  // no three different cells in a row: only uniting is possible
      {{0, 0.3, 1}, {0, 0.7, 0}, {1, 0.4, 1}, {1, 0.8, 0}, {2, 0.2, 1}, {2, 0.4, 0}}};
  for (const auto& intervals : all) {
    for (const double value : {0.0, 1e-300, 1e300, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
      std::vector<DistanceForm> forms;
      for (int g = 0; g < 4; ++g) forms.push_back(test::form(g, value, value, value));
      INFO("value " << value);
      require_sound(AssembledFace(intervals, forms));
    }
  }
}

TEST_CASE("random label intervals and random forms: complete, without intersections, and a partition") {
  test::Random random(31);
  for (int round = 0; round < 6000; ++round) {
    const int count = 2 + random.below(7), cells = 2 + random.below(5);
    const auto intervals = test::random_intervals(random, count, cells);
    if (intervals.empty()) continue;
    std::vector<DistanceForm> forms;
    for (int g = 0; g < cells; ++g) {
      const double size = std::pow(10.0, random.real(-6, 6));
      forms.push_back(test::form(g, size * random.real(-1, 1), size * random.real(-1, 1), size * random.real(-1, 1)));
    }
    INFO("round " << round);
    require_sound(AssembledFace(intervals, forms));
  }
}

/// Claims to confirm, with paths that enter anywhere.
class ContradictoryDistances final : public FaceDistances, public FacePaths {
 public:
  ContradictoryDistances(const std::vector<DistanceForm>& forms, test::Random& random)
      : forms_(forms), random_(random) {}
  double at(GeneratorId g, const Bary& p) const override { return forms_.at(g, p); }
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const override {
    return forms_.equidistant(a, b, c, start);
  }
  std::vector<Bary> equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const override {
    const auto p = equidistant(a, b, c, {});
    return p ? std::vector{*p} : std::vector<Bary>{};
  }
  double crossing_error(const BoundaryCrossing&) const override {
    return random_.below(2) == 0 ? 0 : random_.real(0, 3);
  }
  std::optional<double> entry(GeneratorId, const Bary&) const override { return random_.real(0, 3); }
  bool is_branch_point(GeneratorId, GeneratorId, GeneratorId, const Bary&) const override { return false; }

 private:
  FormDistances forms_;
  test::Random& random_;
};

TEST_CASE("paths that contradict each other, as by rounding of ties: still complete") {
  test::Random random(11);
  for (int trial = 0; trial < 3000; ++trial) {
    CAPTURE(trial);
    const auto intervals = test::random_intervals(random, 2 + random.below(14), 2 + random.below(5));
    if (intervals.empty()) continue;
    const auto forms = test::flat_forms(7);
    const ContradictoryDistances distances(forms, random);
    require_complete(AssembledFace(intervals, distances, &distances));
  }
}

TEST_CASE("the lower envelope of random linear forms comes back: branch points where three forms are least") {
  test::Random random(32);
  int branches = 0;
  for (int round = 0; round < 3000; ++round) {
    const int cells = 2 + random.below(4);
    std::vector<DistanceForm> forms;
    for (int g = 0; g < cells; ++g)
      forms.push_back(test::form(g, random.real(0, 1), random.real(0, 1), random.real(0, 1)));
    const auto intervals = test::envelope_intervals(forms);
    if (intervals.size() < 2) continue;
    const AssembledFace face(intervals, forms);
    INFO("round " << round);
    require_sound(face);
    if (intervals.size() != 3) continue;
    const auto& bary = face.diagram.branches[BranchPointId(0)].bary;
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = forms[intervals[i].next].at(bary);
    if (*std::min_element(bary.begin(), bary.end()) < 1e-5) continue;  // moved inwards
    ++branches;
    REQUIRE(*std::max_element(values.begin(), values.end()) - *std::min_element(values.begin(), values.end()) < 1e-9);
  }
  CHECK(branches > 100);
}

FacePolygon polygon_of(const std::vector<int>& labels) {
  std::vector<std::pair<double, int>> positions;
  for (std::size_t i = 0; i < labels.size(); ++i)
    positions.emplace_back(3 * (static_cast<double>(i) + 0.5) / static_cast<double>(labels.size()), labels[i]);
  return test::polygon_of(test::boundary_of(positions));
}

TEST_CASE("pairs cross where their ends alternate, nested, disjoint and touching pairs do not") {
  const IntervalPair pair{0, 2, 6};
  CHECK(pair.crosses({0, 0, 4}));
  CHECK(pair.crosses({0, 3, 7}));
  CHECK_FALSE(pair.crosses({0, 3, 5}));
  CHECK_FALSE(pair.crosses({0, 0, 7}));
  CHECK_FALSE(pair.crosses({0, 0, 1}));
  CHECK_FALSE(pair.crosses({0, 2, 4}));
  CHECK_FALSE(pair.crosses({0, 4, 6}));
}

TEST_CASE("where every label comes once, there is no pair") {
  test::PointDistances distances;
  distances.points = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  CHECK(find_pairs_to_unite(polygon_of({0, 1, 2}), distances, true).empty());
}

TEST_CASE("the generator that is nearest between its intervals is united") {
  test::PointDistances distances;
  for (const int near : {0, 1}) {
    distances.points = {Vec2(near == 0 ? 0.3 : 5, 0.3), Vec2(near == 1 ? 0.3 : 5, 0.3)};
    const auto pairs = find_pairs_to_unite(polygon_of({0, 1, 0, 1}), distances, false);
    REQUIRE(pairs.size() == 1);
    CHECK(pairs[0].i == static_cast<std::size_t>(near));
    CHECK(pairs[0].j == static_cast<std::size_t>(near) + 2);
    CHECK(pairs[0].excess < 0);
  }
}

TEST_CASE("a pair that is not nearest is united only where a pair must be") {
  test::PointDistances distances;
  distances.points = {Vec2(9, 9), Vec2(0.3, 0.3), Vec2(0.4, 0.3)};
  const FacePolygon polygon = polygon_of({0, 1, 0, 2});
  CHECK(find_pairs_to_unite(polygon, distances, false).empty());  // 1 and 2 can have branch points with 0
  REQUIRE(find_pairs_to_unite(polygon, distances, true).size() == 1);
  CHECK(find_pairs_to_unite(polygon, distances, true)[0].excess > 0);
}

TEST_CASE("no two of the pairs cross, and they come in the order of their excess") {
  test::PointDistances distances;
  distances.points = {Vec2(0.3, 0.3), Vec2(0.31, 0.3)};
  const auto pairs = find_pairs_to_unite(polygon_of({0, 1, 0, 1, 0, 1, 0, 1}), distances, true);
  REQUIRE(pairs.size() > 1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK_FALSE(pairs[i].crosses(pairs[j]));
      CHECK(pairs[j].excess <= pairs[i].excess);
    }
  }
}

TEST_CASE("two intervals are united through a narrow channel, and those that it parts are not") {
  // Generator 1 is nearest in a channel of a twentieth of the face, and generator 0 everywhere else.
  class Channel final : public test::PointDistances {
   public:
    double at(GeneratorId g, const Bary& p) const override {
      const double from_middle = std::abs(affine_point(p).y() - affine_point(p).x() - 0.1);
      return g == GeneratorId(0) ? 1 : 1 + 10 * (from_middle - 0.025);
    }
  } distances;
  // The channel leads from side 1 to side 2, beside corner 0.
  const FacePolygon polygon = test::polygon_of(test::boundary_of({{1.5375, 1}, {1.5625, 0}, {2.875, 1}, {2.925, 0}}));
  const auto pairs = find_pairs_to_unite(polygon, distances, true);
  REQUIRE(pairs.size() == 1);
  CHECK(polygon[pairs[0].i].next == GeneratorId(1));
}

}  // namespace gvd::test_face_assembly
