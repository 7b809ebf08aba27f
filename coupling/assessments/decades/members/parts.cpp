#include "coupling/assessments/decades/members/parts.hpp"

#include <charconv>
#include <cstdio>
#include <functional>
#include <set>
#include <system_error>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/members/bare_part.hpp"
#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/output_folder.hpp"

namespace coupling::decades {

namespace {

/// Of the members in a folder, from the most years: KEY_YEARS_LISTS.part.
std::vector<PartKind> kinds_in(const std::filesystem::path& folder) {
    std::set<PartKind, std::greater<>> kinds;
    std::error_code not_there;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::directory_iterator{folder, not_there}) {
        const std::string name = entry.path().stem().string();
        const std::size_t first = name.find('_');
        const std::size_t second = name.find('_', first + 1);
        if (first == std::string::npos || second == std::string::npos) {
            continue;
        }
        PartKind kind{0, name.substr(second + 1)};
        const auto read = std::from_chars(name.data() + first + 1, name.data() + second, kind.years);
        if (read.ec == std::errc{} && kind.years > 0) {
            kinds.insert(std::move(kind));
        }
    }
    return {kinds.begin(), kinds.end()};
}

}  // namespace

using config::joined;

Parts::Parts(std::filesystem::path folder, std::string hash, const MemberKeys* keys, std::string remedy)
    : folder_{std::move(folder)},
      kept_{OutputFolder::members_of(folder_.parent_path())},
      hash_{std::move(hash)},
      keys_{keys},
      remedy_{std::move(remedy)} {}

std::filesystem::path Parts::kept(const std::string& content) const {
    return kept_ / joined(content, ".part");
}

std::filesystem::path Parts::kept(const Member& member, const PartKind& kind) const {
    return kept_ /
           joined(keys_->of(member, kind.years), "_", std::to_string(kind.years), "_", kind.lists, ".part");
}

std::filesystem::path Parts::of(const Member& member) const {
    return folder_ / joined("member_", std::to_string(member.regime + 1), "_",
                            std::to_string(member.climate + 1), "_", std::to_string(member.replicate + 1),
                            ".part");
}

std::filesystem::path Parts::of_bare(std::uint32_t replicate, std::size_t block) const {
    return folder_ / joined("bare_", std::to_string(replicate + 1), "_", std::to_string(block + 1), ".part");
}

bool Parts::any() const {
    return is_there(OutputFolder::checkpoint_of(folder_));
}

/// Says of which run the parts are; comes before the first one.
void Parts::keep_marker() const {
    if (!any()) {
        write_marker(OutputFolder::checkpoint_of(folder_), hash_);
    }
}

void Parts::keep(const KeptMember& member) const {
    const std::lock_guard lock{mutex_};
    keep_marker();
    write_part(of(member.years.member), mark_of(member.years.member), member);
}

/// Of an own part: of these settings and, where keys say so, of this program.
PartMark Parts::mark_of(const Member& member) const {
    return {hash_, keys_ == nullptr ? std::string{} : keys_->of(member)};
}

template <class Read>
auto Parts::if_sound(const std::filesystem::path& file, const Read& read) const -> decltype(read()) {
    try {
        return read();
    } catch (const config::InputError&) {
        const std::lock_guard lock{mutex_};
        if (told_.insert(file).second) {
            std::fprintf(stderr, "bannwald: note: %s is damaged: what it kept is simulated again\n",
                         file.string().c_str());
        }
        return {};
    }
}

std::int32_t Parts::run_years() const {
    return static_cast<std::int32_t>(keys_->scenario().run.years);
}

std::optional<KeptMember> Parts::read(const Member& member) const {
    if (std::optional<KeptMember> own = read_part(of(member), mark_of(member), member, remedy_);
        own || keys_ == nullptr) {
        return own;
    }
    const std::optional<PartKind> kind = longest(member, run_years());
    return kind && kind->years == run_years() ? read_kept(member, *kind) : std::nullopt;
}

std::optional<KeptMember> Parts::read_kept(const Member& member, const PartKind& kind) const {
    const std::filesystem::path file = kept(member, kind);
    std::optional<KeptMember> found = if_sound(file, [&] {
        return read_part(file, {"", keys_->of(member, kind.years)}, member, kept_part_remedy);
    });
    if (found) {
        leave_what_is_wanted(*found, keys_->scenario());
        found->taken_over = kind.years;
    }
    return found;
}

std::optional<PartKind> Parts::longest(const Member& member, std::int32_t at_most) const {
    for (const PartKind& kind : kinds_in(kept_)) {
        if (kind.years > at_most) {
            continue;
        }
        const std::optional<PartYears> found =
            peek_part(kept(member, kind), {"", keys_->of(member, kind.years)});
        if (found && found->kept.last == kind.years && can_go_on(found->kept, keys_->scenario())) {
            return kind;
        }
    }
    return std::nullopt;
}

std::int32_t Parts::kept_years(const Member& member) const {
    const std::optional<PartKind> kind = keys_ == nullptr ? std::nullopt : longest(member, run_years());
    return kind ? kind->years : 0;
}

std::optional<KeptMember> Parts::begun(const Member& member) const {
    std::optional<PartKind> kind = keys_ == nullptr ? std::nullopt : longest(member, run_years() - 1);
    while (kind) {
        if (std::optional<KeptMember> found = read_kept(member, *kind)) {
            return found;
        }
        kind = longest(member, kind->years - 1);
    }
    return std::nullopt;
}

std::uint64_t Parts::own_years(std::span<const Member> members) const {
    std::uint64_t years = 0;
    for (const Member& member : members) {
        if (const std::optional<PartYears> own = peek_part(of(member), mark_of(member))) {
            years += static_cast<std::uint64_t>(own->kept.last - own->taken_over);
        }
    }
    return years;
}

void Parts::keep_bare(std::uint32_t replicate, std::size_t block,
                      std::span<const exchange::BareYear> years) const {
    const std::lock_guard lock{mutex_};
    keep_marker();
    write_bare_part(of_bare(replicate, block),
                    {hash_, keys_ == nullptr ? std::string{} : keys_->of_bare(replicate, block)},
                    {replicate, block}, years);
}

bool Parts::has_bare(std::uint32_t replicate, std::size_t block) const {
    if (is_there(of_bare(replicate, block)) || keys_ == nullptr) {
        return is_there(of_bare(replicate, block));
    }
    const std::string content = keys_->of_bare(replicate, block);
    return is_there(kept(content)) &&
           !if_sound(kept(content), [&] {
                return read_bare_part(kept(content), {"", content}, {replicate, block}, kept_part_remedy);
            }).empty();
}

std::vector<exchange::BareYear> Parts::read_bare(std::uint32_t replicate, std::size_t block) const {
    const BarePlace place{replicate, block};
    if (keys_ == nullptr || is_there(of_bare(replicate, block))) {
        return read_bare_part(of_bare(replicate, block),
                              {hash_, keys_ == nullptr ? "" : keys_->of_bare(replicate, block)}, place);
    }
    const std::string content = keys_->of_bare(replicate, block);
    return read_bare_part(kept(content), {"", content}, place, kept_part_remedy);
}

void Parts::keep_for_others(std::span<const Member> members, std::size_t blocks) const {
    make_folder(kept_);
    // They stay here until the results are whole: what they say of this run is needed once more after a kill.
    const auto keep = [](const std::filesystem::path& from, const std::filesystem::path& to) {
        if (is_there(from)) {
            delete_entry(to);  // it may be there, and damaged
            link_or_copy(from, to);
        }
    };
    const PartKind kind{run_years(), name_of_lists(kept_years_of(keys_->scenario()))};
    std::set<std::uint32_t> replicates;
    for (const Member& member : members) {
        keep(of(member), kept(member, kind));
        replicates.insert(member.replicate);
    }
    for (const std::uint32_t replicate : replicates) {
        for (std::size_t block = 0; block < blocks; ++block) {
            keep(of_bare(replicate, block), kept(keys_->of_bare(replicate, block)));
        }
    }
    sync_folder(kept_);
}

}  // namespace coupling::decades
