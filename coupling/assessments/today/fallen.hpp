#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "coupling/assessments/today/row_tables.hpp"
#include "coupling/inputs/site_falls.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/output_folder.hpp"
#include "coupling/run/ranks.hpp"

namespace coupling {

/// What rocks leave: those of a whole run, or of a piece of it.
struct Fallen {
    rockfall::EnsembleTally total;
    std::array<std::unique_ptr<rockfall::CellHistograms>, rockfall::covers> histograms{};  ///< where wanted
    Checkpoint state{};
    std::unique_ptr<RowTables> tables{};  ///< open

    [[nodiscard]] std::array<rockfall::CellHistograms*, rockfall::covers> pointers() const {
        return {histograms[0].get(), histograms[1].get()};
    }
};

/// Lets the rocks of a run fall, and keeps what they leave in folders of parts.
class FallingRocks {
public:
    /// `hash`: of settings, inputs and version.
    FallingRocks(const Scenario& scenario, const Site& site, const SiteFalls& falls, std::string hash,
                 int threads);

    [[nodiscard]] Fallen none() const;
    /// What a folder of parts keeps of a run, or of a piece; its tables are open then. Throws InputError
    /// (settings) for parts of other settings.
    [[nodiscard]] Fallen kept_in(const std::filesystem::path& parts) const;

    struct Watch {
        std::function<void(std::uint64_t rocks)> fell;
        std::function<void()> kept = [] {};                    ///< after each part that is on the disk
        std::function<bool()> stopped = [] { return false; };  ///< whether another rank has failed
        bool keep_whole = false;                               ///< also what is whole after a short time
    };
    /// Goes on with these chunks. Throws Interrupted, FailedElsewhere.
    void fall(std::span<const rockfall::Chunk> chunks, const std::filesystem::path& parts, Fallen& fallen,
              const Watch& watch) const;

    /// Puts together what all pieces left; tables lie in `folder` then. Throws InputError for pieces of other
    /// settings (settings) or that are not finished (file).
    [[nodiscard]] Fallen joined(std::span<const std::filesystem::path> pieces,
                                std::span<const rockfall::Chunk> chunks,
                                const std::filesystem::path& folder) const;

private:
    void refuse_others(const std::filesystem::path& checkpoint) const;

    const Scenario& scenario_;
    const Site& site_;
    const SiteFalls& falls_;
    std::string hash_;
    int threads_;
};

}  // namespace coupling
