#include "coupling/assessments/decades/members/member_part.hpp"

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/members/end_archive.hpp"
#include "coupling/results/disk/disk.hpp"

namespace coupling::decades {
namespace {

using config::joined;

constexpr std::uint64_t member_part_magic = 0x33314D45'4D4E4142ULL;  // "BANMEM13", least byte first

/// The lists of a member in one order for writing and reading.
template <class Years, class Visit>
void each_list(Years& years, const Visit& visit) {
    visit(years.years);
    visit(years.stands);
    visit(years.gaps);
    visit(years.indicators);
    visit(years.losses);
    visit(years.trees);
    visit(years.dead_wood);
    visit(years.paths);
    visit(years.patches);
    visit(years.removed);
    visit(years.harvest);
    visit(years.cut_patches);
    visit(years.timber);
    visit(years.margins);
    visit(years.slopes);
    visit(years.departures);
    visit(years.targets);
    visit(years.living);
    visit(years.energies);
    visit(years.rocks_at_targets);
    visit(years.bands);
    visit(years.stopping_patches);
}

/// As the names of part files count.
std::string in_words(const Member& member) {
    return joined("regime ", std::to_string(member.regime + 1), ", climate ",
                  std::to_string(member.climate + 1), ", replicate ", std::to_string(member.replicate + 1));
}

void write_years(ByteWriter& out, const KeptMember& kept) {
    out.value(kept.kept.last);
    out.value(kept.taken_over);
    out.list(kept.kept.tree_lists);
    out.list(kept.kept.maps);
}

PartYears read_years(ByteReader& in) {
    PartYears years;
    years.kept.last = in.value<std::int32_t>();
    years.taken_over = in.value<std::int32_t>();
    years.kept.tree_lists = in.list<int>();
    years.kept.maps = in.list<int>();
    return years;
}

bool is_of(const PartMark& mark, const PartMark& wanted) {
    return wanted.run.empty() ? mark.content == wanted.content : mark.run == wanted.run;
}

void write_rows(ByteWriter& out, const MemberYears& years) {
    each_list(years, [&](const auto& list) { out.list(list); });
    out.value(static_cast<std::uint64_t>(years.maps.size()));
    for (const CellMap& map : years.maps) {
        out.value(map.year);
        out.value(map.cover);
        out.list(map.cells);
    }
}

void read_rows(ByteReader& in, MemberYears& years) {
    each_list(years, [&]<class Row>(std::vector<Row>& list) { list = in.list<Row>(); });
    years.maps.resize(in.count_of(sizeof(std::int32_t)));
    for (CellMap& map : years.maps) {
        map.year = in.value<std::int32_t>();
        map.cover = in.value<Cover>();
        map.cells = in.list<rockfall::CellSums>();
    }
}

}  // namespace

void begin_part(ByteWriter& out, std::uint64_t magic_number, const PartMark& mark) {
    out.value(magic_number);
    out.text(mark.run);
    out.text(mark.content);
}

PartMark check_begin(ByteReader& in, std::uint64_t magic_number, const PartMark& wanted,
                     const std::filesystem::path& file) {
    if (in.value<std::uint64_t>() != magic_number) {
        config::fail(config::ExitCode::file, {file.string()}, "not a part file of this version", in.remedy());
    }
    in.check_whole();
    PartMark mark{in.text()};
    mark.content = in.text();
    if (!is_of(mark, wanted)) {
        config::fail(config::ExitCode::file, {file.string()}, "a part of a run with other settings or inputs",
                     in.remedy());
    }
    return mark;
}

void refuse_other_build(const PartMark& mark, const PartMark& wanted, const ByteReader& in,
                        const std::filesystem::path& file) {
    if (!wanted.content.empty() && mark.content != wanted.content) {
        config::fail(config::ExitCode::file, {file.string()}, "a part made by another build of the program",
                     in.remedy());
    }
}

void write_part(const std::filesystem::path& file, const PartMark& mark, const KeptMember& kept) {
    const std::filesystem::path temporary = temporary_beside(file);
    ByteWriter out{temporary};
    begin_part(out, member_part_magic, mark);
    write_years(out, kept);
    out.value(kept.years.member);
    write_rows(out, kept.years);
    write(out, kept.end);
    close_and_rename(out, temporary, file);
}

std::optional<KeptMember> read_part(const std::filesystem::path& file, const PartMark& wanted,
                                    const Member& member, const std::string& remedy) {
    if (!is_there(file)) {
        return std::nullopt;
    }
    ByteReader in{file, remedy};
    const PartMark mark = check_begin(in, member_part_magic, wanted, file);
    PartYears years = read_years(in);
    KeptMember kept{std::move(years.kept), years.taken_over, {}, {}};
    kept.years.member = in.value<Member>();
    if (wanted.run.empty()) {
        kept.years.member = member;  // places in the lists of the run that made it say nothing
    } else if (kept.years.member != member) {
        config::fail(config::ExitCode::file, {file.string()},
                     joined("the part of ", in_words(kept.years.member)),
                     joined("that of ", in_words(member), ", as its name says; ", remedy));
    }
    refuse_other_build(mark, wanted, in, file);
    read_rows(in, kept.years);
    read(in, kept.end);
    in.check_end();
    return kept;
}

std::optional<PartYears> peek_part(const std::filesystem::path& file, const PartMark& wanted) {
    if (!is_there(file)) {
        return std::nullopt;
    }
    try {
        ByteReader in{file};
        if (in.value<std::uint64_t>() != member_part_magic) {
            return std::nullopt;
        }
        PartMark mark{in.text()};
        mark.content = in.text();
        return is_of(mark, wanted) ? std::optional{read_years(in)} : std::nullopt;
    } catch (const config::InputError&) {
        return std::nullopt;
    }
}

}  // namespace coupling::decades
