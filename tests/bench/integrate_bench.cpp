// What samplers err on the battery of docs/integrate.md, one set a trial:
//   integrate_bench sets [trials] [samplers...]   MSE beside Owen-scrambled points, disk and square
//   integrate_bench peers [trials] [samplers...]  the same of every family, with 95 % intervals
//   integrate_bench square [trials] [samplers...] the same on the square, for 64, 256 and 1024 points
//   integrate_bench parts [trials] [samplers...]  parts of trajectory splitting: their spacing, their error
//                                                 beside whole sets of as many points, and that of their
//                                                 union beside as many independent sets
//   integrate_bench paths [trials] [samplers...]  parts of 128 points, as light paths take, and their union:
//                                                 MSE beside Owen-scrambled parts and their union

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "integrate/integrand.h"
#include "points/ensemble.h"
#include "points/spread_partition.h"
#include "sampling/sampler.h"

namespace {

using namespace capcon;

constexpr std::size_t kChunks = 64;

struct Family {
  const integrate::Integrand* integrand;
  SampleDomain domain;
};

std::vector<Family> families(std::initializer_list<const char*> names) {
  std::vector<Family> all;
  for (const char* name : names) {
    const auto& integrand = integrate::find_integrand(name);
    all.push_back({&integrand,
                   integrand.domain == integrate::Domain::disk ? SampleDomain::disk : SampleDomain::square});
  }
  return all;
}

Points set_of(const Sampler& sampler, std::uint32_t pixel, const Family& family) {
  Points points;
  for (std::uint32_t i = 0; i < sampler.count(); ++i) {
    const glm::dvec2 p = to_double(sampler.sample(pixel, i, 0, family.domain));
    points.push_back(family.domain == SampleDomain::disk ? into_domain(EnsembleDomain::disk, p) : p);
  }
  return points;
}

/// Mean squared errors over trials: of the whole set, and of its parts.
struct Errors {
  double whole = 0, part = 0;
};

Errors errors_of(const Sampler& sampler, const Family& family, std::size_t trials) {
  std::vector<Errors> sums(kChunks);
  parallel_for(kChunks, [&](std::size_t chunk) {
    for (std::size_t trial = chunk; trial < trials; trial += kChunks) {
      const auto draw = family.integrand->draw(5, trial);
      const Points points = set_of(sampler, static_cast<std::uint32_t>(trial), family);
      const std::size_t size = sampler.split().points;
      double whole = 0;
      for (std::uint32_t p = 0; p < sampler.split().parts; ++p) {
        const double error = draw.average(std::span(points).subspan(p * size, size), {}) - draw.integral;
        whole += error / sampler.split().parts;
        sums[chunk].part += error * error / sampler.split().parts / static_cast<double>(trials);
      }
      sums[chunk].whole += whole * whole / static_cast<double>(trials);
    }
  });
  Errors total;
  for (const Errors& e : sums) total.whole += e.whole, total.part += e.part;
  return total;
}

void compare_sets(std::size_t trials, const std::vector<std::string>& samplers) {
  const auto all = families({"edge-on-disk", "blocker", "leaves", "smooth-disk", "shaded-edge", "half-plane",
                             "disk", "smooth", "product", "soft-shadow"});
  for (const std::uint32_t n : {2u, 4u, 8u, 16u, 64u, 256u}) {
    const std::size_t used = std::max<std::size_t>(1000, trials / std::max(1u, n / 16));
    const auto owen = make_sampler("sobol-owen", n, 1);
    std::map<std::string, double> base;
    for (const Family& f : all) base[f.integrand->name] = errors_of(*owen, f, used).whole;
    for (const std::string& name : samplers) {
      const auto sampler = make_sampler(name, n, 1);
      fmt::print("n {:4} {:14}", n, name);
      for (const Family& f : all)
        fmt::print("  {} {:.3f}", f.integrand->name,
                   errors_of(*sampler, f, used).whole / base[f.integrand->name]);
      fmt::print("\n");
    }
  }
}

/// Sums of squared errors of whole sets, a chunk of trials each.
std::vector<double> chunks_of(const Sampler& sampler, const Family& family, std::size_t trials) {
  std::vector<double> sums(kChunks);
  parallel_for(kChunks, [&](std::size_t chunk) {
    for (std::size_t trial = chunk; trial < trials; trial += kChunks) {
      const auto draw = family.integrand->draw(5, trial);
      const double error =
          draw.average(set_of(sampler, static_cast<std::uint32_t>(trial), family), {}) - draw.integral;
      sums[chunk] += error * error;
    }
  });
  return sums;
}

struct Ratio {
  double value = 0, half_width = 0;
};

/// Of two sums, with the jackknife's interval over chunks.
Ratio ratio_of(const std::vector<double>& above, const std::vector<double>& below) {
  constexpr double kStudent = 1.998;  // 63 degrees of freedom, 0.975
  const double a = std::accumulate(above.begin(), above.end(), 0.0),
               b = std::accumulate(below.begin(), below.end(), 0.0);
  double squares = 0;
  for (std::size_t i = 0; i < kChunks; ++i) {
    const double left_out = (a - above[i]) / (b - below[i]) - a / b;
    squares += left_out * left_out;
  }
  return {a / b, kStudent * std::sqrt(squares * (kChunks - 1) / kChunks)};
}

void compare_peers(std::size_t trials, const std::vector<std::string>& samplers,
                   const std::vector<Family>& all, const std::vector<std::uint32_t>& counts) {
  for (const std::uint32_t n : counts) {
    const std::size_t used = std::max<std::size_t>(1000, trials / (n / 16));
    const auto owen = make_sampler("sobol-owen", n, 1);
    std::map<std::string, std::vector<double>> base;
    for (const Family& f : all) base[f.integrand->name] = chunks_of(*owen, f, used);
    for (const std::string& name : samplers) {
      const auto sampler = make_sampler(name, n, 1);
      fmt::print("n {:4} {:14}", n, name);
      for (const Family& f : all) {
        const Ratio r = ratio_of(chunks_of(*sampler, f, used), base[f.integrand->name]);
        fmt::print("  {} {:.3f} +- {:.3f}", f.integrand->name, r.value, r.half_width);
      }
      fmt::print("\n");
    }
  }
}

SubsetSpacing spacing_of(const Sampler& sampler, std::uint32_t pixels) {
  SubsetSpacing total{0, 1e300};
  std::vector<std::uint32_t> labels(sampler.count());
  for (std::uint32_t i = 0; i < labels.size(); ++i) labels[i] = i / sampler.split().points;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    Points points;
    for (std::uint32_t i = 0; i < sampler.count(); ++i)
      points.push_back(to_double(sampler.sample(pixel, i, 0)));
    const SubsetSpacing s = subset_spacing(points, labels, sampler.split().parts);
    total.mean += s.mean / pixels;
    total.worst = std::min(total.worst, s.worst);
  }
  return total;
}

void compare_parts(std::size_t trials, const std::vector<std::string>& samplers) {
  const auto all = families({"edge-on-disk", "blocker", "leaves", "smooth-disk"});
  struct Case {
    std::uint32_t count, parts;
  };
  for (const Case c : {Case{16, 2}, Case{16, 4}, Case{16, 8}, Case{64, 2}, Case{64, 4}, Case{64, 8},
                       Case{64, 16}, Case{64, 32}, Case{96, 6}, Case{128, 8}, Case{256, 4}, Case{256, 16},
                       Case{256, 64}, Case{1024, 8}, Case{1024, 64}, Case{1024, 128}}) {
    const std::size_t used = std::max<std::size_t>(500, trials / std::max(1u, c.count / 16));
    for (const std::string& name : samplers) {
      const auto split = make_sampler(name, c.count, 1, c.parts), naive = make_sampler(name, c.count, 1),
                 small = make_sampler(name, c.count / c.parts, 1);
      const SubsetSpacing spacing = spacing_of(*split, c.count > 256 ? 10 : 50);
      fmt::print("{:4} = {:3} x {:3} {:14} spacing {:.3f} worst {:.3f}; parts / sets of {}:", c.count,
                 c.parts, c.count / c.parts, name, spacing.mean, spacing.worst, c.count / c.parts);
      std::string unions;
      for (const Family& f : all) {
        const Errors e = errors_of(*split, f, used);
        const double alone = errors_of(*small, f, used).whole, one = errors_of(*naive, f, used).whole;
        fmt::print(" {} {:.2f}", f.integrand->name, e.part / alone);
        unions +=
            fmt::format(" {} {:.2f} ({:.2f})", f.integrand->name, e.whole / (alone / c.parts), e.whole / one);
      }
      fmt::print("; union / independent sets (/ one set):{}\n", unions);
    }
  }
}

void compare_paths(std::size_t trials, const std::vector<std::string>& samplers) {
  const auto all = families({"edge-on-disk", "blocker", "leaves", "smooth-disk", "half-plane", "smooth"});
  for (const std::uint32_t parts : {4u, 16u, 32u}) {
    const std::uint32_t count = 128 * parts;
    const auto owen = make_sampler("sobol-owen", count, 1, parts);
    std::map<std::string, Errors> base;
    for (const Family& f : all) base[f.integrand->name] = errors_of(*owen, f, trials);
    for (const std::string& name : samplers) {
      const auto sampler = make_sampler(name, count, 1, parts);
      fmt::print("{:4} = {:2} x 128 {:14} part, union:", count, parts, name);
      for (const Family& f : all) {
        const Errors e = errors_of(*sampler, f, trials), &b = base[f.integrand->name];
        fmt::print("  {} {:.2f} {:.2f}", f.integrand->name, e.part / b.part, e.whole / b.whole);
      }
      fmt::print("\n");
    }
  }
}

}  // namespace

int main(int count, char** words) {
  const std::string what = count > 1 ? words[1] : "sets";
  const std::size_t trials = count > 2 ? std::strtoull(words[2], nullptr, 10) : 20'000;
  std::vector<std::string> samplers(words + std::min(count, 3), words + count);
  if (what == "parts") {
    if (samplers.empty()) samplers = sampler_names();
    compare_parts(trials, samplers);
  } else if (what == "paths") {
    if (samplers.empty()) samplers = sampler_names();
    compare_paths(trials, samplers);
  } else if (what == "peers") {
    if (samplers.empty()) samplers = {"lattice", "pmj02", "sobol-xor", "capcon-domain"};
    compare_peers(trials, samplers,
                  families({"edge-on-disk", "blocker", "leaves", "smooth-disk", "shaded-edge", "half-plane",
                            "disk", "soft-shadow", "smooth"}),
                  {16, 64, 256});
  } else if (what == "square") {
    if (samplers.empty()) samplers = {"capcon-bounded", "capcon-domain", "capcon"};
    compare_peers(trials, samplers, families({"half-plane", "disk", "soft-shadow", "smooth", "product"}),
                  {64, 256, 1024});
  } else {
    if (samplers.empty()) samplers = {"capcon-domain"};
    compare_sets(trials, samplers);
  }
}
