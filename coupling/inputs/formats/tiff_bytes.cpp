#include "coupling/inputs/formats/tiff_bytes.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace coupling::formats {
namespace {

TiffBytes& source_of(thandle_t handle) {
    return *static_cast<TiffBytes*>(handle);
}

tmsize_t read_some(thandle_t handle, void* to, tmsize_t size) {
    TiffBytes& source = source_of(handle);
    const std::uint64_t left = source.size - std::min<std::uint64_t>(source.at, source.size);
    const std::uint64_t count = std::min(left, static_cast<std::uint64_t>(std::max<tmsize_t>(size, 0)));
    if (count > 0 && source.read_at) {
        try {
            source.read_at(source.at, static_cast<char*>(to), count);
        } catch (...) {
            source.failure = std::current_exception();
            return 0;
        }
    } else if (count > 0) {
        std::memcpy(to, source.bytes.data() + source.at, count);
    }
    source.at += count;
    source.wanted_beyond = source.wanted_beyond || static_cast<tmsize_t>(count) < size;
    return static_cast<tmsize_t>(count);
}

tmsize_t write_nothing(thandle_t, void*, tmsize_t) {
    return 0;
}

toff_t move_to(thandle_t handle, toff_t offset, int from) {
    TiffBytes& source = source_of(handle);
    source.at = from == SEEK_SET ? offset : from == SEEK_CUR ? source.at + offset : source.size + offset;
    return source.at;
}

int close_nothing(thandle_t) {
    return 0;
}

toff_t size_of(thandle_t handle) {
    return source_of(handle).size;
}

int say_nothing(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

/// The largest piece of memory that the library takes at once, against sizes that a damaged file claims.
constexpr tmsize_t most_at_once = tmsize_t{1} << 30;

}  // namespace

std::unique_ptr<TIFF, void (*)(TIFF*)> open_tiff(TiffBytes& source) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options{TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree};
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_at_once);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_nothing, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_nothing, nullptr);
    // m: no mapping of files, the bytes are in memory already.
    return {TIFFClientOpenExt("bytes", "rm", &source, read_some, write_nothing, move_to, close_nothing,
                              size_of, nullptr, nullptr, options.get()),
            TIFFClose};
}

}  // namespace coupling::formats
