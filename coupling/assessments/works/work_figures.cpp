#include "coupling/assessments/works/work_figures.hpp"

#include <algorithm>
#include <iterator>

#include "config/units/constants.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {
namespace {

/// The side of the outline of a dam or a ditch that lies at a distance along it.
WorkSide side_at(const WorkRecord& work, double along_m) {
    std::size_t side = 0;
    while (side + 1 < work_sides && along_m > work.side_ends_m[side]) {
        ++side;
    }
    return static_cast<WorkSide>(side);
}

}  // namespace

const char* name_of(WorkOutcome outcome) {
    constexpr std::array<const char*, work_outcomes> names{"held", "over", "beside", "back", "broke"};
    return names[static_cast<std::size_t>(outcome)];
}

std::vector<NetRow> take_work_rows(std::vector<NetRow>& rows, std::size_t nets) {
    std::vector<NetRow> of_works;
    const auto is_of_work = [&](const NetRow& row) { return row.crossing.net >= nets; };
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(of_works), is_of_work);
    std::erase_if(rows, is_of_work);
    for (NetRow& row : of_works) {
        row.crossing.net -= static_cast<std::uint32_t>(nets);
    }
    return of_works;
}

WorkOutcome outcome_at(const WorkRecord& work, std::span<const NetRow> of_rock) {
    const NetRow& last = of_rock.back();
    if (work.kind == WorkKind::wall) {
        switch (last.crossing.outcome) {
            case rockfall::NetOutcome::held:
                return WorkOutcome::held;
            case rockfall::NetOutcome::broke:
                return WorkOutcome::broke;
            default:
                return WorkOutcome::over;
        }
    }
    // Each crossing of a closed outline leads in or out; rocks start outside.
    if (of_rock.size() % 2 == 1) {
        return WorkOutcome::held;
    }
    if (work.kind == WorkKind::gallery) {
        return WorkOutcome::beside;
    }
    switch (side_at(work, static_cast<double>(last.crossing.along_m))) {
        case WorkSide::uphill:
            return WorkOutcome::back;
        case WorkSide::downhill:
            return WorkOutcome::over;
        default:
            return WorkOutcome::beside;
    }
}

std::vector<WorkFigures> work_figures(std::span<const WorkRecord> works, std::span<const NetRow> rows,
                                      rockfall::Cover cover, std::uint64_t rocks) {
    std::vector<WorkFigures> all;
    for (std::uint32_t number = 0; number < works.size(); ++number) {
        std::vector<NetRow> at_work;
        std::copy_if(rows.begin(), rows.end(), std::back_inserter(at_work),
                     [&](const NetRow& row) { return row.cover == cover && row.crossing.net == number; });
        std::vector<double> energies_kj;
        std::vector<double> heights_m;
        std::array<std::uint64_t, work_outcomes> outcomes{};
        for (auto first = at_work.begin(); first != at_work.end();) {
            const auto last = std::find_if(first, at_work.end(),
                                           [&](const NetRow& row) { return row.rock != first->rock; });
            energies_kj.push_back(static_cast<double>(first->crossing.energy_j) / config::j_per_kj);
            heights_m.push_back(static_cast<double>(first->crossing.height_m) +
                                static_cast<double>(first->crossing.radius_m));
            ++outcomes[static_cast<std::size_t>(outcome_at(works[number], {first, last}))];
            first = last;
        }
        WorkFigures& figures = all.emplace_back();
        figures.work = number;
        figures.cover = cover;
        figures.reached = share_of(energies_kj.size(), rocks);
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            figures.outcome[i] = share_of(outcomes[i], energies_kj.size());
        }
        figures.energy_kj = net_quantity_of(std::move(energies_kj));
        figures.height_m = net_quantity_of(std::move(heights_m));
    }
    return all;
}

std::vector<WorkFigures> work_figures(const RunResults& results) {
    std::vector<WorkFigures> all;
    for (const Cover cover : covers_of(results)) {
        const std::vector<WorkFigures> of_slope = work_figures(results.site.works, results.work_rows, cover,
                                                               results.tally.runs[index_of(cover)].rocks);
        all.insert(all.end(), of_slope.begin(), of_slope.end());
    }
    return all;
}

}  // namespace coupling
