// Relaxation, remeshing and segmentation give the same with any number of threads. Under the thread sanitizer these
// tests, and those of single steps, show the hand-over of results between steps.
#include <vector>

#include "gvd/lloyd.hpp"
#include "gvd/remesh.hpp"
#include "gvd/segment.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_threaded_results {

/// Large enough for several chunks and partitions in each step.
Mesh make_mesh() { return test::make_bumpy_sphere(4, 3); }

DiagramOptions with_threads(int threads) {
  DiagramOptions options;
  options.threads = threads;
  return options;
}

TEST_CASE("every number of threads gives the same relaxed generators") {
  test::with_many_threads([] {
    const Mesh mesh = make_mesh();
    const auto generators = test::random_generators(mesh, 30, 5);
    LloydOptions options;
    options.max_iterations = 2;
    const auto relax = [&](int threads) {
      options.diagram = with_threads(threads);
      return relax_generators(mesh, generators, options);
    };
    const LloydResult one = relax(1);
    for (const int threads : {3, 8}) {
      const LloydResult other = relax(threads);
      CHECK(test::same_diagram(one.diagram, other.diagram));
      CHECK(one.initial_energy == other.initial_energy);
    }
  });
}

TEST_CASE("every number of threads gives the same coarse mesh") {
  test::with_many_threads([] {
    const Mesh mesh = make_mesh();
    const auto generators = test::random_generators(mesh, 60, 2);
    const auto coarsen = [&](int threads) {
      RemeshOptions options;
      options.diagram = with_threads(threads);
      return remesh(mesh, generators, options);
    };
    const RemeshResult one = coarsen(1);
    for (const int threads : {3, 8}) {
      const RemeshResult other = coarsen(threads);
      CHECK(one.generators == other.generators);
      CHECK(one.mesh.positions() == other.mesh.positions());
      CHECK(test::same_diagram(one.diagram, other.diagram));
    }
  });
}

TEST_CASE("every number of threads gives the same labels and pieces of faces") {
  test::with_many_threads([] {
    const Mesh mesh = make_mesh();
    const auto generators = test::random_generators(mesh, 40, 8);
    const Diagram one = compute_diagram(mesh, generators, with_threads(1));
    const Diagram other = compute_diagram(mesh, generators, with_threads(8));
    CHECK(segment_faces(mesh, one).face_label == segment_faces(mesh, other).face_label);
    CHECK(cut_faces(mesh, one).parent == cut_faces(mesh, other).parent);
  });
}

}  // namespace gvd::test_threaded_results
