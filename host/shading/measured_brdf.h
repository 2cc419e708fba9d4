#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace capcon {

/// A measured isotropic BRDF as a regular table over Rusinkiewicz' half-difference angles ("A New Change of
/// Variables for Efficient BRDF Representation", EGWR 1998). Node (h, d, a) is at
///   theta_h = (h / (kHalf - 1))^2 pi/2, theta_d = d / (kDifference - 1) pi/2, phi_d = a / (kAzimuth - 1)
///   pi/2.
/// phi_d is folded into [0, pi/2]: by reciprocity (phi_d + pi) and the mirror symmetry of isotropic surfaces
/// (-phi_d), so that the table is reciprocal whatever was measured.
struct MeasuredBrdf {
  static constexpr int kHalf = 64;
  static constexpr int kDifference = 64;
  static constexpr int kAzimuth = 32;

  std::vector<glm::vec3> values;  ///< 1/sr, linear sRGB, not negative; phi_d fastest, then theta_d
  /// Sampling: with this probability the visible normals of GGX of this alpha (Heitz, JCGT 7(4), 2018), else
  /// the cosine; see fit_sampling.
  double specular_weight = 0;
  double alpha = 1;
  std::vector<std::string> remarks;  ///< what was mended or is odd, phrases

  /// The BRDF between unit directions (z is the normal) on the upper side; trilinear; 0 when one is below.
  glm::dvec3 operator()(const glm::dvec3& in, const glm::dvec3& out) const;
};

/// One direction pair of the Cornell tables: angles in radians, spectrum reduced by rgb_of_reflectance.
struct BrdfSample {
  double theta_in, phi_in, theta_out, phi_out;
  glm::dvec3 value;
};

/// Samples of the Cornell Program of Computer Graphics' text: "#" before comments, the number of wavelengths,
/// the wavelengths in nm, then rows of theta_i phi_i theta_s phi_s and the values. InputError for anything
/// else, for angles beyond 0 to pi/2 (theta) and for more than 100,000 rows.
struct CornellBrdf {
  std::vector<BrdfSample> samples;
  std::size_t negatives = 0;  ///< values below 0, read as 0
};
CornellBrdf parse_cornell_brdf(std::string_view bytes, const std::string& name);

/// The binary of Matusik et al., "A Data-Driven Reflectance Model", SIGGRAPH 2003: three little-endian int32
/// (theta_h, theta_d, phi_d; 90, 90, 180 in the database), then a plane of doubles for red, green and blue.
/// Bins are sqrt-spaced in theta_h and even in theta_d (to pi/2) and phi_d (to pi).
struct MerlBrdf {
  std::array<int, 3> size{};
  std::vector<glm::vec3> values;  ///< scaled to 1/sr; a negative red: no measurement
};
/// InputError when the size of the file is not what its first 12 bytes promise; checked before allocating.
MerlBrdf parse_merl_brdf(std::string_view bytes, const std::string& name);

/// Resamples. The scattered samples by Gaussian weights exp(-100 d^2) over those within the smallest radius
/// of sqrt(0.001 2^k) that holds three, in Marschner's coordinates (sin sin, dphi/pi, cos cos): pbrt-v2's
/// rule (Pharr and Humphreys 2010, section 8.6.1), so that its images stay comparable. MERL's bins by
/// trilinear weights over those that were measured. Nodes without a value take the mean of their nearest
/// nodes that have one. All threads; the same bits for any number of them.
MeasuredBrdf resample(const CornellBrdf& measured);
MeasuredBrdf resample(const MerlBrdf& measured);

/// The sampling whose estimator f cos / pdf has the least second moment, relative to the squared albedo and
/// averaged over five outgoing angles from 15 to 75 degrees: a search over alpha (0.005 to 1) and the weight
/// (0 to 0.95).
void fit_sampling(MeasuredBrdf& brdf);

/// Fraction of the light from direction theta (cosine > 0) that is reflected, by quadrature over half
/// vectors.
glm::dvec3 directional_albedo(const MeasuredBrdf& brdf, double cosine);

/// Reads a file of either kind (told apart by their contents), resamples it and fits the sampling. Says in
/// `remarks` what was mended and whether more light is reflected than arrives.
MeasuredBrdf read_measured_brdf(const std::filesystem::path& path);

}  // namespace capcon
