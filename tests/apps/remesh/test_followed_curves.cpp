// Which creases and boundaries gvd-remesh follows by default, and what it says where it does not.
#include <fmt/format.h>

#include <array>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "apps/remesh/run_remesh.hpp"
#include "support/catch.hpp"
#include "support/featured_meshes.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test_followed_curves {

using namespace test;
using Catch::Matchers::Contains;

/// What a run says and reports.
struct Outcome {
  std::string err;
  nlohmann::json report;

  double followed() const { return report["results"]["creases"]["followed"]; }
  std::size_t vertices() const { return report["results"]["output"]["vertices"]; }
  /// Numbers in the first line that the pattern matches, one for each group.
  std::vector<int> numbers(const std::string& pattern) const {
    std::smatch match;
    std::vector<int> found;
    if (!std::regex_search(err, match, std::regex(pattern))) return found;
    for (std::size_t i = 1; i < match.size(); ++i) found.push_back(std::stoi(match[i].str()));
    return found;
  }
};

/// Remeshes of one mesh.
class Remesher {
 public:
  explicit Remesher(const Mesh& mesh) { write_simple_obj(scratch_ / "input.obj", mesh); }

  Outcome run(const std::string& options) const {
    const std::string report = scratch_ / "report.json";
    Outcome outcome{run_remesh(scratch_ / "input.obj " + options + " --report " + report), {}};
    outcome.report = nlohmann::json::parse(read_text(report));
    return outcome;
  }
  /// The vertices on the boundary of the remesh.
  std::size_t count_on_boundary(const std::string& options) const {
    run_remesh(scratch_ / "input.obj -q " + options + " -o " + scratch_ / "coarse.json");
    std::map<std::pair<int, int>, int> faces_of;
    const auto coarse = nlohmann::json::parse(read_text(scratch_ / "coarse.json"))["remesh"];
    for (const std::array<int, 3> face : coarse["faces"]) {
      for (int i = 0; i < 3; ++i) ++faces_of[std::minmax(face[i], face[(i + 1) % 3])];
    }
    std::set<int> on_boundary;
    for (const auto& [edge, faces] : faces_of) {
      if (faces == 1) on_boundary.insert({edge.first, edge.second});
    }
    return on_boundary.size();
  }

 private:
  ScratchFolder scratch_;
};

constexpr const char* kPlaced = "generators: (\\d+) fixed, (\\d+) on creases or the boundary, (\\d+) free";
constexpr const char* kLeftCreases = "creases: not followed, .*; -n (\\d+) or --features 40 follows them";
constexpr const char* kLeftLoops = "boundary: (\\d+) of (\\d+) loops are not followed, .*; -n (\\d+) puts some on each";

TEST_CASE("gvd-remesh: creases are followed by default where at most half of the generators do it") {
  const Remesher box(make_domed_box());
  for (const int n : {100, 150}) {
    CAPTURE(n);
    const Outcome outcome = box.run(fmt::format("-n {}", n));
    CHECK(outcome.report["options"]["features"] == "auto");
    CHECK(outcome.followed() == Approx(10));
    CHECK(outcome.numbers(kLeftCreases).empty());
    const std::vector<int> placed = outcome.numbers(kPlaced);
    REQUIRE(placed.size() == 3);
    CHECK(placed[0] == 8);
    CHECK(placed[0] + placed[1] <= n / 2);
    CHECK(placed[0] + placed[1] + placed[2] == n);
  }
}

TEST_CASE("gvd-remesh: creases that would take more than half are left, and the note says which -n follows them") {
  const Remesher box(make_domed_box());
  for (const int n : {30, 60}) {
    CAPTURE(n);
    const Outcome few = box.run(fmt::format("-n {}", n));
    CHECK(few.report["options"]["features"] == "auto");
    CHECK(few.followed() == 0);
    CHECK(few.numbers(kPlaced).empty());
    const std::vector<int> enough = few.numbers(kLeftCreases);
    REQUIRE(enough.size() == 1);
    CHECK(enough[0] > n);
    CHECK(box.run(fmt::format("-n {}", enough[0])).followed() == Approx(10));
  }
}

TEST_CASE("gvd-remesh --features: 'none' follows no crease, and an angle those that are sharper, however few -n") {
  const Remesher box(make_domed_box());
  const Outcome none = box.run("-n 100 --features none");
  CHECK(none.report["options"]["features"] == "none");
  CHECK(none.followed() == 0);
  CHECK_THAT(none.err, !Contains("creases"));
  const Outcome few = box.run("-n 30 --features 40");
  CHECK(few.report["options"]["features"] == 40);
  CHECK(few.followed() == Approx(10));
  CHECK(few.numbers(kLeftCreases).empty());
  const auto length = [&](const char* angle) {
    return double(box.run(std::string("-n 100 --features ") + angle).report["results"]["creases"]["length"]);
  };
  CHECK(length("80") == Approx(10));  // the upright edges and the ends of the others; the rest has half of it and more
  CHECK(length("95") == 0);
}

TEST_CASE("gvd-remesh: folds of slivers at the edges of a box are no creases of their own") {
  const Mesh box = make_plate(6, 0.5);
  const Remesher folded(fold_creases(box, 0.01)), plain(box);
  for (const char* features : {"auto", "40"}) {
    CAPTURE(features);
    const std::string options = std::string("-n 200 --features ") + features;
    const Outcome outcome = folded.run(options), expected = plain.run(options);
    CHECK(expected.followed() == Approx(10));
    CHECK(outcome.followed() == Approx(10).epsilon(0.01));
    CHECK(outcome.vertices() <= expected.vertices() + 20);
    CHECK(outcome.numbers(kPlaced).front() == 8);  // the corners of the box
    CHECK(outcome.report["results"]["certificate"]["self_intersections"] == 0);
    CHECK(double(outcome.report["results"]["quality"]["output"]["q_average"]) > 0.85);
  }
}

TEST_CASE("gvd-remesh: rounded edges are creases for an angle where the generators are farther apart, not by default") {
  const Remesher pillow(make_rounded_box());
  const Outcome asked = pillow.run("-n 150 --features 40");
  CHECK(asked.followed() > 6);
  CHECK(pillow.run("-n 150").followed() == 0);
}

TEST_CASE("gvd-remesh: narrow bevels are creases by default, and wide ones are not") {
  const auto rms = [](const Outcome& outcome) -> double {
    return outcome.report["results"]["distance"]["output_to_input"]["rms"];
  };
  const auto q = [](const Outcome& outcome) -> double {
    return outcome.report["results"]["quality"]["output"]["q_average"];
  };
  for (const double width : {0.002, 0.005}) {  // the spacing of 300 vertices is .15
    CAPTURE(width);
    const Remesher cube(make_bevelled_cube(width));
    const Outcome followed = cube.run("-n 300"), smooth = cube.run("-n 300 --features none");
    CHECK(followed.followed() == Approx(12).epsilon(0.01));
    CHECK(rms(followed) < 0.8 * rms(smooth));
    CHECK(q(followed) > q(smooth) - 0.02);
  }
  CHECK(Remesher(make_bevelled_cube(0.02)).run("-n 300").followed() == 0);
}

TEST_CASE("gvd-remesh: holes take no more than their share of the generators, and a note says which -n suffices") {
  const Remesher plane(make_plane_with_holes());
  const Outcome few = plane.run("-n 60");
  const std::vector<int> left = few.numbers(kLeftLoops), placed = few.numbers(kPlaced);
  REQUIRE(left.size() == 3);
  CHECK(left[0] == 16);
  CHECK(left[1] == 17);
  CHECK(left[2] > 60);
  REQUIRE(placed.size() == 3);
  CHECK(placed[0] + placed[1] <= 30);
  CHECK(few.followed() == Approx(96));  // the outline
  CHECK(plane.count_on_boundary("-n 60") <= 60 / 2 + 3 * 17);
  const Outcome enough = plane.run(fmt::format("-n {}", left[2]));
  CHECK(enough.numbers(kLeftLoops).empty());
  CHECK(enough.numbers(kPlaced).at(0) >= 4 + 2 * 16);  // of each square hole, two corners or more
  CHECK(enough.numbers(kPlaced).at(0) + enough.numbers(kPlaced).at(1) <= left[2] / 2);
  CHECK(double(enough.report["results"]["creases"]["length"]) == Approx(160));
}

TEST_CASE("gvd-remesh: --keep-boundary follows all loops, and --loose-boundary none, without a note") {
  const Remesher plane(make_plane_with_holes());
  const Outcome kept = plane.run("-n 80 --keep-boundary"), loose = plane.run("-n 80 --loose-boundary");
  CHECK(kept.numbers(kLeftLoops).empty());
  CHECK(double(kept.report["results"]["creases"]["length"]) == Approx(160));
  CHECK(loose.numbers(kLeftLoops).empty());
  CHECK(loose.followed() == 0);
}

}  // namespace gvd::test_followed_curves
