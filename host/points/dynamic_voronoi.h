#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace capcon {

/// The Voronoi diagram of sites on the unit torus that come and go. Each cell is a convex polygon whose edges
/// know the site across: that is all an insertion or removal needs, and both touch a handful of cells only.
/// Cells are cut one by one in floating point; where four or more sites are on one circle, edges of length
/// about 0 may be there or not, which harms nothing: what a cell covers is right up to rounding.
class DynamicVoronoi {
 public:
  /// A site's image: its number, moved by whole periods.
  struct Image {
    std::uint32_t site = 0;
    std::int16_t x = 0, y = 0;
    bool operator==(const Image&) const = default;
  };
  /// An edge begins at `corner` (relative to the cell's own site) and ends at the next edge's,
  /// counter-clockwise.
  struct Edge {
    glm::dvec2 corner;
    Image across;
  };
  using Cell = std::vector<Edge>;

  /// Room for sites 0 to count - 1; none is there yet.
  explicit DynamicVoronoi(std::size_t count) : positions_(count), cells_(count) {}

  /// Puts site i at p in [0, 1)^2. `near` is a site that is there already (the search for p's place begins
  /// there), or i for the first of all. Two sites must not be at the same place.
  void insert(std::uint32_t i, glm::dvec2 p, std::uint32_t near);
  /// Takes site i away; its cell is empty then.
  void remove(std::uint32_t i);
  /// Puts back what the last call, a removal, took away, exactly.
  void undo_remove();

  /// The sites whose cells the last call changed, each once.
  const std::vector<std::uint32_t>& changed() const { return changed_; }
  const Cell& cell(std::uint32_t i) const { return cells_[i]; }
  glm::dvec2 position(std::uint32_t i) const { return positions_[i]; }
  /// The site nearest to p, in the image nearest to p itself; the search begins at site `near`.
  Image nearest(glm::dvec2 p, std::uint32_t near) const;
  /// The way from site i to an image.
  glm::dvec2 offset(std::uint32_t i, Image image) const;

 private:
  enum class Cut : std::uint8_t { kNone, kTouch, kCut };

  /// The square about site i that its own images leave it.
  static void set_whole(Cell& cell, std::uint32_t i);
  /// Finds the cell of i, whose nearest site is `start`, by going around it. False, with no cell, where
  /// rounding or few sites leave doubts.
  bool walk_around(std::uint32_t i, Image start);
  /// The same by cutting with all that come into question: slower, always right.
  void search_around(std::uint32_t i, Image start);
  /// Keeps what is nearer to the cell's site than to the image at distance d.
  Cut clip(Cell& cell, glm::dvec2 d, Image image);
  /// The cell of q without its only edge towards the removed site; false if it would reach far.
  bool without_edge(std::uint32_t q, Cell& cell) const;
  /// Trades the cell of q for what it is without the removed site; the old one is in `cell` then.
  void heal(std::uint32_t q, Cell& cell);

  std::vector<glm::dvec2> positions_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> changed_;
  bool four_on_a_circle_ = false;  ///< it has occurred that an edge was shorter than rounding allows to know
  std::uint32_t removed_ = 0;
  Cell hole_;                 ///< the cell of the removed site
  std::vector<Cell> before_;  ///< the cells of changed_ before the removal
  std::vector<Image> seen_;
  std::vector<double> heights_;
  Cell clipped_;
};

}  // namespace capcon
