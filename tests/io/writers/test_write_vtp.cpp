#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "io/fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_write_vtp {

using namespace test;

std::string decode_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  if (text.size() % 4 != 0) throw std::runtime_error("base64 comes in fours");
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::size_t group = 0, padding = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      padding += text[k] == '=';
      group = group * 64 + (text[k] == '=' ? 0 : digits.find(text[k]));
    }
    for (std::size_t k = 0; k < 3 - padding; ++k) bytes.push_back(static_cast<char>(group >> (16 - 8 * k) & 255));
  }
  return bytes;
}

/// A small XML reader: checks that tags nest and close, and collects the DataArrays as "Parent/Name" -> bytes.
class Vtp {
 public:
  explicit Vtp(const std::string& text) {
    std::vector<std::string> open;
    std::size_t at = text.find("?>") + 2;
    while ((at = text.find('<', at)) != std::string::npos) {
      const std::size_t end = text.find('>', at);
      const std::string tag = text.substr(at + 1, end - at - 1);
      const std::string name = tag.substr(0, tag.find(' '));
      at = end + 1;
      if (name[0] == '/') {
        if (open.empty() || open.back() != name.substr(1)) throw std::runtime_error("</" + name + "> closes nothing");
        open.pop_back();
        continue;
      }
      tags_[name] = tag;
      if (name == "DataArray") read_array(open.back(), tag, text.substr(end + 2, text.find('<', end) - end - 3));
      open.push_back(name);
    }
    if (!open.empty()) throw std::runtime_error("<" + open.back() + "> is not closed");
  }

  std::string attribute(const std::string& tag, const std::string& name) const {
    return attribute_of(tags_.at(tag), name);
  }
  bool has(const std::string& array) const { return arrays_.count(array) > 0; }

  template <class T>
  std::vector<T> get(const std::string& array, const std::string& type) const {
    CHECK(types_.at(array) == type);
    const std::string& bytes = arrays_.at(array);
    std::vector<T> values;
    for (std::size_t offset = 8; offset < bytes.size();) values.push_back(take<T>(bytes, offset));
    return values;
  }

 private:
  static std::string attribute_of(const std::string& tag, const std::string& name) {
    const std::size_t begin = tag.find(" " + name + "=\"") + name.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
  }

  void read_array(const std::string& parent, const std::string& tag, const std::string& base64) {
    const std::string key = parent + "/" + attribute_of(tag, "Name");
    const std::string bytes = decode_base64(base64);
    std::size_t offset = 0;
    if (take<std::uint64_t>(bytes, offset) != bytes.size() - 8) throw std::runtime_error(key + ": wrong length");
    arrays_[key] = bytes;
    types_[key] = attribute_of(tag, "type");
  }

  std::map<std::string, std::string> tags_, arrays_, types_;
};

TEST_CASE("a labelled VTP carries faces, bisectors and their arrays") {
  const Labelled labelled;
  const Vtp vtp(to_bytes(labelled.view(), MeshFormat::vtp));
  CHECK(vtp.attribute("VTKFile", "type") == "PolyData");
  CHECK(vtp.attribute("VTKFile", "header_type") == "UInt64");
  CHECK(vtp.attribute("Piece", "NumberOfPoints") == "29");
  CHECK(vtp.attribute("Piece", "NumberOfLines") == "3");
  CHECK(vtp.attribute("Piece", "NumberOfPolys") == "24");

  const auto label = vtp.get<std::int32_t>("CellData/Label", "Int32");
  const auto left = vtp.get<std::int32_t>("CellData/Left", "Int32");
  const auto right = vtp.get<std::int32_t>("CellData/Right", "Int32");
  const auto parent = vtp.get<std::int32_t>("CellData/Parent", "Int32");
  REQUIRE(label.size() == 27);
  CHECK(std::vector(left.begin(), left.begin() + 4) == std::vector<std::int32_t>{0, 1, 2, -1});
  CHECK(std::vector(right.begin(), right.begin() + 4) == std::vector<std::int32_t>{1, 2, 2, -1});
  CHECK(std::vector(label.begin(), label.begin() + 3) == std::vector<std::int32_t>{-1, -1, -1});
  for (std::size_t f = 0; f < 24; ++f) {
    CHECK(label[3 + f] == labelled.face_label.raw()[f].value());
    CHECK(parent[3 + f] == static_cast<int>(f / 2));
  }
  CHECK(vtp.get<std::int64_t>("Lines/connectivity", "Int64") ==
        std::vector<std::int64_t>{20, 21, 22, 23, 24, 25, 26, 27, 28});
  CHECK(vtp.get<std::int64_t>("Lines/offsets", "Int64") == std::vector<std::int64_t>{3, 5, 9});
  CHECK(vtp.get<std::int64_t>("Polys/offsets", "Int64").back() == 72);
}

TEST_CASE("points and distances of a VTP are doubles, bit for bit") {
  const Labelled labelled;
  const Vtp vtp(to_bytes(labelled.view(), MeshFormat::vtp));
  const auto points = vtp.get<double>("Points/Points", "Float64");
  const auto distance = vtp.get<double>("PointData/Distance", "Float64");
  const auto label = vtp.get<std::int32_t>("PointData/Label", "Int32");
  const auto corners = vtp.get<std::int64_t>("Polys/connectivity", "Int64");
  REQUIRE(points.size() == 87);
  for (int v = 0; v < 20; ++v) {
    const auto i = static_cast<std::size_t>(v);
    CHECK(Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]) == labelled.mesh.position(VertexId(v)));
    CHECK(distance[i] == labelled.diagram.vertex_distance[VertexId(v)]);
    CHECK(label[i] == labelled.diagram.vertex_label[VertexId(v)].value());
  }
  CHECK(std::isinf(distance[19]));
  for (std::size_t i = 0; i < 72; ++i) {
    CHECK(corners[i] == labelled.mesh.vertices(FaceId(static_cast<int>(i / 3)))[i % 3].value());
  }
  // The branch point lies in face 7: its distance is between those of its corners.
  double expected = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    expected += (i == 2 ? 0.5 : 0.25) * labelled.diagram.vertex_distance[labelled.mesh.vertices(FaceId(7))[i]];
  }
  CHECK(distance[20] == Approx(expected).epsilon(1e-14));
}

TEST_CASE("a plain VTP has neither data nor lines") {
  const Vtp vtp(to_bytes(LabelledMesh{make_sphere(0)}, MeshFormat::vtp));
  CHECK(vtp.attribute("Piece", "NumberOfLines") == "0");
  CHECK_FALSE(vtp.has("CellData/Label"));
  CHECK_FALSE(vtp.has("CellData/Left"));
  CHECK_FALSE(vtp.has("PointData/Distance"));
  CHECK(vtp.get<std::int64_t>("Polys/connectivity", "Int64").size() == 60);
}

TEST_CASE("a VTU has the faces first, then each segment of the bisectors as a cell") {
  const Labelled labelled;
  const Vtp vtu(to_bytes(labelled.view(), MeshFormat::vtu));
  CHECK(vtu.attribute("VTKFile", "type") == "UnstructuredGrid");
  CHECK(vtu.attribute("Piece", "NumberOfPoints") == "29");
  CHECK(vtu.attribute("Piece", "NumberOfCells") == "30");
  const auto types = vtu.get<std::uint8_t>("Cells/types", "UInt8");
  REQUIRE(types.size() == 30);
  CHECK(std::count(types.begin(), types.begin() + 24, 5) == 24);
  CHECK(std::count(types.begin() + 24, types.end(), 3) == 6);
  const auto corners = vtu.get<std::int64_t>("Cells/connectivity", "Int64");
  for (const HalfedgeId h : labelled.mesh.halfedges()) CHECK(corners.at(h.index()) == labelled.mesh.from(h).value());
  CHECK(std::vector(corners.begin() + 72, corners.end()) ==
        std::vector<std::int64_t>{20, 21, 21, 22, 23, 24, 25, 26, 26, 27, 27, 28});
  const auto ends = vtu.get<std::int64_t>("Cells/offsets", "Int64");
  CHECK(ends.at(23) == 72);
  CHECK(ends.at(29) == 84);
  const auto label = vtu.get<std::int32_t>("CellData/Label", "Int32");
  for (const FaceId f : labelled.mesh.faces()) CHECK(label.at(f.index()) == labelled.face_label[f].value());
  const auto left = vtu.get<std::int32_t>("CellData/Left", "Int32");
  CHECK(std::vector(left.begin() + 22, left.end()) == std::vector<std::int32_t>{-1, -1, 0, 0, 1, 2, 2, 2});
  CHECK(std::vector(label.begin() + 24, label.end()) == std::vector<std::int32_t>(6, -1));
  // Points and what they carry are those of a VTP.
  const Vtp vtp(to_bytes(labelled.view(), MeshFormat::vtp));
  CHECK(vtu.get<double>("Points/Points", "Float64") == vtp.get<double>("Points/Points", "Float64"));
  CHECK(vtu.get<std::int32_t>("PointData/Label", "Int32") == vtp.get<std::int32_t>("PointData/Label", "Int32"));
}

}  // namespace gvd::test_write_vtp
