#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/table/table.hpp"
#include "coupling/inputs/climate/dates.hpp"

namespace coupling::climate {

/// What a month of days is made of.
enum class OfMonth : std::uint8_t { mean, sum };

/// A column of monthly climate that services give by day or month, in units of their own.
struct Quantity {
    std::string_view column;
    std::string_view unit;  ///< as config/table/column_form.hpp calls it
    OfMonth of_month = OfMonth::mean;
};

inline constexpr std::array<Quantity, 6> quantities{{{"tmin_c", "c"},
                                                     {"tmax_c", "c"},
                                                     {"tave_c", "c"},
                                                     {"prec_mm", "mm", OfMonth::sum},
                                                     {"rad_mj_m2_d", "mjm2d"},
                                                     {"sunshine_h", "hours", OfMonth::sum}}};

/// The numbers of a quantity in our unit, one for each row.
struct Values {
    std::string found;     ///< the column as the file has it
    std::string how_read;  ///< how our numbers came from it, such as "'tmin [K]' - 273.15"; "" if it was ours
    std::vector<std::optional<double>> of_rows;  ///< nothing where a row has none
    std::size_t missing = 0;                     ///< rows with -999 and the like, or nothing
};

/// Reads a quantity. The unit is that of the header, else that of an explanation above it, else that of the
/// service that has the name (config/data/climate_units.csv) where the numbers cannot be ours. Explanations
/// may give parts of a unit ("in 0.1 mm") and -1 for traces. Temperatures that are all between 180 and 335
/// are kelvin; means that no place has are refused as degrees Fahrenheit or tenths. W/m2 beside a day length
/// in seconds are means of daylight (Daymet). Nothing where the table lacks the column. Throws InputError for
/// a field that is no number and for a unit without a way to ours.
std::optional<Values> values_of(const config::Table& table, const Quantity& quantity,
                                const std::vector<Date>& dates);

/// Whether a line above the header begins with the name of a column and has some words, in small letters.
bool is_explained_as(const config::Table& table, const std::string& found, std::string_view words);

/// The height that an explanation above the header gives for the place [m].
std::optional<double> elevation_above_header(const config::Table& table);

}  // namespace coupling::climate
