#include <cstdio>

#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

using namespace gvd;

TEST_CASE("sweep") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 3, 4, 5, 10, 30, 100}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        const auto generators = test::random_generators(mesh, count, seed);
        try {
          const RemeshResult r = remesh(mesh, generators);
          std::printf("%-16s m %3d seed %u: ok, added %ld rounds %d\n", name.c_str(), count, seed, long(r.added),
                      r.rounds);
        } catch (const Error& e) {
          std::printf("%-16s m %3d seed %u: %d %s\n", name.c_str(), count, seed, int(e.code()), e.what());
        }
      }
    }
  }
}
