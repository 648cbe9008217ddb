#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// A flat grid with labels and a diagram made by hand: every feature that a writer meets (faces and vertices that
/// nothing reaches, ends on the boundary, a closed bisector, coordinates with all their digits), no true Voronoi
/// diagram.
struct Labelled {
  Labelled();
  /// Everything that is known.
  LabelledMesh view() const;

  Mesh mesh;
  IdVector<FaceId, GeneratorId> face_label;
  IdVector<FaceId, FaceId> face_parent;
  Diagram diagram;
};

/// A folder of its own, removed with its content at the end.
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

/// What `write_mesh` puts into a stream.
std::string to_bytes(const LabelledMesh& mesh, OutputFormat format);

/// The little-endian number at `offset`, which moves behind it.
template <class T>
T take(const std::string& bytes, std::size_t& offset);

}  // namespace gvd::test
