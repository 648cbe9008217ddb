#pragma once

#include <vector>

#include "path_submesh.hpp"

namespace gvd {

/// Exact distances from the submesh's source to its targets, by CGAL's Surface_mesh_shortest_path; infinity if CGAL
/// finds no path. Only the .cpp file includes CGAL.
/// Throws Error{no_valid_result} if CGAL rejects the surface.
std::vector<double> solve_shortest_paths(const PathSubmesh& submesh);

/// While an object of this class exists, a failed check of CGAL throws and prints nothing.
class QuietCgal {
 public:
  QuietCgal();
  ~QuietCgal();
  QuietCgal(const QuietCgal&) = delete;
  QuietCgal& operator=(const QuietCgal&) = delete;

 private:
  using Handler = void (*)(const char*, const char*, const char*, int, const char*);
  Handler on_error_;
  Handler on_warning_;
};

}  // namespace gvd
