// The result does not depend on the number of threads.
#include <string>
#include <string_view>
#include <vector>

#include "diagram/envelope/trace_envelope.hpp"
#include "diagram/graph/connected_tracer.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_threads {

const std::vector<Method> kMethods{Method::exact, Method::gbgvd, Method{Solver::fast_marching, Tracer::envelope},
                                   Method{Solver::windows, Tracer::growth}};

Diagram compute(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Method method, int threads) {
  DiagramOptions options;
  options.method = method;
  options.threads = threads;
  return compute_diagram(mesh, generators, options);
}

/// Throws for every face from a given one on.
class FailingField final : public DistanceField {
 public:
  FailingField(const DistanceField& field, FaceId from) : field_(field), from_(from) {}

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override {
    return field_.contested_edges(parallel);
  }
  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override { field_.collect(e, sources); }
  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override {
    if (f >= from_) throw Error(ErrorCode::no_valid_result, "no distances", f.value());
    field_.collect(f, layout, sources);
  }

 private:
  const DistanceField& field_;
  FaceId from_;
};

TEST_CASE("every number of threads gives the same diagram, in every field") {
  test::with_many_threads([] {
    for (const auto& [name, mesh] : test::small_family()) {
      const auto generators = test::random_generators(mesh, 40, 19);
      for (std::size_t i = 0; i < kMethods.size(); ++i) {
        const Diagram one = compute(mesh, generators, kMethods[i], 1);
        for (const int threads : {0, 2, 3, 8}) {
          INFO(name << ", method " << i << ", " << threads << " threads");
          CHECK(test::same_diagram(one, compute(mesh, generators, kMethods[i], threads)));
        }
      }
    }
  });
}

TEST_CASE("every number of threads gives the same diagram of a larger mesh, in five runs") {
  test::with_many_threads([] {
    const Mesh mesh = test::make_bumpy_sphere(5, 3);
    for (const int count : {1, 2, 300}) {
      const auto generators = test::random_generators(mesh, count, 7);
      const Diagram one = compute(mesh, generators, Method::exact, 1);
      for (int repetition = 0; repetition < 5; ++repetition) {
        for (const int threads : test::kThreads) {
          INFO(count << " generators, " << threads << " threads");
          REQUIRE(test::same_diagram(one, compute(mesh, generators, Method::exact, threads)));
        }
      }
    }
  });
}

TEST_CASE("a step can be cancelled while several threads work on it") {
  test::with_many_threads([] {
    const Mesh mesh = test::make_sphere(5);
    const auto generators = test::random_generators(mesh, 300, 4);
    for (const std::string step : {"bisectors", "faces", "cells"}) {
      for (const int threads : test::kThreads) {
        INFO(step << ", " << threads << " threads");
        int calls_after = -1;
        DiagramOptions options;
        options.threads = threads;
        options.progress = [&](std::string_view current, double fraction) {
          // The first report of the step's work. Usually it comes while threads work; a calling thread that got no
          // processor until all was done reports once, at the end.
          if (calls_after >= 0 || (current == step && fraction > 0)) ++calls_after;
          return calls_after < 0;
        };
        try {
          compute_diagram(mesh, generators, options);
          FAIL("was not cancelled");
        } catch (const Error& error) {
          CHECK(error.code() == ErrorCode::interrupted);
        }
        CHECK(calls_after == 0);
      }
    }
  });
}

TEST_CASE("of several faces that fail, the first one is named") {
  test::with_many_threads([] {
    const Mesh mesh = test::make_sphere(4);
    const WorkingMesh working(mesh, test::random_generators(mesh, 100, 4));
    const WindowField field =
        propagate_windows(working.mesh(), working.generator_vertices().raw(), {KeepWindows::near_bisectors, {}}, {});
    const WindowDistances distances(working.mesh(), field);
    const auto first_failure = [&](int threads) {
      const Progress silent;
      const ParallelChunks parallel(threads, silent);
      const FailingField failing(distances, FaceId(working.mesh().face_count() / 2));
      EnvelopeTracer tracer(working, failing, 1e-3, parallel);
      try {
        trace_connected(working, take_labels(working, field.distance, field.label, parallel), tracer, silent);
      } catch (const Error& error) {
        return error.element();
      }
      return std::int64_t{-1};
    };
    const std::int64_t expected = first_failure(1);
    CHECK(expected >= working.mesh().face_count() / 2);
    for (int repetition = 0; repetition < 10; ++repetition) {
      for (const int threads : test::kThreads) CHECK(first_failure(threads) == expected);
    }
  });
}

TEST_CASE("a negative number of threads is refused") {
  const Mesh mesh = test::make_sphere(1);
  try {
    compute(mesh, test::random_generators(mesh, 3, 1), Method::exact, -1);
    FAIL("was not refused");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::invalid_option);
  }
}

}  // namespace gvd::test_threads
