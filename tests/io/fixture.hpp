#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// A flat grid with labels and a diagram made by hand, which is no Voronoi diagram. It has every feature that a writer
/// must handle: faces and vertices that no generator reaches, ends on the boundary, a closed bisector, and coordinates
/// with 17 digits.
struct Labelled {
  Labelled();
  /// With all arrays and the diagram.
  LabelledMesh view() const;

  Mesh mesh;
  IdVector<FaceId, GeneratorId> face_label;
  IdVector<FaceId, FaceId> face_parent;
  Diagram diagram;
};

/// A new folder, removed with its content at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Names of the files in it, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string read_bytes(const std::filesystem::path& path);
void write_bytes(const std::filesystem::path& path, const std::string& bytes);

/// The colour of a label in the files of a mesh.
Rgb color_in(const LabelledMesh& mesh, GeneratorId label);

/// The bytes that `write_mesh` writes.
std::string to_bytes(const LabelledMesh& mesh, MeshFormat format);

/// The little-endian number at `offset`; moves `offset` behind it.
template <class T>
T take(const std::string& bytes, std::size_t& offset);

}  // namespace gvd::test
