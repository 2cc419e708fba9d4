#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "base/error.h"
#include "base/hash.h"
#include "tiling/region_layout.h"
#include "tiling/tile_set.h"

namespace capcon {
namespace {

constexpr std::uint32_t kMaxColours = 8, kMaxPoints = 4096;

// The lines of a capcon-tiles text, one after another, with the place for messages.
class Lines {
 public:
  Lines(std::string_view text, const std::string& name) : text_(text), place_{name, 0, 0} {}

  std::string_view next(const char* expected) {
    ++place_.line;
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos)
      fail(fmt::format("the file ends here but {} should follow; it is truncated, copy or make it again",
                       expected));
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }
  std::size_t offset() const { return at_; }
  bool at_end() const { return at_ == text_.size(); }
  const SourcePlace& place() const { return place_; }
  [[noreturn]] void fail(const std::string& message) const { throw InputError(place_, message); }

 private:
  std::string_view text_;
  SourcePlace place_;
  std::size_t at_ = 0;
};

// The words of one line, separated by single blanks.
class Words {
 public:
  Words(std::string_view line, const Lines& lines) : rest_(line), lines_(lines) {}

  std::string_view word() {
    const std::size_t end = rest_.find(' ');
    const std::string_view result = rest_.substr(0, end);
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    return result;
  }
  std::uint32_t number(const char* what) {
    const std::string_view text = word();
    std::uint32_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || stop != text.data() + text.size() || text.empty() ||
        (text.size() > 1 && text[0] == '0'))  // one way to write a set: its checksum is its name
      lines_.fail(
          fmt::format("'{}' is not a whole number in [0, 2^32) without leading zeros ({})", text, what));
    return value;
  }
  std::string_view rest() const { return rest_; }
  void end() const {
    if (!rest_.empty()) lines_.fail(fmt::format("'{}' is too much on this line", rest_));
  }

 private:
  std::string_view rest_;
  const Lines& lines_;
};

std::uint32_t field(Lines& lines, const char* key, std::uint32_t low, std::uint32_t high) {
  Words words(lines.next(key), lines);
  if (words.word() != key) lines.fail(fmt::format("'{} <number>' should stand here", key));
  const std::uint32_t value = words.number(key);
  words.end();
  if (value < low || value > high) lines.fail(fmt::format("{} must be in {} to {}", key, low, high));
  return value;
}

TileSet::TilePoint tile_point(Lines& lines) {
  Words words(lines.next("a point 'x y kind region slot'"), lines);
  TileSet::TilePoint point;
  point.position.x = words.number("x");
  point.position.y = words.number("y");
  const std::string_view kind = words.word();
  bool known = false;
  for (const RegionKind k :
       {RegionKind::corner, RegionKind::horizontal_edge, RegionKind::vertical_edge, RegionKind::interior})
    if (kind == region_name(k)) point.kind = k, known = true;
  if (!known)
    lines.fail(
        fmt::format("'{}' is no kind of region; there are corner, horizontal, vertical, interior", kind));
  point.region = words.number("region");
  point.slot = words.number("slot");
  words.end();
  return point;
}

void check_end(Lines& lines, std::string_view text) {
  const std::uint64_t sum = fnv1a64(text.substr(0, lines.offset()));
  const std::string_view line = lines.next("'checksum fnv1a64 <16 hex digits>'");
  if (line.substr(0, 17) != "checksum fnv1a64 ")
    lines.fail(
        "'checksum fnv1a64 <16 hex digits>' should stand here: there are more lines than points and tiles "
        "say");
  if (line.substr(17) != fmt::format("{:016x}", sum))
    lines.fail(
        fmt::format("the checksum should be {:016x}: the file was changed or damaged, make it again with "
                    "`capcon tiles make`",
                    sum));
  if (!lines.at_end())
    throw InputError({lines.place().file, lines.place().line + 1, 0}, "nothing may follow the checksum");
}

}  // namespace

TileSet parse_tile_set(std::string_view text, const std::string& name) {
  Lines lines(text, name);
  Words magic(lines.next("'capcon-tiles 1'"), lines);
  if (magic.word() != "capcon-tiles") lines.fail("not a tile set: the first line should be 'capcon-tiles 1'");
  if (magic.rest() != "1" && magic.rest() != "2" && magic.rest() != "3")
    lines.fail(fmt::format("version '{}' of the format is not known, only 1, 2 and 3", magic.rest()));
  const bool compact = magic.rest() == "2", bounded = magic.rest() == "3";
  TileSet set;
  set.colours = field(lines, "colours", 1, kMaxColours);
  set.points_per_tile = field(lines, "points", 1, kMaxPoints);
  if (compact) {
    if (lines.next("'colouring apart'") != "colouring apart")
      lines.fail("'colouring apart' should stand here: version 2 holds compact sets, and these only");
    set.colouring = Colouring::apart;
  }
  if (bounded) {
    if (set.colours < 2)
      throw InputError({lines.place().file, 2, 0},
                       "a bounded set has 2 colours or more: the last one is outside");
    if (lines.next("'colouring bounded'") != "colouring bounded")
      lines.fail("'colouring bounded' should stand here: version 3 holds bounded sets, and these only");
    set.colouring = Colouring::bounded;
  }
  Words recipe(lines.next("'recipe <command>'"), lines);
  if (recipe.word() != "recipe") lines.fail("'recipe <command>' should stand here");
  set.recipe = recipe.rest();

  set.tiles.resize(tile_count(set.colours));
  std::vector<std::vector<SourcePlace>> places(set.tiles.size());
  const std::vector<std::uint32_t> numbers = tile_numbers(set.colours, set.colouring);
  for (const std::uint32_t t : numbers) {
    if (lines.next("'tile <number>'") != fmt::format("tile {}", t))
      lines.fail(fmt::format("'tile {}' should stand here: a {} set has {} tiles of {} points, in order", t,
                             compact   ? "compact"
                             : bounded ? "bounded"
                                       : "complete",
                             numbers.size(), set.points_per_tile));
    for (std::uint32_t r = 0; r < set.points_per_tile; ++r) {
      set.tiles[t].push_back(tile_point(lines));
      places[t].push_back(lines.place());
    }
  }
  check_end(lines, text);
  if (const auto fault = find_region_fault(set))
    throw InputError(places[fault->tile][fault->rank], fault->message);
  return set;
}

}  // namespace capcon
