#include "forest/protection/nais.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "config/text/numbers.hpp"

namespace forest {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

constexpr std::array<std::pair<std::string_view, NaisQuantity>, 10> plain_names{{
    {"gap_m", NaisQuantity::gap},
    {"cover_percent", NaisQuantity::cover},
    {"regeneration_percent", NaisQuantity::regeneration_cover},
    {"regeneration_pha", NaisQuantity::regeneration_stems},
    {"hd", NaisQuantity::slenderness},
    {"hd_above_90_percent", NaisQuantity::slender_stems},
    {"crown_ratio_percent", NaisQuantity::crown_ratio},
    {"logs_m3pha", NaisQuantity::logs},
    {"mixture_conifers_percent", NaisQuantity::mixture_conifers},
    {"mixture_broadleaves_percent", NaisQuantity::mixture_broadleaves},
}};

/// What stands between a beginning and an end; nothing if these are not there.
std::optional<std::string_view> between(std::string_view text, std::string_view begin, std::string_view end) {
    if (text.size() <= begin.size() + end.size() || !text.starts_with(begin) || !text.ends_with(end)) {
        return std::nullopt;
    }
    return text.substr(begin.size(), text.size() - begin.size() - end.size());
}

std::optional<NaisCriterion> stems_from(std::string_view name, double dbh_cm) {
    const double classes = dbh_cm / dbh_class_cm;
    const bool is_border =
        classes == std::floor(classes) && classes >= 1.0 && classes < static_cast<double>(dbh_classes);
    return is_border ? std::optional{NaisCriterion{std::string{name}, NaisQuantity::stems_from, dbh_cm, {}}}
                     : std::nullopt;
}

}  // namespace

std::optional<NaisCriterion> nais_criterion(std::string_view name, const SpeciesTable& species,
                                            double effective_cm) {
    if (name == "stems_effective") {
        return stems_from(name, effective_cm);
    }
    if (const auto number = between(name, "stems_from_", "_cm")) {
        const auto dbh_cm = config::parse_number(std::string{*number});
        return dbh_cm ? stems_from(name, *dbh_cm) : std::nullopt;
    }
    for (const auto& [known, quantity] : plain_names) {
        if (name == known) {
            return NaisCriterion{std::string{name}, quantity, 0.0, {}};
        }
    }
    if (const auto code = between(name, "mixture_", "_percent")) {
        if (const auto found = species.find(*code)) {
            return NaisCriterion{std::string{name}, NaisQuantity::mixture_species, 0.0, *found};
        }
    }
    return std::nullopt;
}

std::string nais_criteria_in_words() {
    std::string text = "stems_from_N_cm (N a multiple of 4), stems_effective, mixture_CODE_percent";
    for (const auto& [name, quantity] : plain_names) {
        text.append(", ").append(name);
    }
    return text;
}

std::optional<NaisLimit> nais_limit(std::string_view text, bool wants_much) {
    const auto number = [](std::string_view part) {
        const auto value = config::parse_number(std::string{part});
        return value && *value >= 0.0 ? value : std::nullopt;
    };
    if (text.starts_with(">=")) {
        const auto low = number(text.substr(2));
        return low ? std::optional{NaisLimit{*low, endless}} : std::nullopt;
    }
    if (text.starts_with("<=")) {
        const auto high = number(text.substr(2));
        return high ? std::optional{NaisLimit{-endless, *high}} : std::nullopt;
    }
    if (const auto dash = text.find('-', 1); dash != std::string_view::npos && !text.empty()) {
        const auto low = number(text.substr(0, dash));
        const auto high = number(text.substr(dash + 1));
        return low && high && *low <= *high ? std::optional{NaisLimit{*low, *high}} : std::nullopt;
    }
    const auto value = number(text);
    if (!value) {
        return std::nullopt;
    }
    return wants_much ? NaisLimit{*value, endless} : NaisLimit{-endless, *value};
}

std::string_view name_of(NaisStatus status) {
    constexpr std::array<std::string_view, nais_statuses> names{"below", "minimal", "ideal"};
    return names[static_cast<std::size_t>(status)];
}

NaisStatus status_of(double value, const NaisLimit& minimal, const std::optional<NaisLimit>& ideal) {
    if (!minimal.holds(value)) {
        return NaisStatus::below;
    }
    return ideal && ideal->holds(value) ? NaisStatus::ideal : NaisStatus::minimal;
}

double nais_value(const NaisCriterion& criterion, const NaisStand& stand) {
    switch (criterion.quantity) {
        case NaisQuantity::stems_from: {
            const auto& classes = stand.stand->stems_pha_by_class;
            const auto first = static_cast<std::ptrdiff_t>(dbh_class_of(criterion.dbh_from_cm));
            return std::accumulate(classes.begin() + first, classes.end(), 0.0);
        }
        case NaisQuantity::gap:
            return stand.gaps->max_m;
        case NaisQuantity::cover:
            return stand.indicators->cover_percent;
        case NaisQuantity::regeneration_cover:
            return stand.indicators->regeneration_percent;
        case NaisQuantity::regeneration_stems:
            return stand.indicators->regeneration_pha;
        case NaisQuantity::slenderness:
            return stand.indicators->slenderness;
        case NaisQuantity::slender_stems:
            return stand.indicators->slender_percent;
        case NaisQuantity::crown_ratio:
            return stand.indicators->crown_ratio_percent;
        case NaisQuantity::logs:
            return stand.indicators->logs_m3pha;
        case NaisQuantity::mixture_species:
        case NaisQuantity::mixture_conifers:
        case NaisQuantity::mixture_broadleaves:
            break;
    }
    return 100.0 * stand.basal_area_of_species / stand.stand->basal_area_m2pha;
}

}  // namespace forest
