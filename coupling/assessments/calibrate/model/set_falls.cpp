#include "coupling/assessments/calibrate/model/set_falls.hpp"

#include <algorithm>

#include "coupling/assessments/calibrate/model/random.hpp"
#include "rockfall/tally/impact_log.hpp"
#include "rockfall/trajectory.hpp"

namespace coupling::calibrate {
namespace {

rockfall::Cover cover_of(const rockfall::Assessment& assessment) {
    return assessment.only_bare() ? rockfall::Cover::bare : rockfall::Cover::forest;
}

/// From impacts after which the rock jumps on to those that follow.
void add_jumps_between(std::span<const rockfall::GroundImpact> impacts, std::vector<SetRocks::Jump>& jumps) {
    for (std::size_t i = 1; i < impacts.size(); ++i) {
        if (impacts[i - 1].onward == rockfall::GroundImpact::Onward::jumps) {
            const double length_m = (impacts[i].place_m - impacts[i - 1].place_m).head<2>().norm();
            jumps.push_back({static_cast<float>(length_m), impacts[i - 1].ground});
        }
    }
}

}  // namespace

struct SetFalls::Instruments {
    explicit Instruments(const rockfall::Assessment& assessment)
        : obstacles{assessment.obstacles(cover_of(assessment), {})},
          footprint{assessment.slope.terrain, config::GridFrame{}, assessment.targets},
          impacts{assessment.slope} {}

    rockfall::Obstacles obstacles;
    rockfall::Footprint footprint;
    rockfall::ImpactLog impacts;
    rockfall::FallScratch scratch;
};

SetFalls::SetFalls(const rockfall::Assessment& assessment, std::uint64_t rocks, bool with_jumps)
    : assessment_{&assessment},
      rocks_{rocks},
      with_jumps_{with_jumps},
      instruments_{std::make_unique<Instruments>(assessment)} {}

SetFalls::~SetFalls() = default;
SetFalls::SetFalls(SetFalls&&) noexcept = default;

void SetFalls::fall(const rockfall::FallDraw& draw, const SetKey& key, SetRocks& out) {
    out.ends.clear();
    out.hits.clear();
    out.passages.clear();
    out.jumps.clear();
    const std::span<const rockfall::ReleaseSource> sources = assessment_->sources;
    const std::uint64_t released = sources.back().first_rock + sources.back().rocks;
    const double first = choices(key.seed, key.wave, Choice::first_rock, key.number).uniform();
    const double every = static_cast<double>(released) / static_cast<double>(rocks_);
    rockfall::Footprint& footprint = instruments_->footprint;
    const rockfall::SlopeView slope{assessment_->slope, draw.types};
    std::uint32_t source = 0;
    std::uint64_t last_rock = released;
    std::uint16_t again = 0;  ///< how often the same rock fell before
    for (std::uint64_t i = 0; i < rocks_; ++i) {
        // Of the rocks of the sources each `every`-th; where they are too few, each of them several times.
        const auto rock =
            std::min(released - 1, static_cast<std::uint64_t>((static_cast<double>(i) + first) * every));
        while (rock >= sources[source].first_rock + sources[source].rocks) {
            ++source;
        }
        again = rock == last_rock ? static_cast<std::uint16_t>(again + 1) : std::uint16_t{0};
        last_rock = rock;
        const config::StreamKey stream{key.seed, key.number,
                                       static_cast<std::uint16_t>(key.wave + most_waves * again), rock};
        const auto start = rockfall::start_of(assessment_->slope, sources[source], source, assessment_->start,
                                              stream, draw.block_size);
        if (!start) {
            continue;
        }
        footprint.begin(*start, false);
        footprint.finish(rockfall::fall(slope, instruments_->obstacles, draw.law, stream, *start,
                                        instruments_->scratch, footprint));
        const rockfall::RockRecord& record = footprint.record();
        out.ends.push_back({record.start_m.head<2>(), record.end_m.head<2>(), sources[source].zone,
                            record.diameter_m, record.reason == rockfall::StopReason::left_terrain});
        for (const rockfall::TreeHitRecord& hit : footprint.tree_hits()) {
            const rockfall::PlacedStem& stem = assessment_->stems.placed()[hit.stem];
            out.hits.push_back(
                {{stem.x_m, stem.y_m}, hit.height_m, static_cast<float>(200.0 * stem.breast_radius_m)});
        }
        for (const auto& [target, arrival] : footprint.arrivals()) {
            out.passages.push_back({target, arrival});
        }
        if (with_jumps_) {
            instruments_->impacts.begin();
            rockfall::fall(slope, instruments_->obstacles, draw.law, stream, *start, instruments_->scratch,
                           instruments_->impacts);
            add_jumps_between(instruments_->impacts.impacts(), out.jumps);
        }
    }
}

}  // namespace coupling::calibrate
