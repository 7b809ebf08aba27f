#include "coupling/assessments/vary/write_table.hpp"

#include "coupling/inputs/tables/csv_row.hpp"

namespace coupling::vary {

namespace {

void add_share(CsvRow& row, const Share& share) {
    row.number<6>(share.value).number<6>(share.interval.low).number<6>(share.interval.high);
}

}  // namespace

void write_table(std::ostream& out, const std::vector<Factor>& factors,
                 const std::vector<Outcome>& outcomes) {
    CsvRow row{out};
    row.text("run").text("moved");
    for (const Factor& factor : factors) {
        row.text(factor.setting);
    }
    for (const char* column :
         {"target_id", "rocks", "share_bare", "share_bare_low", "share_bare_high", "energy_mean_bare_kj",
          "energy_p95_bare_kj", "share_forest", "share_forest_low", "share_forest_high",
          "energy_mean_forest_kj", "energy_p95_forest_kj", "protection_percent", "protection_low_percent",
          "protection_high_percent", "run_out_mean_m", "left_terrain_percent"}) {
        row.text(column);
    }
    row.end();
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        const Outcome& outcome = outcomes[i];
        for (const TargetOutcome& target : outcome.targets) {
            row.whole(i);
            row.text(i == 0 ? "none" : outcome.combination.alone.empty() ? "crossed" : "alone");
            for (const std::string& value : outcome.combination.values) {
                row.text(value);
            }
            row.text(target.id).whole(outcome.rocks);
            add_share(row, target.bare.share);
            row.number<3>(target.bare.energy_kj.mean).number<3>(target.bare.energy_kj.p95);
            if (outcome.with_forest) {
                add_share(row, target.forest.share);
                row.number<3>(target.forest.energy_kj.mean).number<3>(target.forest.energy_kj.p95);
            } else {
                row.empty().empty().empty().empty().empty();
            }
            if (target.protection) {
                row.number<3>(100.0 * target.protection->value);
                row.number<3>(100.0 * target.protection->interval.low);
                row.number<3>(100.0 * target.protection->interval.high);
            } else {
                row.empty().empty().empty();
            }
            row.number<2>(outcome.run_out_mean_m).number<4>(100.0 * outcome.left_terrain.value);
            row.end();
        }
    }
}

}  // namespace coupling::vary
