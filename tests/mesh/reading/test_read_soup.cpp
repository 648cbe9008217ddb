#include <clocale>
#include <filesystem>
#include <fstream>
#include <locale>
#include <random>

#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/models.hpp"

namespace gvd::test_read_soup {

using namespace test;

struct Sample {
  MeshFormat format;
  std::string bytes;
};

std::vector<Sample> samples() {
  return {{MeshFormat::obj, kObj},
          {MeshFormat::off, kOff},
          {MeshFormat::ply, kPly},
          {MeshFormat::ply, binary_ply(true)},
          {MeshFormat::ply, binary_ply(false)},
          {MeshFormat::stl, kStl},
          {MeshFormat::stl, binary_stl()},
          {MeshFormat::vtp, kVtp},
          {MeshFormat::vtu, kVtu},
          {MeshFormat::vtk, kVtk},
          {MeshFormat::mni, kMni},
          {MeshFormat::gltf, kGltf},
          {MeshFormat::glb, glb_of(glb_description(2), glb_numbers())},
          {MeshFormat::gii, kGifti},
          {MeshFormat::fs, freesurfer_surface()}};
}

// A file in a folder of its own; the folder is removed with it.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& bytes)
      : folder_(std::filesystem::temp_directory_path() / ("gvd_read_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(folder_);
    std::ofstream(path_ = folder_ / name, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_, path_;
};

void require_file_refused(const std::filesystem::path& path, const std::string& part) {
  try {
    read_soup(path);
    FAIL("read, expected: " << part);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::unreadable_input);
    CHECK_THAT(error.what(), Catch::Matchers::Contains(part) && Catch::Matchers::StartsWith(path.string()));
  }
}

// Reads and builds; anything but success or an Error with one line fails the test.
void read_anything(std::string_view bytes, MeshFormat format) {
  try {
    build_mesh(parse_soup(bytes, format, "file"), DefectPolicy::largest);
  } catch (const Error& error) {
    REQUIRE(std::string(error.what()).size() > 10);
    REQUIRE(std::string(error.what()).find('\n') == std::string::npos);
  }
}

struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_CASE("the format is detected by content first, then by extension") {
  for (const auto& [format, bytes] : samples()) {
    for (const std::string name : {"a.obj", "a.OFF", "a.ply", "a.stl", "a", "a.b/c", "a.txt"}) {
      INFO(name << " " << name_in(input_format_names(), format));
      CHECK(detect_format(bytes, name) == format);
    }
  }
  CHECK(detect_format("3 1 0\n", "a.off") == MeshFormat::off);
  CHECK(detect_format("anything", "a.Obj") == MeshFormat::obj);
  CHECK_FALSE(detect_format("anything", "a.txt").has_value());
  CHECK_FALSE(detect_format("", "").has_value());
  CHECK(format_from_extension("PLY") == MeshFormat::ply);
  CHECK(format_from_extension(".stl") == MeshFormat::stl);
  CHECK_FALSE(format_from_extension("step").has_value());
}

TEST_CASE("files are read whatever their extension, and refused with the reason") {
  for (const auto& [format, bytes] : samples()) require_tetrahedron(read_soup(TemporaryFile("a.off", bytes).path()));
  const TemporaryFile file("a.off", kPly);
  CHECK_THROWS_WITH(read_soup(file.path(), MeshFormat::off), Catch::Matchers::Contains("should be OFF, and is 'ply'"));
  require_file_refused(TemporaryFile("a.off", "").path(), "the file is empty");
  require_file_refused(TemporaryFile("a.txt", "hello\n").path(),
                       "neither the name nor the content is that of a PLY, OBJ, OFF, STL, VTP, VTU, VTK, GLB, glTF, "
                       "GIFTI, MNI or FreeSurfer file; name the format");
  for (const char* name : {"a.obj", "a.obj.gz", "gz"}) {
    require_file_refused(TemporaryFile(name, "\x1f\x8b\x08").path(), "gzip's data end after 0 unpacked bytes");
    require_file_refused(TemporaryFile(name, "PK\x03\x04").path(), "the file is compressed by zip; unpack it first");
  }
  require_file_refused(TemporaryFile("a.off", "hello\n").path(), "should be OFF, and is 'hello'");
  require_file_refused(file.folder(), "directory");
  require_file_refused(file.folder() / "missing.off", "there is no such file");
}

TEST_CASE("compressed bytes are told by their mark, however few there are") {
  CHECK(find_compression("\x1f\x8b\x08 more") == "gzip");
  CHECK(find_compression("BZh91AY&SY") == "bzip2");
  for (const char* bytes : {"", "B", "BZh", "BZh9", "BZh91AY&S", "PK", "v 0 0 0"})
    CHECK(find_compression(bytes).empty());
}

TEST_CASE("numbers are the same in any locale") {
  const std::string bytes = "v 1.5 1234.25 1e-3\nv 0.25 -0.125 1\nv 3 4 5.5\nf 1 2 3\n";
  const PolygonSoup plain = parse_soup(bytes, MeshFormat::obj, "file");
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_ALL, name)) break;
  }
  const PolygonSoup there = parse_soup(bytes, MeshFormat::obj, "file");
  std::string message;
  try {
    parse_soup(bytes + "f 1 2 1234\n", MeshFormat::obj, "file");
  } catch (const Error& error) {
    message = error.what();
  }
  std::setlocale(LC_ALL, "C");
  std::locale::global(before);
  CHECK(plain.positions == there.positions);
  CHECK(plain.positions[0] == Vec3(1.5, 1234.25, 1e-3));
  CHECK(message == "file:5: a face refers to vertex 1234, and the file has 3");
}

TEST_CASE("a file cut off at any byte is read or refused") {
  for (const auto& [format, bytes] : samples()) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      INFO(name_in(input_format_names(), format) << " cut off at " << size);
      read_anything(bytes.substr(0, size), format);
      // Formats with counts in the header notice every missing byte but the last line break.
      if (format != MeshFormat::obj && size + 1 < bytes.size() && size + 24 < bytes.size()) {
        CHECK_THROWS_AS(parse_soup(bytes.substr(0, size), format, "file"), Error);
      }
    }
  }
}

TEST_CASE("a file with changed bytes is read or refused") {
  std::mt19937 random(7);
  for (const auto& [format, bytes] : samples()) {
    for (int round = 0; round < 1500; ++round) {
      std::string changed = bytes;
      const auto changes = 1 + random() % 4;
      for (std::size_t i = 0; i < changes; ++i) {
        const std::size_t at = random() % changed.size();
        switch (random() % 4) {
          case 0:
            changed[at] = static_cast<char>(random());
            break;
          case 1:
            changed.erase(at, 1 + random() % 3);
            break;
          case 2:
            changed.insert(at, 1, "0123456789 -\n.e"[random() % 15]);
            break;
          default:
            changed[at] = "0123456789 -\n.e"[random() % 15];
            break;
        }
        if (changed.empty()) changed.assign(1, ' ');
      }
      INFO(name_in(input_format_names(), format) << " " << changed);
      read_anything(changed, format);
    }
  }
}

TEST_CASE("larger models are read with all their faces") {
  struct Model {
    const char* name;
    std::int32_t faces, euler_characteristic, boundary_loops;
    std::int64_t unused;
  };
  for (const Model& model : {Model{"lucy.obj", 20000, 2, 0, 0}, Model{"kitten_16k.obj", 16060, 0, 0, 0},
                             Model{"rocker_arm.obj", 20088, 0, 0, 0}, Model{"fandisk.obj", 12946, 2, 0, 0},
                             Model{"bunny_69k_boundary.obj", 69451, -3, 5, 1113}}) {
    INFO(model.name);
    const auto path = find_model(model.name);
    if (!path) continue;
    const CheckedMesh checked = build_mesh(read_soup(*path));
    const MeshSummary summary = compute_mesh_summary(checked.mesh);
    CHECK(summary.faces == model.faces);
    CHECK(summary.euler_characteristic == model.euler_characteristic);
    CHECK(summary.boundary_loops == model.boundary_loops);
    CHECK(checked.defects.count(DefectKind::unused_vertices) == model.unused);
    CHECK(checked.defects.defects.size() == (model.unused > 0 ? 1U : 0U));
  }
}

TEST_CASE("check_counts: as many vertices and polygons as 32-bit ids can count, and not one more") {
  const auto most = static_cast<std::uint64_t>(kMostVertices);
  CHECK_NOTHROW(check_counts(most, most, "file"));
  CHECK_THROWS_AS(check_counts(most + 1, 0, "file"), Error);
  CHECK_THROWS_AS(check_counts(0, most + 1, "file"), Error);
}

TEST_CASE("mesh format: names and extensions, upper or lower case") {
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off, MeshFormat::stl, MeshFormat::vtp,
                                  MeshFormat::vtu, MeshFormat::vtk, MeshFormat::glb, MeshFormat::gltf}) {
    CHECK(format_from_extension(name_in(input_format_names(), format)) == format);
    CHECK(format_from_extension("a.b/model." + std::string(name_in(input_format_names(), format))) == format);
  }
  CHECK(format_from_extension("MODEL.OBJ") == MeshFormat::obj);
  CHECK(format_from_extension("model.obj.gz") == MeshFormat::obj);
  CHECK(format_from_extension("model.VTP.GZ") == MeshFormat::vtp);
  for (const char* name : {"model.3mf", "model.gz", "model.obj.bz2", "gz"}) CHECK_FALSE(format_from_extension(name));
  CHECK_FALSE(format_from_extension(""));
}

TEST_CASE("mesh format: the content decides, and the extension only where the content says nothing") {
  CHECK(detect_format(test::kObj, "a.stl") == MeshFormat::obj);
  CHECK(detect_format(test::kPly, "a.obj") == MeshFormat::ply);
  CHECK(detect_format(test::kOff, "a") == MeshFormat::off);
  CHECK(detect_format(test::kStl, "a.off") == MeshFormat::stl);
  CHECK(detect_format(test::binary_stl(), "a.off") == MeshFormat::stl);
  CHECK(detect_format("4 4 6\n", "a.off") == MeshFormat::off);
  for (const std::string before : {"\xEF\xBB\xBF", " ", "\t"}) {
    CHECK(detect_format(before + test::kPly, "a.obj") == MeshFormat::ply);
  }
  CHECK_FALSE(detect_format("plywood\n", "a"));
  CHECK_FALSE(detect_format("ply", "a"));
  CHECK_FALSE(detect_format("hello\n", "a.txt"));
  CHECK_FALSE(detect_format("hello\n", "off"));
}

TEST_CASE("mesh format: OFF keywords, and the length of a binary STL") {
  for (const char* word : {"OFF", "COFF", "NOFF", "STCNOFF", "4OFF", "nOFF"}) CHECK(is_off_keyword(word));
  for (const char* word : {"", "off", "OFFX", "XOFF"}) CHECK_FALSE(is_off_keyword(word));
  CHECK(is_binary_stl(test::binary_stl()));
  CHECK_FALSE(is_binary_stl(test::binary_stl() + "x"));
  CHECK_FALSE(is_binary_stl(std::string(84, '\0')));
  CHECK_FALSE(is_binary_stl(""));
}

}  // namespace gvd::test_read_soup
