#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/exchange/bare_year.hpp"
#include "coupling/results/disk/byte_archive.hpp"

namespace coupling::decades {

/// The part files of a run in a folder that threads, ranks and shards may share.
class Parts {
public:
    /// `hash` is that of settings, inputs and version; `remedy` what a message advises where a part cannot be
    /// used.
    Parts(std::filesystem::path folder, std::string hash, std::string remedy = own_part_remedy)
        : folder_{std::move(folder)}, hash_{std::move(hash)}, remedy_{std::move(remedy)} {}

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Whether anything was kept.
    [[nodiscard]] bool any() const;
    /// Keeps a member that is through. Until the first part there is nothing to go on from, and an
    /// interrupted run leaves nothing behind. From any thread; throws config::InputError (file).
    void keep(const MemberYears& years) const;
    /// What a member left; nothing if it is not through. Throws config::InputError (file) if its part is
    /// damaged, of other settings or of another member.
    [[nodiscard]] std::optional<MemberYears> read(const Member& member) const;

    /// The same of a block of years over the bare slope (bare_falls.hpp).
    void keep_bare(std::uint32_t replicate, std::size_t block,
                   std::span<const exchange::BareYear> years) const;
    [[nodiscard]] bool has_bare(std::uint32_t replicate, std::size_t block) const;
    [[nodiscard]] std::vector<exchange::BareYear> read_bare(std::uint32_t replicate, std::size_t block) const;

private:
    void keep_marker() const;
    [[nodiscard]] std::filesystem::path of(const Member& member) const;
    [[nodiscard]] std::filesystem::path of_bare(std::uint32_t replicate, std::size_t block) const;

    std::filesystem::path folder_;
    std::string hash_;
    std::string remedy_;
    mutable std::mutex mutex_;  ///< one part is written at a time
};

}  // namespace coupling::decades
