#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "points/generators.h"

namespace capcon::cli {

/// What `capcon points` was asked for.
struct PointsOptions {
  std::string method;
  std::string file;  ///< for import
  GeneratorOptions generator;
  std::string density;
  std::string domain = "torus";
  std::string strategy = "global";
  std::string kind = "maximin";
  std::string finish = "none";
  double time_limit = 0;  ///< seconds for all sets together; 0 for none
  std::uint32_t count = 1;
  std::string output;
  bool json = false;
  bool quiet = false;
};

/// Declares the options of the verb, to be read into `options`, which must outlive it.
void add_points_options(CLI::App& verb, PointsOptions& options);

/// Refuses an unknown method, and options that would change nothing (InputError).
void check_points_options(const CLI::App& verb, const std::string& method);

}  // namespace capcon::cli
