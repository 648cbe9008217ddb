// gvd-segment inside given regions, without masked faces, and at several levels.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_segment_regions {

using namespace test;
using Catch::Matchers::Contains;

constexpr int kFigureFaces = 5876;

std::string run(const std::string& arguments) {
  const CommandResult result = run_command("gvd-segment", arguments);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return result.err;
}

/// A list with a number for each face of figure.obj.
template <class Number>
std::string list_of(Number number) {
  std::ostringstream text;
  for (int f = 0; f < kFigureFaces; ++f) text << number(f) << '\n';
  return text.str();
}

nlohmann::json read_json(const std::string& path) { return nlohmann::json::parse(read_text(path)); }

TEST_CASE("gvd-segment --within: one region of all faces changes no byte") {
  const ScratchFolder scratch;
  write_text(scratch / "one.txt", list_of([](int) { return 3; }));
  for (const std::string options :
       {"-n 20", "-n 20 --cut --sampling poisson --seed 4", "--radius 0.7 --labels nearest"}) {
    std::map<std::string, std::string> bytes;
    for (const std::string& within : {std::string(), " --within " + scratch / "one.txt"}) {
      std::string files = " --diagram " + scratch / "d.json" + " --face-labels " + scratch / "f.npy" +
                          " --vertex-distances " + scratch / "v.npy" + " --stats " + scratch / "s.csv";
      for (const std::string extension : {"obj", "off", "stl", "glb"}) files += " -o " + scratch / "a." + extension;
      run(data_file("figure.obj") + " -q " + options + within + files);
      for (const std::string name : {"d.json", "f.npy", "v.npy", "s.csv", "a.obj", "a.off", "a.stl", "a.glb"}) {
        CAPTURE(options, name);
        const auto [known, is_new] = bytes.emplace(name, read_text(scratch / name));
        if (!is_new) CHECK(known->second == read_text(scratch / name));
      }
    }
  }
}

TEST_CASE("gvd-segment --within: every form in which labels are written gives the same parcels") {
  const ScratchFolder scratch;
  run(data_file("figure.obj") + " -q --levels 3,7 -o " + scratch / "l.ply" + " -o " + scratch / "l.vtp" + " -o " +
      scratch / "l.vtu" + " --face-labels " + scratch / "l.npy");
  run(data_file("figure.obj") + " -q --levels 3,7 --face-labels " + scratch / "l.csv");
  run(data_file("figure.obj") + " -q --within " + scratch / "l.csv" + " -n 7 --face-labels " + scratch / "one.csv");
  std::map<std::string, std::string> made;
  for (const std::string& arguments :
       {scratch / "l.ply" + " --within label", scratch / "l.vtp" + " --within Label",
        scratch / "l.vtu" + " --within label", data_file("figure.obj") + " --within " + scratch / "l.npy",
        data_file("figure.obj") + " --within " + scratch / "l.csv",
        data_file("figure.obj") + " --within " + scratch / "one.csv",
        data_file("figure.obj") + " --mask " + scratch / "l.csv"}) {
    CAPTURE(arguments);
    run(arguments + " -q -n 30 --face-labels " + scratch / "made.npy");
    made[read_text(scratch / "made.npy")] += arguments.find("--mask") == arguments.npos ? "within " : "mask ";
  }
  REQUIRE(made.size() == 2);
  for (const auto& [labels, options] : made) {
    CHECK((options == "mask " || options == "within within within within within within "));
  }
  // A coarser level is named by its property.
  run(scratch / "l.vtu" + " -q -n 30 --within label_1 --face-labels " + scratch / "made.npy");
  CHECK(made.count(read_text(scratch / "made.npy")) == 0);
}

TEST_CASE("gvd-segment --within: labels of the triangles of quadrilaterals fit the file that these came from") {
  const ScratchFolder scratch;
  std::ostringstream off;  // eight squares in a row
  off << "OFF\n18 8 0\n";
  for (int i = 0; i < 18; ++i) off << i / 2 << ' ' << i % 2 << " 0\n";
  for (int i = 0; i < 16; i += 2) off << "4 " << i << ' ' << i + 2 << ' ' << i + 3 << ' ' << i + 1 << '\n';
  write_text(scratch / "quads.off", off.str());
  run(scratch / "quads.off" + " -q -n 2 --face-labels " + scratch / "f.csv" + " --vertex-labels " + scratch / "v.npy");
  for (const char* name : {"f.csv", "v.npy"}) {
    run(scratch / "quads.off" + " -q -n 4 --within " + scratch / name + " --report " + scratch / "r.json");
    CHECK(read_json(scratch / "r.json")["results"]["within"]["regions"] == 2);
  }
}

TEST_CASE(
    "gvd-segment --within: a face of three labels joins a neighbour if it were alone, and a lost label is named") {
  const ScratchFolder scratch;
  // Face 0 has corners of 1, 2 and 3, and a neighbour across each side: of 2 below and, across a longer side, of 3.
  write_text(scratch / "a.off",
             "OFF\n6 4 0\n0 0 0\n1 0 0\n0.4 1 0\n0.5 -1 0\n1.5 1 0\n-0.5 1 0\n"
             "3 0 1 2\n3 1 0 3\n3 2 1 4\n3 0 2 5\n");
  write_text(scratch / "labels.txt", "1\n2\n3\n2\n3\n3\n");
  const std::string notes = run(scratch / "a.off" + " --within " + scratch / "labels.txt" + " -n 12 --cut -o " +
                                scratch / "a.json" + " --report " + scratch / "r.json");
  CHECK_THAT(notes, Contains("labels.txt: no face is in region 1: most corners of its faces have other numbers\n"));
  CHECK_THAT(notes, Contains("inside 2 regions of 2 connected parts"));
  const nlohmann::json cut = read_json(scratch / "a.json")["cut_mesh"];
  const std::vector<int> region_of_face{3, 2, 3, 3};
  for (std::size_t f = 0; f < cut["parents"].size(); ++f) {
    CHECK(cut["face_numbers"]["region"][f] == region_of_face[cut["parents"][f].get<std::size_t>()]);
  }
  // 12 generators by area: .5 of 2 in region 2.
  std::map<int, int> generators;
  const nlohmann::json report = read_json(scratch / "r.json");
  for (const auto& region : report["results"]["regions"]) ++generators[region["region"]];
  CHECK(generators == std::map<int, int>{{2, 3}, {3, 9}});
  // Numbers of faces stay as they are.
  write_text(scratch / "faces.txt", "1\n2\n3\n3\n");
  CHECK_THAT(run(scratch / "a.off" + " --within " + scratch / "faces.txt" + " -n 12 -o " + scratch / "b.json"),
             Contains("inside 3 regions of 4 connected parts") && !Contains("no face is in"));
}

TEST_CASE("gvd-segment --levels: the same as twice in a row, on any number of threads") {
  const ScratchFolder scratch;
  const auto outputs = [&](const std::string& stem) {
    return " --diagram " + scratch / stem + ".json --vertex-distances " + scratch / stem + ".npy -o " + scratch / stem +
           ".glb";
  };
  run(data_file("figure.obj") + " -q -n 7 -o " + scratch / "coarse.ply");
  REQUIRE(std::system(("gzip -k " + scratch / "coarse.ply").c_str()) == 0);
  run(scratch / "coarse.ply.gz" + " -q -n 60 --within label" + outputs("a") + " --threads 1 --face-labels " +
      scratch / "a.csv");
  run(data_file("figure.obj") + " -q --levels 7,60" + outputs("b") + " --threads 5 --face-labels " + scratch / "b.csv" +
      " --report " + scratch / "b.report.json -o " + scratch / "b.vtp");
  CHECK_THAT(read_text(scratch / "b.vtp"), Contains("Name=\"label_1\"") && Contains("Name=\"label_2\""));
  for (const std::string extension : {".json", ".npy", ".glb"}) {
    CAPTURE(extension);
    CHECK(read_text(scratch / "a" + extension) == read_text(scratch / "b" + extension));
  }
  std::istringstream one(read_text(scratch / "a.csv")), both(read_text(scratch / "b.csv"));
  std::string line, other;
  std::getline(one, line);
  std::getline(both, other);
  CHECK(other == "face,label_1,label_2");
  int faces = 0;
  std::map<std::string, std::set<std::string>> within;
  while (std::getline(one, line) && std::getline(both, other)) {
    ++faces;
    const std::size_t first = other.find(','), last = other.rfind(',');
    REQUIRE(line == other.substr(0, first) + other.substr(last));
    within[other.substr(last)].insert(other.substr(first, last - first));
  }
  CHECK(faces == kFigureFaces);
  CHECK(within.size() == 60);
  for (const auto& [label, parents] : within) CHECK(parents.size() == 1);

  const nlohmann::json report = read_json(scratch / "b.report.json");
  CHECK(report["options"]["levels"] == std::vector{7, 60});
  CHECK(report["options"]["count"].is_null());
  CHECK(report["results"]["within"]["regions"] == 7);
  for (const auto& region : report["results"]["regions"]) CHECK(region["label_1"] < 7);
}

TEST_CASE("gvd-segment --within --mask: the report and JSON name regions, and masked faces have label -1") {
  const ScratchFolder scratch;
  write_text(scratch / "regions.txt", list_of([](int f) { return f < 2000 ? 40 : f < 4000 ? 12 : 7; }));
  write_text(scratch / "mask.txt", list_of([](int f) { return f % 1000 < 100 ? 0.5 : 0; }));
  const std::string given = data_file("figure.obj") + " --within " + scratch / "regions.txt" + " --mask " +
                            scratch / "mask.txt" + " --report " + scratch / "r.json" + " -o " + scratch / "a.json";
  const std::string notes = run(given + " -n 600");
  CHECK_THAT(notes, Contains("inside 3 regions of") && Contains("; 600 faces are left out") &&
                        !Contains("reached by no generator"));
  const nlohmann::json output = read_json(scratch / "a.json"), report = read_json(scratch / "r.json");
  const auto labels = output["face_labels"].get<std::vector<int>>();
  const auto regions = output["face_numbers"]["region"].get<std::vector<int>>();
  REQUIRE(labels.size() == kFigureFaces);
  const auto& listed = report["results"]["regions"];
  REQUIRE(listed.size() == 600);
  for (int f = 0; f < kFigureFaces; ++f) {
    CHECK((labels[std::size_t(f)] < 0) == (f % 1000 < 100));
    if (labels[std::size_t(f)] >= 0)
      CHECK(listed[std::size_t(labels[std::size_t(f)])]["region"] == regions[std::size_t(f)]);
  }
  CHECK(report["results"]["within"]["left_out_faces"] == 600);
  CHECK(report["results"]["unreached_faces"] == 0);
  CHECK(output["vertex_labels"].size() == report["input"]["vertices"]);

  run(given + " --per-region 150 --cut");
  const nlohmann::json cut = read_json(scratch / "a.json")["cut_mesh"], cut_report = read_json(scratch / "r.json");
  CHECK(cut_report["results"]["regions"].size() == 450);
  CHECK(cut_report["results"]["uncut_faces"] == 0);
  CHECK(cut_report["options"]["per_region"] == 150);
  CHECK(cut["face_numbers"]["region"].size() == cut["faces"].size());
}

TEST_CASE("gvd-segment --within: labels of faces and vertices serve in each format of values") {
  const ScratchFolder scratch;
  const std::string figure = data_file("figure.obj") + " -q ";
  run(figure + "-n 9 -o " + scratch / "a.ply" + " --face-labels " + scratch / "f.npy" + " --vertex-labels " +
      scratch / "v.npy");
  for (const std::string name : {"v.label.gii", "v.annot"}) run(figure + "-n 9 -o " + scratch / name);
  const auto segment = [&](const std::string& input, const std::string& within) {
    run(input + " -q -n 40 --within " + within + " -o " + scratch / "b.glb");
    return read_text(scratch / "b.glb");
  };
  const std::string by_faces = segment(scratch / "a.ply", "label"), by_vertices = segment(figure, scratch / "v.npy");
  CHECK(segment(figure, scratch / "f.npy") == by_faces);
  CHECK(by_vertices != by_faces);
  for (const std::string name : {"v.label.gii", "v.annot"}) {
    CAPTURE(name);
    CHECK(segment(figure, scratch / name) == by_vertices);
  }
}

TEST_CASE("gvd-segment --within --balance: the cells of a region share out its own area") {
  const ScratchFolder scratch;
  run(data_file("figure.obj") + " -q -n 5 -o " + scratch / "a.ply");
  run(scratch / "a.ply" + " -q --within label -n 40 --balance area --cut -o " + scratch / "b.obj" + " --report " +
      scratch / "r.json");
  const nlohmann::json results = read_json(scratch / "r.json")["results"];
  const auto masses = results["balance"]["masses"].get<std::vector<double>>();
  const auto targets = results["balance"]["targets"].get<std::vector<double>>();
  REQUIRE(masses.size() == 40);
  CHECK(results["balance"]["converged"] == true);
  std::map<int, double> target, missing;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const int region = results["regions"][i]["region"];
    CHECK(targets[i] == Approx(target.emplace(region, targets[i]).first->second).epsilon(1e-12));
    missing[region] += targets[i] - masses[i];
    CHECK(results["regions"][i]["area"].get<double>() == Approx(masses[i]).epsilon(1e-6));
  }
  CHECK(target.size() == 5);
  std::set<double> different;
  for (const auto& [region, share] : target) {
    CHECK(std::abs(missing[region]) < 1e-9 * share);
    different.insert(share);
  }
  CHECK(different.size() == 5);
}

TEST_CASE("gvd-segment --within --cut: pieces of both sides of a border have the border's vertices in common") {
  const ScratchFolder scratch;
  run(data_file("torus.ply") + " -q -n 5 -o " + scratch / "a.ply");
  run(scratch / "a.ply" + " -q --within label -n 40 --cut -o " + scratch / "b.ply");
  const CheckedMesh cut = build_mesh(read_soup(scratch / "b.ply"), DefectPolicy::error);
  const MeshSummary summary = compute_mesh_summary(cut.mesh);
  CHECK(summary.components == 1);
  CHECK(summary.boundary_loops == 0);
  CHECK(summary.euler_characteristic == 0);
  const auto region = read_soup_property(scratch / "b.ply", "region", SoupElement::polygon);
  const auto label = read_soup_property(scratch / "b.ply", "label", SoupElement::polygon);
  REQUIRE(region);
  REQUIRE(label);
  std::map<double, std::set<double>> within;
  for (std::size_t f = 0; f < label->values.size(); ++f) within[label->values[f]].insert(region->values[f]);
  CHECK(within.size() == 40);
  for (const auto& [id, regions] : within) CHECK(regions.size() == 1);
}

TEST_CASE("gvd-segment --within: regions that can't be kept to are errors in one line") {
  const ScratchFolder scratch;
  const std::string figure = data_file("figure.obj") + " ";
  write_text(scratch / "three.txt", list_of([](int f) { return f % 3; }));
  write_text(scratch / "half.txt", list_of([](int f) { return f / 2.0; }));
  write_text(scratch / "none.txt", list_of([](int) { return 1; }));
  write_text(scratch / "short.txt", "1 2 3\n");
  write_text(scratch / "inside.txt", "1 0.2 0.3 0.5\n");
  const std::string three = figure + "--within " + scratch / "three.txt" + " ", name = "gvd-segment";
  require_error(name, three + "-n 2", 4, "2 generators for 3 regions; ask for one or more in each");
  require_error(name, figure + "-n 9 --within " + scratch / "half.txt", 4, "half.txt: the region of face 1 is 0.5");
  require_error(name, figure + "-n 9 --within " + scratch / "short.txt", 3, "short.txt: 3 numbers; give one for each");
  require_error(name, figure + "-n 9 --mask " + scratch / "none.txt", 4, "none.txt: no face is left");
  write_text(scratch / "all.txt", list_of([](int) { return -1; }));
  require_error(name, figure + "-n 9 --within " + scratch / "all.txt", 4,
                "all.txt: all numbers are negative, so no face remains; give numbers from 0 for the faces of regions");
  require_error(name, figure + "-n 9 --within atlas", 3, "--within atlas: there is no such file, and");
  require_error(name, figure + "--generators " + scratch / "inside.txt" + " --mask " + scratch / "three.txt", 4,
                "generator 0 lies on a face that is left out; choose another");
  require_error(name, figure + "--per-region 3", 2, "--within");
  require_error(name, figure + "--levels 5,3", 2, "3 follows 5; write ascending numbers");
  require_error(name, figure + "--levels 5,x", 2, "'x' is not a whole number");
  require_error(name, figure + "--levels 5,9 -n 3", 2, "--levels");
  require_error(name, three + "--per-region 3 -n 30", 2, "--per-region");
}

TEST_CASE("gvd-segment: files of weights and shares with numbers that can't be are named") {
  const ScratchFolder scratch;
  const std::string torus = data_file("torus.ply") + " -n 3 ", file = scratch / "numbers.txt";
  for (const char* wrong : {"nan", "inf", "-inf"}) {
    write_text(file, fmt::format("1\n{}\n2\n", wrong));
    require_error("gvd-segment", torus + "--weights " + file, 4,
                  fmt::format("numbers.txt: the weight of generator 1 is {}; give finite numbers", wrong));
  }
  for (const char* wrong : {"0", "-1", "nan"}) {
    write_text(file, fmt::format("1\n1\n{}\n", wrong));
    require_error("gvd-segment", torus + "--balance area --shares " + file, 4,
                  fmt::format("numbers.txt: the share of generator 2 is {}; give finite numbers above 0", wrong));
  }
}

TEST_CASE("gvd-segment --within: parts without a generator are told, and how many generators reach all") {
  const ScratchFolder scratch;
  write_text(scratch / "stripes.txt", list_of([](int f) { return f / 10 % 2; }));
  const std::string given = data_file("figure.obj") + " --within " + scratch / "stripes.txt" + " ";
  const std::string notes = run(given + "-n 2");
  CHECK_THAT(notes,
             Contains("parts of regions have no generator, because there are too few;") && Contains(" reach all"));
  const std::size_t end = notes.find(" reach all");
  const std::string parts = notes.substr(notes.rfind(' ', end - 1) + 1, end - notes.rfind(' ', end - 1) - 1);
  CHECK_THAT(run(given + "-n " + parts), !Contains("no generator"));
}

}  // namespace gvd::test_segment_regions
