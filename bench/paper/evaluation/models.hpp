#pragma once

#include <string>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd::paper {

/// A model of the paper, and what may stand for it.
struct Wanted {
  std::string model;               ///< the paper's name
  int faces = 0;                   ///< the paper's number; 0 for the mesh as it is
  std::vector<std::string> files;  ///< names without extension, the best first
};

struct FoundMesh {
  std::string name;  ///< what the mesh is: its file, and whether it is resampled
  Mesh mesh;
};

/// The meshes at hand: those of the folders, and data/figure.obj, which stands for every model that is not there.
class Models {
 public:
  /// `scale` multiplies the paper's numbers of faces, > 0: less than 1 for tests.
  Models(std::vector<std::string> folders, double scale) : folders_(std::move(folders)), scale_(scale) {}

  /// The first file of `wanted` that a folder has, resampled if its number of faces differs by more than
  /// kFacesTolerance. Meshes with a boundary are never resampled. Throws Error if a file is no mesh.
  FoundMesh find(const Wanted& wanted) const;

 private:
  std::string find_path(const Wanted& wanted) const;

  std::vector<std::string> folders_;
  double scale_;
};

}  // namespace gvd::paper
