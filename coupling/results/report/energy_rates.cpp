#include "coupling/results/report/energy_rates.hpp"

#include "config/text/joined.hpp"
#include "coupling/results/figures/effect_words.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string rate_text(const Share& share) {
    const std::string interval = page_text("{low} to {high}", {{"low", rate_per_1000(share.interval.low)},
                                                               {"high", rate_per_1000(share.interval.high)}});
    return joined(rate_per_1000(share.value), " ",
                  element("span", {{"class", "soft"}}, joined("(", interval, ")")));
}

}  // namespace

std::string energy_rates_table(const std::string& first_head, std::span<const EnergyRates> rows) {
    if (rows.empty()) {
        return "";
    }
    std::vector<std::string> head{first_head};
    for (std::size_t i = 0; i < rockfall::counted_energies_j.size(); ++i) {
        head.push_back(page_text("above {energy_kj} kJ", {{"energy_kj", kj_text(i)}}));
    }
    HtmlTable table{
        page_text("Rocks above an energy, per 1000 rocks released; in brackets the 95 % interval. Unlike a "
                  "mean or a percentile of those that arrive, this counts the rocks that are stopped too."),
        head};
    for (const EnergyRates& row : rows) {
        std::vector<std::string> cells{row.name};
        for (const Share& share : row.above) {
            cells.push_back(rate_text(share));
        }
        table.row(cells);
    }
    return table.html();
}

}  // namespace coupling::report
