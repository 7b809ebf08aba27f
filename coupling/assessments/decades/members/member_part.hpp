#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "coupling/assessments/decades/members/kept_member.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/results/disk/byte_archive.hpp"

namespace coupling::decades {

/// What a part is, at its beginning.
struct PartMark {
    std::string run;        ///< hash of settings, inputs and version of the run that made it
    std::string content{};  ///< key of what it depends on (member_keys.hpp); "": it has none
};

/// Writes what a member left, under a temporary name first, renamed when whole. Throws config::InputError
/// (file) if the disk does not take it.
void write_part(const std::filesystem::path& file, const PartMark& mark, const KeptMember& kept);

/// Reads back what this member left; nothing if there is no such file. `wanted`: with a run, the part of this
/// run and member (and of this content where it has one); without one, the part of any run with this content.
/// Throws config::InputError (file) if it is cut off, damaged or another one; the message ends with `remedy`.
std::optional<KeptMember> read_part(const std::filesystem::path& file, const PartMark& wanted,
                                    const Member& member, const std::string& remedy = own_part_remedy);

/// What a part says of its years, at its beginning.
struct PartYears {
    KeptYears kept;
    std::int32_t taken_over = 0;
};
/// Reads the beginning alone, for counting; nothing if there is no such file or it is none of `wanted`.
/// Damage behind it is found when the part is read.
std::optional<PartYears> peek_part(const std::filesystem::path& file, const PartMark& wanted);

/// How each kind of part begins.
void begin_part(ByteWriter& out, std::uint64_t magic_number, const PartMark& mark);
/// Throws config::InputError (file) if a part begins otherwise than wanted, or if its checksum does not fit.
PartMark check_begin(ByteReader& in, std::uint64_t magic_number, const PartMark& wanted,
                     const std::filesystem::path& file);
/// Of a part of the same settings and inputs, and of the place asked for: throws config::InputError (file) if
/// its content is another one, which leaves the program as the cause.
void refuse_other_build(const PartMark& mark, const PartMark& wanted, const ByteReader& in,
                        const std::filesystem::path& file);

}  // namespace coupling::decades
