#pragma once

#include <array>
#include <string_view>

#include "gvd/progress.hpp"

/// The schedule of `compute_diagram`: the steps that it reports to its progress callback, and how stages share a step.
namespace gvd::steps {

inline constexpr std::string_view kWorkingMesh = "working mesh";  ///< the generators become vertices
inline constexpr std::string_view kDistances = "distances";       ///< windows or fast marching
inline constexpr std::string_view kTables = "tables";             ///< windows before growth: tables of the faces
inline constexpr std::string_view kBisectors = "bisectors";       ///< labels, and where bisectors cross edges
inline constexpr std::string_view kFaces = "faces";               ///< envelope: bisectors inside the faces
inline constexpr std::string_view kGrowth = "growth";             ///< growth: bisectors inside the gaps
inline constexpr std::string_view kCells = "cells";               ///< bisectors from end to end, then cells

/// All steps, in the order in which they begin. A method reports only the steps that it needs. It reports kBisectors
/// again after kFaces and kGrowth, and when cells have to be connected.
inline constexpr std::array<std::string_view, 7> kAll{kWorkingMesh, kDistances, kTables, kBisectors,
                                                      kFaces,       kGrowth,    kCells};

// The parts of steps that several stages share.
inline constexpr StepPart kLabels{kBisectors, 0, 0};              ///< unsupported vertices, contested edges
inline constexpr StepPart kCrossings{kBisectors, 0, 0.5};         ///< the crossings of the edges
inline constexpr StepPart kCrossingsAgain{kBisectors, 0.5, 0.5};  ///< edges that are crossed at most once
inline constexpr StepPart kRefinement{kBisectors, 0.5, 0.75};     ///< growth: crossings by unfolding
inline constexpr StepPart kAssembly{kBisectors, 0.75, 1};         ///< growth: faces outside of the gaps
inline constexpr StepPart kPolylines{kCells, 0, 0.5};             ///< the points of the bisectors
inline constexpr StepPart kVerticesAndEdges{kCells, 0.5, 0.5};    ///< counted for the cells' Euler characteristics
inline constexpr StepPart kPieces{kCells, 0.5, 1};                ///< the cells' faces, cut and whole

}  // namespace gvd::steps
