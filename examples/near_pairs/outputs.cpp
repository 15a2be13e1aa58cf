// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Atomic output files; see outputs.h.

#include "outputs.h"

#include "error.h"
#include "temporary_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <random>
#include <system_error>

namespace near_pairs {
namespace {

namespace fs = std::filesystem;

// Whether what is written here would stand among the lines of the summary. fs::equivalent() of GCC
// 12 compares no pipes. A device, such as /dev/null or a terminal, may be both.
bool is_standard_output(const fs::path& file)
{
  struct stat a, b;
  return ::stat(file.c_str(), &a) == 0 && ::fstat(STDOUT_FILENO, &b) == 0 && a.st_dev == b.st_dev
         && a.st_ino == b.st_ino && !S_ISCHR(a.st_mode);
}

} // namespace

fs::path target_of(const fs::path& file)
{
  const int most_links = 40; // as Linux follows
  std::error_code ignored;
  fs::path target = file;
  for(int i = 0; i < most_links && fs::is_symlink(target, ignored) && !fs::exists(target, ignored);
      ++i)
    target = target.parent_path() / fs::read_symlink(target, ignored);
  target = fs::weakly_canonical(target, ignored);
  return target.empty() ? file : target;
}

Output_file::Output_file(const std::string& file, const std::vector<std::string>& inputs)
  : name_(file)
{
  std::error_code ignored;
  if(file == "-")
    return;
  if(fs::is_directory(file, ignored))
    throw Error(file, "is a directory");
  for(const std::string& input : inputs)
    if(fs::equivalent(file, input, ignored))
      throw Error(file, "is the input file");
  target_ = target_of(file); // a link stays one: its target is replaced
  if(fs::exists(target_, ignored)) {
    if(is_standard_output(target_))
      throw Error(file, "is the standard output, which has the name - here");
    file_.open(target_, std::ios::app); // changes nothing: asks whether it may be replaced
    if(!file_)
      throw Error(file, std::strerror(errno));
    if(!fs::is_regular_file(target_, ignored))
      return;
    file_.close();
  }
  open_temporary();
}

void Output_file::open_temporary()
{
  std::random_device random;
  std::error_code ignored;
  do {
    temporary_ = target_;
    temporary_ += ".part" + std::to_string(random());
  } while(fs::exists(temporary_, ignored));
  remember_temporary_file(temporary_.string());
  file_.open(temporary_);
  if(!file_) {
    const int error = errno;
    forget_temporary_file(temporary_.string());
    throw Error(name_, std::strerror(error));
  }
  const fs::perms permissions = fs::status(target_, ignored).permissions();
  if(permissions != fs::perms::unknown) // of a file that is replaced
    fs::permissions(temporary_, permissions, ignored);
}

Output_file::~Output_file()
{
  if(temporary_.empty())
    return;
  file_.close();
  std::error_code ignored;
  fs::remove(temporary_, ignored);
  forget_temporary_file(temporary_.string());
}

std::ostream& Output_file::stream()
{
  return name_ == "-" ? std::cout : file_;
}

void Output_file::check()
{
  if(!stream())
    throw Error(name_, "cannot be written to its end");
}

void Output_file::commit()
{
  stream().flush();
  if(name_ != "-")
    file_.close();
  check();
  if(temporary_.empty())
    return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if(error)
    throw Error(name_, error.message());
  forget_temporary_file(temporary_.string());
  temporary_.clear();
}

std::unique_ptr<Output_file> open_output(const std::string& file,
                                         const std::vector<std::string>& inputs)
{
  return file.empty() ? nullptr : std::make_unique<Output_file>(file, inputs);
}

} // namespace near_pairs
