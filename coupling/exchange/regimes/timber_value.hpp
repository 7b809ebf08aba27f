#pragma once

#include <array>
#include <optional>
#include <vector>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"
#include "coupling/exchange/regimes/apply.hpp"
#include "forest/inventory/tables.hpp"
#include "forest/stand/species.hpp"
#include "forest/treatment/felling.hpp"

namespace coupling {

/// A cubic metre of stem wood over bark of a species and diameter class.
struct TimberPrice {
    double sold_share = 0.0;          ///< [0, 1], of the wood taken: less bark and what is lost in sorting
    double revenue_eur_per_m3 = 0.0;  ///< >= 0, of what is sold
    double felling_eur_per_m3 = 0.0;  ///< >= 0, of all that is felled
    double hauling_eur_per_m3 = 0.0;  ///< >= 0, of what is taken
};

/// Prices by species (in the order of the species table) and diameter class (forest/inventory/tables.hpp),
/// and the cost of work on young trees.
struct PriceTable {
    std::vector<std::array<TimberPrice, forest::dbh_classes>> by_species;
    double planted_tree_eur = 0.0;
    std::optional<double>
        guarded_tree_eur{};  ///< tube or cage, set up and taken away; nothing: not in the table
    double tended_ha_eur = 0.0;
    double fenced_ha_eur = 0.0;    ///< of the area inside, posts and wire, to build, keep and take away
    double entry_eur = 0.0;        ///< of planning and moving machines, where prices of wood are without it
    double cable_setup_eur = 0.0;  ///< to rig a cable line and take it down, where hauling is without it
};

struct TimberPriceRow;
struct WorkCostRow;
const config::Schema<TimberPriceRow>& timber_price_columns();
const config::Schema<WorkCostRow>& work_cost_columns();

/// A diameter class has the price of the row in which its middle lies; species without rows of their own that
/// of `any`. Throws one InputError (data) for all that is wrong with a table, gaps and overlaps between rows
/// included.
PriceTable read_prices(const config::Table& prices, const config::Table& work,
                       const forest::SpeciesTable& species);
/// Those that come with the program: an order of magnitude.
PriceTable shipped_prices(const forest::SpeciesTable& species);

/// What is left of the revenue after the costs of the work itself, without overhead [EUR].
struct Margin {
    double revenue_eur = 0.0;
    double harvest_eur = 0.0;  ///< felling and hauling
    double young_eur = 0.0;    ///< planting, tending and fencing
    double fixed_eur = 0.0;    ///< entries and cable lines, however much is cut

    [[nodiscard]] double contribution_eur() const {
        return revenue_eur - harvest_eur - young_eur - fixed_eur;
    }
    Margin& operator+=(const Margin& other);
};

/// Of timber alone. Requires prices for its species.
Margin contribution_margin(const forest::Timber& timber, const PriceTable& prices);
/// Of a year of a regime: timber, plants, tended and fenced area, entries that found something to do.
/// `cable_setups`: lines that were rigged.
Margin contribution_margin(const RegimeReport& report, const PriceTable& prices, double cable_setups = 0.0);

/// What the living trees would bring at these prices if they were felled and hauled [EUR]: the value that a
/// stand keeps by standing. Classes that do not pay for their felling count as nothing, as nobody would fell
/// them. Requires prices for their species.
double standing_value_eur(const forest::Stand& stand, const forest::SpeciesTable& species,
                          const PriceTable& prices);

}  // namespace coupling
