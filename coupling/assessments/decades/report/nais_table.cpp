#include "coupling/assessments/decades/report/nais_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "coupling/assessments/decades/report/figure_cells.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using report::page_text;
using report::PageFields;

/// Years of a table on paper.
constexpr std::size_t most_nais_years = 5;

using CriterionInTable = std::pair<std::string, std::string>;  // hazard and criterion

/// Area times replicates by status.
using Weights = std::array<double, forest::nais_statuses>;

/// The commonest status with its share.
PageFields status_fields(const Weights& weights) {
    constexpr std::array<const char*, forest::nais_statuses> letters{"B", "M", "I"};
    const auto commonest = std::max_element(weights.begin(), weights.end());
    const auto status = static_cast<std::size_t>(commonest - weights.begin());
    const double share = *commonest / (weights[0] + weights[1] + weights[2]);
    return {{"status", std::string{forest::name_of(static_cast<forest::NaisStatus>(status))}},
            {"letter", page_text(letters[status])},
            {"share", report::fixed(100.0 * share, 0)}};
}

std::vector<std::int32_t> shown_nais_years(std::span<const NaisCell> cells) {
    std::set<std::int32_t> known;
    for (const NaisCell& cell : cells) {
        known.insert(cell.year);
    }
    const std::vector<std::int32_t> years{known.begin(), known.end()};
    std::vector<std::int32_t> shown;
    const std::size_t count = std::min(most_nais_years, years.size());
    for (std::size_t i = 0; i < count; ++i) {
        shown.push_back(count == 1 ? years.front() : years[i * (years.size() - 1) / (count - 1)]);
    }
    return shown;
}

std::string criterion_in_words(const CriterionInTable& criterion, bool several_hazards) {
    const std::string name =
        criterion.second == whole_profile ? page_text("All criteria together") : criterion.second;
    return several_hazards ? report::with_label(criterion.first, name) : name;
}

}  // namespace

std::string nais_table(const Names& names, std::span<const NaisCell> cells) {
    if (cells.empty()) {
        return "";
    }
    const std::vector<std::int32_t> years = shown_nais_years(cells);
    std::vector<CriterionInTable> criteria;
    std::set<std::string> hazards;
    std::set<std::string> sources;
    std::map<std::pair<std::pair<std::size_t, std::int32_t>, CriterionInTable>, Weights> weights;
    for (const NaisCell& cell : cells) {
        const CriterionInTable criterion{cell.hazard, cell.criterion};
        if (std::find(criteria.begin(), criteria.end(), criterion) == criteria.end()) {
            criteria.push_back(criterion);
        }
        hazards.insert(cell.hazard);
        sources.insert(cell.source);
        Weights& sum = weights[{{cell.course, cell.year}, criterion}];
        for (std::size_t s = 0; s < sum.size(); ++s) {
            sum[s] += cell.area_ha * static_cast<double>(cell.replicates[s]);
        }
    }
    std::vector<std::string> profiles;
    for (const std::string& source : sources) {
        profiles.push_back(report::message_text(source));
    }
    std::vector<PageFields> courses;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        std::vector<PageFields> rows;
        for (const CriterionInTable& criterion : criteria) {
            std::vector<PageFields> row;
            for (const std::int32_t year : years) {
                const auto found = weights.find({{course, year}, criterion});
                row.push_back(
                    {{"known",
                      found == weights.end() ? std::nullopt : std::optional{status_fields(found->second)}}});
            }
            rows.push_back({{"is_whole", criterion.second == whole_profile},
                            {"criterion", criterion_in_words(criterion, hazards.size() > 1)},
                            {"cells", row}});
        }
        const std::string title = look_of(names, course).title();
        courses.push_back(
            {{"course", title.empty() ? names.course_name(course) : title}, {"criteria", rows}});
    }
    return report::filled_template("nais_table.html", {{"profiles", report::join_with_semicolons(profiles)},
                                                       {"years", heads_of(years)},
                                                       {"columns", std::to_string(years.size() + 1)},
                                                       {"courses", courses}});
}

}  // namespace coupling::decades
