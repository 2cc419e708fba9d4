#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace capcon {

/// Rows of an image that is still being made, on disk: a stopped render goes on where it was. The file
/// (docs/render.md) is a line "capcon-partial 1 KEY WIDTH HEIGHT CHANNELS", then records of first row, rows
/// (32 bits each), FNV-1a checksum (64 bits) and float values; a record that was cut off is dropped.
class PartialImage {
 public:
  /// Opens or creates the file. `key` says what is being made: the rows of a file with another key (or size)
  /// are dropped. Failure when it cannot be written, or another process is writing it.
  PartialImage(std::filesystem::path path, std::uint64_t key, int width, int height, int channels);
  PartialImage(const PartialImage&) = delete;
  PartialImage& operator=(const PartialImage&) = delete;
  ~PartialImage();

  /// Whether these rows, as one record, are there already.
  bool has(int first_row, int rows) const;
  /// Rows that are there.
  int row_count() const;
  /// Adds rows, flushed to disk. Failure when the disk is full: what was there stays.
  void add(int first_row, std::span<const float> pixels);
  /// Hands out all rows from the top, record by record; every row must be there.
  void read(const std::function<void(std::span<const float>)>& take) const;
  /// Deletes the file: the image is complete elsewhere.
  void remove();

 private:
  struct Record {
    int rows;
    std::uint64_t offset;  ///< of its values in the file
  };
  void open();
  bool read_existing();
  void create();

  std::filesystem::path path_;
  std::string header_;
  int width_, height_, channels_;
  std::map<int, Record> records_;  ///< by first row
  std::FILE* file_ = nullptr;
};

}  // namespace capcon
