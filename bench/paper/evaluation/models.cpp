#include "models.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "command_line.hpp"
#include "resample.hpp"

namespace gvd::paper {

std::string Models::find_path(const Wanted& wanted) const {
  for (const std::string& file : wanted.files) {
    for (const std::string& folder : folders_) {
      for (const char* extension : {"obj", "off", "ply", "stl"}) {
        std::string path = fmt::format("{}/{}.{}", folder, file, extension);
        if (std::filesystem::exists(path)) return path;
      }
    }
  }
  return GVD_SOURCE_DIR "/data/figure.obj";
}

FoundMesh Models::find(const Wanted& wanted) const {
  const std::string path = find_path(wanted);
  const std::string file = std::filesystem::path(path).filename().string();
  Mesh mesh = bench::read_named_mesh(path).mesh;
  const int faces = static_cast<int>(scale_ * (wanted.faces == 0 ? mesh.face_count() : wanted.faces));
  const bool is_near = std::abs(mesh.face_count() - faces) <= kFacesTolerance * faces;
  if (is_near || compute_mesh_summary(mesh).boundary_loops > 0) return {file, std::move(mesh)};
  return {fmt::format("{}, resampled", file), resample(mesh, faces)};
}

}  // namespace gvd::paper
