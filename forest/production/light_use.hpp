#pragma once

namespace forest {

/// From absorbed light to dry matter.
struct LightUse {
    double dry_matter_gpmol = 24.0;  ///< per mol of carbon
    double photons_molpmj = 2.3;     ///< mol of photons per MJ of solar radiation
    double npp_share = 0.47;         ///< of GPP, the rest is respired [Landsberg & Waring 1997]

    /// Gross production [t/ha] of absorbed solar radiation [MJ/m2] at a quantum efficiency [mol/mol].
    [[nodiscard]] double gpp_tpha(double quantum_efficiency, double absorbed_mjpm2) const {
        constexpr double tpha_per_gpm2 = 0.01;
        return dry_matter_gpmol * photons_molpmj * quantum_efficiency * absorbed_mjpm2 * tpha_per_gpm2;
    }
};

}  // namespace forest
