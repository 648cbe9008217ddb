#pragma once

#include <vector>

#include "geodesic/windows/propagation/face_crossing.hpp"

namespace gvd::test {

/// Records the paths and windows that FaceCrossing and PseudoSources hand on.
struct RecordingTarget {
  struct Path {
    VertexCopyId vertex;
    VertexPath path;
  };
  struct Sent {
    Window window;
    WindowHistory history;
    WindowEdge edge;
  };
  std::vector<Path> paths;
  std::vector<Sent> windows;

  void reach_vertex(VertexCopyId v, const VertexPath& path) { paths.push_back({v, path}); }
  void enqueue_on_edge(const Window& w, const WindowHistory& history, const WindowEdge& edge) {
    windows.push_back({w, history, edge});
  }
};

}  // namespace gvd::test
