#include "coupling/program/actions/input_tables.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/consequences/risk_curves.hpp"
#include "coupling/assessments/hazard/hazard_matrix.hpp"
#include "coupling/assessments/profile/falls/profile_site.hpp"
#include "coupling/assessments/stopping/stopping_recipe.hpp"
#include "coupling/assessments/vary/study/plan.hpp"
#include "coupling/exchange/regimes/fell_list.hpp"
#include "coupling/exchange/regimes/stem_numbers.hpp"
#include "coupling/exchange/regimes/timber_value.hpp"
#include "coupling/inputs/climate/dates.hpp"
#include "coupling/inputs/collapse_settings.hpp"
#include "coupling/inputs/forest/climate_input.hpp"
#include "coupling/inputs/forest/climate_variants.hpp"
#include "coupling/inputs/forest/dbh_class_input.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/forest/log_input.hpp"
#include "coupling/inputs/forest/nais_input.hpp"
#include "coupling/inputs/forest/soil_input.hpp"
#include "coupling/inputs/forest/stand_input.hpp"
#include "coupling/inputs/forest/start_input.hpp"
#include "coupling/inputs/forest/tops/species_of_tops.hpp"
#include "coupling/inputs/forest/tree_input.hpp"
#include "coupling/inputs/ground/ground_soils.hpp"
#include "coupling/inputs/ground/stopping_input.hpp"
#include "coupling/inputs/ground/surface_types.hpp"
#include "coupling/inputs/nets/net_input.hpp"
#include "coupling/inputs/observed/observed_events_input.hpp"
#include "coupling/inputs/observed/observed_input.hpp"
#include "coupling/inputs/parameters/parameter_widths.hpp"
#include "coupling/inputs/places/target_input.hpp"
#include "coupling/inputs/release/source_start.hpp"
#include "coupling/inputs/terrain/surface_input.hpp"
#include "coupling/inputs/works/work_input.hpp"
#include "forest/climate/series.hpp"

namespace coupling {
namespace {

/// "number in (0, 500]", with what an empty field needs.
std::string values_of(const config::ColumnRules& column) {
    std::string values = column.values_in_words();
    values = values.starts_with("a ") ? values.substr(2) : values;
    return config::joined(values, column.rules.unique ? ", each once" : "",
                          column.rules.optional ? "; may be missing" : "");
}

/// The unit of a column as people write it, not as names of columns end with it.
std::string unit_of(const config::ColumnRules& column) {
    constexpr std::pair<std::string_view, std::string_view> written[]{
        {"percent", "%"},   {"pha", "1/ha"}, {"m2pha", "m2/ha"}, {"m3pha", "m3/ha"},       {"mps", "m/s"},
        {"kgpm3", "kg/m3"}, {"kj", "kJ"},    {"pm", "1/m"},      {"kgphayear", "kg/ha/yr"}};
    const std::string unit = column.unit();
    const auto* const found = std::find_if(std::begin(written), std::end(written),
                                           [&](const auto& each) { return each.first == unit; });
    return found == std::end(written) ? unit : std::string{found->second};
}

void write_columns(const config::TableSchema& schema, std::ostream& out) {
    const config::TableRules& rules = schema.rules();
    const bool begins_with_vowel =
        std::string_view{"aeiou"}.find(rules.row.front()) != std::string_view::npos;
    out << "### `" << rules.setting << "`: a row is " << (begins_with_vowel ? "an " : "a ") << rules.row
        << "\n\n"
        << "| column | unit | values | meaning |\n|---|---|---|---|\n";
    for (const config::ColumnRules& column : schema.columns()) {
        out << "| `" << column.name << "` | " << unit_of(column) << " | " << values_of(column) << " | "
            << column.meaning << " |\n";
    }
}

}  // namespace

std::vector<const config::TableSchema*> input_tables() {
    static const auto logs_by_ends = log_columns({.by_ends = true, .one_diameter = true});
    static const auto logs_by_place = log_columns({.by_ends = false, .one_diameter = false});
    static const auto stops_by_place = observed_stop_columns(false);
    static const auto stops_by_shape = observed_stop_columns(true);
    return {&tree_columns(true),
            &tree_columns(false),
            &logs_by_ends,
            &logs_by_place,
            &net_columns(),
            &work_columns(),
            &target_list_columns(),
            &source_shape_columns(),
            &zone_block_columns(),
            &stopping_columns(true),
            &ground_soil_columns(),
            &surface_type_columns(),
            &parameter_width_columns(),
            &surface_polygon_columns(),
            &slope_ground_columns(),
            &observed_passage_columns(),
            &observed_impact_columns(),
            &observed_scar_columns(),
            &observed_tree_columns(),
            &observed_outline_columns(),
            &searched_area_columns(),
            &stops_by_place,
            &stops_by_shape,
            &species_area_columns(),
            &stand_polygon_columns(),
            &stand_record_columns(),
            &tree_area_columns(),
            &dbh_class_columns(),
            &dead_wood_columns(),
            &sapling_columns(),
            &soil_columns(),
            &target_profile_columns(),
            &forest::climate_columns(false),
            &climate::delivered_columns(),
            &climate_change_columns(),
            &climate_variant_columns(),
            &collapse::joint_set_columns(),
            &profile::corner_columns(),
            &profile::station_columns(),
            &hazard::matrix_columns(),
            &consequences::curve_columns(),
            &felled_tree_columns(),
            &stem_number_columns(),
            &timber_price_columns(),
            &work_cost_columns(),
            &recipe_columns(),
            &vary::factor_columns()};
}

void write_input_tables(const std::string& table, std::ostream& out) {
    std::vector<std::string> names;
    bool found = false;
    for (const config::TableSchema* schema : input_tables()) {
        const config::TableRules& rules = schema->rules();
        names.insert(names.end(), {rules.role, rules.setting});
        if (table.empty() || table == rules.role || table == rules.setting) {
            out << (found ? "\n" : "");
            write_columns(*schema, out);
            found = true;
        }
    }
    if (!found) {
        const std::string nearest = config::nearest_word(table, names);
        config::fail(config::ExitCode::settings, {}, "table " + config::in_quotes(table),
                     nearest.empty() ? "one of `bannwald info inputs`" : config::in_quotes(nearest));
    }
}

}  // namespace coupling
