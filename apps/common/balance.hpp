#pragma once

#include "common/run.hpp"
#include "gvd/balance.hpp"

namespace gvd::app {

/// Notes and reports how equal the cells are, and which have no share of their own.
void report_balance(Run& run, const BalancedDiagram& balanced);

}  // namespace gvd::app
