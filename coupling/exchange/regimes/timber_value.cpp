#include "coupling/exchange/regimes/timber_value.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <string>

#include "config/data/shipped_tables.hpp"
#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "forest/stand/allometry.hpp"

namespace coupling {
namespace {
constexpr double open_end = std::numeric_limits<double>::max();
}  // namespace

struct TimberPriceRow : TimberPrice {
    std::string species;
    double from_cm = 0.0;
    double to_cm = open_end;
};

struct WorkCostRow {
    std::string work;
    double cost_eur = 0.0;
};

namespace {

using config::joined;
using PriceRows = std::vector<config::Read<TimberPriceRow>>;

constexpr config::NumberRange euro_range{.low = 0.0, .high = 10'000.0};
constexpr const char* any_species = "any";

/// Rows follow each other from 0 to the open end.
void check_classes(const PriceRows& rows, const config::Table& table, config::RowProblems& wrong) {
    double at_cm = 0.0;
    for (const auto& row : rows) {
        if (row.from_cm != at_cm || row.to_cm <= row.from_cm) {
            wrong.refuse(
                row.row, "dbh_from_cm",
                joined(table.text(row.row, "dbh_from_cm"), " to ", table.text(row.row, "dbh_to_cm"), " cm"),
                joined("a row that begins at ", config::to_text(at_cm), " cm and ends above it"));
        }
        at_cm = row.to_cm;
    }
    if (!rows.empty() && at_cm != open_end) {
        wrong.refuse(rows.back().row, "dbh_to_cm", joined("a last row to ", config::to_text(at_cm), " cm"),
                     "an empty dbh_to_cm in the last row of a species");
    }
}

std::array<TimberPrice, forest::dbh_classes> prices_by_class(const PriceRows& rows) {
    std::array<TimberPrice, forest::dbh_classes> prices;
    for (std::size_t c = 0; c < forest::dbh_classes; ++c) {
        const double middle_cm = (static_cast<double>(c) + 0.5) * forest::dbh_class_cm;
        for (const TimberPriceRow& row : rows) {
            if (middle_cm >= row.from_cm && middle_cm < row.to_cm) {
                prices[c] = row;
            }
        }
    }
    return prices;
}

std::vector<std::array<TimberPrice, forest::dbh_classes>> timber_prices(const config::Table& table,
                                                                        const forest::SpeciesTable& species) {
    config::RowProblems wrong{table};
    std::vector<PriceRows> own(species.size());
    PriceRows others;
    for (const auto& row : timber_price_columns().rows(table, wrong)) {
        if (row.species == any_species) {
            others.push_back(row);
        } else if (const auto found = species.find(row.species, table.place(row.row, "species"), wrong)) {
            own[forest::index_of(*found)].push_back(row);
        }
    }
    wrong.throw_first();
    const bool needs_others =
        std::any_of(own.begin(), own.end(), [](const PriceRows& rows) { return rows.empty(); });
    if (others.empty() && needs_others) {
        wrong.refuse("no row `any`", "one for species without rows of their own");
    }
    check_classes(others, table, wrong);
    std::vector<std::array<TimberPrice, forest::dbh_classes>> prices;
    for (const PriceRows& rows : own) {
        check_classes(rows, table, wrong);
        prices.push_back(prices_by_class(rows.empty() ? others : rows));
    }
    wrong.throw_first();
    return prices;
}

void read_work(const config::Table& table, PriceTable& prices) {
    config::RowProblems wrong{table};
    std::map<std::string, double> costs;
    for (const WorkCostRow& row : work_cost_columns().rows(table, wrong)) {
        costs.emplace(row.work, row.cost_eur);
    }
    wrong.throw_first();
    const auto cost_of = [&](const std::string& work) {
        if (!costs.contains(work)) {
            wrong.refuse(joined("no row ", work), "its cost in EUR");
        }
        return costs[work];
    };
    if (costs.contains("guarded_tree")) {
        prices.guarded_tree_eur = costs["guarded_tree"];
    }
    prices.entry_eur = costs.contains("entry") ? costs["entry"] : 0.0;
    prices.cable_setup_eur = costs.contains("cable_setup") ? costs["cable_setup"] : 0.0;
    prices.planted_tree_eur = cost_of("planted_tree");
    prices.tended_ha_eur = cost_of("tended_ha");
    prices.fenced_ha_eur = cost_of("fenced_ha");
    wrong.throw_first();
}

}  // namespace

const config::Schema<TimberPriceRow>& timber_price_columns() {
    using R = TimberPriceRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "timber_prices", .setting = "regimes.timber_prices", .row = "price"},
        {{"species", &R::species, "code or name, or any: of species without rows of their own"},
         {"dbh_from_cm", &R::from_cm, "lower end of the class; 0 in the first row of a species", {.range = {0.0, 1000.0}}},
         {"dbh_to_cm", &R::to_cm, "upper end, where the next row begins; empty in the last row of a species", {.range = {0.0, 1000.0}, .may_be_empty = true}},
         {"sold_share", &R::sold_share, "of the wood taken: less bark and what is lost in sorting", {.unit = "-", .range = {0.0, 1.0}}},
         {"revenue_eur_per_m3", &R::revenue_eur_per_m3, "of what is sold", {.unit = "EUR/m3", .range = euro_range}},
         {"felling_eur_per_m3", &R::felling_eur_per_m3, "of all that is felled", {.unit = "EUR/m3", .range = euro_range}},
         {"hauling_eur_per_m3", &R::hauling_eur_per_m3, "of what is taken", {.unit = "EUR/m3", .range = euro_range}}}};
    // clang-format on
    return columns;
}

const config::Schema<WorkCostRow>& work_cost_columns() {
    using R = WorkCostRow;
    // clang-format off
    static const config::Schema<R> columns{
        {.role = "work_costs", .setting = "regimes.work_costs", .row = "kind of work"},
        {{"work", &R::work, "guarded_tree only where plants have guards; entry and cable_setup only where prices of wood are without these fixed costs", {.unique = true, .words = {"planted_tree", "guarded_tree", "tended_ha", "fenced_ha", "entry", "cable_setup"}}},
         {"cost_eur", &R::cost_eur, "of one tree, hectare, entry or cable line", {.unit = "EUR", .range = euro_range}}}};
    // clang-format on
    return columns;
}

PriceTable read_prices(const config::Table& prices, const config::Table& work,
                       const forest::SpeciesTable& species) {
    PriceTable table;
    config::Problems problems;  // of both tables at once
    const auto collect = [&problems](const auto& step) {
        try {
            step();
        } catch (const config::InputError& error) {
            problems.add(error);
        }
    };
    collect([&] { table.by_species = timber_prices(prices, species); });
    collect([&] { read_work(work, table); });
    problems.throw_if_any();
    return table;
}

PriceTable shipped_prices(const forest::SpeciesTable& species) {
    return read_prices(config::read_shipped_table("timber_prices.csv"),
                       config::read_shipped_table("work_costs.csv"), species);
}

Margin& Margin::operator+=(const Margin& other) {
    revenue_eur += other.revenue_eur;
    harvest_eur += other.harvest_eur;
    young_eur += other.young_eur;
    fixed_eur += other.fixed_eur;
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

Margin contribution_margin(const RegimeReport& report, const PriceTable& prices, double cable_setups) {
    Margin margin = contribution_margin(report.timber, prices);
    margin.fixed_eur = cable_setups * prices.cable_setup_eur;
    for (const Entry& entry : report.entries) {
        margin.fixed_eur += entry.found_nothing() ? 0.0 : prices.entry_eur;
        margin.young_eur += static_cast<double>(entry.plants) * prices.planted_tree_eur;
        margin.young_eur += static_cast<double>(entry.guarded) * prices.guarded_tree_eur.value_or(0.0);
        margin.young_eur += entry.tended_ha * prices.tended_ha_eur;
        margin.young_eur += entry.fenced_ha * prices.fenced_ha_eur;
    }
    return margin;
}

double standing_value_eur(const forest::Stand& stand, const forest::SpeciesTable& species,
                          const PriceTable& prices) {
    double value_eur = 0.0;
    for (const forest::Tree& tree : stand.trees()) {
        if (tree.dbh_cm < forest::least_dead_wood_cm) {
            continue;  // as in felling: too thin to be worth hauling
        }
        const TimberPrice& price =
            prices.by_species[index_of(tree.species)][forest::dbh_class_of(tree.dbh_cm)];
        const double eur_per_m3 =
            price.sold_share * price.revenue_eur_per_m3 - price.felling_eur_per_m3 - price.hauling_eur_per_m3;
        const double stem_m3 =
            forest::stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m);
        value_eur += tree.stems * stem_m3 * std::max(0.0, eur_per_m3);
    }
    return value_eur;
}

}  // namespace coupling
