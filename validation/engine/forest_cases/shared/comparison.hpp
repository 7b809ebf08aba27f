#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"
#include "forest/stand/species.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/case/comparison.hpp"
#include "validation/engine/slope/recipe.hpp"

namespace coupling::validation::forest_cases {

/// What the reference of forest_light looked at.
struct LightSettings {
    std::uint64_t first_month = 1;
    std::uint64_t last_month = 12;
    double least_angle_deg = 10.0;
};

/// The settings of case.ini beside [case], each for one kind.
struct Settings {
    LightSettings light;
};

/// Declares the settings that a kind has.
void declare(config::Options& options, Settings& settings, CaseKind kind);

/// Reads the files of a case of the forest. Throws InputError (file, data) for what is missing or not
/// plausible.
Comparison read(CaseKind kind, const CaseFiles& files, const Settings& settings);

Comparison read_production(const CaseFiles& files);
Comparison read_light(const CaseFiles& files, const LightSettings& settings);

/// "piab" of a species: its code as names of figures have it.
std::string code_in_figures(const forest::Species& species);

/// Does pieces 0, 1, ... of some work on several threads. Each must write to a place of its own. Throws
/// Interrupted between pieces.
template <class Piece>
void each_piece(const Work& work, std::size_t pieces, const Piece& piece) {
    FirstError error;
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.threads)
    for (std::size_t i = 0; i < pieces; ++i) {
        error.guard([&] {
            if (InterruptGuard::requested()) {
                throw Interrupted{};
            }
            piece(i);
#pragma omp critical(pieces_done)
            work.done(1);
        });
    }
    error.rethrow();
}

}  // namespace coupling::validation::forest_cases
