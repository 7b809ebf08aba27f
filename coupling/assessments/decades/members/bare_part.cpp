#include "coupling/assessments/decades/members/bare_part.hpp"

#include "config/text/joined.hpp"
#include "coupling/run/tally_archive.hpp"

namespace coupling::decades {
namespace {

using config::joined;

constexpr std::uint64_t bare_part_magic = 0x36304552'41424E42ULL;  // "BNBARE06", least byte first

std::string in_words(const BarePlace& place) {
    return joined("replicate ", std::to_string(place.replicate + 1), ", block of years ",
                  std::to_string(place.block + 1));
}

}  // namespace

void write_bare_part(const std::filesystem::path& file, const PartMark& mark, const BarePlace& place,
                     std::span<const exchange::BareYear> years) {
    const std::filesystem::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    begin_part(out, bare_part_magic, mark);
    out.value(place.replicate);
    out.value(place.block);
    out.value(static_cast<std::uint64_t>(years.size()));
    for (const exchange::BareYear& bare : years) {
        out.value(bare.year);
        write(out, bare.run);
        out.value(static_cast<std::uint64_t>(bare.targets.size()));
        for (const rockfall::ArrivalTally& target : bare.targets) {
            write(out, target);
        }
        for (const std::vector<exchange::RockAtTarget>& rocks : bare.at_targets) {
            out.list(rocks);
        }
        write(out, bare.cells);
        out.list(bare.arrived);
    }
    close_and_rename(out, temporary, file);
}

std::vector<exchange::BareYear> read_bare_part(const std::filesystem::path& file, const PartMark& wanted,
                                               const BarePlace& place, const std::string& remedy) {
    ByteReader in{file, remedy};
    const PartMark mark = check_begin(in, bare_part_magic, wanted, file);
    BarePlace found;
    found.replicate = in.value<std::uint32_t>();
    found.block = in.value<std::uint64_t>();
    if (found != place) {
        config::fail(config::ExitCode::file, {file.string()},
                     joined("falls over the bare slope of ", in_words(found)),
                     joined("those of ", in_words(place), ", as its name says; ", in.remedy()));
    }
    refuse_other_build(mark, wanted, in, file);
    std::vector<exchange::BareYear> years(in.count_of(sizeof(std::int32_t)));
    for (exchange::BareYear& bare : years) {
        bare.year = in.value<std::int32_t>();
        read(in, bare.run);
        bare.targets.resize(in.count_of(sizeof(std::uint64_t)));
        for (rockfall::ArrivalTally& target : bare.targets) {
            read(in, target);
        }
        bare.at_targets.resize(bare.targets.size());
        for (std::vector<exchange::RockAtTarget>& rocks : bare.at_targets) {
            rocks = in.list<exchange::RockAtTarget>();
        }
        read(in, bare.cells);
        bare.arrived = in.list<std::uint64_t>();
    }
    in.check_end();
    return years;
}

}  // namespace coupling::decades
