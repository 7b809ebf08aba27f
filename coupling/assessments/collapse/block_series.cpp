#include "coupling/assessments/collapse/block_series.hpp"

#include <algorithm>
#include <cmath>

namespace coupling::collapse {

std::vector<SeriesBlock> chosen_blocks(const CollapseResults& results) {
    constexpr double moved_m = 1.0;  // [choice]
    const std::size_t blocks = results.site.count.free;
    std::vector<double> ways_m(blocks);
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < blocks; ++i) {
        ways_m[i] = (results.seen(i).centre_m - results.site.blocks[i].centre_m).head<2>().norm();
        if (ways_m[i] > moved_m) {
            moved.push_back(i);
        }
    }
    if (moved.empty()) {
        return {};
    }
    std::stable_sort(moved.begin(), moved.end(),
                     [&](std::size_t a, std::size_t b) { return ways_m[a] < ways_m[b]; });
    const auto& speeds = results.record.block_speed_mps;
    const auto fastest =
        static_cast<std::size_t>(std::max_element(speeds.begin(), speeds.end()) - speeds.begin());
    std::vector<SeriesBlock> chosen;
    for (const auto& [number, reason] :
         {std::pair{fastest, Chosen::fastest}, std::pair{moved.back(), Chosen::farthest},
          std::pair{moved[moved.size() / 2], Chosen::median}}) {
        const auto same = std::find_if(chosen.begin(), chosen.end(),
                                       [n = number](const SeriesBlock& other) { return other.number == n; });
        if (same == chosen.end()) {
            chosen.push_back({number, {reason}});
        } else {
            same->reasons.push_back(reason);
        }
    }
    return chosen;
}

BlockMoment moment_of(const CollapseResults& results, std::size_t block, std::size_t frame) {
    const auto& frames = results.record.frames;
    const BlockPlace& place = frames[frame][block];
    const auto& of_mass = results.mass.blocks()[block];
    const Eigen::Vector3d way_m = place.centre() - results.site.blocks[block].centre_m;
    BlockMoment moment;
    moment.time_s = results.record.rows[frame].time_s;
    moment.place_m = place.centre();
    moment.place_m.head<2>() += results.site.origin_m;
    moment.displacement_m = way_m.norm();
    moment.speed_mps = static_cast<double>(place.speed_mps);
    if (frame > 0) {
        const double since_s = moment.time_s - results.record.rows[frame - 1].time_s;
        moment.acceleration_mps2 = (place.velocity() - frames[frame - 1][block].velocity()).norm() / since_s;
    }
    moment.kinetic_j = static_cast<double>(place.energy_j);
    moment.released_j = -of_mass.weight_n / of_mass.mass_factor * way_m.z();
    return moment;
}

MeanMoment mean_moment(const CollapseResults& results, std::size_t frame) {
    const FrameRow& row = results.record.rows[frame];
    const auto blocks = static_cast<double>(results.site.count.free);
    MeanMoment mean;
    mean.speed_mps = row.mean_speed_mps;
    mean.acceleration_mps2 = row.known(row.mean_acceleration_mps2);
    mean.displacement_m = row.mean_displacement_m;
    mean.kinetic_j = (row.ledger.translation_j + row.ledger.rotation_j) / blocks;
    mean.friction_j = row.ledger.friction_j / blocks;
    mean.fracture_j = row.ledger.fracture_j / blocks;
    mean.strain_j =
        (row.ledger.contact_normal_j + row.ledger.contact_shear_j + row.ledger.bonds.sum_j()) / blocks;
    mean.given_up_j = row.ledger.given_by_gravity_j() / blocks - mean.kinetic_j;
    return mean;
}

std::vector<std::size_t> picture_frames(const CollapseResults& results) {
    const auto& rows = results.record.rows;
    std::vector<std::size_t> frames;
    const std::vector<double>& wanted_s = results.scenario.settings.picture_times_s;
    for (const double time_s : wanted_s) {
        const auto nearest =
            std::min_element(rows.begin(), rows.end(), [&](const FrameRow& a, const FrameRow& b) {
                return std::abs(a.time_s - time_s) < std::abs(b.time_s - time_s);
            });
        frames.push_back(static_cast<std::size_t>(nearest - rows.begin()));
    }
    if (wanted_s.empty()) {
        for (const double share : {0.0, 0.133, 0.333, 0.667, 1.0}) {
            frames.push_back(
                static_cast<std::size_t>(std::lround(share * static_cast<double>(rows.size() - 1))));
        }
    }
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

}  // namespace coupling::collapse
