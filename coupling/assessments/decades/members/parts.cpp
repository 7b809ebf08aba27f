#include "coupling/assessments/decades/members/parts.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/members/bare_part.hpp"
#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/output_folder.hpp"

namespace coupling::decades {

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

void Parts::keep(const MemberYears& years) const {
    const std::lock_guard lock{mutex_};
    keep_marker();
    write_part(of(years.member), mark_of(years.member), years);
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

std::optional<MemberYears> Parts::read(const Member& member) const {
    if (std::optional<MemberYears> own = read_part(of(member), mark_of(member), member, remedy_);
        own || keys_ == nullptr) {
        return own;
    }
    const std::string content = keys_->of(member);
    return if_sound(kept(content), [&] {
        return read_part(kept(content), {"", content}, member, kept_part_remedy);
    });
}

std::size_t Parts::own(std::span<const Member> members) const {
    return static_cast<std::size_t>(std::count_if(
        members.begin(), members.end(), [&](const Member& member) { return is_there(of(member)); }));
}

bool Parts::has_kept(const Member& member) const {
    return keys_ != nullptr && is_there(kept(keys_->of(member)));
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
    std::set<std::uint32_t> replicates;
    for (const Member& member : members) {
        keep(of(member), kept(keys_->of(member)));
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
