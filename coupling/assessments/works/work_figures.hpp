#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/inputs/works/work_record.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling {

/// What becomes of a rock that reaches a work.
enum class WorkOutcome : std::uint8_t {
    held,    ///< rests in front of a wall, on a roof, or in a dam or ditch and the strip above it
    over,    ///< passes over it: leaves over the downhill side
    beside,  ///< leaves over one of its ends; of a roof: over any side
    back,    ///< leaves that strip uphill and does not come again: rests above it, or goes around it
    broke,   ///< breaks through a wall
};
inline constexpr std::size_t work_outcomes = 5;

/// "held", "over", "beside", "back", "broke".
const char* name_of(WorkOutcome outcome);

/// A work on one slope. Each rock counts once: energy and height as it first comes to the work, the outcome
/// as it last leaves it. Outcomes add up to the rocks that reach it.
struct WorkFigures {
    std::uint32_t work = 0;
    rockfall::Cover cover = rockfall::Cover::bare;
    Share reached;                               ///< of all rocks that fell
    std::array<Share, work_outcomes> outcome{};  ///< of those that reached it
    NetQuantity energy_kj;                       ///< translation and rotation
    NetQuantity height_m;                        ///< of the rock's upper edge above the ground

    [[nodiscard]] const Share& at(WorkOutcome of) const { return outcome[static_cast<std::size_t>(of)]; }
};

/// Takes the rocks at works out of the crossings of a run: works stand behind `nets` nets in its index. Their
/// numbers begin at 0.
std::vector<NetRow> take_work_rows(std::vector<NetRow>& rows, std::size_t nets);

/// The outcome at a work of a rock on one slope, from its crossings in their order, at least one.
WorkOutcome outcome_at(const WorkRecord& work, std::span<const NetRow> of_rock);

/// The figures of all works on one slope, of which `rocks` rocks fell. `rows`: rock by rock, each in the
/// order of its way.
std::vector<WorkFigures> work_figures(std::span<const WorkRecord> works, std::span<const NetRow> rows,
                                      rockfall::Cover cover, std::uint64_t rocks);

/// Those of a run, slope by slope.
std::vector<WorkFigures> work_figures(const RunResults& results);

}  // namespace coupling
