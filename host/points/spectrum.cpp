#include "points/spectrum.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/parallel.h"

namespace capcon {
namespace {

constexpr std::size_t kBlock = 128;  // points whose exponentials are held at once: they fit the caches

/// cos and sin of 2 pi k c for k = 0 .. reach, by recurrence: the error grows like k eps.
void powers(double c, int reach, double* cosines, double* sines) {
  const std::complex<double> step = std::polar(1.0, 2 * M_PI * c);
  std::complex<double> z = 1;
  for (int k = 0; k <= reach; ++k, z *= step) cosines[k] = z.real(), sines[k] = z.imag();
}

/// The four sums over points of products of cos or sin of k_x x with cos or sin of k_y y give F at both
/// (k_x, k_y) and (k_x, -k_y).
struct Row {
  std::vector<double> cc, ss, cs, sc;  ///< first letter: of x; one entry a k_y
  explicit Row(std::size_t size) : cc(size), ss(size), cs(size), sc(size) {}
};

void add_point(Row& row, double cx, double sx, const double* cy, const double* sy) {
  double *cc = row.cc.data(), *ss = row.ss.data(), *cs = row.cs.data(), *sc = row.sc.data();
  const std::size_t size = row.cc.size();
#pragma GCC ivdep
  for (std::size_t k = 0; k < size; ++k) {
    cc[k] += cx * cy[k];
    ss[k] += sx * sy[k];
    cs[k] += cx * sy[k];
    sc[k] += sx * cy[k];
  }
}

void add_periodogram(Spectrum& spectrum, const Points& points) {
  const int reach = spectrum.reach;
  const std::size_t size = std::size_t(reach) + 1;
  std::vector<Row> rows(size, Row(size));
  std::vector<double> cx(kBlock * size), sx(kBlock * size), cy(kBlock * size), sy(kBlock * size);
  for (std::size_t first = 0; first < points.size(); first += kBlock) {
    const std::size_t count = std::min(kBlock, points.size() - first);
    for (std::size_t p = 0; p < count; ++p) {
      powers(points[first + p].x, reach, &cx[p * size], &sx[p * size]);
      powers(points[first + p].y, reach, &cy[p * size], &sy[p * size]);
    }
    const auto row = [&](std::size_t kx) {
      for (std::size_t p = 0; p < count; ++p)
        add_point(rows[kx], cx[p * size + kx], sx[p * size + kx], &cy[p * size], &sy[p * size]);
    };
    parallel_for(size, row, std::max<std::size_t>(1, 65536 / size));
  }
  const double scale = 1 / (static_cast<double>(points.size()) * static_cast<double>(spectrum.sets));
  const auto add = [&](int kx, int ky, double power) {
    spectrum.power[std::size_t(ky + reach) * spectrum.side() + (kx + reach)] += power;
  };
  for (int kx = 0; kx <= reach; ++kx) {
    const Row& row = rows[kx];
    for (int ky = 0; ky <= reach; ++ky) {
      const auto power = [&](double re, double im) { return (re * re + im * im) * scale; };
      const double plus = power(row.cc[ky] - row.ss[ky], row.cs[ky] + row.sc[ky]);
      const double minus = power(row.cc[ky] + row.ss[ky], row.cs[ky] - row.sc[ky]);
      add(kx, ky, plus);
      if (kx > 0 || ky > 0) add(-kx, -ky, plus);
      if (kx > 0 && ky > 0) add(kx, -ky, minus), add(-kx, ky, minus);
    }
  }
}

double decibel(double ratio) {
  return std::isnan(ratio) ? ratio : 10 * std::log10(std::max(ratio, 1e-10));
}

}  // namespace

int default_reach(std::size_t n) {
  return std::max(4, static_cast<int>(std::lround(2.5 * std::sqrt(static_cast<double>(n)))));
}

Spectrum power_spectrum(const std::vector<Points>& sets, int reach) {
  assert(!sets.empty() && reach > 0);
  Spectrum spectrum{sets[0].size(), sets.size(), reach, {}};
  spectrum.power.assign(std::size_t(spectrum.side()) * spectrum.side(), 0.0);
  for (const Points& points : sets) {
    assert(!points.empty() && points.size() == spectrum.n);
    add_periodogram(spectrum, points);
  }
  return spectrum;
}

RadialSpectrum radial_spectrum(const Spectrum& spectrum) {
  std::vector<std::vector<double>> rings(std::size_t(spectrum.reach) + 1);
  const double root = std::sqrt(static_cast<double>(spectrum.n));
  double low = 0;
  double low_count = 0;
  for (int ky = 0; ky <= spectrum.reach; ++ky) {
    for (int kx = ky == 0 ? 1 : -spectrum.reach; kx <= spectrum.reach; ++kx) {
      const double radius = std::hypot(kx, ky), power = spectrum.at(kx, ky);
      const auto ring = static_cast<std::size_t>(std::floor(radius + 0.5));
      if (ring < rings.size()) rings[ring].push_back(power);
      if (radius <= root / 2) low += power, ++low_count;
    }
  }
  RadialSpectrum radial;
  radial.low = low / low_count;  // NaN where there is no such frequency
  double ratios = 0;
  int rated = 0;
  for (std::size_t r = 1; r < rings.size(); ++r) {
    const auto& ring = rings[r];
    double mean = 0, squares = 0;
    for (const double power : ring) mean += power / static_cast<double>(ring.size());
    for (const double power : ring) squares += (power - mean) * (power - mean);
    const bool rounding =
        mean < 1e-12 * static_cast<double>(spectrum.n);  // P(0) = n has errors of about eps^2 n^2
    const double ratio =
        rounding ? std::numeric_limits<double>::quiet_NaN()
                 : squares / static_cast<double>(ring.size() - 1) / (mean * mean);  // >= 4 in each
    if (!rounding) ratios += ratio, ++rated;
    radial.frequency.push_back(static_cast<double>(r) / root);
    radial.mean.push_back(mean);
    radial.anisotropy.push_back(decibel(ratio));
    if (mean > radial.peak) radial.peak = mean, radial.peak_frequency = radial.frequency.back();
  }
  radial.mean_anisotropy = decibel(ratios / std::max(rated, 1));
  return radial;
}

nlohmann::ordered_json to_json(const Spectrum& spectrum, const RadialSpectrum& radial, bool power) {
  nlohmann::ordered_json json = {{"reach", spectrum.reach},
                                 {"periodograms", spectrum.sets},
                                 {"low", radial.low},
                                 {"peak", radial.peak},
                                 {"peak_frequency", radial.peak_frequency},
                                 {"mean_anisotropy_db", radial.mean_anisotropy},
                                 {"frequency", radial.frequency},
                                 {"radial_mean", radial.mean},
                                 {"anisotropy_db", radial.anisotropy}};
  if (power) json["power"] = spectrum.power;
  return json;
}

}  // namespace capcon
