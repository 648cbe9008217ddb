#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "comparators.hpp"
#include "judge.hpp"
#include "models.hpp"

namespace gvd::paper {

/// What is measured on a mesh. Run i draws the generators with seed i.
struct Experiment {
  const Mesh& mesh;
  int generators = 1;
  int runs = 1;
  bool errors = false;   ///< whether E and the turning angle are computed, which takes most of the time
  bool memory = false;   ///< whether the peak of the heap is counted, in a run of its own
  bool others = false;   ///< whether what else could be taken for E is measured
  bool crowded = false;  ///< whether all generators lie in one face, instead of at vertices
};

struct Statistic {
  double mean = 0;
  double deviation = 0;  ///< of the sample, 0 for one run
  double least = 0;
  double most = 0;
};

Statistic summarize(const std::vector<double>& values);

/// A method's figures: one value for each run in each list. What the experiment does not ask for is empty or 0.
struct Measurement {
  std::string method;
  double memory_kb = 0;  ///< largest heap of the first run, without the input
  std::vector<double> field_ms, diagram_ms;
  std::vector<double> errors;                                       ///< E, square mesh units
  std::vector<double> turn_per_length;                              ///< radians for each mesh unit
  std::vector<double> wrong_percent;                                ///< the share of the vertices with a wrong label
  std::vector<double> islands;                                      ///< components of cells without their generator
  std::vector<double> by_marching, by_straight, of_face, distance;  ///< OtherErrors
};

std::vector<Measurement> measure(const Experiment& experiment, const std::vector<Comparator>& methods);

struct Evaluation {
  Models models;
  int runs = 1;
  /// Called with the name of each row when its measurement begins; may be empty.
  std::function<void(const std::string&)> report;
};

/// A table or a figure of section 5: its key, and its rows as `scripts/make_paper.py` reads them. A row has the paper's
/// model, the mesh that stands for it, its faces, area and quality, m, and a list of methods with their figures.
struct Table {
  std::string key;
  std::function<nlohmann::json(const Evaluation&)> measure;
};

/// Tables 1 to 5, E at ten sets of generators, figure 10, and many generators in one triangle.
std::vector<Table> list_tables();

}  // namespace gvd::paper
