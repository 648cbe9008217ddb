// gvd-segment on files: its JSON and its report, with whole and with cut faces.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "mesh/reading/array_bytes.hpp"
#include "support/catch.hpp"

namespace gvd::test_segment_command {

using namespace test;
using Catch::Matchers::Contains;

struct Outcome {
  nlohmann::json output, report;
};

Outcome segment(const std::string& options) {
  const ScratchFolder scratch;
  const CommandResult result =
      run_command("gvd-segment", data_file("figure.obj") + " -q -n 20 -o " + scratch / "a.json" + " --report " +
                                     scratch / "r.json" + " " + options);
  CAPTURE(options, result.err);
  REQUIRE(result.exit_code == 0);
  return {nlohmann::json::parse(read_text(scratch / "a.json")), nlohmann::json::parse(read_text(scratch / "r.json"))};
}

/// The regions of the report have the faces of the labels, and together the area of the mesh.
void check_regions(const nlohmann::json& report, const std::vector<int>& labels) {
  const auto& regions = report["results"]["regions"];
  REQUIRE(regions.size() == 20);
  double area = 0;
  for (std::size_t g = 0; g < regions.size(); ++g) {
    CHECK(regions[g]["label"] == g);
    CHECK(regions[g]["faces"] == std::count(labels.begin(), labels.end(), static_cast<int>(g)));
    area += regions[g]["area"].get<double>();
  }
  CHECK(area == Approx(report["input"]["area"].get<double>()));
  CHECK(report["results"]["faces"] == labels.size());
  CHECK(report["results"]["unreached_faces"] == 0);
}

TEST_CASE("gvd-segment: JSON carries the diagram and a label for each face") {
  const auto [output, report] = segment("");
  CHECK(output["schema"] == "gvd-diagram/1");
  CHECK(output["face_labels"].size() == report["input"]["faces"]);
  CHECK(output["vertex_labels"].size() == report["input"]["vertices"]);
  CHECK(output["vertex_distances"].size() == report["input"]["vertices"]);
  CHECK(report["options"]["cut"] == false);
  CHECK(report["results"]["generators_without_face"] == nlohmann::json::array());
  check_regions(report, output["face_labels"].get<std::vector<int>>());
}

TEST_CASE("gvd-segment: JSON of a cut mesh carries its faces, their labels and their parents") {
  const auto [output, report] = segment("--cut");
  const auto& cut = output["cut_mesh"];
  CHECK(cut["faces"].size() > report["input"]["faces"].get<std::size_t>());
  CHECK(cut["labels"].size() == cut["faces"].size());
  CHECK(cut["parents"].size() == cut["faces"].size());
  CHECK(cut["vertex_labels"].size() == cut["vertices"].size());
  CHECK(cut["vertex_distances"].size() == cut["vertices"].size());
  CHECK(report["options"]["cut"] == true);
  CHECK(report["results"]["uncut_faces"] == 0);
  check_regions(report, cut["labels"].get<std::vector<int>>());
}

TEST_CASE("gvd-segment: --labels smooth is the default, with shorter borders than nearest") {
  const auto smooth = segment("").report, same = segment("--labels smooth").report;
  const auto nearest = segment("--labels nearest").report;
  CHECK(smooth["options"]["labels"] == "smooth");
  CHECK(nearest["options"]["labels"] == "nearest");
  CHECK(smooth["results"] == same["results"]);
  CHECK(smooth["results"]["border_ratio"] < 1.1);
  CHECK(nearest["results"]["border_ratio"] > 1.25);
  CHECK(smooth["results"]["smoothed_faces"] > 0);
  CHECK(nearest["results"]["smoothed_faces"] == 0);
  const double length = smooth["diagram"]["length"];
  CHECK(smooth["results"]["border_length"] == Approx(smooth["results"]["border_ratio"].get<double>() * length));
}

TEST_CASE("gvd-segment: smooth borders that are longer than usual get a note with their ratio") {
  const auto run = [](const std::string& file, const std::string& options) {
    const CommandResult result = run_command("gvd-segment", data_file(file) + " " + options);
    CAPTURE(file, options, result.err);
    REQUIRE(result.exit_code == 0);
    return result.err;
  };
  // Cells of 1.6 faces each: no edges lie near the bisectors.
  CHECK_THAT(run("torus.ply", "-n 1000"), Contains("borders are 1.") && Contains("times as long as the bisectors"));
  CHECK_THAT(run("figure.obj", "-n 20"), !Contains("borders are"));
  CHECK_THAT(run("torus.ply", "-n 1000 --labels nearest"), !Contains("borders are"));
  CHECK_THAT(run("torus.ply", "-n 1"), !Contains("borders are"));
}

TEST_CASE("gvd-segment: --labels with --cut, or with another name, is a usage error") {
  for (const std::string options : {"--cut --labels smooth", "--labels sharp"}) {
    const CommandResult result = run_command("gvd-segment", data_file("figure.obj") + " -n 2 " + options);
    CAPTURE(options, result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.err.find("--labels") != std::string::npos);
  }
}

TEST_CASE("gvd-segment: without bisectors the ratio of the borders is null") {
  const ScratchFolder scratch;
  const CommandResult result =
      run_command("gvd-segment", data_file("figure.obj") + " -q -n 1 --report " + scratch / "r.json");
  REQUIRE(result.exit_code == 0);
  const auto results = nlohmann::json::parse(read_text(scratch / "r.json"))["results"];
  CHECK(results["border_length"] == 0);
  CHECK(results["border_ratio"].is_null());
}

TEST_CASE("gvd-segment: --stats writes a row for each region, whatever the labels") {
  const ScratchFolder scratch;
  std::vector<std::string> texts;
  for (const std::string options : {"", " --labels nearest", " --cut"}) {
    const std::string file = scratch / "stats.csv";
    const CommandResult result =
        run_command("gvd-segment", data_file("figure.obj") + " -n 20 --stats " + file + options);
    CAPTURE(options, result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(result.err.find("no file is written") == std::string::npos);
    texts.push_back(read_text(file));
  }
  CHECK(std::count(texts[0].begin(), texts[0].end(), '\n') == 21);
  CHECK(texts[1] == texts[0]);
  CHECK(texts[2] == texts[0]);
}

TEST_CASE("gvd-segment: --adjacency writes the graph of the regions, whatever the labels") {
  const ScratchFolder scratch;
  std::vector<std::string> texts;
  for (const std::string options : {"", " --cut"}) {
    const CommandResult result =
        run_command("gvd-segment", data_file("figure.obj") + " -q -n 20 --adjacency " + scratch / "a.graphml" +
                                       " --report " + scratch / "r.json" + options);
    CAPTURE(options, result.err);
    REQUIRE(result.exit_code == 0);
    const auto report = nlohmann::json::parse(read_text(scratch / "r.json"));
    CHECK(report["options"]["adjacency"] == scratch / "a.graphml");
    texts.push_back(read_text(scratch / "a.graphml"));
  }
  const auto count = [&](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = texts[0].find(word); at != std::string::npos; at = texts[0].find(word, at + 1)) ++found;
    return found;
  };
  CHECK(count("<node ") == 20);
  CHECK(count("<edge ") >= 19);
  CHECK(texts[1] == texts[0]);
}

TEST_CASE("gvd-segment: the target of --stats is checked before the work") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj"), same = scratch / "a.json", link = scratch / "a.csv";
  std::filesystem::create_symlink(same, link);
  CHECK(run_command("gvd-segment", mesh + " -n 2 --stats " + scratch / "none/a.csv").exit_code == 6);
  require_error("gvd-segment", mesh + " -n 2 --report " + same + " --stats " + link, 2, "two outputs go there");
  CHECK(run_command("gvd-segment", mesh + " -n 2 --stats -").exit_code == 2);
  CHECK(run_command("gvd-lloyd", mesh + " -n 2 --stats a.csv").exit_code == 2);
}

TEST_CASE("gvd-segment: generators without a face are named in one line, all of them in the report") {
  const ScratchFolder scratch;
  const std::string report = scratch / "r.json";
  const CommandResult result = run_command("gvd-segment", data_file("plate.stl") + " -n 3000 --report " + report);
  CHECK(result.exit_code == 0);
  const auto unowned = nlohmann::json::parse(read_text(report))["results"]["generators_without_face"];
  REQUIRE(unowned.size() > 8);
  CHECK_THAT(result.err, Contains(std::to_string(unowned.size()) + " generators own no face"));
  CHECK_THAT(result.err, Contains(", ...\n"));
  CHECK(line_count(result.err) < 8);
}

/// The text of the page's element with this id.
std::string element_text(const std::string& page, const std::string& id) {
  const std::size_t at = page.find("id=\"" + id + "\">");
  REQUIRE(at != std::string::npos);
  const std::size_t first = page.find('>', at) + 1;
  return page.substr(first, page.find('<', first) - first);
}

/// The labels of the faces on the page; -1 where a face has none.
std::vector<int> labels_on_page(const std::string& page) {
  const auto scene = nlohmann::json::parse(element_text(page, "manifest"))["scenes"].back();
  CHECK_FALSE(scene.contains("pieces"));
  CHECK(scene["codes"]["type"] == "u8");
  const std::string text = element_text(page, "blob-" + scene["codes"]["blob"].dump());
  ArrayBytes packed(text, true);
  std::string codes;
  ExpansionLimit limit(text.size(), "page");
  REQUIRE(append_inflated(codes, packed.take(packed.most()), scene["codes"]["count"], limit));
  std::vector<int> labels;
  for (const char code : codes) labels.push_back(code == 0 ? -1 : static_cast<unsigned char>(code) - 2);
  return labels;
}

TEST_CASE("gvd-segment: the page shows the labels of the file's faces, whole or cut, and first the cells") {
  for (const std::string options : {"", "--labels nearest", "--cut", "--mask", "--cut --mask"}) {
    const ScratchFolder scratch;
    std::string mask;
    for (int f = 0; f < 5876; ++f) mask += f < 600 ? "1 " : "0 ";
    write_text(scratch / "mask.txt", mask);
    const bool is_masked = options.ends_with("--mask"), is_cut = options.starts_with("--cut");
    const CommandResult result = run_command(
        "gvd-segment", data_file("figure.obj") + " -q -n 20 -o " + scratch / "a.json" + " --view " +
                           scratch / "v.html --up z " + options + (is_masked ? " " + scratch / "mask.txt" : ""));
    if (result.exit_code == 2) {
      WARN("skipped: this build is without the viewer");
      return;
    }
    CAPTURE(options, result.err);
    REQUIRE(result.exit_code == 0);
    const auto output = nlohmann::json::parse(read_text(scratch / "a.json"));
    const auto& labels = output.contains("cut_mesh") ? output["cut_mesh"]["labels"] : output["face_labels"];
    const std::string page = read_text(scratch / "v.html");
    CHECK((std::count(labels.begin(), labels.end(), -1) > 0) == is_masked);
    CHECK(labels_on_page(page) == labels.get<std::vector<int>>());
    const auto manifest = nlohmann::json::parse(element_text(page, "manifest"));
    CHECK(manifest["up"] == "z");
    CHECK(manifest["scenes"].back()["figures"][0] == nlohmann::json({"Faces", std::to_string(labels.size())}));
    CHECK(manifest["scenes"].size() == (is_cut ? 1 : 2));
    CHECK(manifest["scenes"][0].contains("pieces") == !is_cut);
    CHECK(manifest["scenes"][0].contains("borders") == is_masked);
  }
}

TEST_CASE("gvd-segment: arrays and tables have the labels of the faces and the distances of the vertices") {
  for (const std::string options : {"", " --cut"}) {
    const ScratchFolder scratch;
    const auto file = [&](const char* name) { return scratch / name; };
    const CommandResult result =
        run_command("gvd-segment", data_file("figure.obj") + " -q -n 20 -o " + file("a.json") + " --face-labels " +
                                       file("f.csv") + " --vertex-distances " + file("v.csv") + options);
    CAPTURE(options, result.err);
    REQUIRE(result.exit_code == 0);
    const auto output = nlohmann::json::parse(read_text(file("a.json")));
    const auto& mesh = options.empty() ? output : output["cut_mesh"];
    std::string faces = "face,label\n", vertices = "source,vertex,distance\n";
    const auto& labels = mesh[options.empty() ? "face_labels" : "labels"];
    for (std::size_t f = 0; f < labels.size(); ++f) faces += fmt::format("{},{}\n", f, labels[f].get<int>());
    for (std::size_t v = 0; v < mesh["vertex_labels"].size(); ++v) {
      vertices +=
          fmt::format("{},{},{}\n", mesh["vertex_labels"][v].get<int>(), v, mesh["vertex_distances"][v].get<double>());
    }
    CHECK(read_text(file("f.csv")) == faces);
    CHECK(read_text(file("v.csv")) == vertices);
  }
}

TEST_CASE("gvd-segment: NumPy's arrays have one value for each element, and other extensions are refused") {
  const ScratchFolder scratch;
  const std::string line = data_file("figure.obj") + " -q -n 20 ";
  REQUIRE(run_command("gvd-segment",
                      line + "--face-labels " + scratch / "f.npy" + " --vertex-distances " + scratch / "v.npy")
              .exit_code == 0);
  CHECK(read_text(scratch / "f.npy").size() == 128 + 4 * 5876);
  CHECK(read_text(scratch / "v.npy").size() == 128 + 8 * 2938);
  CHECK_THAT(read_text(scratch / "f.npy"), Contains("'descr': '<i4'") && Contains("'shape': (5876,)"));
  require_error("gvd-segment", line + "--face-labels " + scratch / "f.ply", 2,
                "the extension must be one of .npy, .csv");
}

TEST_CASE("gvd-segment: labels and distances of vertices go to arrays, tables, GIFTI and FreeSurfer's files") {
  const ScratchFolder scratch;
  const auto file = [&](const char* name) { return scratch / name; };
  const std::string line = data_file("figure.obj") + " -q -n 20 ";
  REQUIRE(run_command("gvd-segment", line + "-o " + file("a.json") + " -o " + file("a.label.gii") + " -o " +
                                         file("a.shape.gii") + " -o " + file("lh.annot") + " -o " + file("lh.curv") +
                                         " --vertex-labels " + file("v.csv"))
              .exit_code == 0);
  std::string vertices = "vertex,label\n";
  const auto output = nlohmann::json::parse(read_text(file("a.json")));
  const std::size_t count = output["vertex_labels"].size();
  for (std::size_t v = 0; v < count; ++v) {
    vertices += fmt::format("{},{}\n", v, output["vertex_labels"][v].get<int>());
  }
  CHECK(read_text(file("v.csv")) == vertices);
  for (const auto& [labels, distances, as_labels, as_distances] :
       {std::array{"b.label.gii", "b.shape.gii", "a.label.gii", "a.shape.gii"},
        std::array{"b.annot", "b.curv", "lh.annot", "lh.curv"},
        std::array{"c.label.gii", "c.func.gii", "a.label.gii", "a.shape.gii"}}) {
    REQUIRE(
        run_command("gvd-segment", line + "--vertex-labels " + file(labels) + " --vertex-distances " + file(distances))
            .exit_code == 0);
    CHECK(read_text(file(labels)) == read_text(file(as_labels)));
    CHECK(read_text(file(distances)) == read_text(file(as_distances)));
  }
  REQUIRE(run_command("gvd-segment", line + "--vertex-labels " + file("v.npy")).exit_code == 0);
  CHECK(read_text(file("v.npy")).size() == 128 + 4 * count);
  require_error("gvd-segment", line + "--vertex-labels " + file("v.gii"), 2,
                "the extension must be one of .npy, .csv, .label.gii, .annot");
  require_error("gvd-segment", line + "-o " + file("v.txt"), 2, ".surf.gii, .label.gii, .shape.gii, .fs");
}

TEST_CASE("gvd-segment: FreeSurfer's surfaces have any name, and all surfaces give the same regions") {
  const ScratchFolder scratch;
  const auto file = [&](const char* name) { return scratch / name; };
  REQUIRE(run_command("gvd-segment", data_file("figure.obj") + " -q -n 20 -o " + file("lh.white") + " -o " +
                                         file("a.surf.gii") + " -o " + file("a.ply") + " --output-format fs")
              .exit_code == 0);
  REQUIRE(run_command("gvd-segment", data_file("figure.obj") + " -q -n 20 -o - --output-format fs > " + file("b"))
              .exit_code == 0);
  CHECK(read_text(file("b")) == read_text(file("lh.white")));
  for (const char* input : {"lh.white", "a.surf.gii"}) {
    REQUIRE(run_command("gvd-segment",
                        file(input) + " -q -n 20 -o " + file("again.surf.gii") + " -o " + file(input) + ".label.gii")
                .exit_code == 0);
    CHECK(read_text(file("again.surf.gii")) == read_text(file("a.surf.gii")));
  }
  CHECK(read_text(file("lh.white.label.gii")) == read_text(file("a.surf.gii.label.gii")));
  REQUIRE(run_command("gvd-segment", file("lh.white") + " " + file("a.surf.gii") + " -q -n 5 --output-format " +
                                         "surf.gii,annot --output-dir " + file("out"))
              .exit_code == 0);
  for (const char* made : {"out/lh.surf.gii", "out/lh.annot", "out/a.surf.gii", "out/a.annot"}) {
    CHECK(std::filesystem::exists(file(made)));
  }
  require_error("gvd-segment", data_file("figure.obj") + " -n 5 -o " + file("lh.white"), 2,
                "the extension must be one of");
  require_error("gvd-segment", data_file("figure.obj") + " -n 5 -o " + file("c.ply") + " --output-format fs", 2,
                "--output-format has no effect here");
}

}  // namespace gvd::test_segment_command
