#include "coupling/exchange/regimes/timber_value.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr config::NumberRange dbh_range{.low = 0.0, .high = 1000.0};
constexpr config::NumberRange euro_range{.low = 0.0, .high = 10'000.0};
constexpr const char* any_species = "any";

struct PriceRow {
    std::size_t row = 0;
    double from_cm = 0.0;
    double to_cm = 0.0;
    TimberPrice price;
};

/// Rows of a price table by species.
class PriceReader {
public:
    PriceReader(const config::Table& table, const forest::SpeciesTable& species, config::Problems& problems)
        : table_{table}, species_{species}, problems_{problems}, own_(species.size()) {}

    std::vector<std::array<TimberPrice, forest::dbh_classes>> all() {
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            const std::string& name = table_.text(row, "species");
            if (name == any_species) {
                others_.push_back(read(row));
            } else if (const auto found = species_.find(name, table_.place(row, "species"), problems_)) {
                own_[forest::index_of(*found)].push_back(read(row));
            }
        }
        const bool needs_others =
            std::any_of(own_.begin(), own_.end(), [](const auto& rows) { return rows.empty(); });
        if (others_.empty() && needs_others) {
            problems_.add(config::ExitCode::data, {table_.file()}, "no row `any`",
                          "one for species without rows of their own");
        }
        for (auto& rows : own_) {
            check(rows);
        }
        check(others_);
        std::vector<std::array<TimberPrice, forest::dbh_classes>> prices(species_.size());
        for (std::size_t s = 0; s < prices.size(); ++s) {
            const std::vector<PriceRow>& rows = own_[s].empty() ? others_ : own_[s];
            for (std::size_t c = 0; c < forest::dbh_classes; ++c) {
                const double middle_cm = (static_cast<double>(c) + 0.5) * forest::dbh_class_cm;
                for (const PriceRow& row : rows) {
                    if (middle_cm >= row.from_cm && middle_cm < row.to_cm) {
                        prices[s][c] = row.price;
                    }
                }
            }
        }
        return prices;
    }

private:
    PriceRow read(std::size_t row) {
        const auto number = [&](const char* column, const config::NumberRange& range) {
            return table_.number(row, column, range, problems_).value_or(0.0);
        };
        PriceRow result{.row = row, .from_cm = number("dbh_from_cm", dbh_range), .price = {}};
        result.to_cm = table_.text(row, "dbh_to_cm").empty() ? std::numeric_limits<double>::max()
                                                             : number("dbh_to_cm", dbh_range);
        result.price = {number("sold_share", {.low = 0.0, .high = 1.0}),
                        number("revenue_eur_per_m3", euro_range), number("felling_eur_per_m3", euro_range),
                        number("hauling_eur_per_m3", euro_range)};
        return result;
    }

    /// Rows follow each other from 0 to the open end.
    void check(std::vector<PriceRow>& rows) {
        double at_cm = 0.0;
        for (const PriceRow& row : rows) {
            if (row.from_cm != at_cm || row.to_cm <= row.from_cm) {
                problems_.add(
                    config::ExitCode::data, table_.place(row.row, "dbh_from_cm"),
                    joined(table_.text(row.row, "dbh_from_cm"), " to ", table_.text(row.row, "dbh_to_cm"),
                           " cm"),
                    joined("a row that begins at ", config::to_text(at_cm), " cm and ends above it"));
            }
            at_cm = row.to_cm;
        }
        if (!rows.empty() && at_cm != std::numeric_limits<double>::max()) {
            problems_.add(config::ExitCode::data, table_.place(rows.back().row, "dbh_to_cm"),
                          joined("a last row to ", config::to_text(at_cm), " cm"),
                          "an empty dbh_to_cm in the last row of a species");
        }
    }

    const config::Table& table_;
    const forest::SpeciesTable& species_;
    config::Problems& problems_;
    std::vector<std::vector<PriceRow>> own_;
    std::vector<PriceRow> others_;
};

void read_work(const config::Table& table, PriceTable& prices, config::Problems& problems) {
    const auto cost_of = [&](const std::string& work) {
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (table.text(row, "work") == work) {
                return table.number(row, "cost_eur", euro_range, problems).value_or(0.0);
            }
        }
        problems.add(config::ExitCode::data, {table.file()}, joined("no row ", work), "its cost in EUR");
        return 0.0;
    };
    prices.planted_tree_eur = cost_of("planted_tree");
    const std::string guard = "guarded_tree";
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "work") == guard) {
            prices.guarded_tree_eur = cost_of(guard);
        }
    }
    prices.tended_ha_eur = cost_of("tended_ha");
    prices.fenced_ha_eur = cost_of("fenced_ha");
}

config::Table shipped(const std::string& name) {
    std::istringstream in{std::string{config::shipped_table(name)}};
    return config::Table::read(in, name);
}

}  // namespace

PriceTable read_prices(const config::Table& prices, const config::Table& work,
                       const forest::SpeciesTable& species) {
    config::Problems problems;
    const bool has_prices = prices.require({"species", "dbh_from_cm", "dbh_to_cm", "sold_share",
                                            "revenue_eur_per_m3", "felling_eur_per_m3", "hauling_eur_per_m3"},
                                           problems);
    const bool has_work = work.require({"work", "cost_eur"}, problems);
    PriceTable table;
    if (has_prices) {
        table.by_species = PriceReader{prices, species, problems}.all();
    }
    if (has_work) {
        read_work(work, table, problems);
    }
    problems.throw_if_any();
    return table;
}

PriceTable shipped_prices(const forest::SpeciesTable& species) {
    return read_prices(shipped("timber_prices.csv"), shipped("work_costs.csv"), species);
}

Margin& Margin::operator+=(const Margin& other) {
    revenue_eur += other.revenue_eur;
    harvest_eur += other.harvest_eur;
    young_eur += other.young_eur;
    return *this;
}

Margin contribution_margin(const forest::Timber& timber, const PriceTable& prices) {
    assert(timber.by_species.size() <= prices.by_species.size());
    Margin margin;
    for (std::size_t s = 0; s < timber.by_species.size(); ++s) {
        for (std::size_t c = 0; c < forest::dbh_classes; ++c) {
            const forest::TimberClass& wood = timber.by_species[s][c];
            const TimberPrice& price = prices.by_species[s][c];
            margin.revenue_eur += wood.taken_m3 * price.sold_share * price.revenue_eur_per_m3;
            margin.harvest_eur += (wood.taken_m3 + wood.left_m3) * price.felling_eur_per_m3 +
                                  wood.taken_m3 * price.hauling_eur_per_m3;
        }
    }
    return margin;
}

Margin contribution_margin(const RegimeReport& report, const PriceTable& prices) {
    Margin margin = contribution_margin(report.timber, prices);
    for (const Entry& entry : report.entries) {
        margin.young_eur += static_cast<double>(entry.plants) * prices.planted_tree_eur;
        margin.young_eur += static_cast<double>(entry.guarded) * prices.guarded_tree_eur.value_or(0.0);
        margin.young_eur += entry.tended_ha * prices.tended_ha_eur;
        margin.young_eur += entry.fenced_ha * prices.fenced_ha_eur;
    }
    return margin;
}

}  // namespace coupling
