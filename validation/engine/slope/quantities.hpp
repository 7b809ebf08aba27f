#pragma once

#include <map>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "validation/engine/slope/falls.hpp"

namespace coupling::validation {

/// A stretch of slope that rocks may stop in, plan distances.
struct Section {
    std::string name;
    double from_m = 0.0;
    double to_m = 0.0;
};

/// What figures need to know of the slope beside the falls.
struct FigureFrame {
    double start_m = 0.0;         ///< plan distance of the start
    double slope_length_m = 0.0;  ///< from the upper to the lower end
    double radius_m = 0.0;        ///< of the rocks
    std::vector<Section> sections;
    std::vector<std::string> stations;  ///< in the order of the arrivals
};

/// A figure that the program knows how to compute.
struct Quantity {
    enum class About : std::uint8_t { all_rocks, section, station };

    std::string name;   ///< such as "energy_mean_kj"; with ":NAME" where it is about a section or station
    std::string label;  ///< for people, such as "mean energy"
    std::string unit;
    About about = About::all_rocks;
    /// NaN where no rock gives it. `place` is the number of the section or station.
    double (*value)(const Falls& falls, const FigureFrame& frame, std::size_t place) = nullptr;
};

/// All quantities, each declared once, in the order of tables.
std::span<const Quantity> quantities();

/// The name of a figure taken apart: [open.|reduction.]quantity[:place].
struct FigureName {
    enum class Cover : std::uint8_t {
        as_is,
        open,       ///< the same rocks over the bare slope
        reduction,  ///< 1 - forest / open
    };
    Cover cover = Cover::as_is;
    const Quantity* quantity = nullptr;
    std::string place;

    [[nodiscard]] std::string label() const;
    [[nodiscard]] std::string unit() const;
};

/// Nothing for a name that no quantity has, or with a place where none belongs or without one where one does.
std::optional<FigureName> parse_figure(std::string_view name);

/// Every legal name for these sections and stations, without and with open. and reduction.
std::vector<std::string> figure_names(const FigureFrame& frame, bool with_open);

/// All figures of an ensemble by name.
std::map<std::string, double> figures_of(const Falls& falls, const FigureFrame& frame);

/// Adds open.* and reduction.* to the figures of a forest; a reduction of nothing is NaN.
void add_open(std::map<std::string, double>& figures, const std::map<std::string, double>& open);

/// Every quantity with its unit and what it is, one a line, for people who write a case.
void write_quantities(std::ostream& out);

/// The value below which a share of the values lies: straight between order statistics (definition 7 of
/// Hyndman & Fan 1996, that of most statistics programs). NaN without values.
double quantile(std::vector<double> values, double share);

}  // namespace coupling::validation
