#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/decades/records.hpp"
#include "coupling/exchange/yearly_rockfall.hpp"

namespace coupling::decades {

/// The part files of a run in a folder that threads, ranks and shards may share.
class Parts {
public:
    /// `hash` is that of settings, inputs and version.
    Parts(std::filesystem::path folder, std::string hash)
        : folder_{std::move(folder)}, hash_{std::move(hash)} {}

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Whether anything was kept.
    [[nodiscard]] bool any() const;
    /// Keeps a member that is through. Until the first part there is nothing to go on from, and an
    /// interrupted run leaves nothing behind. From any thread; throws config::InputError (file).
    void keep(const MemberYears& years) const;
    /// What a member left; nothing if it is not through. Throws config::InputError (file) if its part is
    /// damaged or of other settings.
    [[nodiscard]] std::optional<MemberYears> read(const Member& member) const;

    /// The same of a block of years over the bare slope (bare_falls.hpp).
    void keep_bare(std::uint32_t replicate, std::size_t block,
                   std::span<const exchange::BareYear> years) const;
    [[nodiscard]] bool has_bare(std::uint32_t replicate, std::size_t block) const;
    [[nodiscard]] std::vector<exchange::BareYear> read_bare(std::uint32_t replicate, std::size_t block) const;

private:
    [[nodiscard]] std::filesystem::path of(const Member& member) const;
    [[nodiscard]] std::filesystem::path of_bare(std::uint32_t replicate, std::size_t block) const;

    std::filesystem::path folder_;
    std::string hash_;
    mutable std::mutex mutex_;  ///< one part is written at a time
};

}  // namespace coupling::decades
