#include "coupling/inputs/forest/nais_input.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "forest/protection/target_profile.hpp"

namespace coupling {
namespace {

using config::ExitCode;
using config::joined;

constexpr double highest_stand_of_profiles = 4e9;

/// Reads rows and collects what is wrong in them.
class NaisReader {
public:
    NaisReader(const config::Table& table, const forest::SpeciesTable& species, const forest::PatchGrid& grid,
               double effective_cm, std::string name)
        : table_{table}, species_{species}, effective_cm_{effective_cm}, name_{std::move(name)} {
        for (const forest::Patch& patch : grid.patches()) {
            stands_.insert(patch.management_unit);
        }
    }

    void read(std::size_t row) {
        const std::size_t before = problems_.list().size();
        NaisRow result;
        result.stand = stand_of(row);
        result.site_type = table_.text(row, "site_type");
        result.hazard = table_.text(row, "hazard");
        result.source = name_;
        const std::string& name = table_.text(row, "criterion");
        const auto criterion = forest::nais_criterion(name, species_, effective_cm_);
        if (!criterion) {
            const bool no_size = name == "stems_effective";
            refuse(row, "criterion", joined("criterion ", config::in_quotes(name)),
                   no_size ? "stems_from_N_cm: no diameter is known for rocks of this size"
                           : forest::nais_criteria_in_words());
            return;
        }
        result.criterion = *criterion;
        result.minimal_text = table_.text(row, "minimal");
        result.ideal_text = table_.text(row, "ideal");
        const auto minimal = limit_of(row, "minimal", result.minimal_text, *criterion);
        result.ideal =
            result.ideal_text.empty() ? std::nullopt : limit_of(row, "ideal", result.ideal_text, *criterion);
        if (!minimal || problems_.list().size() > before) {
            return;
        }
        result.minimal = *minimal;
        if (result.ideal && (result.ideal->low < minimal->low || result.ideal->high > minimal->high)) {
            refuse(
                row, "ideal",
                joined("ideal ", result.ideal_text, ", which allows more than minimal ", result.minimal_text),
                "an ideal within the minimum");
            return;
        }
        const bool again = std::any_of(rows_.begin(), rows_.end(), [&](const NaisRow& other) {
            return other.stand == result.stand && other.hazard == result.hazard &&
                   other.criterion.name == result.criterion.name;
        });
        if (again) {
            refuse(row, "criterion", joined(name, " a second time for stand ", table_.text(row, "stand")),
                   "each criterion once for a stand and hazard");
            return;
        }
        rows_.push_back(std::move(result));
    }

    std::vector<NaisRow> finish() {
        problems_.throw_if_any();
        return std::move(rows_);
    }

private:
    void refuse(std::size_t row, const std::string& column, std::string found, std::string expected) {
        problems_.add(ExitCode::data, table_.place(row, column), std::move(found), std::move(expected));
    }

    std::uint32_t stand_of(std::size_t row) {
        if (table_.text(row, "stand") == "all") {
            return 0;
        }
        const auto number = table_.whole(row, "stand", {1.0, highest_stand_of_profiles}, problems_);
        if (number && !stands_.contains(static_cast<std::uint32_t>(*number))) {
            refuse(row, "stand", joined("stand ", table_.text(row, "stand"), " which has no forest cell"),
                   "a stand of the map, or all");
        }
        return number ? static_cast<std::uint32_t>(*number) : 0;
    }

    std::optional<forest::NaisLimit> limit_of(std::size_t row, const std::string& column,
                                              const std::string& text,
                                              const forest::NaisCriterion& criterion) {
        const auto limit = forest::nais_limit(text, criterion.wants_much());
        if (!limit) {
            refuse(row, column, joined(column, " ", config::in_quotes(text)),
                   joined("a number (", criterion.wants_much() ? "at least" : "at most",
                          "), a range such as 10-90, >=10 or <=80"));
        }
        return limit;
    }

    const config::Table& table_;
    const forest::SpeciesTable& species_;
    double effective_cm_;
    std::string name_;  ///< of the file, as the scenario names it
    std::set<std::uint32_t> stands_;
    std::vector<NaisRow> rows_;
    config::Problems problems_;
};

}  // namespace

std::optional<std::vector<NaisRow>> read_nais_profile(const forest::SpeciesTable& species,
                                                      const forest::PatchGrid& grid, double effective_cm,
                                                      Reading& reading) {
    const std::string& name = reading.scenario().forest.target_profile;
    return reading.attempt([&] {
        const config::Table table = reading.table("stands.target_profile", "target_profile", name);
        config::Problems problems;
        table.require({"stand", "site_type", "hazard", "criterion", "minimal", "ideal"}, problems);
        problems.throw_if_any();
        NaisReader reader{table, species, grid, effective_cm, name};
        for (std::size_t row = 0; row < table.rows(); ++row) {
            reader.read(row);
        }
        return reader.finish();
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
