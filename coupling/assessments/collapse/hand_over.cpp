#include "coupling/assessments/collapse/hand_over.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Those of a return.
template <class Visit, class AnyReturn>
void visit_return(Visit& visit, AnyReturn& back) {
    visit(back.time_s);
    visit(back.taken.motion_j);
    visit(back.taken.lift_m);
    visit(back.taken.strain_j);
}

/// A light block that a heavy one strikes leaves with up to about twice the speed of the point that strikes
/// it [-].
constexpr double struck_by_speed = 2.0;

double point_speed_of(const rockfall::solids::Solid& solid, const SeenBlock& seen) {
    return point_speed_mps(solid, seen.velocity_mps.norm(), seen.energy_j - seen.translation_j);
}

}  // namespace

/// As many steps of a guard as come nearest to its time, then as many guards.
GuardPlan guards_for(std::uint64_t steps_of_look) {
    const std::uint64_t steps =
        std::max<std::uint64_t>(1, (2 * steps_of_look + guards_of_look) / (2 * guards_of_look));
    return {std::max<std::uint64_t>(1, (2 * steps_of_look + steps - 1) / (2 * steps)), steps};
}

HandOver::HandOver(const CollapseScenario& scenario, const CollapseSite& site, double guard_s,
                   std::uint64_t guards, rockfall::rock_mass::ParallelFor parallel)
    : site_{scenario.settings.hand_over == HandOverTo::single_blocks ? &site : nullptr},
      settings_{&scenario.scenario.rockfall.fall, scenario.scenario.run.seed, guard_s},
      look_s_{static_cast<double>(guards) * guard_s},
      after_s_{scenario.settings.hand_over_after_s},
      parallel_{std::move(parallel)},
      fall_of_(site.count.free, -1) {}

void HandOver::load_stems(RockMass& mass) {
    for (std::size_t f = 0; f < falls_.size(); ++f) {
        const std::vector<StemBlow>& blows = falls_[f].blows;
        for (std::size_t& k = blows_done_[f];
             k < blows.size() && starts_s_[f] + blows[k].after_s <= mass.time_s(); ++k) {
            mass.load_stem(blows[k].stem, blows[k].energy_j, blows[k].broken);
        }
    }
}

/// Where all blocks are, and how far they go as they move now.
std::vector<BlockOnWay> HandOver::as_all_move(const RockMass& mass, double time_s) const {
    std::vector<BlockOnWay> all;
    for (std::size_t i = 0; i < mass.blocks().size(); ++i) {
        const SeenBlock seen = this->seen(mass, i);
        const bool is_there = seen.status != BlockStatus::left;
        const rockfall::solids::Solid* solid = is_there ? &site_->blocks[i].solid : nullptr;
        const double way_m = is_there && seen.status == BlockStatus::moving
                                 ? way_within_m(point_speed_of(*solid, seen), time_s)
                                 : 0.0;
        all.push_back({solid, seen.centre_m, seen.attitude, way_m, is_there && seen.is_handed});
    }
    return all;
}

/// Where all blocks are, and how far they may go: each as its energy allows, and those of the mass also as
/// far as the fastest of them sends a light one that it strikes. Those that come back now are of the mass.
std::vector<BlockOnWay> HandOver::after_any_blow(const RockMass& mass, double time_s,
                                                 std::span<const std::uint8_t> comes_back) const {
    std::vector<BlockOnWay> all;
    std::vector<std::size_t> may_be_hit;
    double fastest_mps = 0.0;
    for (std::size_t i = 0; i < mass.blocks().size(); ++i) {
        const rockfall::solids::Solid& solid = site_->blocks[i].solid;
        const SeenBlock seen = this->seen(mass, i);
        BlockOnWay block{&solid, seen.centre_m, seen.attitude, 0.0, seen.is_handed && comes_back[i] == 0};
        if (seen.status == BlockStatus::left) {
            block = {};
        } else if (seen.status == BlockStatus::moving) {
            block.way_m = way_within_m(fastest_point_mps(solid, seen.energy_j), time_s);
            fastest_mps = block.is_single ? fastest_mps : std::max(fastest_mps, point_speed_of(solid, seen));
        }
        if (!block.is_single && (seen.status == BlockStatus::moving || seen.status == BlockStatus::asleep)) {
            may_be_hit.push_back(i);
        }
        all.push_back(block);
    }
    for (const std::size_t i : may_be_hit) {
        all[i].way_m = std::max(all[i].way_m, way_within_m(struck_by_speed * fastest_mps, time_s));
    }
    return all;
}

/// Whether it may come over terrain that was dug out.
bool HandOver::may_reach_dug(const BlockOnWay& block) const {
    return !site_->handed_ground->is_untouched(site_->ground, block.centre_m.head<2>(),
                                               block.solid->bounding_radius_m + block.way_m);
}

/// Falls of which the block comes back into the mass now, in the order of their blocks. What comes back may
/// strike others, so blocks near to those come back as well.
std::vector<std::size_t> HandOver::falls_to_end(const RockMass& mass) const {
    std::vector<std::uint8_t> comes_back(mass.blocks().size(), 0);
    for (bool is_first = true, more = true; more; is_first = false) {
        const std::vector<BlockOnWay> all = after_any_blow(mass, settings_.moment_s, comes_back);
        const std::vector<std::uint8_t> near = singles_near_others(all);
        more = false;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool dug = is_first && all[i].is_single && all[i].way_m > 0.0 && may_reach_dug(all[i]);
            if (near[i] != 0 || dug) {
                comes_back[i] = 1;
                more = true;
            }
        }
    }
    std::vector<std::size_t> falls;
    for (std::size_t i = 0; i < comes_back.size(); ++i) {
        if (comes_back[i] != 0) {
            falls.push_back(static_cast<std::size_t>(fall_of_[i]));
        }
    }
    return falls;
}

void HandOver::guard(RockMass& mass) {
    load_stems(mass);
    if (std::all_of(fall_of_.begin(), fall_of_.end(), [](std::int32_t fall) { return fall < 0; })) {
        return;
    }
    const std::vector<std::size_t> ending = falls_to_end(mass);
    for (const std::size_t f : ending) {
        returns_[f] = Return{mass.time_s(), {}};
        fall_of_[crossings_[f].block.number] = -1;
    }
    follow_again(ending);
    std::vector<rockfall::rock_mass::BlockBack> backs;
    for (const std::size_t f : ending) {
        backs.push_back(falls_[f].last);
    }
    const std::vector<rockfall::rock_mass::TakenBack> taken = mass.take_back(backs);
    for (std::size_t k = 0; k < ending.size(); ++k) {
        returns_[ending[k]]->taken = taken[k];
    }
}

void HandOver::look(RockMass& mass) {
    if (site_ == nullptr) {
        return;
    }
    std::vector<std::uint32_t> leaving = mass.lone_blocks(after_s_);
    if (!leaving.empty()) {
        std::vector<BlockOnWay> all = as_all_move(mass, look_s_);
        for (const std::uint32_t i : leaving) {
            all[i].is_single = true;
        }
        const std::vector<std::uint8_t> near = singles_near_others(all);
        std::erase_if(leaving, [&](std::uint32_t i) {
            return i >= site_->count.free || near[i] != 0 || may_reach_dug(all[i]);
        });
    }
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
        returns_.emplace_back();
    }
    follow_from(first);
}

void HandOver::follow_from(std::size_t first) {
    falls_.resize(crossings_.size());
    blows_done_.resize(crossings_.size(), 0);
    std::vector<std::size_t> falls;
    for (std::size_t f = first; f < crossings_.size(); ++f) {
        falls.push_back(f);
        fall_of_[crossings_[f].block.number] = returns_[f] ? -1 : static_cast<std::int32_t>(f);
    }
    follow_again(falls);
}

/// Side by side: a fall depends on its own crossing and the time of its return alone.
void HandOver::follow_again(std::span<const std::size_t> falls) {
    parallel_(falls.size(), [&](std::size_t k) {
        const std::size_t f = falls[k];
        const Crossing& crossing = crossings_[f];
        std::vector<std::uint8_t> gone(site_->handed_ground->stems().placed().size(), 0);
        for (const std::uint32_t stem : crossing.gone) {
            gone[stem] = 1;
        }
        falls_[f] = follow(
            *site_->handed_ground, settings_, crossing.block,
            std::make_shared<const rockfall::solids::Solid>(site_->blocks[crossing.block.number].solid),
            std::move(gone), falls_before(f),
            returns_[f] ? returns_[f]->time_s - starts_s_[f] : std::numeric_limits<double>::infinity());
    });
}

/// How often its block had left the mass before.
std::uint32_t HandOver::falls_before(std::size_t fall) const {
    return static_cast<std::uint32_t>(std::count_if(
        crossings_.begin(), crossings_.begin() + static_cast<std::ptrdiff_t>(fall),
        [&](const Crossing& other) { return other.block.number == crossings_[fall].block.number; }));
}

std::size_t HandOver::blocks() const {
    std::vector<std::uint32_t> numbers;
    for (const Crossing& crossing : crossings_) {
        numbers.push_back(crossing.block.number);
    }
    std::sort(numbers.begin(), numbers.end());
    return static_cast<std::size_t>(std::unique(numbers.begin(), numbers.end()) - numbers.begin());
}

std::size_t HandOver::returns() const {
    return static_cast<std::size_t>(
        std::count_if(returns_.begin(), returns_.end(), [](const auto& back) { return back.has_value(); }));
}

std::size_t HandOver::returns_of(std::size_t block) const {
    std::size_t count = 0;
    for (std::size_t f = 0; f < crossings_.size(); ++f) {
        count += crossings_[f].block.number == block && returns_[f] ? 1 : 0;
    }
    return count;
}

double HandOver::lift_given_j(std::size_t f, const RockMass& mass) const {
    if (!returns_[f]) {
        return 0.0;
    }
    const Block& block = mass.blocks()[crossings_[f].block.number];
    const double work_j = block.weight_n / block.mass_factor * returns_[f]->taken.lift_m;
    return work_j - (falls_[f].motion_end_j - returns_[f]->taken.motion_j);
}

bool HandOver::was_ever_single(std::size_t block) const {
    return std::any_of(crossings_.begin(), crossings_.end(),
                       [&](const Crossing& crossing) { return crossing.block.number == block; });
}

bool HandOver::was_single(std::size_t block, double time_s) const {
    for (std::size_t f = 0; f < crossings_.size(); ++f) {
        if (crossings_[f].block.number == block && starts_s_[f] <= time_s &&
            !(returns_[f] && returns_[f]->time_s <= time_s)) {
            return true;
        }
    }
    return false;
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
        if (!returns_[f] && starts_s_[f] + falls_[f].duration_s > time_s) {
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
        write(returns_[f] ? 1.0 : 0.0);
        if (returns_[f]) {
            visit_return(write, *returns_[f]);
        }
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
    const std::size_t falls = count(numbers.size() + 1);
    if (!whole || (falls > 0 && site_ == nullptr)) {
        return false;
    }
    std::vector<std::uint8_t> away(fall_of_.size(), 0);
    for (std::size_t f = 0; f < falls && whole; ++f) {
        Crossing crossing;
        starts_s_.push_back(next());
        crossing.block.number = count(fall_of_.size());
        crossing.block.on_ground = next() != 0.0;
        visit_block(read, crossing.block);
        returns_.emplace_back();
        if (count(2) == 1) {
            visit_return(read, returns_.back().emplace());
        }
        for (std::uint32_t left = count(mass.stems().size() + 1); left > 0 && whole; --left) {
            crossing.gone.push_back(count(mass.stems().size()));
        }
        if (whole && !returns_.back()) {
            std::uint8_t& is_away = away[crossing.block.number];
            whole = is_away == 0 && mass.blocks()[crossing.block.number].status == BlockStatus::handed;
            is_away = 1;
        }
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
