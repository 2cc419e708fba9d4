#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "study/kept_study.h"

namespace capcon {

/// One study beside the first, sampler by sampler.
struct Beside {
  std::size_t study = 1;      ///< which of the studies
  std::vector<Ratio> ratios;  ///< `baseline` empty: the same sampler of the first study
  bool same_errors = false;   ///< every run that both have erred by the same number, bit by bit
};

/// Studies of one kind and scene, by several machines or versions, laid over each other.
struct Overlay {
  std::vector<KeptStudy> studies;
  std::vector<std::string> labels;
  std::vector<std::string> samplers;   ///< those that all have, or that were asked for
  std::vector<std::uint32_t> samples;  ///< counts that all have
  std::uint32_t seeds = 0;             ///< that all have: 1 ... seeds
  std::vector<Figures> figures;        ///< one a study
  std::vector<Beside> beside;          ///< one a study but the first

  const Ratio* ratio(const Beside& b, const std::string& sampler, std::uint32_t count) const;
};

/// InputError where two studies measured different things, saying which, or have no sampler or count in
/// common; where there are not as many labels as studies. No labels: names of the folders, or their paths
/// where names are the same.
Overlay make_overlay(std::vector<KeptStudy> studies, std::vector<std::string> labels,
                     std::vector<std::string> samplers = {});

/// What they say of each other, the headline first.
std::vector<std::string> make_findings(const Overlay& overlay);

/// Names and values of what differs between the studies (device, driver, version, settings), one value a
/// study.
struct Difference {
  std::string name;
  std::vector<std::string> values;
};
std::vector<Difference> differences(const Overlay& overlay);

std::string html_report(const Overlay& overlay);
nlohmann::json to_json(const Overlay& overlay);

}  // namespace capcon
