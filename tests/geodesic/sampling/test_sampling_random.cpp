// The sources of random samplings: numbers that are the same on every platform, and faces by their area.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "geodesic/sampling/samplers.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_sampling_random {

/// A row of faces between y = 0 and y = 1 whose areas are half of these bases. A base of 0 gives a face on one line.
Mesh make_row(const std::vector<double>& bases) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  double x = 0;
  for (const double base : bases) {
    const int a = static_cast<int>(positions.size());
    if (base > 0) {
      positions.insert(positions.end(), {{x, 0, 0}, {x + base, 0, 0}, {x, 1, 0}});
    } else {
      positions.insert(positions.end(), {{x, 0, 0}, {x, 0.5, 0}, {x, 1, 0}});
    }
    faces.push_back({a, a + 1, a + 2});
    x += base + 1;
  }
  return test::make_mesh(std::move(positions), faces);
}

constexpr int kDraws = 20000;

/// The number of times that each face is drawn out of [first, last) of the sampler's list.
std::vector<int> count_draws(const Mesh& mesh, const AreaSampler& sampler, std::size_t first, std::size_t last) {
  std::vector<int> count(static_cast<std::size_t>(mesh.face_count()), 0);
  SeededRandom random(11);
  for (int i = 0; i < kDraws; ++i) ++count[sampler.draw_face(random, first, last).index()];
  return count;
}

/// Five standard deviations of the number of draws that have this probability. Chance exceeds it once in 1.7 million.
double allowed_deviation(double share) { return 5 * std::sqrt(kDraws * share * (1 - share)); }

TEST_CASE("seeded random numbers are the upper 53 bits of the 64-bit Mersenne twister") {
  struct Known {
    std::uint64_t seed;
    std::array<double, 4> first;
  };
  // By an implementation of the published recurrence (Nishimura, Tables of 64-bit Mersenne twisters, 2000) that uses no
  // standard library. 5489 is the seed of the C++ standard's example.
  const std::array<Known, 4> all{{
      {0, {0x51d06f8b9683bp-53, 0x1fbfa74f87c81fp-53, 0x1442642fe065dp-53, 0x131ead2079dc7fp-53}},
      {1, {0x448b7abf76d0dp-53, 0x45d724a04631fp-53, 0xe705a3cef5cc8p-53, 0xac3b00af26b8p-53}},
      {5489, {0x192da3239eded5p-53, 0x803ef58f17901p-53, 0x16bdd196d57c8ap-53, 0x1e4b1a45a9b722p-53}},
      {~std::uint64_t{0}, {0xd4494f447f79p-53, 0x16f92220cc5ba8p-53, 0x13af6cce326abp-53, 0x1072f00c132f8ep-53}},
  }};
  for (const Known& known : all) {
    SeededRandom random(known.seed);
    for (const double expected : known.first) CHECK(random.real() == expected);
  }
}

TEST_CASE("seeded random numbers lie from 0 up to 1 and fill that evenly") {
  constexpr int kBins = 64, kCount = 64000;
  for (const std::uint64_t seed : {0, 1, 2, 99}) {
    CAPTURE(seed);
    SeededRandom random(seed);
    std::array<int, kBins> count{};
    for (int i = 0; i < kCount; ++i) {
      const double x = random.real();
      REQUIRE(x >= 0);
      REQUIRE(x < 1);
      REQUIRE(std::ldexp(x, 53) == std::floor(std::ldexp(x, 53)));
      ++count[static_cast<std::size_t>(x * kBins)];
    }
    double chi_square = 0;
    for (const int n : count) chi_square += (n - kCount / kBins) * double(n - kCount / kBins) / (kCount / kBins);
    // 63 degrees of freedom: chance leaves these bounds once in 10^5 on either side.
    CHECK(chi_square > 26);
    CHECK(chi_square < 121);
  }
}

TEST_CASE("faces are drawn as often as their areas say, and faces without area never") {
  const std::vector<double> bases{0, 1, 3, 0, 0.5, 0};
  const Mesh mesh = make_row(bases);
  const AreaSampler sampler(mesh, list_faces(mesh));
  const double sum = std::accumulate(bases.begin(), bases.end(), 0.0);
  const std::vector<int> count = count_draws(mesh, sampler, 0, bases.size());
  for (std::size_t i = 0; i < bases.size(); ++i) {
    CAPTURE(i);
    const double share = bases[i] / sum;
    CHECK(std::abs(count[i] - kDraws * share) <= allowed_deviation(share));  // 0 where there is no area
  }
}

TEST_CASE("the first and the last face of a list are drawn as often as those between") {
  const Mesh mesh = make_row({2, 2, 2, 2, 2});
  const std::vector<FaceId> listed{FaceId(3), FaceId(0), FaceId(4), FaceId(1), FaceId(2)};
  const AreaSampler sampler(mesh, listed);
  for (const int n : count_draws(mesh, sampler, 0, 5)) CHECK(std::abs(n - kDraws / 5) <= allowed_deviation(0.2));
  // A part of the list: the faces 0, 4 and 1.
  const std::vector<int> some = count_draws(mesh, sampler, 1, 4);
  for (const int f : {0, 1, 4}) {
    CHECK(std::abs(some[f] - kDraws / 3.0) <= allowed_deviation(1 / 3.0));
  }
  CHECK(some[2] + some[3] == 0);
  CHECK(count_draws(mesh, sampler, 0, 1)[3] == kDraws);
  CHECK(count_draws(mesh, sampler, 4, 5)[2] == kDraws);
}

TEST_CASE("of faces that all have no area the last one is drawn") {
  const Mesh mesh = make_row({1, 0, 0, 1});
  const AreaSampler sampler(mesh, list_faces(mesh));
  CHECK(count_draws(mesh, sampler, 1, 3)[2] == kDraws);
}

TEST_CASE("points are drawn inside a face, uniform by area") {
  const Mesh triangle = test::make_triangle();
  const AreaSampler sampler(triangle, list_faces(triangle));
  SeededRandom random(4);
  std::array<double, 3> sum{};
  double least = 1;
  std::array<int, 4> quarters{};  // at the corners, where a coordinate exceeds 1/2, and in the middle
  for (int i = 0; i < kDraws; ++i) {
    const SurfacePoint p = sampler.draw_point(random);
    REQUIRE(p.kind() == SurfacePoint::Kind::face);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += p.bary[k];
    least = std::min(least, *std::min_element(p.bary.begin(), p.bary.end()));
    const auto corner = std::find_if(p.bary.begin(), p.bary.end(), [](double b) { return b > 0.5; });
    ++quarters[corner - p.bary.begin()];
  }
  CHECK(least < 1e-4);  // points may lie close to the sides, on which they may not
  // A coordinate of a uniform point has the mean 1/3 and the variance 1/18.
  for (const double s : sum) CHECK(std::abs(s - kDraws / 3.0) <= 5 * std::sqrt(kDraws / 18.0));
  for (const int n : quarters) CHECK(std::abs(n - kDraws / 4.0) <= allowed_deviation(0.25));
}

}  // namespace gvd::test_sampling_random
