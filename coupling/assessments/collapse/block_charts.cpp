#include <algorithm>
#include <functional>

#include "config/text/joined.hpp"
#include "coupling/assessments/collapse/block_series.hpp"
#include "coupling/assessments/collapse/side_views.hpp"
#include "coupling/results/report/chart.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::collapse {
namespace {

using config::joined;
using report::page_text;

std::string why(const SeriesBlock& block) {
    std::vector<std::string> reasons;
    for (const Chosen reason : block.reasons) {
        reasons.push_back(reason == Chosen::fastest    ? page_text("fastest")
                          : reason == Chosen::farthest ? page_text("farthest")
                                                       : page_text("median way"));
    }
    return report::join_with_commas(reasons);
}

/// Lines of the chosen blocks and, last, of the mean one.
class BlockChart {
public:
    BlockChart(const CollapseResults& results, const std::vector<SeriesBlock>& blocks)
        : results_{results}, blocks_{blocks} {}

    [[nodiscard]] std::string figure(
        const std::string& title, const std::string& axis, const std::string& caption,
        const std::function<std::optional<double>(const BlockMoment&)>& of_block,
        const std::function<std::optional<double>(const MeanMoment&)>& of_mean) const {
        const std::size_t frames = results_.record.rows.size();
        std::vector<std::vector<report::ChartPoint>> lines(blocks_.size() + 1);
        double high = 0.0, low = 0.0;
        for (std::size_t line = 0; line < lines.size(); ++line) {
            for (std::size_t frame = 0; frame < frames; ++frame) {
                const std::optional<double> value =
                    line < blocks_.size() ? of_block(moment_of(results_, blocks_[line].number, frame))
                                          : of_mean(mean_moment(results_, frame));
                if (value) {
                    high = std::max(high, *value);
                    low = std::min(low, *value);
                    lines[line].push_back({results_.record.rows[frame].time_s, *value});
                }
            }
        }
        report::Axis y = report::Axis::from_zero(axis, std::max(high, 1e-9));
        if (low < 0.0) {
            const double step = report::nice_step(std::max(high, -low) / 3.0);
            y.low = std::floor(low / step) * step;
            y.high = std::max(step, std::ceil(high / step) * step);
        }
        report::Chart chart{
            title, report::Axis::from_zero(page_text("Time, s"), results_.record.rows.back().time_s), y};
        for (std::size_t line = 0; line < lines.size(); ++line) {
            const bool is_mean = line == blocks_.size();
            const std::string style = is_mean ? "s5" : joined("s", std::to_string(line));
            chart.add_line(style, lines[line]);
            chart.add_name(style, is_mean ? page_text("mean of all blocks")
                                          : page_text("block {block}: {why}",
                                                      {{"block", std::to_string(blocks_[line].number)},
                                                       {"why", why(blocks_[line])}}));
        }
        return chart.figure(caption);
    }

private:
    const CollapseResults& results_;
    const std::vector<SeriesBlock>& blocks_;
};

/// Energies of the whole mass by the number of blocks.
std::string mean_energies(const CollapseResults& results) {
    struct Part {
        std::string name;
        double MeanMoment::*value;
        std::vector<report::ChartPoint> line{};
    };
    Part parts[]{{page_text("motion"), &MeanMoment::kinetic_j},
                 {page_text("friction"), &MeanMoment::friction_j},
                 {page_text("fracture"), &MeanMoment::fracture_j},
                 {page_text("strain"), &MeanMoment::strain_j}};
    double high = 1e-9;
    for (Part& part : parts) {
        for (std::size_t frame = 0; frame < results.record.rows.size(); ++frame) {
            const double value = mean_moment(results, frame).*part.value / j_per_mj;
            high = std::max(high, value);
            part.line.push_back({results.record.rows[frame].time_s, value});
        }
    }
    report::Chart chart{page_text("Energies of the mean block"),
                        report::Axis::from_zero(page_text("Time, s"), results.record.rows.back().time_s),
                        report::Axis::from_zero(page_text("Energy, MJ"), high)};
    for (std::size_t k = 0; k < std::size(parts); ++k) {
        const std::string style = joined("s", std::to_string(k));
        chart.add_line(style, parts[k].line);
        chart.add_name(style, parts[k].name);
    }
    return chart.figure(
        page_text("Sums of the whole mass by the number of blocks: motion and strain at the "
                  "time, friction and fracture so far."));
}

}  // namespace

std::optional<report::PageFields> block_charts(const CollapseResults& results) {
    const std::vector<SeriesBlock> blocks = chosen_blocks(results);
    if (blocks.empty()) {
        return std::nullopt;
    }
    const BlockChart chart{results, blocks};
    const std::string mean_by_number = page_text("The mean is the sum of all blocks by their number.");
    return report::PageFields{
        {"charts",
         joined(
             chart.figure(
                 page_text("Speed of blocks"), page_text("Speed, m/s"), page_text("The mean is by mass."),
                 [](const BlockMoment& m) { return m.speed_mps; },
                 [](const MeanMoment& m) { return m.speed_mps; }),
             chart.figure(
                 page_text("Acceleration of blocks"), page_text("Acceleration, m/s²"),
                 page_text("Change of the velocity from one time to the next, {window} s later, by the time "
                           "between: shorter blows are spread over it. The mean is by mass.",
                           {{"window", report::exact(results.scenario.settings.frame_s)}}),
                 [](const BlockMoment& m) { return m.acceleration_mps2; },
                 [](const MeanMoment& m) { return m.acceleration_mps2; }),
             chart.figure(
                 page_text("Displacement of blocks"), page_text("Distance from the start, m"),
                 page_text("The mean is by mass."), [](const BlockMoment& m) { return m.displacement_m; },
                 [](const MeanMoment& m) { return m.displacement_m; }),
             chart.figure(
                 page_text("Kinetic energy of blocks"), page_text("Energy, MJ"), mean_by_number,
                 [](const BlockMoment& m) { return m.kinetic_j / j_per_mj; },
                 [](const MeanMoment& m) { return m.kinetic_j / j_per_mj; }),
             chart.figure(
                 page_text("Energy that blocks gave up"), page_text("Energy, MJ"),
                 page_text(
                     "Released by the height that a block lost and not kinetic: taken by contacts, bonds, "
                     "ground and trees; below 0 where other blocks push it. The mean is the sum of all "
                     "blocks by their number."),
                 [](const BlockMoment& m) { return m.given_up_j() / j_per_mj; },
                 [](const MeanMoment& m) { return m.given_up_j / j_per_mj; }),
             mean_energies(results))}};
}

}  // namespace coupling::collapse
