#include "forest/regeneration/ground_cover.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

/// Ground that a fallen tree covers with stem and crown [m2]: twice that of its stem.
double fallen_area_m2(double length_m, double thick_end_cm) {
    return 2.0 * 0.005 * length_m * thick_end_cm;
}

}  // namespace

std::vector<GroundCover> ground_covers(const Stand& stand) {
    constexpr double rotten_density = 0.5;
    constexpr int branches_years = 10;
    std::vector<GroundCover> covers(stand.grid().size());
    for (std::size_t i = 0; i < covers.size(); ++i) {
        covers[i].herbs = static_cast<double>(stand.patch_states()[i].herb_cover);
    }
    const auto lay = [&](double x_m, double y_m, double area_m2, double GroundCover::*part) {
        if (const std::optional<PatchId> patch = stand.grid().at(x_m, y_m)) {
            double& here = covers[index_of(*patch)].*part;
            here = std::min(1.0, here + area_m2 / patch_area_m2);
        }
    };
    for (const Log& log : stand.dead_wood().logs) {
        // On the patch of its thick end, which is the wider bed.
        const double area_m2 = log.length_m * 0.005 * (log.thick_end_cm + log.thin_end_cm);
        if (log.density_share < rotten_density) {
            lay(log.x_m, log.y_m, area_m2, &GroundCover::rotten_wood);
        } else {
            const bool with_branches = stand.year() - log.year < branches_years;
            lay(log.x_m, log.y_m, with_branches ? 2.0 * area_m2 : area_m2, &GroundCover::fresh_wood);
        }
    }
    for (const Snag& snag : stand.dead_wood().snags) {
        if (snag.cut && snag.density_share < rotten_density) {
            lay(snag.x_m, snag.y_m, basal_area_m2(snag.dbh_cm), &GroundCover::rotten_wood);
        }
    }
    return covers;
}

PatchState after_year_of_herbs(PatchState state) {
    constexpr double open_light = 0.3;
    constexpr double dark_light = 0.15;
    constexpr std::uint16_t free_years = 1;
    constexpr float spread_pyear = 0.25F;
    constexpr std::uint16_t most_years = 60'000;
    if (state.ground_light > open_light) {
        state.open_years =
            std::min<std::uint16_t>(static_cast<std::uint16_t>(state.open_years + 1), most_years);
    } else {
        state.open_years = 0;
    }
    if (state.ground_light < dark_light) {
        state.herb_cover = 0.0F;
    } else if (state.open_years > free_years) {
        state.herb_cover = std::min(1.0F, state.herb_cover + spread_pyear);
    }
    return state;
}

std::vector<double> crushed_shares(const Stand& stand) {
    std::vector<double> shares(stand.grid().size(), 0.0);
    const auto lay = [&](double x_m, double y_m, double area_m2) {
        if (const std::optional<PatchId> patch = stand.grid().at(x_m, y_m)) {
            shares[index_of(*patch)] =
                1.0 - (1.0 - shares[index_of(*patch)]) * std::max(0.0, 1.0 - area_m2 / patch_area_m2);
        }
    };
    const int last_year = stand.year() - 1;
    for (const Log& log : stand.dead_wood().logs) {
        if (log.year == last_year && log.origin != LogOrigin::felled_crosswise) {
            lay(log.x_m, log.y_m, fallen_area_m2(log.length_m, log.thick_end_cm));
        }
    }
    for (const Snag& snag : stand.dead_wood().snags) {
        if (snag.year == last_year && snag.cut) {
            lay(snag.x_m, snag.y_m, fallen_area_m2(snag.tree_height_m, snag.dbh_cm));
        }
    }
    return shares;
}

}  // namespace forest
