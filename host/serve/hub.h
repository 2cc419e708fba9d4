#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include "serve/comparison.h"

namespace capcon::serve {

/// There are as many comparisons as there may be.
struct Busy : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// All comparisons under way. One thread renders them in turn, a frame each, since there is one device; equal
/// settings share one. Who has not asked for so long (`patience`) counts as gone, and a comparison that
/// nobody looks at is dropped.
class Hub {
 public:
  explicit Hub(std::chrono::milliseconds patience = std::chrono::seconds(15));
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// The comparison of these settings, started anew where there is none or `anew`; the client leaves the one
  /// that it looked at. `key`: equal for equal settings. Busy where there are kMostComparisons.
  std::shared_ptr<Comparison> start(const std::string& client, const std::string& key,
                                    const Settings& settings);
  /// Null where it is not there (any more). Says that the client still looks.
  std::shared_ptr<Comparison> find(const std::string& id, const std::string& client);
  /// The client looks no longer.
  void leave(const std::string& client);
  std::size_t size() const;

  static constexpr std::size_t kMostComparisons = 4;
  static constexpr std::size_t kMostClients = 64;

 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::string key;
    std::shared_ptr<Comparison> comparison;
    std::map<std::string, Clock::time_point> clients;  ///< when each asked last
    bool idle = false;                                 ///< nothing is left to render
  };
  void work(const std::stop_token& stop);
  void drop_abandoned();

  const std::chrono::milliseconds patience_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::list<Entry> entries_;
  std::uint64_t started_ = 0;
  std::jthread thread_;  // last: ends first
};

}  // namespace capcon::serve
