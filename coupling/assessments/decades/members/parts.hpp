#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/member_keys.hpp"
#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/exchange/bare_year.hpp"
#include "coupling/results/disk/byte_archive.hpp"

namespace coupling::decades {

/// Parts of a member that runs of different length, or with other lists and maps, have kept side by side.
struct PartKind {
    std::int32_t years = 0;
    std::string lists;  ///< name_of_lists
    friend auto operator<=>(const PartKind&, const PartKind&) = default;
};

/// The part files of a run in a folder that threads, ranks and shards may share, and beside it those that
/// earlier runs have kept: of the same content, they serve this one as well. A kept member of fewer years is
/// where this run goes on; one of more years serves no shorter run, which would want other lists and maps.
class Parts {
public:
    /// `hash` is that of settings, inputs and version; `keys` of what parts depend on, null: parts of earlier
    /// runs are left alone. `remedy` is what a message advises where a part cannot be used.
    Parts(std::filesystem::path folder, std::string hash, const MemberKeys* keys = nullptr,
          std::string remedy = own_part_remedy);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Whether anything was kept.
    [[nodiscard]] bool any() const;
    /// Keeps a member that is through. Until the first part there is nothing to go on from, and an
    /// interrupted run leaves nothing behind. From any thread; throws config::InputError (file).
    void keep(const KeptMember& member) const;
    /// What a member left; nothing if it is not through. Throws config::InputError (file) if its part is
    /// damaged, of other settings or of another member.
    [[nodiscard]] std::optional<KeptMember> read(const Member& member) const;

    /// The same of a block of years over the bare slope (bare_falls.hpp).
    void keep_bare(std::uint32_t replicate, std::size_t block,
                   std::span<const exchange::BareYear> years) const;
    [[nodiscard]] bool has_bare(std::uint32_t replicate, std::size_t block) const;
    [[nodiscard]] std::vector<exchange::BareYear> read_bare(std::uint32_t replicate, std::size_t block) const;

    /// So many first years of this member an earlier run has kept, 0 to all: this one may take them over. By
    /// the beginning of the part, which may yet turn out damaged.
    [[nodiscard]] std::int32_t kept_years(const Member& member) const;
    /// The first years of a member that an earlier, shorter run has kept, as this one writes them; nothing
    /// where there is no sound part that it can go on from.
    [[nodiscard]] std::optional<KeptMember> begun(const Member& member) const;
    /// Puts the parts of these members, and of the bare slope in so many blocks of their replicates, among
    /// those that are kept, too.
    void keep_for_others(std::span<const Member> members, std::size_t blocks) const;
    /// Years of these members that this run has simulated: its parts lie here until its results are whole.
    [[nodiscard]] std::uint64_t own_years(std::span<const Member> members) const;

private:
    void keep_marker() const;
    [[nodiscard]] PartMark mark_of(const Member& member) const;
    /// What a kept part holds; nothing, with a note, where it is damaged: it only spares work.
    template <class Read>
    auto if_sound(const std::filesystem::path& file, const Read& read) const -> decltype(read());
    [[nodiscard]] std::filesystem::path of(const Member& member) const;
    [[nodiscard]] std::filesystem::path of_bare(std::uint32_t replicate, std::size_t block) const;
    [[nodiscard]] std::filesystem::path kept(const std::string& content) const;
    [[nodiscard]] std::filesystem::path kept(const Member& member, const PartKind& kind) const;
    /// The part with the most of its first years, at most so many, that this run can go on from.
    [[nodiscard]] std::optional<PartKind> longest(const Member& member, std::int32_t at_most) const;
    /// As this run writes it; nothing, with a note, where the part is damaged.
    [[nodiscard]] std::optional<KeptMember> read_kept(const Member& member, const PartKind& kind) const;
    [[nodiscard]] std::int32_t run_years() const;

    std::filesystem::path folder_;
    std::filesystem::path kept_;
    std::string hash_;
    const MemberKeys* keys_;
    std::string remedy_;
    mutable std::mutex mutex_;                      ///< one part is written at a time
    mutable std::set<std::filesystem::path> told_;  ///< damaged kept parts that were named
};

}  // namespace coupling::decades
