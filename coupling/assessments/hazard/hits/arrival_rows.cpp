#include "coupling/assessments/hazard/hits/arrival_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "config/text/numbers.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling::hazard::hits {
namespace {

Cover cover_in(std::string_view field, const OwnRows& rows) {
    if (field == name_of(Cover::bare)) {
        return Cover::bare;
    }
    if (field != name_of(Cover::forest)) {
        rows.refuse("a slope that is neither forest nor bare");
    }
    return Cover::forest;
}

double energy_in(std::string_view field, const OwnRows& rows) {
    std::string text{field};
    std::replace(text.begin(), text.end(), ',', '.');  // tables for Excel
    const std::optional<double> energy_kj = config::parse_number(text);
    if (!energy_kj) {
        rows.refuse("an energy that is no number");
    }
    return *energy_kj;
}

}  // namespace

void for_each_arrival(const std::filesystem::path& file, const Site& site, const BlockRows& blocks,
                      const std::function<void(const ArrivalRow&)>& take) {
    OwnRows rows{file, std::nullopt, config::ExitCode::data};
    const std::size_t rock_at = rows.column("rock");
    const std::size_t target_at = rows.column("target_id");
    const std::size_t cover_at = rows.column("cover");
    const std::size_t energy_at = rows.column("energy_kj");
    std::map<std::string, std::size_t, std::less<>> numbers;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        numbers.emplace(site.targets[i].id, i);
    }
    const auto rocks = static_cast<double>(site.rocks());
    while (rows.next()) {
        const auto target = numbers.find(rows.fields()[target_at]);
        const std::optional<double> rock = config::parse_number(std::string{rows.fields()[rock_at]});
        if (target == numbers.end() || !rock || *rock < 0.0 || *rock >= rocks || *rock != std::floor(*rock)) {
            rows.refuse("a rock or target that this scenario does not have");
        }
        const auto number = static_cast<std::uint64_t>(*rock);
        take({number, blocks.row_of(number), target->second, cover_in(rows.fields()[cover_at], rows),
              energy_in(rows.fields()[energy_at], rows)});
    }
}

}  // namespace coupling::hazard::hits
