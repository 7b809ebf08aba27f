// A library to be preloaded (LD_PRELOAD) that counts what a program changes on the disk below a folder and
// lets one of these operations go wrong. Settings come from the environment:
//
//     BANNWALD_FAULT_FOLDER   absolute path; operations elsewhere are neither counted nor disturbed
//     BANNWALD_FAULT_MODE     count    nothing goes wrong
//                             kill     the process dies before the operation
//                             tear     a write writes its first half, then the process dies
//                             power    the process dies before the operation, and what no fsync has brought
//                             to the
//                                      disk is lost: each file is cut to the length of its last fsync
//                             eio      the operation fails with an input/output error; later ones work
//                             enospc   the disk is full from the operation on: a write writes its first half,
//                             later
//                                      ones and whatever makes a file or a folder fail; renaming and deleting
//                                      work
//                             term     the process is asked to terminate before the operation, which then
//                             works
//                             unread   reading fails with an input/output error: opening a file for it, and
//                             each read
//                             eintr    a signal interrupts the operation, a change or a read, which has then
//                             done
//                                      nothing
//                             count_all  nothing goes wrong; reads are counted too
//     BANNWALD_FAULT_READ_FOLDER  absolute path; with unread, eintr and count_all reads below it are counted
//                             as well
//     BANNWALD_FAULT_AT       number of the operation, counted from 1; 0 with term: before the program begins
//     BANNWALD_FAULT_LOG      file that gets a line for each operation: number, name, outcome (ok or the
//     mode), path
//
// Only names that the dynamic linker resolves can be replaced: a write inside the C library (fwrite, fputs)
// is not seen. The program writes through streams and SQLite, which call the functions below.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "tests/faults/injector.hpp"

namespace {

namespace fs = std::filesystem;

using faults::Fate;
using faults::Injector;
using faults::Kind;

/// The function that this library stands in front of.
template <class Function>
Function* original(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// When the dynamic linker sets up the libraries, before those of the program and its `main`.
[[gnu::constructor]] void begin() {
    Injector::of_process().begin();
}

std::string linked_path(int descriptor) {
    std::array<char, PATH_MAX> path{};
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    const ssize_t length = readlink(link.c_str(), path.data(), path.size());
    return length < 0 ? "" : std::string{path.data(), static_cast<std::size_t>(length)};
}

std::string whole_path(int folder, const char* name) {
    if (name == nullptr) {
        return "";
    }
    if (name[0] == '/') {
        return fs::path{name}.lexically_normal().string();
    }
    std::error_code ignored;
    const fs::path base = folder == AT_FDCWD ? fs::current_path(ignored) : fs::path{linked_path(folder)};
    return (base / name).lexically_normal().string();
}

bool fails(const char* name, Kind kind, const std::string& path) {
    return Injector::of_process().next(name, kind, path) != Fate::as_usual;
}

/// Writes through `write_bytes(count)`, whole or as the injector wants it.
template <class Write>
ssize_t written(const char* name, int descriptor, std::size_t bytes, const Write& write_bytes) {
    const Fate fate = Injector::of_process().next(name, Kind::writes, linked_path(descriptor));
    if (fate == Fate::as_usual) {
        return write_bytes(bytes);
    }
    if (fate == Fate::fails) {
        return -1;
    }
    const int reason = errno;
    const ssize_t half = bytes < 2 ? 0 : write_bytes(bytes / 2);
    if (Injector::of_process().tears()) {
        Injector::die();
    }
    errno = reason;
    return half > 0 ? half : -1;
}

/// Reads through `read_bytes()`, unless the injector lets that fail.
template <class Read>
ssize_t taken(const char* name, int descriptor, const Read& read_bytes) {
    const bool counts = Injector::of_process().counts_reads();
    return counts && fails(name, Kind::reads, linked_path(descriptor)) ? -1 : read_bytes();
}

int opened_file(const char* name, int folder, const char* file, int flags, mode_t mode) {
    const bool changes = (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
    if (!changes && Injector::of_process().counts_reads() &&
        fails((flags & O_DIRECTORY) != 0 ? "opendir" : "open_read", Kind::reads, whole_path(folder, file))) {
        return -1;
    }
    const std::string path = changes ? whole_path(folder, file) : "";
    if (changes && fails(name, (flags & O_CREAT) != 0 ? Kind::makes : Kind::other, path)) {
        return -1;
    }
    const int descriptor = static_cast<int>(syscall(SYS_openat, folder, file, flags | O_LARGEFILE, mode));
    if (changes && descriptor >= 0 && Injector::of_process().sees(path)) {
        Injector::of_process().opened(descriptor);
    }
    return descriptor;
}

FILE* opened_stream(const char* name, const char* file, const char* mode) {
    const bool changes = std::string_view{mode}.find_first_of("wa+") != std::string_view::npos;
    const std::string path = changes ? whole_path(AT_FDCWD, file) : "";
    if (changes && fails(name, Kind::makes, path)) {
        return nullptr;
    }
    if (!changes && Injector::of_process().counts_reads() &&
        fails("fopen_read", Kind::reads, whole_path(AT_FDCWD, file))) {
        return nullptr;
    }
    FILE* stream = original<FILE*(const char*, const char*)>("fopen64")(file, mode);
    if (changes && stream != nullptr && Injector::of_process().sees(path)) {
        Injector::of_process().opened(fileno(stream));
    }
    return stream;
}

mode_t mode_argument(int flags, va_list& arguments) {
    const bool makes = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    return makes ? static_cast<mode_t>(va_arg(arguments, unsigned)) : 0;
}

}  // namespace

extern "C" {

int open(const char* file, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    return opened_file("open", AT_FDCWD, file, flags, mode);
}

int open64(const char* file, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    return opened_file("open", AT_FDCWD, file, flags, mode);
}

int openat(int folder, const char* file, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    return opened_file("openat", folder, file, flags, mode);
}

int openat64(int folder, const char* file, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_argument(flags, arguments);
    va_end(arguments);
    return opened_file("openat", folder, file, flags, mode);
}

int creat(const char* file, mode_t mode) {
    return opened_file("creat", AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, mode);
}

int creat64(const char* file, mode_t mode) {
    return opened_file("creat", AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, mode);
}

FILE* fopen(const char* file, const char* mode) {
    return opened_stream("fopen", file, mode);
}

FILE* fopen64(const char* file, const char* mode) {
    return opened_stream("fopen", file, mode);
}

ssize_t read(int descriptor, void* bytes, std::size_t count) {
    return taken("read", descriptor,
                 [&] { return static_cast<ssize_t>(syscall(SYS_read, descriptor, bytes, count)); });
}

ssize_t pread(int descriptor, void* bytes, std::size_t count, off_t at) {
    return taken("pread", descriptor,
                 [&] { return static_cast<ssize_t>(syscall(SYS_pread64, descriptor, bytes, count, at)); });
}

ssize_t pread64(int descriptor, void* bytes, std::size_t count, off64_t at) {
    return taken("pread", descriptor,
                 [&] { return static_cast<ssize_t>(syscall(SYS_pread64, descriptor, bytes, count, at)); });
}

ssize_t readv(int descriptor, const iovec* pieces, int count) {
    return taken("readv", descriptor,
                 [&] { return static_cast<ssize_t>(syscall(SYS_readv, descriptor, pieces, count)); });
}

ssize_t write(int descriptor, const void* bytes, std::size_t count) {
    return written("write", descriptor, count, [&](std::size_t n) {
        return static_cast<ssize_t>(syscall(SYS_write, descriptor, bytes, n));
    });
}

ssize_t pwrite(int descriptor, const void* bytes, std::size_t count, off_t at) {
    return written("pwrite", descriptor, count, [&](std::size_t n) {
        return static_cast<ssize_t>(syscall(SYS_pwrite64, descriptor, bytes, n, at));
    });
}

ssize_t pwrite64(int descriptor, const void* bytes, std::size_t count, off64_t at) {
    return written("pwrite", descriptor, count, [&](std::size_t n) {
        return static_cast<ssize_t>(syscall(SYS_pwrite64, descriptor, bytes, n, at));
    });
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
    std::size_t bytes = 0;
    for (int i = 0; i < count; ++i) {
        bytes += pieces[i].iov_len;
    }
    return written("writev", descriptor, bytes, [&](std::size_t n) -> ssize_t {
        if (n == bytes) {
            return static_cast<ssize_t>(syscall(SYS_writev, descriptor, pieces, count));
        }
        ssize_t done = 0;
        for (int i = 0; i < count && n > 0; ++i) {
            const std::size_t part = pieces[i].iov_len < n ? pieces[i].iov_len : n;
            done += static_cast<ssize_t>(syscall(SYS_write, descriptor, pieces[i].iov_base, part));
            n -= part;
        }
        return done;
    });
}

ssize_t sendfile(int to, int from, off_t* at, std::size_t count) noexcept {
    return written("sendfile", to, count, [&](std::size_t n) {
        return static_cast<ssize_t>(syscall(SYS_sendfile, to, from, at, n));
    });
}

ssize_t sendfile64(int to, int from, off64_t* at, std::size_t count) noexcept {
    return written("sendfile", to, count, [&](std::size_t n) {
        return static_cast<ssize_t>(syscall(SYS_sendfile, to, from, at, n));
    });
}

ssize_t copy_file_range(int from, off64_t* from_at, int to, off64_t* to_at, std::size_t count,
                        unsigned flags) {
    return written("copy_file_range", to, count, [&](std::size_t n) {
        return static_cast<ssize_t>(syscall(SYS_copy_file_range, from, from_at, to, to_at, n, flags));
    });
}

int fsync(int descriptor) {
    if (fails("fsync", Kind::other, linked_path(descriptor))) {
        return -1;
    }
    Injector::of_process().synced(descriptor);
    return 0;  // a crash of the machine is only played: nothing has to wait for the disk
}

int fdatasync(int descriptor) {
    if (fails("fdatasync", Kind::other, linked_path(descriptor))) {
        return -1;
    }
    Injector::of_process().synced(descriptor);
    return 0;
}

int ftruncate(int descriptor, off_t length) noexcept {
    return fails("ftruncate", Kind::other, linked_path(descriptor))
               ? -1
               : static_cast<int>(syscall(SYS_ftruncate, descriptor, length));
}

int ftruncate64(int descriptor, off64_t length) noexcept {
    return fails("ftruncate", Kind::other, linked_path(descriptor))
               ? -1
               : static_cast<int>(syscall(SYS_ftruncate, descriptor, length));
}

int truncate(const char* file, off_t length) noexcept {
    return fails("truncate", Kind::other, whole_path(AT_FDCWD, file))
               ? -1
               : static_cast<int>(syscall(SYS_truncate, file, length));
}

int truncate64(const char* file, off64_t length) noexcept {
    return fails("truncate", Kind::other, whole_path(AT_FDCWD, file))
               ? -1
               : static_cast<int>(syscall(SYS_truncate, file, length));
}

int posix_fallocate(int descriptor, off_t at, off_t length) {
    return fails("posix_fallocate", Kind::makes, linked_path(descriptor))             ? errno
           : static_cast<int>(syscall(SYS_fallocate, descriptor, 0, at, length)) == 0 ? 0
                                                                                      : errno;
}

int rename(const char* from, const char* to) noexcept {
    return fails("rename", Kind::other, whole_path(AT_FDCWD, to))
               ? -1
               : static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
    return fails("rename", Kind::other, whole_path(to_folder, to))
               ? -1
               : static_cast<int>(syscall(SYS_renameat, from_folder, from, to_folder, to));
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) noexcept {
    return fails("rename", Kind::other, whole_path(to_folder, to))
               ? -1
               : static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}

int link(const char* from, const char* to) noexcept {
    return fails("link", Kind::makes, whole_path(AT_FDCWD, to))
               ? -1
               : static_cast<int>(syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
    return fails("link", Kind::makes, whole_path(to_folder, to))
               ? -1
               : static_cast<int>(syscall(SYS_linkat, from_folder, from, to_folder, to, flags));
}

int unlink(const char* file) noexcept {
    const std::string path = whole_path(AT_FDCWD, file);
    if (fails("unlink", Kind::other, path)) {
        return -1;
    }
    Injector::of_process().forget(path);
    return static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, file, 0));
}

int unlinkat(int folder, const char* file, int flags) noexcept {
    const std::string path = whole_path(folder, file);
    if (fails((flags & AT_REMOVEDIR) != 0 ? "rmdir" : "unlink", Kind::other, path)) {
        return -1;
    }
    Injector::of_process().forget(path);
    return static_cast<int>(syscall(SYS_unlinkat, folder, file, flags));
}

int remove(const char* file) noexcept {
    const std::string path = whole_path(AT_FDCWD, file);
    if (fails("remove", Kind::other, path)) {
        return -1;
    }
    Injector::of_process().forget(path);
    return original<int(const char*)>("remove")(file);
}

int rmdir(const char* folder) noexcept {
    return fails("rmdir", Kind::other, whole_path(AT_FDCWD, folder))
               ? -1
               : static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, folder, AT_REMOVEDIR));
}

int mkdir(const char* folder, mode_t mode) noexcept {
    return fails("mkdir", Kind::makes, whole_path(AT_FDCWD, folder))
               ? -1
               : static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, folder, mode));
}

int mkdirat(int parent, const char* folder, mode_t mode) noexcept {
    return fails("mkdir", Kind::makes, whole_path(parent, folder))
               ? -1
               : static_cast<int>(syscall(SYS_mkdirat, parent, folder, mode));
}

int symlink(const char* target, const char* name) noexcept {
    return fails("symlink", Kind::makes, whole_path(AT_FDCWD, name))
               ? -1
               : static_cast<int>(syscall(SYS_symlinkat, target, AT_FDCWD, name));
}

}  // extern "C"
