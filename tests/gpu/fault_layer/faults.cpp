#include "faults.h"

#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

namespace capcon::faults {
namespace {

[[noreturn]] void refuse(const std::string& word) {
  std::fprintf(stderr, "CAPCON_TEST_FAULTS: what is \"%s\"?\n", word.c_str());
  std::abort();
}

}  // namespace

VkResult Faults::called(const std::string& what) {
  const std::uint64_t number = ++counts[what];
  const auto found = calls.find(what);
  if (found == calls.end()) return VK_SUCCESS;
  const Call& call = found->second;
  return number == call.number || (call.onwards && number > call.number) ? call.result : VK_SUCCESS;
}

Faults read_faults() {
  static const std::map<std::string, VkResult> results = {{"device-lost", VK_ERROR_DEVICE_LOST},
                                                          {"no-device-memory", VK_ERROR_OUT_OF_DEVICE_MEMORY},
                                                          {"no-host-memory", VK_ERROR_OUT_OF_HOST_MEMORY},
                                                          {"failed", VK_ERROR_INITIALIZATION_FAILED}};
  static const std::set<std::string> calls = {"submit", "wait",   "allocate", "pipeline",
                                              "pool",   "device", "instance"};
  static const std::set<std::string> values = {"largest",  "storage", "texels",  "heap",
                                               "bindings", "lane",    "watchdog"};
  static const std::set<std::string> flags = {"no-device", "no-compute", "no-timestamps", "no-votes", "old"};
  Faults faults;
  const char* text = std::getenv("CAPCON_TEST_FAULTS");
  std::istringstream words(text ? text : "");
  for (std::string word; std::getline(words, word, ',');) {
    const std::size_t colon = word.find(':'), equals = word.find('=');
    const std::string name = word.substr(0, std::min(colon, equals));
    const std::string right = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (name == "log") {
      faults.log = right;
    } else if (flags.count(word) > 0) {
      faults.values[word] = 1;
    } else if (values.count(name) > 0) {
      faults.values[name] = std::stoull(right);
    } else if (calls.count(name) > 0 && colon < equals && results.count(right) > 0) {
      const std::string number = word.substr(colon + 1, equals - colon - 1);
      faults.calls[name] = {std::stoull(number), number.back() == '+', results.at(right)};
    } else {
      refuse(word);
    }
  }
  return faults;
}

}  // namespace capcon::faults
