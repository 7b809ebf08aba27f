#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "rockfall/draws/fall_draw.hpp"
#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// Draws of what is not known for `validate --draws` [choice].
inline constexpr std::size_t coverage_draws = 32;

/// Draws by the shipped widths, for all of these ground types.
std::vector<rockfall::FallDraw> draws_for(const rockfall::FallLaw& law,
                                          const std::vector<rockfall::SurfaceType>& types,
                                          std::uint64_t seed);

/// Holds what was observed, or published where nothing was observed, against two 90 % bands of default
/// settings: by the chance of as many rocks as were observed (`deviations`), and by that and the scatter of
/// the figure over `draws`. Rows without either or without a deviation are left out.
std::vector<Coverage> coverage_of(const std::vector<VerdictRow>& rows,
                                  const std::map<std::string, double>& deviations,
                                  std::span<const std::map<std::string, double>> draws);

/// "3 of 8 known figures (6 observed, the others published) inside 90 % of rocks alone, 7 inside ...".
std::string in_words(const std::vector<Coverage>& coverage);

}  // namespace coupling::validation
