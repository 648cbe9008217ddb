// Readers and diagrams over real meshes.
#include <iostream>
#include <string>
#include <utility>

#include "corpus/corpus.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

using namespace gvd;
using test::corpus;

TEST_CASE("every mesh of the corpus is read, or refused with one line that names its place") {
  for (const auto& file : corpus()) {
    INFO(file);
    try {
      const CheckedMesh checked = build_mesh(read_soup(file));
      CHECK(checked.mesh.face_count() > 0);
    } catch (const Error& error) {
      const std::string line = error.what();
      CHECK((error.code() == ErrorCode::unreadable_input || error.code() == ErrorCode::precondition));
      CHECK(line.find('\n') == std::string::npos);
      CHECK(line.size() > 20);
    }
  }
}

TEST_CASE("the diagram is complete on every mesh of the corpus") {
  int diagrams = 0;
  for (const auto& file : corpus()) {
    CheckedMesh checked;
    try {
      checked = build_mesh(read_soup(file));
    } catch (const Error&) {
      continue;  // the test above looks at these
    }
    for (const int count : {2, 5, 30, 100, 300}) {
      // Exact diagrams, and those of the paper with either front.
      for (const auto& [method, seed] : std::initializer_list<std::pair<Method, unsigned>>{
               {Method::exact, 1}, {Method::gbgvd, 1}, {Method::gbgvd, 2}}) {
        INFO(file << ", " << count << " generators, seed " << seed << (method == Method::exact ? ", exact" : ""));
        DiagramOptions options;
        options.method = method;
        options.front = seed % 2 == 0 ? Front::circle : Front::planar;
        const Diagram diagram =
            compute_diagram(checked.mesh, test::random_generators(checked.mesh, count, seed), options);
        const DiagramCheck check = check_diagram(checked.mesh, diagram);
        for (const std::string& violation : check.violations) UNSCOPED_INFO(violation);
        REQUIRE(check.ok());
        REQUIRE(diagram.report.unresolved_ends == 0);
        ++diagrams;
      }
    }
  }
  std::cout << diagrams << " diagrams\n";
}
