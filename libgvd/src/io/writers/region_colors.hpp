#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/mesh.hpp"

// Colours of regions, for files and pages.
namespace gvd::io {

/// Colours of regions. Any two of them, and each one and kUnlabelledColor, differ by at least 14.6 in CIEDE2000: for
/// full colour vision, and simulated for protanopia, deuteranopia and tritanopia by the matrices of Machado et al.
/// 2009, and the first two by those of Vienot et al. 1999. Simulated annealing of the smallest of these differences
/// found them. The usual ones have lightnesses from 60 to 93, and neither brown nor olive; they were chosen among 24
/// such palettes by pictures of two meshes. A floor of 42 in place of 60 would allow differences of 20, with brown,
/// charcoal and navy. The other three have a lightness of 38, since no lighter ones differ as much.
inline constexpr std::array<Rgb, 9> kRegionPalette{{{0x5f, 0xc1, 0xd9},
                                                    {0xfd, 0xec, 0x8f},
                                                    {0xde, 0x72, 0x4b},
                                                    {0xbf, 0xf5, 0xf9},
                                                    {0x78, 0x89, 0xed},
                                                    {0xd5, 0xe4, 0xcb},
                                                    {0x49, 0x51, 0xb8},
                                                    {0xae, 0x1b, 0x37},
                                                    {0x7b, 0x4a, 0x65}}};
inline constexpr std::size_t kUsualColors = 6;  ///< of the palette, at its start; dark lines show less on the others

using RegionPair = std::pair<GeneratorId, GeneratorId>;

/// Appends the pairs of labels on both sides of an edge.
void add_face_neighbours(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::vector<RegionPair>& pairs);

/// Appends the pairs of cells with a common bisector.
void add_cell_neighbours(const IdVector<GeneratorId, Cell>& cells, std::vector<RegionPair>& pairs);

/// Leaves each pair once, smaller label first, ascending.
void sort_pairs(std::vector<RegionPair>& pairs);

/// A colour of the palette for each of `count` labels, such that adjacent ones differ.
///
/// Each label in turn takes, of the usual colours that no neighbour has yet, the one that the fewest labels have; of
/// the others where there is none. In the order (smallest-last, Matula and Beck 1983) each label has at most d
/// neighbours before it, d being the degeneracy of the graph. For connected regions d is at most 5 on a surface of
/// genus 0. For genus g > 0 it is at most (5 + sqrt(1 + 48 g)) / 2 (Heawood 1890). So the usual colours suffice for
/// genus 0, and the palette up to genus 3. Elsewhere, a label with all colours round it takes that of the fewest
/// neighbours.
/// Cost: O(n log n) for n labels and pairs.
std::vector<Rgb> choose_region_colors(std::size_t count, const std::vector<RegionPair>& adjacent);

/// The colours `before` of the first labels, all of the palette, changed until adjacent labels differ: labels that have
/// the colour of a neighbour, that are new, or that have a dark colour without need.
///
/// A label takes a usual colour that no neighbour has, if there is one. Else it takes one from a neighbour, which then
/// needs another one in turn. This ends nearly always after a few changes. If it does not, all colours are chosen anew.
/// Cost: O(n log n) for n labels and pairs; nearly always O(n).
std::vector<Rgb> adapt_region_colors(const std::vector<Rgb>& before, std::size_t count,
                                     const std::vector<RegionPair>& adjacent);

}  // namespace gvd::io
