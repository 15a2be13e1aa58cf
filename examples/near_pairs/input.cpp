// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Bytes and lines of an input; see input.h.

#include "input.h"

#include "error.h"

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace near_pairs {
namespace {

namespace io = boost::iostreams;

std::string all_bytes(std::istream& stream, const std::string& name)
{
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  if(stream.bad())
    throw Error(name, "cannot be read to its end");
  return bytes;
}

// CR if that is the last letter of the lines at the beginning of a text, and LF otherwise. A CR
// that nothing has been read behind may be half of an end of a line.
char end_of_lines(const Input& input)
{
  std::string begin(1 << 16, '\0');
  const auto stream = input.open();
  stream->read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(stream->gcount()));
  if(*stream && begin.back() == '\r')
    begin.pop_back();
  return begin.find('\n') == std::string::npos && begin.find('\r') != std::string::npos ? '\r'
                                                                                     : '\n';
}

} // namespace

void take_mark(std::string& line, const std::string& file)
{
  const std::string mark = "\xEF\xBB\xBF";
  const std::string begin = line.substr(0, 2);
  if(begin == "\xFF\xFE" || begin == "\xFE\xFF")
    throw Error(file, "is in UTF-16; save it in UTF-8");
  if(line.compare(0, mark.size(), mark) == 0)
    line.erase(0, mark.size());
}

Input::Input(const std::string& name, bool shows_progress)
  : name_(name), shows_progress_(shows_progress)
{
  const std::string magic = "\x1f\x8b"; // of gzip
  if(name == "-")
    bytes_ = all_bytes(std::cin, name);
  else {
    std::error_code ignored; // opening the file has a better message
    if(std::filesystem::is_directory(name, ignored))
      throw Error(name, "is a directory");
    std::ifstream file(name, std::ios::binary);
    if(!file)
      throw Error(name, std::strerror(errno));
    if(std::filesystem::is_regular_file(name, ignored)) {
      std::string begin(magic.size(), '\0');
      file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
      is_compressed_ = begin == magic;
      if(!is_compressed_)
        size_ = std::filesystem::file_size(name, ignored);
      return;
    }
    bytes_ = all_bytes(file, name);
  }
  is_kept_ = true;
  is_compressed_ = bytes_.compare(0, magic.size(), magic) == 0;
}

std::unique_ptr<std::istream> Input::open() const
{
  const io::array_source kept(bytes_.data(), bytes_.size());
  if(is_compressed_) {
    auto stream = std::make_unique<io::filtering_istream>();
    stream->push(io::gzip_decompressor());
    if(is_kept_)
      stream->push(kept);
    else
      stream->push(io::file_source(name_, std::ios::binary));
    return stream;
  }
  if(is_kept_)
    return std::make_unique<io::stream<io::array_source>>(kept);
  return std::make_unique<std::ifstream>(name_, std::ios::binary);
}

std::string Input::text() const
{
  std::string text;
  try {
    const std::unique_ptr<std::istream> stream = open();
    stream->exceptions(std::ios::badbit);
    text.assign(std::istreambuf_iterator<char>(*stream), {});
  }
  catch(const std::ios::failure&) {
    throw Error(name_, "cannot be read to its end");
  }
  take_mark(text, name_);
  return text;
}

void Input::show_bytes(std::size_t bytes) const
{
  if(!shows_progress_)
    return;
  const std::size_t mebibytes = bytes >> 20;
  if(size_ == 0)
    std::fprintf(stderr, "reading %5zu MiB\r", mebibytes);
  else
    std::fprintf(stderr, "reading   %3zu %%  \r", 100 * std::min(bytes, size_) / (size_ + 1));
}

void Input::check_end(std::size_t bytes) const
{
  if(size_ != 0 && bytes != size_)
    throw Error(name_, "has " + std::to_string(bytes) + " bytes, and had " + std::to_string(size_)
                + " when it was opened");
}

Lines::Lines(const Input& input)
  : input_(input), stream_(input.open()), end_(end_of_lines(input))
{}

bool Lines::next(std::string& line)
{
  const std::size_t shown = bytes_ >> 20;
  const bool is_read = get_line(line);
  if(is_read)
    bytes_ += line.size() + !stream_->eof();
  if(stream_->eof()) // perhaps inside of a line
    input_.check_end(bytes_);
  if(!is_read)
    return false;
  ++number_;
  if(number_ == 1 || bytes_ >> 20 != shown)
    input_.show_bytes(bytes_);
  if(number_ == 1)
    take_mark(line, file());
  if(!line.empty() && line.back() == '\r')
    line.pop_back();
  return true;
}

// Memory that runs out, in a line that is as long as the file, is no fault of the file.
bool Lines::get_line(std::string& line)
{
  try {
    stream_->exceptions(std::ios::badbit);
    const bool is_read = bool(std::getline(*stream_, line, end_));
    stream_->exceptions(std::ios::goodbit);
    return is_read;
  }
  catch(const std::ios::failure&) {
    throw Error(file(), "cannot be read to its end");
  }
}

bool Lines::read_bytes(std::string& bytes, std::size_t count)
{
  bytes.resize(count);
  bytes_ += count;
  return bool(stream_->read(bytes.data(), static_cast<std::streamsize>(count)));
}

bool Lines::skip_bytes(std::size_t count)
{
  bytes_ += count;
  stream_->ignore(static_cast<std::streamsize>(count));
  return static_cast<std::size_t>(stream_->gcount()) == count;
}

} // namespace near_pairs
