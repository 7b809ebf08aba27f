#include "coupling/assessments/profile/falls/profile_tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::profile {
namespace {

/// About 300 stretches of a round length, none shorter than 1 m.
double stretch_length_m(const ProfileSite& site) {
    constexpr double wanted = 300.0;
    return std::max(1.0, report::nice_step((site.last_m() - site.first_m()) / wanted));
}

void add_to(StratumOnProfile& stratum, const WatchedFall& fall) {
    ++stratum.rocks;
    if (rockfall::came_to_rest(fall.record.reason)) {
        stratum.run_out_m.add(fall.record.run_out_m());
    }
    for (std::size_t i = 0; i < stratum.stations.size(); ++i) {
        const rockfall::Arrival& arrival = fall.arrivals[i];
        if (arrival.reached) {
            stratum.stations[i].energy_j.add(static_cast<double>(arrival.energy_j));
            stratum.stations[i].speed_mps.add(static_cast<double>(arrival.speed_mps));
            stratum.stations[i].height_m.add(static_cast<double>(arrival.height_m));
        }
    }
}

/// Place in a row of equal pieces that begins at 0; the last piece takes what lies beyond.
std::size_t piece_of(double position_m, double piece_m, std::size_t pieces) {
    const double place = std::max(0.0, std::floor(position_m / piece_m));
    return std::min(static_cast<std::size_t>(place), pieces - 1);
}

}  // namespace

void Moments::add(double value) {
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
}

double Moments::mean() const {
    return count_ > 0 ? mean_ : no_number;
}

double Moments::deviation() const {
    return count_ > 1 ? std::sqrt(squares_ / static_cast<double>(count_ - 1)) : no_number;
}

void Spread::add(const rockfall::LogBins& bins, double value) {
    moments.add(value);
    counts.resize(bins.count());
    ++counts[bins.bin_of(static_cast<float>(value))];
}

double Spread::quantile(const rockfall::LogBins& bins, double share) const {
    const auto percentile = static_cast<std::uint64_t>(std::lround(100.0 * share));
    if (!percentile_is_known(moments.count(), percentile)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return std::clamp(rockfall::quantile(bins, counts, share), moments.least(), moments.most());
}

std::array<Share, rockfall::counted_energies_j.size()> rates_of(const StationTally& station,
                                                                std::uint64_t rocks) {
    std::array<Share, rockfall::counted_energies_j.size()> rates;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        rates[i] = share_of(station.above[i], rocks);
    }
    return rates;
}

ProfileTally::ProfileTally(const ProfileSite& site, double segment_m_in, std::size_t strata_in)
    : segment_m{segment_m_in},
      stretch_m{stretch_length_m(site)},
      stations(site.stations.size()),
      strata(strata_in) {
    for (StratumOnProfile& stratum : strata) {
        stratum.stations.resize(stations.size());
    }
    const auto pieces = [](double length_m, double piece_m) {
        return static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / piece_m - 1e-9)));
    };
    segments.resize(pieces(site.slope_length_m(site.last_m()), segment_m));
    stretches.resize(pieces(site.last_m() - site.first_m(), stretch_m));
    ends.resize(stretches.size() + 1);
}

config::GridFrame ProfileTally::frame(const ProfileSite& site) const {
    constexpr double width_m = 20.0;
    return {static_cast<int>(stretches.size()), 1, site.first_m(), -0.5 * width_m, stretch_m, width_m};
}

std::uint64_t ProfileTally::ended_beyond(std::size_t stretches_passed) const {
    return std::accumulate(ends.begin() + static_cast<std::ptrdiff_t>(stretches_passed), ends.end(),
                           std::uint64_t{0});
}

void ProfileTally::add(const ProfileSite& site, const WatchedFall& fall, bool released_in_flight,
                       std::size_t stratum) {
    using namespace rockfall;
    const RockRecord& record = fall.record;
    ++rocks;
    if (!strata.empty()) {
        add_to(strata[stratum], fall);
    }
    ++by_reason[static_cast<std::size_t>(record.reason)];
    if (came_to_rest(record.reason)) {
        run_out_m.add(record.run_out_m());
    }
    run_out_at_least_m.add(record.run_out_m());
    max_speed_mps.add(fine_speed_bins, record.max_speed_mps);
    max_energy_j.add(fine_energy_bins, record.max_energy_j);
    max_height_m.add(fine_height_bins, record.max_height_m);
    mean_speed_mps.add(record.mean_speed_mps());
    ground_impacts.add(record.ground_impacts);

    const double middle_m = 0.5 * (site.first_m() + site.last_m());
    const bool over_lower_end = record.reason == StopReason::left_terrain && record.end_m.x() > middle_m;
    if (record.reason == StopReason::left_terrain) {
        ++(over_lower_end ? left_lower : left_upper);
    }
    ++ends[over_lower_end ? stretches.size()
                          : piece_of(record.end_m.x() - site.first_m(), stretch_m, stretches.size())];

    for (std::size_t i = 0; i < stations.size(); ++i) {
        const Arrival& arrival = fall.arrivals[i];
        if (arrival.reached) {
            stations[i].energy_j.add(fine_energy_bins, static_cast<double>(arrival.energy_j));
            for (std::size_t energy = 0; energy < counted_energies_j.size(); ++energy) {
                stations[i].above[energy] += arrival.energy_j >= counted_energies_j[energy] ? 1U : 0U;
            }
            stations[i].translational_j.add(static_cast<double>(arrival.translational_j));
            stations[i].speed_mps.add(fine_speed_bins, static_cast<double>(arrival.speed_mps));
            stations[i].height_m.add(fine_height_bins, static_cast<double>(arrival.height_m));
        }
    }
    for (std::size_t i = released_in_flight ? 1 : 0; i < fall.jumps.size(); ++i) {
        const Jump& jump = fall.jumps[i];
        if (jump.landed && jump.length_m() >= least_jump_m) {
            const double at_m = site.slope_length_m(jump.to_m.x());
            SegmentTally& segment = segments[piece_of(at_m, segment_m, segments.size())];
            segment.length_m.add(jump.length_m());
            segment.impact_mps.add(jump.impact_mps);
            segment.height_m.add(jump.highest_m);
            jump_length_m.add(jump.length_m());
        }
    }
    for (const CellVisit& visit : fall.visits) {
        stretches[visit.cell].energy_j.add(energy_bins, static_cast<double>(visit.energy_j));
        stretches[visit.cell].height_m.add(height_bins, static_cast<double>(visit.height_m));
        stretches[visit.cell].speed_mps.add(fine_speed_bins, static_cast<double>(visit.speed_mps));
    }
    if (!fall.path.empty()) {
        paths.push_back({record.rock, fall.path});
    }
}

}  // namespace coupling::profile
