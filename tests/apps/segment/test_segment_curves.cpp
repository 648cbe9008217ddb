// gvd-segment and gvd-distance with curves in place of points.

#include <nlohmann/json.hpp>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_segment_curves {

using namespace test;

nlohmann::json read_json(const std::string& path) { return nlohmann::json::parse(read_text(path)); }

void run(const std::string& command, const std::string& arguments) {
  const CommandResult result = run_command(command, arguments);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
}

TEST_CASE("gvd-segment --curves: isolines of gvd-distance, and the curves of a diagram, make the same bands") {
  const ScratchFolder scratch;
  const std::string figure = data_file("figure.obj");
  run("gvd-distance", figure + " --from 17 --isolines 0.4 -o " + scratch / "i.json");
  run("gvd-segment", figure + " --curves " + scratch / "i.json" + " --report " + scratch / "r.json --diagram " +
                         scratch / "d.json -o " + scratch / "a.ply --threads 1");
  run("gvd-segment", figure + " --curves " + scratch / "d.json" + " --diagram " + scratch / "e.json --threads 2");
  CHECK(read_text(scratch / "d.json") == read_text(scratch / "e.json"));
  const nlohmann::json report = read_json(scratch / "r.json"), diagram = read_json(scratch / "d.json");
  const std::size_t count = read_json(scratch / "i.json")["isolines"].size();
  CHECK(report["options"]["curves"] == scratch / "i.json");
  CHECK(report["generators"].size() == count);
  CHECK(diagram["curves"].size() == count);
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(diagram["curves"][i]["points"][0]["face"] == diagram["generators"][i]["face"]);
  }
}

TEST_CASE("gvd-segment --curves boundary and creases, cut and whole, with pages and tables") {
  const ScratchFolder scratch;
  run("gvd-segment",
      data_file("half_sphere.off") + " --curves boundary --cut -o " + scratch / "a.obj --stats " + scratch / "s.csv");
  run("gvd-segment",
      data_file("plate.stl") + " --curves creases:30 -o " + scratch / "b.ply --view " + scratch / "b.html");
  run("gvd-distance", data_file("half_sphere.off") + " --curves boundary --isolines 0.2 -o " +
                          scratch / "c.obj --report " + scratch / "c.json");
  CHECK(read_json(scratch / "c.json")["options"]["curves"] == "boundary");
  CHECK(read_json(scratch / "c.json")["results"]["isolines"].size() > 3);
}

TEST_CASE("bad curves, and options that contradict them, are refused in one line") {
  const ScratchFolder scratch;
  const std::string figure = data_file("figure.obj");
  require_error("gvd-segment", data_file("torus.ply") + " --curves boundary", 4,
                "the mesh is closed and has no boundary; use --curves creases, a file of curves, or points");
  require_error("gvd-segment", data_file("torus.ply") + " --curves creases:170", 4, "more than 170 degrees");
  require_error("gvd-segment", figure + " --curves creases:0", 2, "creases:30");
  require_error("gvd-segment", figure + " --curves /nowhere.obj", 3,
                "--curves /nowhere.obj: there is no such file; write boundary, creases or the name of a file");
  require_error("gvd-segment", figure + " --curves boundary -n 5", 2, "-n and --curves exclude each other");
  require_error("gvd-segment", figure + " --curves boundary --verify", 2, "--verify");
  require_error("gvd-segment", data_file("half_sphere.off") + " --curves boundary --method gbgvd", 2, "--method exact");
  require_error("gvd-distance", figure + " -o " + scratch / "a.npy", 2, "--from or --curves");
  require_error("gvd-distance", figure + " --curves boundary --each -o " + scratch / "a.npy", 2, "--each");
  write_text(scratch / "cross.txt", "0 0.8 0.1 0.1\n0 0.1 0.1 0.8\n\n0 0.1 0.8 0.1\n0 0.45 0.05 0.5\n");
  require_error("gvd-segment", figure + " --curves " + scratch / "cross.txt", 4, "curves 0 and 1 cross in face 0");
}

}  // namespace gvd::test_segment_curves
