#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"

namespace coupling {

struct ClimateRow;
const config::Schema<ClimateRow>& climate_variant_columns();

/// A climate as the user asks for it: the settings of [climate], or a row of climate.variants with what it
/// leaves out taken from them.
struct ClimateAsked {
    std::string name;
    ForestSettings settings;
    std::map<std::string, config::Place> given;  ///< where the row gives a setting, such as "climate.file"
    const config::Options& options;

    /// By the scenario or by the row.
    [[nodiscard]] bool was_set(const std::string& key) const;
    [[nodiscard]] config::Place place_of(const std::string& key) const;
    /// What a file is in the list of inputs: `what`, with the name of the climate where the row names it.
    [[nodiscard]] std::string role(const std::string& key, const std::string& what) const;
    /// What messages about one of several climates begin with: "climate 'warm': ".
    [[nodiscard]] std::string prefix() const;
};

/// The climates that the scenario asks for, in the order of climate.variants; without that table one. Throws
/// one config::InputError for all that is wrong with the table.
std::vector<ClimateAsked> asked_climates(Reading& reading);

}  // namespace coupling
