#pragma once

#include <array>
#include <cstddef>

namespace coupling::report {

/// The colour of a species on light and on dark pages: "#rrggbb".
struct SpeciesColour {
    const char* on_light;
    const char* on_dark;  ///< brighter where the colour would sink into a dark page
};

/// In the order of the species table. Colours of P. Tol's schemes for colour-blind readers
/// (SRON/EPS/TN/09-002).
inline constexpr std::array<SpeciesColour, 12> species_colours{{{"#117733", "#2f9a55"},
                                                                {"#332288", "#7d70d8"},
                                                                {"#ddcc77", "#ddcc77"},
                                                                {"#cc6677", "#cc6677"},
                                                                {"#88ccee", "#88ccee"},
                                                                {"#882255", "#c25590"},
                                                                {"#999933", "#999933"},
                                                                {"#44aa99", "#44aa99"},
                                                                {"#aa4499", "#c46bb5"},
                                                                {"#dddddd", "#dddddd"},
                                                                {"#661100", "#b5613f"},
                                                                {"#6699cc", "#6699cc"}}};

/// `species`: its place in the species table; colours repeat after the last.
constexpr const SpeciesColour& colour_of_species(std::size_t species) {
    return species_colours[species % species_colours.size()];
}

}  // namespace coupling::report
