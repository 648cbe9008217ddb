#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

// Larger models that are not part of the repository: in the folder that GVD_MODELS names, else in `../shared`, else
// among the meshes of Debian's libcgal-demo that a test unpacks.

namespace gvd::test {

/// A mesh by the name of its file, as in "fandisk.obj"; of libcgal-demo "fandisk.off". Without it, a warning and
/// nothing.
std::optional<std::filesystem::path> find_model(const std::string& file);

/// A mesh with exact distances: NAME.obj, NAME.generators.txt and NAME.dist.f64 in one of the folders.
struct Reference {
  std::string name;
  Mesh mesh;
  std::vector<VertexId> generators;
  std::vector<std::vector<double>> distances;  ///< [generator][vertex], mesh units, exact

  std::vector<SurfacePoint> generator_points() const;
};

/// The names of all references, ascending; with a warning where there is none.
std::vector<std::string> list_references();

/// Throws Error{unreadable_input} where a file is missing or does not have the size that the mesh asks for.
Reference read_reference(const std::string& name);

/// The reference of that name; without it, a warning and nothing.
std::optional<Reference> find_reference(const std::string& name);

}  // namespace gvd::test
