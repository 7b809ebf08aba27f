#include <algorithm>
#include <optional>

#include "coupling/assessments/today/arrival_breakdown.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

/// What arrives at a target from a part of the rocks, or on a part of its line.
template <class Part>
struct ArrivalsOf {
    const rockfall::Target& target;
    const Part& part;
    Cover cover;
    ArrivalFigures figures;
    std::optional<ProtectionEffect> effect;  ///< in rows with forest, of enough rocks
};

/// The columns of a part among those of all arrivals.
template <class Part>
TableOf<ArrivalsOf<Part>> table_of(const char* file, const char* sentence, const char* row,
                                   const ColumnsOf<Part>& before, const ColumnsOf<Part>& after) {
    const auto of_part = [](const auto& of) -> const Part& { return of.part; };
    return {file,
            sentence,
            row,
            {{before, of_part},
             {target_columns(),
              [](const auto& of) {
                  return TargetName{of.target.id, of.target.name};
              }},
             {after, of_part},
             {cover_column(), [](const auto& of) { return name_of(of.cover); }},
             {arrival_columns(), [](const auto& of) { return &of.figures; }},
             {protection_effect_columns(), [](const auto& of) { return of.effect; }}}};
}

TableOf<ArrivalsOf<Stretch>> along_lines() {
    constexpr const char* cut = "stretches of 10 m";
    return table_of<Stretch>(
        "along_lines.csv",
        "What arrives on each stretch of 10 m of a line: share of rocks, energy, speed and height.",
        "a stretch of 10 m of a line on one slope", {},
        {{"from_m", 1, "where the stretch begins, in plan along the line from its first vertex", cut,
          &Stretch::from_m},
         {"to_m", 1, "where it ends", cut, &Stretch::to_m},
         {"x_m", 2, "easting of the middle of the stretch", "input targets.file",
          [](const Stretch& stretch) { return stretch.middle_m.x(); }},
         {"y_m", 2, "northing of the middle of the stretch", "input targets.file",
          [](const Stretch& stretch) { return stretch.middle_m.y(); }}});
}

TableOf<ArrivalsOf<ReleaseGroup>> by_zone() {
    return table_of<ReleaseGroup>("by_zone.csv", "What arrives at each target from each release zone.",
                                  "a release zone, a target and a slope",
                                  {"zone", "release zone; shares are those of the rocks that it released",
                                   "input release.source", &ReleaseGroup::zone},
                                  {});
}

TableOf<ArrivalsOf<ReleaseGroup>> by_size() {
    return table_of<ReleaseGroup>(
        "by_size.csv", "What arrives at each target by block size.",
        "a class of block size, a target and a slope",
        {{"diameter_low_m", 3, "smallest diameter of the class; shares are those of its rocks",
          &ReleaseGroup::smallest_m},
         {"diameter_high_m", 3, "largest diameter of the class", &ReleaseGroup::largest_m}},
        {});
}

/// A row for each slope on which rocks fell.
template <class Part>
void add_covers(auto& rows, const RunResults& results, std::size_t target, const Part& part,
                const rockfall::TargetTally& tally, std::uint64_t rocks) {
    const PairedCounts paired = paired_counts(tally);
    for (const Cover cover : covers_of(results)) {
        rows.add({results.site.targets[target], part, cover,
                  figures_of(tally.by_cover[index_of(cover)], rocks),
                  cover == Cover::forest && !too_few_for_protection(paired) ? protection_effect(paired)
                                                                            : std::nullopt});
    }
}

void add_groups(auto& rows, const RunResults& results, const std::vector<ReleaseGroup>& groups) {
    for (const ReleaseGroup& group : groups) {
        for (std::size_t target = 0; target < group.targets.size(); ++target) {
            add_covers(rows, results, target, group, group.targets[target], group.released);
        }
    }
}

}  // namespace

std::vector<TableLayout> breakdown_layouts() {
    return {along_lines(), by_zone(), by_size()};
}

void write_breakdown(const RunResults& results, const std::filesystem::path& folder,
                     std::vector<WrittenFile>& written) {
    const Breakdown& breakdown = results.breakdown;
    if (std::any_of(breakdown.lines.begin(), breakdown.lines.end(),
                    [](const AlongLine& line) { return !line.stretches.empty(); })) {
        written.push_back(along_lines().write(folder, [&](auto& rows) {
            for (const AlongLine& line : breakdown.lines) {
                for (const Stretch& stretch : line.stretches) {
                    add_covers(rows, results, line.target, stretch, stretch.tally, results.rocks);
                }
            }
        }));
    }
    if (!breakdown.zones.empty()) {
        written.push_back(
            by_zone().write(folder, [&](auto& rows) { add_groups(rows, results, breakdown.zones); }));
    }
    if (!breakdown.sizes.empty()) {
        written.push_back(
            by_size().write(folder, [&](auto& rows) { add_groups(rows, results, breakdown.sizes); }));
    }
}

}  // namespace coupling
