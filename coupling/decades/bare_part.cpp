#include "coupling/decades/bare_part.hpp"

#include "coupling/decades/member_part.hpp"
#include "coupling/run/tally_archive.hpp"

namespace coupling::decades {
namespace {

constexpr std::uint64_t magic = 0x32304552'41424E42ULL;  // "BNBARE02", least byte first

}  // namespace

void write_bare_part(const std::filesystem::path& file, const std::string& hash,
                     std::span<const exchange::BareYear> years) {
    const std::filesystem::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    begin_part(out, magic, hash);
    out.value(static_cast<std::uint64_t>(years.size()));
    for (const exchange::BareYear& bare : years) {
        out.value(bare.year);
        write(out, bare.run);
        out.value(static_cast<std::uint64_t>(bare.targets.size()));
        for (const rockfall::ArrivalTally& target : bare.targets) {
            write(out, target);
        }
        out.list(bare.cells);
        out.list(bare.arrived);
    }
    close_and_rename(out, temporary, file);
}

std::vector<exchange::BareYear> read_bare_part(const std::filesystem::path& file, const std::string& hash) {
    ByteReader in{file};
    check_begin(in, magic, hash, file);
    std::vector<exchange::BareYear> years(in.count_of(sizeof(std::int32_t)));
    for (exchange::BareYear& bare : years) {
        bare.year = in.value<std::int32_t>();
        read(in, bare.run);
        bare.targets.resize(in.count_of(sizeof(std::uint64_t)));
        for (rockfall::ArrivalTally& target : bare.targets) {
            read(in, target);
        }
        bare.cells = in.list<rockfall::CellSums>();
        bare.arrived = in.list<std::uint64_t>();
    }
    in.check_end();
    return years;
}

}  // namespace coupling::decades
