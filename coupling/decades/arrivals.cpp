#include "coupling/decades/arrivals.hpp"

namespace coupling::decades {

PairedCounts arrivals_of(const Names& names, std::span<const MemberYears> members, std::size_t course,
                         std::uint32_t target, std::int32_t year) {
    PairedCounts sum;
    for (const MemberYears& member : members) {
        if (names.course_of(member.member) != course) {
            continue;
        }
        for (const TargetRow& row : member.targets) {
            if (row.target == target && row.year == year) {
                sum.both += row.paired.both;
                sum.only_forest += row.paired.only_forest;
                sum.only_bare += row.paired.only_bare;
            }
        }
    }
    return sum;
}

}  // namespace coupling::decades
