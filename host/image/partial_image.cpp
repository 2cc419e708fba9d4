#include "image/partial_image.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/hash.h"

namespace capcon {
namespace {

struct RecordHead {
  std::uint32_t first_row = 0, rows = 0;
  std::uint64_t checksum = 0;
};

std::string_view bytes_of(std::span<const float> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

PartialImage::PartialImage(std::filesystem::path path, std::uint64_t key, int width, int height, int channels)
    : path_(std::move(path)),
      header_(fmt::format("capcon-partial 1 {:016x} {} {} {}\n", key, width, height, channels)),
      width_(width),
      height_(height),
      channels_(channels) {
  open();
  if (!read_existing()) create();
}

PartialImage::~PartialImage() {
  if (file_) std::fclose(file_);
}

void PartialImage::open() {
  const int file = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  file_ = file < 0 ? nullptr : ::fdopen(file, "r+b");
  if (!file_) fail_to_write(path_);
  if (!lock(file)) {
    std::fclose(file_);
    throw Failure(fmt::format(
        "{}: another capcon is rendering into this file; wait until it is done, or choose another -o",
        path_.string()));
  }
}

bool PartialImage::read_existing() {
  std::string head(header_.size(), '\0');
  std::uint64_t good = header_.size();
  if (std::fread(head.data(), 1, head.size(), file_) != head.size() || head != header_) return false;
  RecordHead record;
  std::vector<float> values;
  while (std::fread(&record, sizeof record, 1, file_) == 1) {
    if (record.rows == 0 || record.rows > std::uint32_t(height_) ||
        record.first_row > std::uint32_t(height_) - record.rows)
      break;
    values.resize(std::size_t(record.rows) * width_ * channels_);
    if (std::fread(values.data(), sizeof(float), values.size(), file_) != values.size()) break;
    if (fnv1a64(bytes_of(values)) != record.checksum) break;
    records_[static_cast<int>(record.first_row)] = {static_cast<int>(record.rows), good + sizeof record};
    good += sizeof record + 4 * values.size();
  }
  // What follows was being written when the program ended.
  std::fflush(file_);
  if (::ftruncate(::fileno(file_), static_cast<off_t>(good)) != 0 || ::fseeko(file_, 0, SEEK_END) != 0)
    fail_to_write(path_);
  return true;
}

void PartialImage::create() {
  std::rewind(file_);
  if (::ftruncate(::fileno(file_), 0) == 0 &&
      std::fwrite(header_.data(), 1, header_.size(), file_) == header_.size() && std::fflush(file_) == 0 &&
      ::fsync(::fileno(file_)) == 0) {
    return flush_folder(path_.parent_path());
  }
  const int reason = errno;
  ::unlink(path_.c_str());
  std::fclose(file_);
  errno = reason;
  fail_to_write(path_);
}

bool PartialImage::has(int first_row, int rows) const {
  const auto found = records_.find(first_row);
  return found != records_.end() && found->second.rows == rows;
}

int PartialImage::row_count() const {
  int count = 0;
  for (const auto& [first, record] : records_) count += record.rows;
  return count;
}

void PartialImage::add(int first_row, std::span<const float> pixels) {
  const std::size_t row = std::size_t(width_) * channels_;
  assert(pixels.size() % row == 0);
  const RecordHead head{static_cast<std::uint32_t>(first_row),
                        static_cast<std::uint32_t>(pixels.size() / row), fnv1a64(bytes_of(pixels))};
  const bool good = ::fseeko(file_, 0, SEEK_END) == 0;
  const auto offset = static_cast<std::uint64_t>(::ftello(file_));
  if (!good || std::fwrite(&head, sizeof head, 1, file_) != 1 ||
      std::fwrite(pixels.data(), sizeof(float), pixels.size(), file_) != pixels.size() ||
      std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0) {
    throw Failure(fmt::format("cannot write {}: {}; the rows until here are kept, and it goes on from there",
                              path_.string(), reason_of(errno)));
  }
  records_[first_row] = {static_cast<int>(head.rows), offset + sizeof head};
}

void PartialImage::read(const std::function<void(std::span<const float>)>& take) const {
  assert(row_count() == height_);
  std::vector<float> values;
  for (const auto& [first, record] : records_) {
    values.resize(std::size_t(record.rows) * width_ * channels_);
    if (::fseeko(file_, static_cast<off_t>(record.offset), SEEK_SET) != 0 ||
        std::fread(values.data(), sizeof(float), values.size(), file_) != values.size()) {
      throw Failure(fmt::format("cannot read {}: {}", path_.string(), std::strerror(errno)));
    }
    take(values);
  }
}

void PartialImage::remove() {
  std::fclose(file_);
  file_ = nullptr;
  std::error_code error;
  std::filesystem::remove(path_, error);
}

}  // namespace capcon
