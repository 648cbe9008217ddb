// Growth through all gaps, and gaps that are enlarged or merged until they close.
#include <algorithm>
#include <set>

#include "diagram/growth/grow_gaps.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/grown_gaps.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_grow_gaps {

const std::vector<GrowthRules> kRules{{GrowthRules::Images::unfolded}, {GrowthRules::Images::rotated}};

std::size_t count_gaps(const std::vector<ClosedGap>& closed) {
  std::size_t count = 0;
  for (const ClosedGap& c : closed) count += c.merged.size();
  return count;
}

/// Whether each gap and each face is in one closed gap at most, and each closed gap contains those that it merged.
bool are_disjoint(const std::vector<ClosedGap>& closed, const std::vector<Gap>& gaps) {
  std::set<std::size_t> merged;
  std::set<FaceId> faces;
  for (const ClosedGap& c : closed) {
    if (!std::is_sorted(c.merged.begin(), c.merged.end())) return false;
    for (const std::size_t g : c.merged) {
      const bool inside =
          std::all_of(gaps[g].faces.begin(), gaps[g].faces.end(), [&](FaceId f) { return c.gap.contains(f); });
      if (!inside || !merged.insert(g).second) return false;
    }
    for (const FaceId f : c.gap.faces) {
      if (!faces.insert(f).second) return false;
    }
  }
  return true;
}

/// Whether a closed gap has faces that none of its gaps had.
bool is_larger(const ClosedGap& c, const std::vector<Gap>& gaps) {
  std::size_t before = 0;
  for (const std::size_t g : c.merged) before += gaps[g].faces.size();
  return c.gap.faces.size() > before;
}

TEST_CASE("enlarged gaps close where they did not, on all families") {
  for (const auto& [name, mesh] : test::small_family()) {
    std::size_t gaps = 0, alone = 0, enlarged = 0, larger = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
      INFO(name << ", seed " << seed);
      const auto generators = test::random_generators(mesh, 30, seed);
      const test::Stages stages(mesh, generators, Front::circle);
      const std::vector<Gap> found = find_gaps(stages.mesh(), stages.table());
      const auto grow = [&](int enlargements) {
        return grow_gaps(stages.input(), stages.rough, found, {kRules, enlargements, {}}, {});
      };
      const auto few = grow(0), many = grow(10);
      REQUIRE(are_disjoint(few, found));
      REQUIRE(are_disjoint(many, found));
      for (const ClosedGap& c : few) REQUIRE(c.merged.size() == 1);
      gaps += found.size();
      alone += count_gaps(few);
      enlarged += count_gaps(many);
      larger += std::count_if(many.begin(), many.end(), [&](const ClosedGap& c) { return is_larger(c, found); });
    }
    INFO(name << ": " << alone << " alone, " << enlarged << " enlarged, of " << gaps << "; " << larger << " larger");
    CHECK(enlarged > alone);
    CHECK(larger > 0);
    // Measured 81 to 100 %; on meshes with many faces a generator 99 %.
    CHECK(10 * enlarged >= 8 * gaps);
  }
}

TEST_CASE("no gap grows with a forbidden edge") {
  const Mesh mesh = test::make_sphere(3);
  const test::Stages stages(mesh, test::random_generators(mesh, 20, 1), Front::circle);
  const std::vector<Gap> gaps = find_gaps(stages.mesh(), stages.table());
  const auto closed = grow_gaps(stages.input(), stages.rough, gaps, {kRules, 10, {}}, {});
  REQUIRE(count_gaps(closed) > 10);
  const EdgeId forbidden = stages.mesh().edge(Mesh::halfedge(closed[0].gap.faces[0], 0));
  const auto rest = grow_gaps(stages.input(), stages.rough, gaps, {kRules, 10, {forbidden}}, {});
  CHECK(count_gaps(rest) < count_gaps(closed));
  for (const ClosedGap& c : rest) {
    for (const FaceId f : c.gap.faces) {
      for (int corner = 0; corner < 3; ++corner) CHECK(stages.mesh().edge(Mesh::halfedge(f, corner)) != forbidden);
    }
  }
}

}  // namespace gvd::test_grow_gaps
