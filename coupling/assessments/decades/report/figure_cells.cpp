#include "coupling/assessments/decades/report/figure_cells.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/report/series.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::decades {

using config::joined;
using report::fixed;
using report::PageFields;

std::string interval_cell(const std::string& value, const std::string& low, const std::string& high) {
    return joined(value, " ", report::element("small", {}, joined("(", low, " – ", high, ")")));
}

std::string band_cell(const Band& band, int decimals) {
    return band.has_interval() ? interval_cell(fixed(band.mean, decimals), fixed(band.low, decimals),
                                               fixed(band.high, decimals))
                               : fixed(band.mean, decimals);
}

std::string band_cell(const std::optional<OverReplicates>& value, int decimals) {
    return value ? band_cell(value->band, decimals) : "–";
}

std::string protection_cell(const Band& band) {
    return band.has_interval() && says_nothing(band.low, band.high) ? "–" : band_cell(band, 1);
}

std::string protection_cell(const std::optional<OverReplicates>& value) {
    return value ? protection_cell(value->band) : "–";
}

std::string amount_cell(const Band& band) {
    return band.has_interval()
               ? interval_cell(report::three_digits(band.mean), report::three_digits(band.low),
                               report::three_digits(band.high))
               : report::three_digits(band.mean);
}

PageFields difference_cell(const std::optional<PairedDifference>& difference, int decimals) {
    const bool has_interval = difference && !std::isnan(difference->low);
    if (!has_interval) {
        return {{"minus_first", difference ? fixed(difference->mean, decimals) : "–"}, {"open", false}};
    }
    const auto needed = replicates_needed(difference->mean, difference->deviation);
    return {{"minus_first", interval_cell(fixed(difference->mean, decimals), fixed(difference->low, decimals),
                                          fixed(difference->high, decimals))},
            {"open", difference->low <= 0.0 && difference->high >= 0.0},
            {"needed",
             needed ? std::optional{PageFields{{"replicates", std::to_string(*needed)}}} : std::nullopt}};
}

PageFields difference_cell(const std::optional<PairedDifference>& difference) {
    constexpr int most_decimals = 9;
    const double size = difference ? std::abs(difference->mean) : 0.0;
    const int decimals =
        size > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, most_decimals) : 0;
    return difference_cell(difference, decimals);
}

std::vector<std::int32_t> three_of(const std::vector<std::int32_t>& years) {
    std::vector<std::int32_t> chosen;
    for (const std::int32_t year : {years.front(), years[years.size() / 2], years.back()}) {
        if (chosen.empty() || chosen.back() != year) {
            chosen.push_back(year);
        }
    }
    return chosen;
}

PageFields row_of_course(const std::string& title, const std::vector<std::string>& cells) {
    std::vector<PageFields> rows;
    for (const std::string& cell : cells) {
        rows.push_back({{"cell", cell}});
    }
    return {{"course", title}, {"cells", rows}};
}

PageFields figure_over_years(const Names& names, const Series& series, const std::string& name,
                             const std::vector<std::int32_t>& years, int decimals) {
    std::vector<PageFields> rows;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        std::vector<std::string> cells;
        for (const std::int32_t year : years) {
            const auto value = over_replicates(series, course, year);
            cells.push_back(series.quantity.starts_with("protection") ? protection_cell(value)
                                                                      : band_cell(value, decimals));
        }
        rows.push_back(row_of_course(look_of(names, course).title(), cells));
    }
    return {{"figure", name}, {"rows", rows}};
}

std::vector<PageFields> heads_of(const std::vector<std::int32_t>& years) {
    std::vector<PageFields> heads;
    for (const std::int32_t year : years) {
        heads.push_back({{"year", std::to_string(year)}});
    }
    return heads;
}

std::string breakable(const std::string& name) {
    std::string html;
    for (const char c : report::escaped(name)) {
        html += c;
        html += c == '_' ? report::element("wbr", {}) : "";
    }
    return html;
}

}  // namespace coupling::decades
