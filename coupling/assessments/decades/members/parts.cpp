#include "coupling/assessments/decades/members/parts.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/members/bare_part.hpp"
#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/results/disk/disk.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/output_folder.hpp"

namespace coupling::decades {

using config::joined;

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
    write_part(of(years.member), hash_, years);
}

std::optional<MemberYears> Parts::read(const Member& member) const {
    return read_part(of(member), hash_, member, remedy_);
}

void Parts::keep_bare(std::uint32_t replicate, std::size_t block,
                      std::span<const exchange::BareYear> years) const {
    const std::lock_guard lock{mutex_};
    keep_marker();
    write_bare_part(of_bare(replicate, block), hash_, {replicate, block}, years);
}

bool Parts::has_bare(std::uint32_t replicate, std::size_t block) const {
    return is_there(of_bare(replicate, block));
}

std::vector<exchange::BareYear> Parts::read_bare(std::uint32_t replicate, std::size_t block) const {
    return read_bare_part(of_bare(replicate, block), hash_, {replicate, block});
}

}  // namespace coupling::decades
