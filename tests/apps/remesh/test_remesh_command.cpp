// gvd-remesh on files: its JSON carries the diagram and the mesh, and a refusal is one line.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/remesh/run_remesh.hpp"
#include "support/catch.hpp"

namespace gvd::test_remesh_command {

using namespace test;
using Catch::Matchers::Contains;

TEST_CASE("gvd-remesh: sampled generators are relaxed, --relax none moves none") {
  const std::string run = data_file("figure.obj") + " -n 100 --place generator";
  const auto plain = report_of(run + " --relax none"), relaxed = report_of(run),
             longer = report_of(run + " --relax 40");
  CHECK(plain["options"]["relax"] == "none");
  CHECK(plain["results"]["relaxation"].is_null());
  CHECK(relaxed["options"]["relax"] == 15);
  const int iterations = relaxed["results"]["relaxation"]["iterations"];
  CHECK((iterations > 10 && iterations <= 20));  // with those after ends of limbs are taken
  CHECK(longer["results"]["relaxation"]["iterations"] > iterations);
  const auto& relaxation = relaxed["results"]["relaxation"];
  CHECK(relaxation["final_energy"] < relaxation["initial_energy"]);
  const auto quality = [](const auto& report) { return double(report["results"]["quality"]["output"]["q_average"]); };
  CHECK(quality(relaxed) > quality(plain) + 0.03);
}

TEST_CASE(
    "gvd-remesh: a spike that no generators fit round is its own triangles, and the report, the map and stderr say "
    "so") {
  // A pyramid over a pentagon whose apex has a total angle of a thousandth of a degree.
  const ScratchFolder scratch;
  std::string spike = "OFF\n7 10 0\n0 0 1\n";
  const double turn = 2 * std::acos(-1.0) / 5, radius = 1.484e-6;
  for (int i = 0; i < 5; ++i) {
    spike += fmt::format("{} {} 0\n", radius * std::cos(turn * i), radius * std::sin(turn * i));
  }
  spike += "0 0 0\n";
  for (int i = 1; i <= 5; ++i) spike += fmt::format("3 0 {} {}\n3 6 {} {}\n", i, i % 5 + 1, i % 5 + 1, i);
  write_text(scratch / "spike.off", spike);
  const std::string run = scratch / "spike.off" + " -n 10";
  const auto results = report_of(run + " --map " + scratch / "map.json")["results"];
  CHECK(results["decimated_components"] == 1);
  CHECK(results["decimated_vertices"] == results["output"]["vertices"]);
  CHECK(results["certificate"]["manifold"] == true);
  CHECK(results["map"]["obstacle"] == "a connected part is decimated, and not the dual of its cells");
  const CommandResult plain = run_command("gvd-remesh", run + " -o " + scratch / "coarse.obj");
  CHECK(plain.exit_code == 0);
  CHECK_THAT(plain.err, Contains("the surface is the input's own triangles, decimated to 7 vertices in place of 10 "
                                 "generators, since the dual of generators there is no valid mesh: it has a tip too "
                                 "narrow for generators; the first defect: "));
  CHECK(results["decimated_generators"] == 10);
  CHECK(run_command("gvd-remesh", run + " --no-refine -o " + scratch / "none.obj").exit_code == 5);
}

TEST_CASE("gvd-remesh: --drop-smaller-than leaves small components out, and report, map and stderr say so") {
  const ScratchFolder scratch;
  write_text(scratch / "parts.off",
             "OFF\n12 12 0\n0 0 0\n.1 0 0\n0 .1 0\n0 0 .1\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n5 5 5\n5 5 6\n"
             "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 6 8\n3 6 5 8\n3 5 7 8\n3 7 4 8\n3 6 4 9\n3 5 6 9\n3 7 5 9\n3 4 7 "
             "9\n");
  const std::string run = scratch / "parts.off" + " -n 6 --drop-smaller-than ";
  const auto report = report_of(run + "10% --map " + scratch / "map.json");
  CHECK(report["options"]["drop_smaller_than"] == "10%");
  CHECK(report["input"]["components"] == 1);
  CHECK(report["input"]["defects"]["dropped_components"] == 1);
  CHECK(report["results"]["certificate"]["dropped_components"] == 1);
  CHECK(report["results"]["output"]["components"] == 1);
  const auto map = nlohmann::json::parse(read_text(scratch / "map.json"))["input_vertices"];
  CHECK((map[3].is_null() && !map[4].is_null()));
  const CommandResult told = run_command("gvd-remesh", run + "0.2 -o " + scratch / "coarse.obj");
  CHECK_THAT(told.err, Contains("1 component is smaller than 0.2, first the one of face 0: left out, with "));
  const CommandResult all = run_command("gvd-remesh", run + "4 -o " + scratch / "none.obj");
  CHECK(all.exit_code == 4);
  CHECK_THAT(all.err,
             Contains("all components are smaller than 4, the largest one ") && Contains("--drop-smaller-than"));
}

TEST_CASE("gvd-remesh: listed generators stay where they are, unless --relax asks to move them") {
  const ScratchFolder scratch;
  const std::string run = data_file("figure.obj") + " --generators " + scratch / "list.json";
  write_text(scratch / "list.json", report_of(data_file("figure.obj") + " -n 60 --relax none").dump());
  const auto given = nlohmann::json::parse(read_text(scratch / "list.json")), kept = report_of(run);
  const auto first = [](const auto& report) { return report["generators"][0]["position"]; };
  CHECK(kept["results"]["relaxation"].is_null());
  CHECK(first(kept) == first(given));
  CHECK(first(report_of(run + " --relax 3")) != first(given));
}

TEST_CASE("gvd-remesh: the report tells how far listed positions were from the surface") {
  const ScratchFolder scratch;
  write_text(scratch / "list.txt", "p 0 0 5\n100\n");
  const auto generators = report_of(data_file("torus.ply") + " --generators " + scratch / "list.txt")["generators"];
  CHECK(generators[0]["snap_distance"] > 1);
  CHECK(!generators[1].contains("snap_distance"));
}

TEST_CASE("gvd-remesh: constraints hold in the relaxation, and are refused where nothing moves") {
  const ScratchFolder scratch;
  write_text(scratch / "fixed.txt", "5\n77\n");
  const std::string fixed = " --fixed " + scratch / "fixed.txt", run = data_file("figure.obj") + " -n 60";
  const auto report = report_of(run + fixed + " --density curvature");
  CHECK(report["options"]["density"] == "curvature");
  CHECK(report["generators"].size() >= 60);
  CHECK(report["generators"][0]["position"] == report_of(run + fixed)["generators"][0]["position"]);
  const CommandResult idle = run_command("gvd-remesh", run + fixed + " --relax none");
  CHECK(idle.exit_code == 2);
  CHECK_THAT(idle.err, Contains("--fixed: no generator is moved; leave it out, or leave out --relax none"));
  const CommandResult listed =
      run_command("gvd-remesh", data_file("figure.obj") + " --vertices 1,9 --density curvature");
  CHECK(listed.exit_code == 2);
  CHECK_THAT(listed.err, Contains("--density: no generator is moved; ask for it with --relax N"));
  const CommandResult text = run_command("gvd-remesh", run + " --relax some");
  CHECK(text.exit_code == 2);
  CHECK_THAT(text.err, Contains("--relax: 'some' is not a whole number from 0 to 1000000 or 'none'"));
}

TEST_CASE("gvd-remesh --features: a box of eight vertices, and a thin one with its edges") {
  const ScratchFolder scratch;
  const auto box = report_of(data_file("plate.stl") + " -n 8 --features 40");
  CHECK(box["results"]["output"]["vertices"] == 8);
  CHECK(box["results"]["output"]["faces"] == 12);
  CHECK(double(box["results"]["distance"]["input_to_output"]["hausdorff"]) < 1e-9);
  const auto creases = report_of(data_file("plate.stl") + " -n 60 --features 40")["results"]["creases"];
  CHECK(creases["followed"] == creases["length"]);
  CHECK(creases["added_generators"] > 0);
}

TEST_CASE("gvd-remesh: the boundary is kept for sampled generators, unless it is loose or takes too many") {
  const std::string run = data_file("half_sphere.off") + " --place generator";
  const auto followed = [](const auto& report) { return double(report["results"]["creases"]["followed"]); };
  const auto kept = report_of(run + " -n 60"), loose = report_of(run + " -n 60 --loose-boundary");
  CHECK(followed(kept) > 6);
  CHECK(followed(loose) == 0);
  const auto distance = [](const auto& r) { return double(r["results"]["distance"]["input_to_output"]["hausdorff"]); };
  CHECK(distance(kept) < 0.5 * distance(loose));
  CHECK(followed(report_of(run + " -n 3")) == 0);
  CHECK(followed(report_of(run + " --vertices 0,9,100,200")) == 0);
  CHECK(followed(report_of(run + " --vertices 0,9,100,200 --keep-boundary")) > 6);
  const CommandResult both = run_command("gvd-remesh", run + " -n 60 --keep-boundary --loose-boundary");
  CHECK(both.exit_code == 2);
  CHECK_THAT(both.err, Contains("--keep-boundary and --loose-boundary exclude each other: keep one"));
}

TEST_CASE("gvd-remesh: a single triangle gets as many vertices as asked for, most of them on its boundary") {
  const ScratchFolder scratch;
  write_text(scratch / "one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto report = report_of(scratch / "one.off" + " -n 10");
  CHECK(report["results"]["output"]["vertices"] == 10);
  CHECK(report["results"]["creases"]["followed"] == report["results"]["creases"]["length"]);
}

TEST_CASE("gvd-remesh: what edges do not follow is at most the whole length, and the note says what helps") {
  const ScratchFolder scratch;
  const std::string bowl = data_file("half_sphere.off");
  write_text(scratch / "list.json", report_of(bowl + " -n 60 --sampling poisson --loose-boundary --relax none").dump());
  const std::string run = bowl + " --keep-boundary --generators " + scratch / "list.json";
  for (const auto& [options, advice] :
       {std::pair{" --no-refine", "without --no-refine and --exact-count, generators are added there"},
        std::pair{" --max-added 0", "raise --max-added"}}) {
    const CommandResult result = run_command("gvd-remesh", run + options + " --report " + scratch / "report.json");
    REQUIRE(result.exit_code == 0);
    CHECK_THAT(result.err, Contains("edges do not follow 100 % of their length; " + std::string(advice)));
    const auto report = nlohmann::json::parse(read_text(scratch / "report.json"));
    CHECK(report["results"]["creases"]["followed"] == 0);
  }
}

TEST_CASE("gvd-remesh: listed generators with few digits are on the creases that they came from") {
  const ScratchFolder scratch;
  const std::string plate = data_file("plate.stl") + " --features 40";
  const auto placed = report_of(plate + " -n 60 --relax none");
  std::string list;
  for (const auto& generator : placed["generators"]) {
    const auto& p = generator["position"];
    list += fmt::format("{:.6g} {:.6g} {:.6g}\n", double(p[0]), double(p[1]), double(p[2]));
  }
  write_text(scratch / "list.txt", list);
  const auto creases = report_of(plate + " --generators " + scratch / "list.txt")["results"]["creases"];
  CHECK(creases["followed"] == creases["length"]);
  CHECK(creases["added_generators"] == 0);
}

TEST_CASE("gvd-remesh: notes on creases do not contradict each other") {
  const std::string run = data_file("half_sphere.off") + " --vertices 30,11 --keep-boundary --allow-intersections";
  const CommandResult few = run_command("gvd-remesh", run + " --max-added 1");
  CHECK_THAT(few.err, Contains("1 generator was added on creases and boundaries\n"));
  CHECK_THAT(few.err, Contains("edges do not follow 100 % of their length; raise --max-added"));
  const CommandResult enough = run_command("gvd-remesh", run);
  CHECK_THAT(enough.err, Contains("added on creases and boundaries, which the edges then follow"));
  CHECK_THAT(enough.err, !Contains("do not follow"));
}

/// A flat square with k x k square holes, as OFF.
std::string sheet_with_holes(int k) {
  const int n = 2 * k + 1;
  std::string vertices, faces;
  int count = 0;
  for (int x = 0; x <= n; ++x) {
    for (int y = 0; y <= n; ++y) {
      vertices += fmt::format("{} {} 0\n", x, y);
      if (x == n || y == n || (x % 2 == 1 && y % 2 == 1)) continue;
      const int a = x * (n + 1) + y, b = a + n + 1;
      faces += fmt::format("3 {} {} {}\n3 {} {} {}\n", a, b, b + 1, a, b + 1, a + 1);
      count += 2;
    }
  }
  return fmt::format("OFF\n{} {} 0\n{}{}", (n + 1) * (n + 1), count, vertices, faces);
}

TEST_CASE("gvd-remesh: a higher --max-added is advised only where it helps") {
  const ScratchFolder scratch;
  write_text(scratch / "holes.off", sheet_with_holes(6));
  const auto told = [&](int max_added) {
    return run_command("gvd-remesh", scratch / "holes.off" + " --vertices 0,30 --keep-boundary --max-added " +
                                         std::to_string(max_added))
        .err;
  };
  // Each hole takes three vertices, and the first ones added make more defects.
  CHECK_THAT(told(60),
             Contains("8 defects became 74, then 68; about 109 are likely to be needed: give more or other ones, or "
                      "raise --max-added\n"));
  CHECK_THAT(told(110), Contains("8 defects became 74, then 31; about ") && Contains("or raise --max-added\n"));
  // Creases have a limit of their own: one for each given generator, and 100.
  const std::string limited = "edges do not follow 2.04 % of their length; give more generators\n";
  CHECK_THAT(told(143), Contains(limited));
  CHECK_THAT(told(500), Contains(limited));
}

TEST_CASE("gvd-remesh --target-edge: the number of generators for a length of edges") {
  const auto torus = report_of(data_file("torus.ply") + " --target-edge 0.2 --sampling poisson");
  const double area = torus["results"]["output"]["area"], faces = torus["results"]["output"]["faces"];
  const double edge = std::sqrt(4 / std::sqrt(3.0) * area / faces);  // of equilateral triangles
  CHECK(std::abs(edge - 0.2) < 0.02);
  CHECK(torus["options"]["target_edge"] == 0.2);
  const CommandResult both = run_command("gvd-remesh", data_file("torus.ply") + " -n 9 --target-edge 0.2");
  CHECK(both.exit_code == 2);
  const CommandResult short_edge = run_command("gvd-remesh", data_file("torus.ply") + " --target-edge 1e-9");
  CHECK(short_edge.exit_code == 2);
  CHECK_THAT(short_edge.err, Contains("generators; ask for longer edges"));
  CHECK(run_command("gvd-segment", data_file("torus.ply") + " --target-edge 0.2").exit_code == 2);
}

TEST_CASE("gvd-remesh --error: the fewest generators within a distance") {
  const auto torus = report_of(data_file("torus.ply") + " --error 3% --relax 3");
  const auto& search = torus["results"]["search"];
  const auto& distance = torus["results"]["distance"];
  CHECK(distance["input_to_output"]["hausdorff"] <= search["hausdorff"]);
  CHECK(distance["output_to_input"]["hausdorff"] <= search["hausdorff"]);
  CHECK(search["trials"].size() >= 3);
  CHECK(search["trials"].size() <= 16);
  for (const auto& trial : search["trials"]) {
    if (trial["hausdorff"] <= search["hausdorff"]) CHECK(trial["n"] >= torus["generators"].size() / 2);
  }
  const CommandResult wrong = run_command("gvd-remesh", data_file("torus.ply") + " --error 3%%");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("--error: '3%%' is neither a finite number above 0 nor one with a %"));
}

TEST_CASE("gvd-remesh --error: numbers below those of features, or that give no valid mesh, are too small") {
  const auto plate = report_of(data_file("plate.stl") + " --error 20% --features 40");
  const auto& trials = plate["results"]["search"]["trials"];
  CHECK(std::any_of(trials.begin(), trials.end(), [](const auto& trial) { return trial["hausdorff"].is_null(); }));
  CHECK(plate["generators"].size() >= 8);
  const auto torus = report_of(data_file("torus.ply") + " --error 30% --no-refine --relax none");
  CHECK(torus["results"]["added_generators"] == 0);
}

TEST_CASE("gvd-remesh: a mesh without area is refused") {
  const ScratchFolder scratch;
  const std::string line = scratch / "line.off";
  write_text(line, "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  for (const std::string options : {" -n 2", " --error 5% --loose-boundary", " --target-edge 1"}) {
    const CommandResult result = run_command("gvd-remesh", line + options + " -q -o " + (scratch / "coarse.off"));
    CAPTURE(options, result.err);
    CHECK(result.exit_code == 4);
    CHECK_THAT(result.err, Contains("no triangle has an area"));
  }
}

TEST_CASE("gvd-remesh: JSON carries the diagram, the mesh, and which generators were added") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply") + " -q ", path = scratch / "coarse.json";
  const CommandResult result = run_command("gvd-remesh", mesh + "-n 4 --place generator -o " + path);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const auto content = nlohmann::json::parse(read_text(path));
  CHECK(content["schema"] == "gvd-diagram/1");
  const auto& coarse = content["remesh"];
  CHECK(coarse["vertices"].size() == content["generators"].size());
  CHECK(coarse["added"].get<std::size_t>() + 4 == content["generators"].size());
  CHECK(coarse["faces"].size() == 2 * coarse["vertices"].size());  // of a torus
  CHECK(coarse["face_points"].size() == coarse["faces"].size());
  for (std::size_t i = 0; i < coarse["vertices"].size(); ++i) {
    CHECK(coarse["vertices"][i] == content["generators"][i]["position"]);
  }
  // As generators it gives the same mesh again, and none has to be added.
  const std::string again = scratch / "again.json";
  REQUIRE(run_command("gvd-remesh", mesh + "--no-refine --generators " + path + " -o " + again).exit_code == 0);
  CHECK(nlohmann::json::parse(read_text(again))["remesh"]["faces"] == coarse["faces"]);
}

TEST_CASE("gvd-remesh: sampled generators are placed by a fit, listed ones stay, and the report has the distances") {
  const ScratchFolder scratch;
  const std::string run = data_file("figure.obj") + " -n 200";
  const auto fit = report_of(run), quadric = report_of(run + " --place quadric"),
             plain = report_of(run + " --place generator");
  const auto rms = [](const auto& report) { return double(report["results"]["distance"]["input_to_output"]["rms"]); };
  CHECK(fit["options"]["place"] == "fit");
  CHECK(rms(fit) < 0.8 * rms(quadric));
  CHECK(rms(quadric) < 0.8 * rms(plain));
  CHECK(fit["results"]["certificate"]["self_intersections"] == 0);
  CHECK(fit["generators"] == plain["generators"]);
  write_text(scratch / "list.json", plain.dump());
  const auto listed = report_of(data_file("figure.obj") + " --generators " + scratch / "list.json");
  CHECK(listed["options"]["place"] == "generator");
  CHECK(rms(listed) == rms(plain));
  const CommandResult wrong = run_command("gvd-remesh", run + " --place nowhere");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.err, Contains("--place: 'nowhere' is not one of generator|quadric|fit"));
}

TEST_CASE("gvd-remesh --shape: from near the surface to good triangles, and refused where no vertex is fitted") {
  const std::string run = data_file("figure.obj") + " -n 100";
  const auto near = report_of(run + " --shape 0"), plain = report_of(run), good = report_of(run + " --shape 1");
  const auto rms = [](const auto& report) { return double(report["results"]["distance"]["input_to_output"]["rms"]); };
  const auto quality = [](const auto& report) { return double(report["results"]["quality"]["output"]["q_average"]); };
  CHECK(plain["options"]["shape"] == 0.5);
  CHECK(near["options"]["shape"] == 0);
  CHECK(report_of(run + " --place quadric")["options"]["shape"].is_null());
  CHECK(rms(near) < rms(good));
  CHECK(quality(near) < quality(good));
  const auto refusal = [&](const std::string& options) {
    const CommandResult result = run_command("gvd-remesh", data_file("figure.obj") + options);
    CHECK(result.exit_code == 2);
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    return result.err;
  };
  for (const char* wrong : {"-0.1", "1.1", "nan", "much"}) {
    CHECK_THAT(refusal(std::string(" -n 100 --shape ") + wrong), Contains("is not a number from 0 to 1"));
  }
  CHECK_THAT(refusal(" -n 100 --place quadric --shape 0.2"),
             Contains("--shape: no vertex is fitted; leave it out, or take --place fit"));
  CHECK_THAT(refusal(" --vertices 1,9,30,70 --shape 0.2"),
             Contains("--shape: no vertex is fitted; ask for it with --place fit"));
}

TEST_CASE("gvd-remesh: what can't be certified is refused in one line, and nothing is written") {
  const ScratchFolder scratch;
  const std::string path = scratch / "coarse.ply";
  const CommandResult result = run_command("gvd-remesh", data_file("torus.ply") + " -n 2 --no-refine -o " + path);
  CHECK(result.exit_code == 5);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK_THAT(result.err, Contains("gvd-remesh: error: the dual of 2 generators is no valid mesh: (2) cell "));
  CHECK(!std::filesystem::exists(path));
}

TEST_CASE("gvd-remesh: --exact-count gives as many vertices as asked for, or refuses") {
  const ScratchFolder scratch;
  const std::string torus = data_file("torus.ply"), path = scratch / "coarse.ply";
  const CommandResult one = run_command("gvd-remesh", torus + " -n 1 --exact-count -o " + path);
  CHECK(one.exit_code == 5);
  CHECK_THAT(one.err, Contains("no valid mesh of 1 vertex was found"));
  CHECK(!std::filesystem::exists(path));
  const auto json = report_of(torus + " -n 24 --exact-count");
  CHECK(json["options"]["refine"] == true);
  CHECK(json["options"]["exact_count"] == true);
  CHECK(json["results"]["output"]["vertices"] == 24);
  const CommandResult both = run_command("gvd-remesh", torus + " -n 24 --exact-count --no-refine");
  CHECK(both.exit_code == 2);
  // Generators have to be added.
  CHECK(report_of(torus + " -n 18")["results"]["added_generators"] > 0);
  const auto exact = report_of(torus + " -n 18 --exact-count");
  CHECK(exact["results"]["output"]["vertices"] == 18);
  CHECK(exact["results"]["left_out_generators"] > 0);
  CHECK(run_command("gvd-remesh", torus + " -n 18 --no-refine -o " + path).exit_code == 5);
  // Close creases, on which none are added.
  CHECK(report_of(data_file("plate.stl") + " -n 60 --features 40 --exact-count")["results"]["output"]["vertices"] ==
        60);
  // A list stays as it is.
  const CommandResult list = run_command("gvd-remesh", torus + " --vertices 0,1 --exact-count -o " + path);
  CHECK(list.exit_code == 5);
  CHECK_THAT(list.err, Contains("the dual of 2 generators is no valid mesh"));
}

TEST_CASE("gvd-remesh --exact-count: vertices at ends of limbs stay, and the report is that of the chosen start") {
  const ScratchFolder scratch;
  const std::string json = scratch / "coarse.json", report_path = scratch / "report.json";
  const CommandResult result = run_command(
      "gvd-remesh", data_file("figure.obj") + " -n 75 --relax 3 --exact-count -o " + json + " --report " + report_path);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const auto report = nlohmann::json::parse(read_text(report_path)), content = nlohmann::json::parse(read_text(json));
  const auto& results = report["results"];
  CHECK(results["left_out_generators"] > 0);
  CHECK(report["timings_ms"]["other start"] > 0);
  // Begun with so many generators: max_added is ten for each, for the component and for the handle, and 100 more.
  const int begun = 75 + int(results["left_out_generators"]) - int(results["added_generators"]);
  CHECK(report["options"]["max_added"] == 10 * (begun + 2) + 100);
  const auto &vertices = content["remesh"]["vertices"], &generators = content["generators"];
  int at_generators = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) at_generators += vertices[i] == generators[i]["position"] ? 1 : 0;
  CHECK(results["relaxation"]["extremities"] > 0);
  CHECK(at_generators >= results["relaxation"]["extremities"]);
}

TEST_CASE("gvd-remesh: a note says why generators were added") {
  const CommandResult one = run_command("gvd-remesh", data_file("torus.ply") + " -n 1");
  CHECK(one.exit_code == 0);
  CHECK_THAT(
      one.err,
      Contains(" generators were added: with the given 1, 1 cell is not a disc, 1 cell has too few neighbours\n"));
  const CommandResult many = run_command("gvd-remesh", data_file("torus.ply") + " -n 100");
  CHECK(many.exit_code == 0);
  CHECK_THAT(many.err, !Contains("were added"));
}

TEST_CASE("gvd-remesh: there is no --no-curves, since its files have no curves") {
  const ScratchFolder scratch;
  const CommandResult result =
      run_command("gvd-remesh", data_file("torus.ply") + " -n 9 --no-curves -o " + scratch / "coarse.obj");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains("unknown option: --no-curves"));
}

}  // namespace gvd::test_remesh_command
