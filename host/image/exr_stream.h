#pragma once

#include <ImfIO.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

namespace capcon {

/// An EXR file that lies in memory already, for OpenEXR to read.
class MemoryInput : public Imf::IStream {
 public:
  MemoryInput(const std::string& name, const std::string& bytes) : IStream(name.c_str()), bytes_(bytes) {}

  bool read(char c[], int n) override {
    if (n < 0 || place_ > bytes_.size() || static_cast<std::size_t>(n) > bytes_.size() - place_) {
      throw std::runtime_error("the file ends too early");
    }
    std::memcpy(c, bytes_.data() + place_, static_cast<std::size_t>(n));
    place_ += static_cast<std::size_t>(n);
    return place_ < bytes_.size();
  }
  std::uint64_t tellg() override { return place_; }
  void seekg(std::uint64_t place) override { place_ = place; }

 private:
  const std::string& bytes_;
  std::uint64_t place_ = 0;
};

/// Collects what OpenEXR writes. Its own file stream loses errors that show only when the file is closed.
class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : OStream("image") {}

  void write(const char c[], int n) override {
    const std::size_t end = place_ + static_cast<std::size_t>(n);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + place_, c, static_cast<std::size_t>(n));
    place_ = end;
  }
  std::uint64_t tellp() override { return place_; }
  void seekp(std::uint64_t place) override { place_ = place; }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  std::uint64_t place_ = 0;
};

}  // namespace capcon
