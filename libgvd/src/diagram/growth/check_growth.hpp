#pragma once

#include "diagram/growth/growth.hpp"

namespace gvd {

/// Whether what has grown is consistent; fills in `grown.labels`. Separate from the growth, which it does not trust.
bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown);

}  // namespace gvd
