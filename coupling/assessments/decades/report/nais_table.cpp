#include "coupling/assessments/decades/report/nais_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::decades {
namespace {

using config::joined;
using report::escaped;
using report::page_text;

/// Years of a table on paper.
constexpr std::size_t most_nais_years = 5;

using Criterion = std::pair<std::string, std::string>;  // hazard and criterion

/// Area times replicates by status.
using Weights = std::array<double, forest::nais_statuses>;

std::string status_cell(const Weights& weights) {
    constexpr std::array<const char*, forest::nais_statuses> letters{"B", "M", "I"};
    const auto commonest = std::max_element(weights.begin(), weights.end());
    const auto status = static_cast<std::size_t>(commonest - weights.begin());
    const double share = *commonest / (weights[0] + weights[1] + weights[2]);
    return joined("<span class=\"nais nais-", forest::name_of(static_cast<forest::NaisStatus>(status)), "\">",
                  page_text(letters[status]), "</span> <small>", report::fixed(100.0 * share, 0),
                  " %</small>");
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

std::string criterion_in_words(const Criterion& criterion, bool several_hazards) {
    const std::string name = criterion.second == whole_profile
                                 ? joined("<b>", page_text("All criteria together"), "</b>")
                                 : escaped(criterion.second);
    return several_hazards ? report::with_label(escaped(criterion.first), name) : name;
}

}  // namespace

std::string nais_table(const Names& names, std::span<const NaisCell> cells) {
    if (cells.empty()) {
        return "";
    }
    const std::vector<std::int32_t> years = shown_nais_years(cells);
    std::vector<Criterion> criteria;
    std::set<std::string> hazards;
    std::set<std::string> sources;
    std::map<std::pair<std::pair<std::size_t, std::int32_t>, Criterion>, Weights> weights;
    for (const NaisCell& cell : cells) {
        const Criterion criterion{cell.hazard, cell.criterion};
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
    std::vector<std::string> head{page_text("Criterion")};
    for (const std::int32_t year : years) {
        head.push_back(page_text("year {year}", {{"year", std::to_string(year)}}));
    }
    std::vector<std::string> from;
    for (const std::string& source : sources) {
        from.push_back(escaped(report::message_text(source)));
    }
    report::HtmlTable table{page_text("Target profiles over time. Profile: {profiles}.",
                                      {{"profiles", report::join_with_semicolons(from)}}),
                            head};
    for (std::size_t course = 0; course < names.courses(); ++course) {
        table.group(escaped(look_of(names, course).title().empty() ? names.course_name(course)
                                                                   : look_of(names, course).title()));
        for (const Criterion& criterion : criteria) {
            std::vector<std::string> row{criterion_in_words(criterion, hazards.size() > 1)};
            for (const std::int32_t year : years) {
                const auto found = weights.find({{course, year}, criterion});
                row.push_back(found == weights.end() ? "–" : status_cell(found->second));
            }
            table.row(row);
        }
    }
    return joined("<section class=\"card\"><p>",
                  page_text("<span class=\"nais nais-below\">B</span> below the minimum, <span class=\"nais "
                            "nais-minimal\">M</span> at least the minimum, <span class=\"nais "
                            "nais-ideal\">I</span> ideal. Each cell has the commonest status and its share "
                            "of area and replicates; nais.csv has every stand and year."),
                  "</p>\n", table.html(), "</section>\n");
}

}  // namespace coupling::decades
