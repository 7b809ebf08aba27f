#include "coupling/assessments/collapse/hand_over.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::collapse {
namespace {

using rockfall::rock_mass::Block;
using rockfall::rock_mass::BlockStatus;
using rockfall::rock_mass::HandedBlock;
using rockfall::rock_mass::RockMass;

BlockStatus status_after(const rockfall::FallEnd& end) {
    return rockfall::came_to_rest(end.reason)                 ? BlockStatus::asleep
           : end.reason == rockfall::StopReason::left_terrain ? BlockStatus::left
                                                              : BlockStatus::moving;
}

/// The numbers of a crossing in one order, for writing and for reading.
template <class Visit>
void visit_block(Visit& visit, HandedBlock& block) {
    for (Eigen::Vector3d* v : {&block.centre_m, &block.velocity_mps, &block.rotation.momentum_nms}) {
        for (double& x : *v) {
            visit(x);
        }
    }
    for (double& x : block.rotation.attitude.coeffs()) {
        visit(x);
    }
    visit(block.motion_j);
    visit(block.gravity_j);
    visit(block.strain_j);
}

}  // namespace

HandOver::HandOver(const CollapseScenario& scenario, const CollapseSite& site, double look_s,
                   rockfall::rock_mass::ParallelFor parallel)
    : site_{scenario.settings.hand_over == HandOverTo::single_blocks ? &site : nullptr},
      settings_{&scenario.scenario.rockfall.fall, scenario.scenario.run.seed, look_s},
      after_s_{scenario.settings.hand_over_after_s},
      parallel_{std::move(parallel)},
      fall_of_(site.count.free, -1) {}

void HandOver::look(RockMass& mass) {
    if (site_ == nullptr) {
        return;
    }
    for (std::size_t f = 0; f < falls_.size(); ++f) {
        const std::vector<StemBlow>& blows = falls_[f].blows;
        for (std::size_t& k = blows_done_[f];
             k < blows.size() && starts_s_[f] + blows[k].after_s <= mass.time_s(); ++k) {
            mass.load_stem(blows[k].stem, blows[k].energy_j, blows[k].broken);
        }
    }
    std::vector<std::uint32_t> leaving = mass.lone_blocks(after_s_);
    std::erase_if(leaving, [&](std::uint32_t i) {
        const Block& block = mass.blocks()[i];
        return i >= site_->count.free ||
               !site_->handed_ground->is_untouched(site_->ground, block.centre_m.head<2>(), block.radius_m);
    });
    const std::size_t first = falls_.size();
    std::vector<std::uint32_t> gone;
    for (std::uint32_t k = 0; k < mass.stems().size(); ++k) {
        if (mass.stems()[k].is_broken()) {
            gone.push_back(k);
        }
    }
    for (const HandedBlock& block : mass.hand_over(leaving)) {
        crossings_.push_back({block, gone});
        starts_s_.push_back(mass.time_s());
    }
    follow_from(first);
}

/// Side by side: a fall depends on its own crossing alone.
void HandOver::follow_from(std::size_t first) {
    falls_.resize(crossings_.size());
    blows_done_.resize(crossings_.size(), 0);
    parallel_(crossings_.size() - first, [&](std::size_t k) {
        const Crossing& crossing = crossings_[first + k];
        std::vector<std::uint8_t> gone(site_->handed_ground->stems().placed().size(), 0);
        for (const std::uint32_t stem : crossing.gone) {
            gone[stem] = 1;
        }
        falls_[first + k] = follow(
            *site_->handed_ground, settings_, crossing.block,
            std::make_shared<const rockfall::solids::Solid>(site_->blocks[crossing.block.number].solid),
            std::move(gone));
    });
    for (std::size_t f = first; f < crossings_.size(); ++f) {
        fall_of_[crossings_[f].block.number] = static_cast<std::int32_t>(f);
    }
}

SeenBlock HandOver::seen(const RockMass& mass, std::size_t i) const {
    const HandedFall* fall = fall_of(i);
    if (fall == nullptr) {
        const Block& block = mass.blocks()[i];
        return {block.centre_m,
                block.rotation.attitude,
                block.velocity_mps,
                block.translation_j() / block.mass_factor,
                block.own_energy_j(),
                block.status,
                false};
    }
    const double passed = (mass.time_s() - handed_at_s(i)) / settings_.moment_s;
    const auto k = static_cast<std::size_t>(std::lround(std::max(0.0, passed)));
    const bool is_over = k + 1 >= fall->moments.size();
    const HandedMoment& moment = is_over ? fall->moments.back() : fall->moments[k];
    return {moment.centre_m,
            moment.attitude,
            moment.velocity_mps,
            moment.translation_j,
            moment.translation_j + moment.rotation_j,
            is_over ? status_after(fall->end) : BlockStatus::moving,
            true};
}

bool HandOver::is_over(double time_s) const {
    for (std::size_t f = 0; f < falls_.size(); ++f) {
        if (starts_s_[f] + falls_[f].duration_s > time_s) {
            return false;
        }
    }
    return true;
}

double HandOver::given_to_stem_j(std::size_t stem, double time_s) const {
    double sum_j = 0.0;
    for (std::size_t f = 0; f < falls_.size(); ++f) {
        for (const StemBlow& blow : falls_[f].blows) {
            sum_j += blow.stem == stem && starts_s_[f] + blow.after_s <= time_s ? blow.energy_j : 0.0;
        }
    }
    return sum_j;
}

std::vector<double> HandOver::packed() const {
    std::vector<double> numbers;
    const auto write = [&](double value) { numbers.push_back(value); };
    write(static_cast<double>(crossings_.size()));
    for (std::size_t f = 0; f < crossings_.size(); ++f) {
        HandedBlock block = crossings_[f].block;
        write(starts_s_[f]);
        write(static_cast<double>(block.number));
        write(block.on_ground ? 1.0 : 0.0);
        visit_block(write, block);
        write(static_cast<double>(crossings_[f].gone.size()));
        for (const std::uint32_t stem : crossings_[f].gone) {
            write(static_cast<double>(stem));
        }
    }
    return numbers;
}

bool HandOver::unpack(std::span<const double> numbers, const RockMass& mass) {
    std::size_t at = 0;
    bool whole = true;
    const auto next = [&] {
        whole = whole && at < numbers.size();
        return whole ? numbers[at++] : 0.0;
    };
    const auto read = [&](double& value) { value = next(); };
    /// A whole number below a limit; `whole` is false for any other.
    const auto count = [&](std::size_t limit) {
        const double value = next();
        whole = whole && value >= 0.0 && value < static_cast<double>(limit) && value == std::floor(value);
        return whole ? static_cast<std::uint32_t>(value) : 0U;
    };
    const std::size_t falls = count(fall_of_.size() + 1);
    if (!whole || (falls > 0 && site_ == nullptr)) {
        return false;
    }
    for (std::size_t f = 0; f < falls && whole; ++f) {
        Crossing crossing;
        starts_s_.push_back(next());
        crossing.block.number = count(fall_of_.size());
        crossing.block.on_ground = next() != 0.0;
        visit_block(read, crossing.block);
        for (std::uint32_t left = count(mass.stems().size() + 1); left > 0 && whole; --left) {
            crossing.gone.push_back(count(mass.stems().size()));
        }
        whole = whole && mass.blocks()[crossing.block.number].status == BlockStatus::handed;
        crossings_.push_back(std::move(crossing));
    }
    if (!whole || at != numbers.size()) {
        return false;
    }
    if (falls > 0) {
        follow_from(0);
    }
    for (std::size_t f = 0; f < falls_.size(); ++f) {
        const std::vector<StemBlow>& blows = falls_[f].blows;
        blows_done_[f] =
            static_cast<std::size_t>(std::count_if(blows.begin(), blows.end(), [&](const StemBlow& blow) {
                return starts_s_[f] + blow.after_s <= mass.time_s();
            }));
    }
    return true;
}

}  // namespace coupling::collapse
