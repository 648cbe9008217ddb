// GIFTI and FreeSurfer's files. tests/formats/read_with_nibabel.py and wb_command read them, too.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gvd/io/distance_writer.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_write_organs {

using namespace test;
using Catch::Matchers::Contains;

TEST_CASE("surfaces of GIFTI and FreeSurfer come back with the same faces and the nearest floats") {
  for (const auto& [name, mesh] : small_family()) {
    for (const auto& [output, input] :
         {std::pair(MeshFormat::gii, MeshFormat::gii), std::pair(MeshFormat::fs, MeshFormat::fs)}) {
      INFO(name << " " << name_in(input_format_names(), input));
      const PolygonSoup soup = parse_soup(to_bytes(LabelledMesh{mesh}, output), input, "file");
      CHECK(soup.notes.empty());
      const CheckedMesh back = build_mesh(soup, DefectPolicy::error);
      REQUIRE(back.mesh.face_count() == mesh.face_count());
      for (const VertexId v : mesh.vertices()) {
        CHECK(back.mesh.position(v) == mesh.position(v).cast<float>().cast<double>());
      }
      for (const FaceId f : mesh.faces()) CHECK(back.mesh.vertices(f) == mesh.vertices(f));
    }
  }
}

TEST_CASE("the table of labels has the colours of the regions, and ??? for none") {
  const Labelled labelled;
  const std::string gifti = to_bytes(labelled.view(), MeshFormat::label_gii);
  CHECK_THAT(gifti, Contains("<Label Key=\"0\"") && Contains("Alpha=\"0\"><![CDATA[???]]>"));
  const std::vector<Rgb> colors = region_colors(labelled.view());
  for (std::size_t label = 0; label < 3; ++label) {
    const Rgb& color = colors[label];
    CHECK_THAT(gifti,
               Contains(fmt::format("<Label Key=\"{}\" Red=\"{}\" Green=\"{}\" Blue=\"{}\" Alpha=\"1\"><![CDATA["
                                    "region_{}]]>",
                                    label + 1, color.red / 255.0, color.green / 255.0, color.blue / 255.0, label)));
  }
  CHECK_THAT(gifti, !Contains("Key=\"4\""));
}

TEST_CASE("an annotation has another colour for each region, near that of the region") {
  constexpr int kRegions = 3000;
  const Mesh mesh = make_grid(100, 50);
  IdVector<VertexId, GeneratorId> labels;
  for (const VertexId v : mesh.vertices()) labels.push_back(GeneratorId(v.value() < kRegions ? v.value() : -1));
  LabelledMesh labelled{mesh};
  labelled.vertex_label = &labels;
  const std::string bytes = to_bytes(labelled, MeshFormat::annot);
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(bytes[at + i]);
    return value;
  };
  const std::vector<Rgb> region = region_colors(labelled);
  std::set<std::uint32_t> colors, plain;
  int farthest = 0;
  for (std::size_t v = 0; v < kRegions; ++v) {
    const std::uint32_t packed = number(4 + 8 * v + 4);
    const Rgb& color = region[v];
    colors.insert(packed);
    plain.insert(color.red | color.green << 8 | color.blue << 16);
    for (const auto& [channel, shift] : {std::pair(color.red, 0), {color.green, 8}, {color.blue, 16}}) {
      farthest = std::max(farthest, std::abs(int(packed >> shift & 255) - channel));
    }
  }
  CHECK(plain.size() < kRegions);
  CHECK(colors.size() == kRegions);
  CHECK(colors.count(0) == 0);
  CHECK(farthest <= 7);
}

TEST_CASE("a row of distances is an array of GIFTI") {
  std::ostringstream out;
  write_distances_gifti(out, {.rows = {{1, 2, 3, 4, 5, 6}, 3}});
  CHECK_THAT(out.str(), Contains("NumberOfDataArrays=\"3\"") && Contains("<Data>AACAPwAAAEA=</Data>"));
}

TEST_CASE("formats of labels or distances need them, and floats must hold the mesh") {
  const Mesh mesh = make_grid(2, 2);
  const auto refused = [&](MeshFormat format) { return refusal([&] { to_bytes(LabelledMesh{mesh}, format); }); };
  CHECK(refused(MeshFormat::label_gii) ==
        ".label.gii holds labels of vertices, and there are none; choose another format");
  CHECK_THAT(refused(MeshFormat::annot), Contains(".annot holds labels"));
  CHECK_THAT(refused(MeshFormat::shape_gii), Contains(".shape.gii holds distances of vertices"));
  CHECK_THAT(refused(MeshFormat::curv), Contains(".curv holds distances of vertices"));
  std::vector<Vec3> far = mesh.positions();
  for (Vec3& p : far) p *= 1e39;
  std::vector<std::array<VertexId, 3>> faces;
  for (const FaceId f : mesh.faces()) faces.push_back(mesh.vertices(f));
  const Mesh distant(far, faces);
  CHECK_THAT(refusal([&] { to_bytes(LabelledMesh{distant}, MeshFormat::gii); }, ErrorCode::unwritable_output),
             Contains(".surf.gii holds 32-bit floats"));
}

TEST_CASE("GIFTI's extensions have two parts") {
  CHECK(output_format("a/lh.white.surf.gii") == MeshFormat::gii);
  CHECK(output_format("lh.white.gii") == MeshFormat::gii);
  CHECK(output_format("A.LABEL.GII") == MeshFormat::label_gii);
  CHECK(output_format("a.shape.gii") == MeshFormat::shape_gii);
  CHECK(output_format("a.func.gii") == MeshFormat::shape_gii);
  CHECK(output_format("lh.annot") == MeshFormat::annot);
  CHECK(output_format("lh.white.fs") == MeshFormat::fs);
  CHECK(parse_output_format("gii") == MeshFormat::gii);
  CHECK(format_extension("a.ply.gii/b.obj") == "obj");
}

}  // namespace gvd::test_write_organs
