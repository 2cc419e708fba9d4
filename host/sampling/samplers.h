#pragma once

#include <memory>

#include "sampling/sampler.h"

namespace capcon {

// One maker a sampler: (count of points a set, seed, parts of a set), and for those that know neighbours the
// width of the image.

/// Independent uniform points.
std::unique_ptr<Sampler> make_random_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// One random point in each of a x b equal strata, a b = count, as square as count's divisors allow.
std::unique_ptr<Sampler> make_jittered_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// The Sobol' (0,2)-sequence under random digit (XOR) scrambling: the text's baseline.
std::unique_ptr<Sampler> make_sobol_xor_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// The same sequence under hashed Owen scrambling: today's baseline.
std::unique_ptr<Sampler> make_sobol_owen_sampler(std::uint32_t count, std::uint32_t seed,
                                                 std::uint32_t parts);
/// One untiled capacity-constrained set of `count` points, with a Cranley-Patterson rotation a set.
std::unique_ptr<Sampler> make_ccvt_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// One untiled set by farthest-point optimisation, turned and cut like ccvt's.
std::unique_ptr<Sampler> make_fpo_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// The Halton sequence in bases 2 and 3, turned like ccvt's; parts are successive points.
std::unique_ptr<Sampler> make_halton_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// The rank-1 lattice of largest minimum distance (Dammertz and Keller 2008), turned like ccvt's.
std::unique_ptr<Sampler> make_lattice_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// Progressive multi-jittered (0,2)-sequences (Christensen, Kensler and Kilpatrick 2018): one of several
/// stored ones and an XOR a set.
std::unique_ptr<Sampler> make_pmj02_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// The shipped corner tiles: a stochastic toroidal tiling and a rotation a set.
std::unique_ptr<Sampler> make_capcon_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts);
/// The shipped bounded tiles: a stochastic tiling of the square without a seam and one of the square's
/// symmetries a set, a random point in every point's cell. Unbiased. InputError for counts that are not 16
/// k^2 with k 2 to 256.
std::unique_ptr<Sampler> make_capcon_bounded_sampler(std::uint32_t count, std::uint32_t seed,
                                                     std::uint32_t parts);

/// Sets of an ensemble in the integral's own domain, without a seam: one of its sets and the domain's own
/// symmetry (rotation, flips, a shift round the cylinder) by hash, a random point in every cell. Unbiased.
std::unique_ptr<Sampler> make_capcon_domain_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts);

/// The first points of such sets of 256, or of 1,024 for more: the beginning of a sequence, for progressive
/// rendering. InputError beyond 1,024.
std::unique_ptr<Sampler> make_capcon_ranked_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts);

/// The same sets, given to the pixels of an image by a mask (points/screen_mask.h) so that its error is blue
/// noise. InputError for more than kMostScreenPoints points.
std::unique_ptr<Sampler> make_capcon_screen_sampler(std::uint32_t count, std::uint32_t seed,
                                                    std::uint32_t parts, std::uint32_t width);
/// Owen-scrambled Sobol' points in Z order over the image (Ahmed and Wonka 2020).
std::unique_ptr<Sampler> make_sobol_z_sampler(std::uint32_t count, std::uint32_t seed, std::uint32_t parts,
                                              std::uint32_t width);

}  // namespace capcon
