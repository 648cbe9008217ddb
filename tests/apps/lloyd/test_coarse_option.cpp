// --coarse: what the commands do with it, and what their reports tell.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "apps/run_command.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test_coarse_option {

using namespace test;
using Catch::Matchers::Contains;

/// A torus of 6,400 faces in a folder, and commands on it.
class Workplace {
 public:
  explicit Workplace(int count = 40) : count_(count) { write_simple_obj(scratch_ / "torus.obj", make_torus(80, 40)); }

  CommandResult run(const std::string& name, const std::string& arguments) const {
    return run_command(name, fmt::format("{} -n {} {}", scratch_ / "torus.obj", count_, arguments));
  }
  nlohmann::json report(const std::string& name, const std::string& arguments) const {
    const CommandResult result = run(name, arguments + " --report " + (scratch_ / "report.json"));
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(read_text(scratch_ / "report.json"));
  }
  std::string output(const std::string& arguments) const {
    const CommandResult result = run("gvd-lloyd", arguments + " -q -o " + (scratch_ / "out.txt"));
    REQUIRE(result.exit_code == 0);
    return read_text(scratch_ / "out.txt");
  }
  std::string file(const std::string& name) const { return scratch_ / name; }

 private:
  ScratchFolder scratch_;
  int count_;
};

TEST_CASE("gvd-lloyd --coarse: report, page and note tell of the copy, and the energy is as low") {
  const Workplace place;
  const auto plain = place.report("gvd-lloyd", "-q"),
             coarse = place.report("gvd-lloyd", "-q --coarse 2000 --view " + place.file("page.html"));
  CHECK(plain["options"]["coarse"].is_null());
  CHECK(plain["results"]["coarse"].is_null());
  CHECK(coarse["options"]["coarse"] == 2000);
  const auto& copy = coarse["results"]["coarse"];
  CHECK(copy["faces"] == 2000);
  CHECK(copy["iterations"] > 3);
  CHECK(copy["diagrams"] > 3);
  CHECK(coarse["results"]["diagrams"] < plain["results"]["diagrams"]);
  CHECK(coarse["results"]["energies"].back() < 1.005 * plain["results"]["energies"].back().get<double>());
  CHECK_THAT(read_text(place.file("page.html")), Contains("On a coarse copy"));
  CHECK_THAT(place.run("gvd-lloyd", "--coarse 2000 -o " + place.file("out.txt")).err,
             Contains("on a copy of 2000 faces first"));
}

TEST_CASE("gvd-lloyd --coarse: off is the default of small meshes, and threads change nothing") {
  const Workplace place;
  CHECK(place.output("--coarse off") == place.output(""));
  CHECK(place.output("--coarse 1500 --threads 1") == place.output("--coarse 1500 --threads 2"));
  CHECK(place.output("--coarse 1500") != place.output(""));
  CHECK(place.output("--coarse 1500 --iterations 0") == place.output("--iterations 0"));
}

TEST_CASE("gvd-lloyd --coarse: a copy that would save nothing is noted, and other values are refused") {
  const Workplace place;
  CHECK_THAT(place.run("gvd-lloyd", "--coarse 5000 -o " + place.file("out.txt")).err, Contains("not used"));
  for (const std::string value : {"0", "3", "-1", "on", "1e4"}) {
    const CommandResult result = place.run("gvd-lloyd", "--coarse " + value);
    CAPTURE(value, result.err);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("--coarse") && Contains("or 'off'"));
  }
}

TEST_CASE("gvd-remesh --coarse: the mesh is as sound, and its report tells of the copy") {
  const Workplace place;
  const auto report = place.report("gvd-remesh", "-q --coarse 2000 -o " + place.file("out.obj"));
  CHECK(report["options"]["coarse"] == 2000);
  CHECK(report["results"]["relaxation"]["coarse"]["faces"] == 2000);
  CHECK(report["results"]["output"]["vertices"] >= 40);
  CHECK(report["results"]["relaxation"]["diagrams"] == 1);
  const CommandResult idle = place.run("gvd-remesh", "--coarse 2000 --relax none");
  CHECK(idle.exit_code == 2);
  CHECK_THAT(idle.err, Contains("--coarse: no generator is moved"));
}

TEST_CASE("gvd-remesh: by default generators are relaxed on a copy where it has at most half of the faces") {
  const auto relaxation = [](int count, const std::string& options) {
    const Workplace place(count);
    return place.report("gvd-remesh", "-q " + options + "-o " + place.file("out.obj"))["results"]["relaxation"];
  };
  CHECK(relaxation(40, "")["coarse"]["faces"] == 1500);
  CHECK(relaxation(400, "")["coarse"]["faces"] == 3200);
  CHECK(relaxation(401, "")["coarse"].is_null());
  const auto off = relaxation(40, "--coarse off ");
  CHECK(off["coarse"].is_null());
  CHECK(off["diagrams"] > 10);
}

TEST_CASE("gvd-remesh: by default generators of a thin ring are relaxed on the ring itself") {
  const Workplace place;
  const std::string ring = place.file("ring.obj");
  // 0.5 high and 6.3 round: of 100 generators a third moves along the boundary.
  write_simple_obj(ring, make_ring(200, 16));
  const auto relaxation = [&](const std::string& options) {
    const std::string report = place.file("ring.json"), out = place.file("ring_out.obj");
    REQUIRE(run_command("gvd-remesh", ring + " -q -n 100 " + options + "-o " + out + " --report " + report).exit_code ==
            0);
    return nlohmann::json::parse(read_text(report))["results"]["relaxation"];
  };
  CHECK(relaxation("")["coarse"].is_null());
  CHECK_FALSE(relaxation("--loose-boundary ")["coarse"].is_null());
  CHECK(relaxation("--coarse 1500 ")["coarse"]["faces"] == 1500);
}

}  // namespace gvd::test_coarse_option
