#include "forest/disturbance/beetle_hosts.hpp"

#include "config/math/elementary.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

bool is_beetle_host(const Tree& tree, const SpeciesTable& species) {
    return species[tree.species].beetle.host && tree.dbh_cm >= least_host_cm;
}

double success_by_share(double host_share) {
    const double base = 1.0 + 0.2675 * config::exp_of(-6.846 * (host_share - 0.375));
    return 0.08 + 0.92 * config::pow_of(base, -3.33);
}

double success_by_age(double age_years) {
    return 1.0 / (1.0 + config::exp_of(-0.109 * (age_years - 70.0)));
}

double success_by_stress(double stress) {
    return 0.15 + 0.85 * stress;
}

std::vector<BeetleHosts> beetle_hosts_of(const Stand& stand, const SpeciesTable& species) {
    const PatchGrid& grid = stand.grid();
    std::vector<double> all_m2(grid.size(), 0.0);
    std::vector<BeetleHosts> hosts(grid.size());
    for (const Tree& tree : stand.trees()) {
        const double tree_m2 = tree.stems * basal_area_m2(tree.dbh_cm);
        all_m2[index_of(tree.patch)] += tree_m2;
        hosts[index_of(tree.patch)].basal_area_m2 += is_beetle_host(tree, species) ? tree_m2 : 0.0;
    }
    for (std::size_t p = 0; p < hosts.size(); ++p) {
        const config::Cell cell = grid[PatchId{static_cast<std::uint32_t>(p)}].cell;
        double around_m2 = 0.0;
        double host_m2 = 0.0;
        for (int k = 0; k < 9; ++k) {
            if (const auto other = grid.at(config::Cell{cell.column + k % 3 - 1, cell.row + k / 3 - 1})) {
                around_m2 += all_m2[index_of(*other)];
                host_m2 += hosts[index_of(*other)].basal_area_m2;
            }
        }
        hosts[p].share = around_m2 > 0.0 ? host_m2 / around_m2 : 0.0;
    }
    return hosts;
}

double colonisation_success(const Tree& tree, double drought, const BeetleHosts& around) {
    const double stress = tree.stress_years > 0 ? 1.0 : drought;
    return success_by_stress(stress) * success_by_age(tree.age_years) * success_by_share(around.share);
}

}  // namespace forest
