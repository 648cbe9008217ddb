#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::test {

/// One of the meshes with exact distances in the shared data's folder `reference`.
struct Reference {
  std::string name;
  Mesh mesh;
  std::vector<VertexId> generators;
  std::vector<std::vector<double>> distances;  ///< [generator][vertex], mesh units, exact

  std::vector<SurfacePoint> generator_points() const;
};

/// The names of all references in `folder`, ascending: every NAME for which NAME.dist.f64 is there.
std::vector<std::string> list_references(const std::filesystem::path& folder);

/// Throws Error{unreadable_input} where a file is missing or does not have the size that the mesh asks for.
Reference read_reference(const std::filesystem::path& folder, const std::string& name);

}  // namespace gvd::test
