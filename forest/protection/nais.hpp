#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "forest/inventory/tables.hpp"
#include "forest/protection/gaps.hpp"
#include "forest/protection/stand_indicators.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// What a target profile of the guideline NaiS (Frehner et al. 2005) may ask of a stand.
enum class NaisQuantity : std::uint8_t {
    stems_from,           ///< stems_from_N_cm, 1/ha
    gap,                  ///< gap_m: longest along the fall line
    cover,                ///< cover_percent
    regeneration_cover,   ///< regeneration_percent
    regeneration_stems,   ///< regeneration_pha
    slenderness,          ///< hd: height / diameter of the 100 thickest stems per hectare
    slender_stems,        ///< hd_above_90_percent of the stems from 12 cm
    crown_ratio,          ///< crown_ratio_percent of the 100 thickest
    logs,                 ///< logs_m3pha
    mixture_species,      ///< mixture_CODE_percent of the basal area
    mixture_conifers,     ///< mixture_conifers_percent
    mixture_broadleaves,  ///< mixture_broadleaves_percent
};

/// A criterion as a user names it.
struct NaisCriterion {
    std::string name;
    NaisQuantity quantity = NaisQuantity::gap;
    double dbh_from_cm = 0.0;  ///< of stems_from: a multiple of 4, where diameter classes begin
    SpeciesId species{};       ///< of mixture_species
    /// Whether less is worse; of a range both sides count.
    [[nodiscard]] bool wants_much() const {
        return quantity != NaisQuantity::gap && quantity != NaisQuantity::slenderness &&
               quantity != NaisQuantity::slender_stems;
    }
};

/// The criterion of a name; `stems_effective` stands for the stems from the diameter on that counts against
/// the rocks (`effective_cm`; 0: not known). Nothing for an unknown one.
std::optional<NaisCriterion> nais_criterion(std::string_view name, const SpeciesTable& species,
                                            double effective_cm);
/// All names, for messages.
std::string nais_criteria_in_words();

/// What a value must be: within [low, high].
struct NaisLimit {
    double low = 0.0;
    double high = 0.0;
    [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
};

/// "300" (at least, of gaps and slenderness at most), "10-90", ">=10", "<=80". Nothing for other texts.
std::optional<NaisLimit> nais_limit(std::string_view text, bool wants_much);

enum class NaisStatus : std::uint8_t { below, minimal, ideal };
inline constexpr std::size_t nais_statuses = 3;
std::string_view name_of(NaisStatus status);

/// Without an ideal the status is at most minimal.
NaisStatus status_of(double value, const NaisLimit& minimal, const std::optional<NaisLimit>& ideal);

/// A stand at the end of a year, as records have it; the shares of species come from `basal_area_m2pha`.
struct NaisStand {
    const StandFigures* stand = nullptr;
    const GapFigures* gaps = nullptr;
    const StandIndicators* indicators = nullptr;
    double basal_area_of_species = 0.0;  ///< [m2/ha] of the species or group that the criterion is about
};

/// The value that a criterion judges. Stands without trees have no mixture and no slenderness: NaN, which
/// holds no limit.
double nais_value(const NaisCriterion& criterion, const NaisStand& stand);

}  // namespace forest
