// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SCRATCH_FILE_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SCRATCH_FILE_H

// Bytes on disk for as long as an object lives.

#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ios>
#include <string>
#include <system_error>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// A file that has a name only for a moment, where the system allows this: then no file stays, even
// if the process is killed. Elsewhere, the destructor removes the file.
class Scratch_file
{
public:
  // Throws std::system_error if no file can be made in the directory.
  explicit Scratch_file(const std::filesystem::path& directory)
    : directory_(directory), path_(make_empty_file(directory))
  {
    using std::ios_base;
    if(!file_.open(path_, ios_base::in | ios_base::out | ios_base::binary))
      fail("opened");
    remove_name();
  }

  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;

  ~Scratch_file()
  {
    file_.close();
    if(!path_.empty())
      remove_name();
  }

  // Throw std::system_error, such as for a full disk.
  void write(std::uint64_t place, const void* bytes, std::size_t count)
  {
    const auto wanted = static_cast<std::streamsize>(count);
    if(!seek(place) || file_.sputn(static_cast<const char*>(bytes), wanted) != wanted)
      fail("written");
  }
  void read(std::uint64_t place, void* bytes, std::size_t count)
  {
    const auto wanted = static_cast<std::streamsize>(count);
    if(!seek(place) || file_.sgetn(static_cast<char*>(bytes), wanted) != wanted)
      fail("read");
  }

private:
  // Makes a file that did not exist: another process may look for a name at the same time.
  static std::filesystem::path make_empty_file(const std::filesystem::path& directory)
  {
    const auto start = std::chrono::system_clock::now().time_since_epoch().count();
    for(int attempt = 0; attempt < 1000; ++attempt) {
      const auto path = directory / ("thick_intersection_d_" + std::to_string(start) + "_"
                                     + std::to_string(attempt));
      errno = 0;
      if(std::FILE* file = std::fopen(path.string().c_str(), "wbx")) {
        std::fclose(file);
        return path;
      }
      if(errno != EEXIST)
        break;
    }
    throw_error(directory, "made");
  }

  void remove_name()
  {
    std::error_code error;
    if(std::filesystem::remove(path_, error))
      path_.clear();
  }

  // Also writes what is still in the buffer of the stream.
  bool seek(std::uint64_t place)
  {
    errno = 0;
    return file_.pubseekpos(std::streampos(static_cast<std::streamoff>(place)))
           != std::streampos(std::streamoff(-1));
  }

  [[noreturn]] void fail(const char* what) const { throw_error(directory_, what); }

  [[noreturn]] static void throw_error(const std::filesystem::path& directory, const char* what)
  {
    throw std::system_error(errno == 0 ? EIO : errno, std::generic_category(),
                            "The scratch file in " + directory.string() + " cannot be "
                              + what);
  }

  std::filesystem::path directory_;
  std::filesystem::path path_; // empty if the file has no name
  std::filebuf file_;
};

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_EXTERNAL_SCRATCH_FILE_H
