#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "models.hpp"

namespace gvd::paper {

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

/// Tables 1 to 5, E at ten sets of generators, figure 10, and what else the numbers that are not met could be.
std::vector<Table> list_tables();

}  // namespace gvd::paper
