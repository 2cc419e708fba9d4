#include "sampling/parts_file.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/hash.h"
#include "base/little_endian.h"

namespace capcon {
namespace {

constexpr std::string_view kMagic = "CAPPARTS";
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMostRows = 4096;  // the tiles of eight colours

using Rows = std::vector<std::vector<std::uint32_t>>;

void put_rows(std::string& bytes, const Rows& rows) {
  for (const auto& row : rows)
    for (const std::uint32_t number : row) put_bytes(bytes, static_cast<std::uint8_t>(number));
}

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  [[noreturn]] void fail(const char* what) const {
    throw InputError(fmt::format(
        "{}: the parts of splits {}; make the file again with `capcon tiles parts -o FILE`, or remove "
        "it, and parts are made at every start",
        name_, what));
  }
  bool at_end() const { return rest_.empty(); }

  void need(std::size_t bytes) const {
    if (rest_.size() < bytes) fail("are cut short");
  }
  template <class T>
  T number() {
    need(sizeof(T));
    return take_bytes<T>(rest_);
  }
  std::string_view text(std::size_t length) {
    need(length);
    const std::string_view result = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return result;
  }

  /// Permutations of 0 ... length - 1.
  Rows rows(std::uint32_t count, std::uint32_t length) {
    if (count > kMostRows || length > kMostStoredPoints || (count == 0) != (length == 0))
      fail("have sizes that do not fit each other");
    Rows result(count);
    for (auto& row : result) {
      std::vector<char> seen(length);
      for (std::uint32_t i = 0; i < length; ++i) {
        row.push_back(number<std::uint8_t>());
        if (row.back() >= length || seen[row.back()] != 0) fail("do not hold every point once");
        seen[row.back()] = 1;
      }
    }
    return result;
  }

 private:
  std::string_view rest_;
  const std::string& name_;
};

}  // namespace

std::string format_parts(const PartsFile& file) {
  std::string bytes(kMagic);
  put_bytes(bytes, kVersion);
  put_bytes(bytes, file.tiles);
  put_bytes(bytes, static_cast<std::uint32_t>(file.splits.size()));
  for (const StoredParts& s : file.splits) {
    const auto& [rank, orders] = s.dealt;
    for (const std::size_t word : {std::size_t(s.count), std::size_t(s.parts), rank.size(),
                                   rank.empty() ? std::size_t(0) : rank[0].size(), orders.size()})
      put_bytes(bytes, static_cast<std::uint32_t>(word));
    put_rows(bytes, rank);
    put_rows(bytes, orders);
  }
  put_bytes(bytes, fnv1a64(bytes));
  return bytes;
}

PartsFile parse_parts(std::string_view bytes, const std::string& name) {
  Reader reader(bytes, name);
  if (bytes.substr(0, kMagic.size()) != kMagic) reader.fail("do not begin with CAPPARTS");
  reader.text(kMagic.size());
  if (reader.number<std::uint32_t>() != kVersion) reader.fail("are of another version than 1");
  PartsFile file;
  file.tiles = reader.number<std::uint64_t>();
  const auto splits = reader.number<std::uint32_t>();
  // The checksum comes before what it protects: a damaged byte is called that, whatever it says.
  reader.need(sizeof(std::uint64_t));
  std::string_view end = bytes.substr(bytes.size() - sizeof(std::uint64_t));
  if (take_bytes<std::uint64_t>(end) != fnv1a64(bytes.substr(0, bytes.size() - sizeof(std::uint64_t))))
    reader.fail("have a wrong checksum: they are damaged or cut short");
  for (std::uint32_t k = 0; k < splits; ++k) {
    StoredParts& s = file.splits.emplace_back();
    s.count = reader.number<std::uint32_t>();
    s.parts = reader.number<std::uint32_t>();
    const auto tiles = reader.number<std::uint32_t>(), ranks = reader.number<std::uint32_t>(),
               orders = reader.number<std::uint32_t>();
    if (s.count == 0 || s.parts == 0 || s.count % s.parts != 0) reader.fail("are not equal parts");
    s.dealt.rank = reader.rows(tiles, ranks);
    s.dealt.orders = reader.rows(orders, s.count);
  }
  reader.text(sizeof(std::uint64_t));
  if (!reader.at_end()) reader.fail("are followed by more than they announce");
  return file;
}

}  // namespace capcon
