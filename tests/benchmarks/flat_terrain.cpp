#include "tests/benchmarks/flat_terrain.hpp"

#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace benchmarks {
namespace {

template <class T>
void write_list(std::ostream& out, std::span<const T> list) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = list.size();
    out.write(reinterpret_cast<const char*>(&count), sizeof count);
    out.write(reinterpret_cast<const char*>(list.data()), static_cast<std::streamsize>(list.size_bytes()));
}

template <class T>
std::vector<T> read_list(std::istream& in) {
    std::uint64_t count = 0;
    in.read(reinterpret_cast<char*>(&count), sizeof count);
    std::vector<T> list(in ? count : 0);
    in.read(reinterpret_cast<char*>(list.data()), static_cast<std::streamsize>(count * sizeof(T)));
    if (!in) {
        throw std::runtime_error{"the file of the terrain ends too early"};
    }
    return list;
}

}  // namespace

void write_flat(std::ostream& out, const rockfall::Terrain& terrain) {
    const std::vector<double> origin_m{terrain.origin_m().x(), terrain.origin_m().y()};
    write_list(out, std::span<const double>{origin_m});
    write_list(out, terrain.vertices());
    write_list(out, terrain.triangles());
}

rockfall::Terrain read_flat(std::istream& in) {
    const std::vector<double> origin_m = read_list<double>(in);
    std::vector<rockfall::Vertex> vertices = read_list<rockfall::Vertex>(in);
    std::vector<rockfall::Triangle> triangles = read_list<rockfall::Triangle>(in);
    return {{origin_m.at(0), origin_m.at(1)}, std::move(vertices), std::move(triangles)};
}

}  // namespace benchmarks
