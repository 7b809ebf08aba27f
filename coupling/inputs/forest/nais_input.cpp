#include "coupling/inputs/forest/nais_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/forest/stand_input.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling {

struct NaisTableRow : NaisRow {
    std::string stand_text;
    std::string criterion_text;
};

namespace {

using config::joined;

/// What limits are read by.
struct NaisContext {
    const forest::SpeciesTable& species;
    std::set<std::uint32_t> stands;
    double effective_cm = 0.0;
};

std::optional<forest::NaisLimit> limit_of(std::size_t row, const std::string& column, const std::string& text,
                                          const forest::NaisCriterion& criterion,
                                          config::RowProblems& wrong) {
    const auto limit = forest::nais_limit(text, criterion.wants_much());
    if (!limit) {
        wrong.refuse(row, column, joined(column, " ", config::in_quotes(text)),
                     joined("a number (", criterion.wants_much() ? "at least" : "at most",
                            "), a range such as 10-90, >=10 or <=80"));
    }
    return limit;
}

/// Fills in what the texts of a row mean, but for its stand.
void interpret(config::Read<NaisTableRow>& row, const NaisContext& in, config::RowProblems& wrong) {
    const auto criterion = forest::nais_criterion(row.criterion_text, in.species, in.effective_cm);
    if (!criterion) {
        wrong.refuse(row.row, "criterion", joined("criterion ", config::in_quotes(row.criterion_text)),
                     row.criterion_text == "stems_effective"
                         ? "stems_from_N_cm: no diameter is known for rocks of this size"
                         : forest::nais_criteria_in_words());
        return;
    }
    row.criterion = *criterion;
    const auto minimal = limit_of(row.row, "minimal", row.minimal_text, *criterion, wrong);
    row.minimal = minimal.value_or(row.minimal);
    if (!row.ideal_text.empty()) {
        row.ideal = limit_of(row.row, "ideal", row.ideal_text, *criterion, wrong);
    }
    if (minimal && row.ideal && (row.ideal->low < minimal->low || row.ideal->high > minimal->high)) {
        wrong.refuse(row.row, "ideal",
                     joined("ideal ", row.ideal_text, ", which allows more than minimal ", row.minimal_text),
                     "an ideal within the minimum");
    }
}

}  // namespace

const config::Schema<NaisTableRow>& target_profile_columns() {
    using R = NaisTableRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "target_profile", .setting = "stands.target_profile", .row = "requirement", .unique_together = {{"stand", "hazard", "criterion"}}},
        {{"stand", &R::stand_text, "its number on the map, or all", {.may_be_empty = true}},
         {"site_type", &R::site_type, "as the guideline calls it", {.may_be_empty = true}},
         {"hazard", &R::hazard, "against which it protects", {.may_be_empty = true}},
         {"criterion", &R::criterion_text, "such as stems_from_24_cm or gap_m", {.may_be_empty = true}},
         {"minimal", &R::minimal_text, "a number, a range such as 10-90, >=10 or <=80", {.may_be_empty = true}},
         {"ideal", &R::ideal_text, "the same, within the minimum", {.may_be_empty = true}}}};
    // clang-format on
    return columns;
}

std::optional<std::vector<NaisRow>> read_nais_profile(const forest::SpeciesTable& species,
                                                      const forest::PatchGrid& grid, double effective_cm,
                                                      Reading& reading) {
    const std::string& name = reading.forest().target_profile;
    return reading.attempt([&] {
        const config::Table table = table_of(target_profile_columns(), name, reading);
        NaisContext in{species, {}, effective_cm};
        for (const forest::Patch& patch : grid.patches()) {
            in.stands.insert(patch.management_unit);
        }
        config::RowProblems wrong{table};
        std::vector<NaisRow> rows;
        StandsOffTheMap off;
        for (config::Read<NaisTableRow>& row : target_profile_columns().rows(table, wrong)) {
            row.source = name;
            interpret(row, in, wrong);
            if (const auto stand = stand_called(row.stand_text, row.row, in.stands, table, wrong, off)) {
                row.stand = *stand;
                rows.push_back(std::move(row));
            }
        }
        wrong.throw_first();
        off.report(table.file(), rows.size(), reading);
        return rows;
    });
}

std::vector<NaisRow> shipped_nais_profile(double block_diameter_m) {
    const auto profile = forest::target_profile(block_diameter_m);
    if (!profile) {
        return {};
    }
    constexpr double endless = std::numeric_limits<double>::infinity();
    const auto whole = [](double value) { return std::to_string(std::lround(value)); };
    const std::string any = "any";
    const std::string hazard = "rockfall";
    const std::string source = joined("shipped: ", profile->source);
    return {{0,
             any,
             hazard,
             {joined("stems_from_", whole(profile->dbh_from_cm), "_cm"),
              forest::NaisQuantity::stems_from,
              profile->dbh_from_cm,
              {}},
             {profile->least_stems_pha, endless},
             forest::NaisLimit{profile->ideal_stems_pha, endless},
             whole(profile->least_stems_pha),
             whole(profile->ideal_stems_pha),
             source},
            {0,
             any,
             hazard,
             {"gap_m", forest::NaisQuantity::gap, 0.0, {}},
             {-endless, profile->longest_gap_m},
             std::nullopt,
             whole(profile->longest_gap_m),
             "",
             source}};
}

}  // namespace coupling
