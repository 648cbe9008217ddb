#pragma once

#include <vector>

#include "reach.hpp"

namespace gvd {

/// Exact distances from the reach's source to its targets, by CGAL's Surface_mesh_shortest_path; infinity where CGAL
/// finds no path. Every word of CGAL is in the .cpp.
/// Throws Error{no_valid_result} where CGAL refuses the surface.
std::vector<double> solve_shortest_paths(const Reach& reach);

/// While one lives, CGAL reports a broken check by its exception alone and prints nothing.
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
