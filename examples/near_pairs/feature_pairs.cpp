// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Pairs of features of files; see feature_pairs.h.

#include "feature_pairs.h"

#include "error.h"
#include "exact_number.h"
#include "feature_picture.h"
#include "outputs.h"
#include "row_reader.h"
#include "solid_picture.h"
#include "standard_streams.h"
#include "summary.h"
#include "text.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace near_pairs {
namespace {

using Files = std::vector<std::vector<Feature>>;

// Features have doubles as coordinates.
void refuse_options_for_points(const Options& options)
{
  const std::pair<const char*, bool> for_points[]
    = {{"closest", options.closest}, {"geographic", options.geographic},
       {"decimal", options.decimal}, {"kernel exact", options.kernel == "exact"},
       {"memory", options.memory != 0}, {"points", !options.points.empty()},
       {"coordinates", options.coordinates}, {"components", options.components},
       {"explain", options.explain}, {"dimension 3", options.dimension == 3},
       {"dimension 2", options.dimension == 2 && options.solids},
       {"periodic", options.is_periodic}};
  for(const auto& [name, is_given] : for_points)
    if(is_given)
      throw Error(std::string("--") + name + " is for points, and "
                  + (options.solids ? "--solids has none"
                                    : "a file of WKT or GeoJSON has features"));
  if(extension(options.pairs) == ".geojson")
    throw Error("--pairs: pairs of features are a table, so name it .csv");
}

// Writes positions, and ids and properties if a file has some.
class Feature_pair_table
{
public:
  Feature_pair_table(std::ostream& out, const Files& files)
    : out_(out), first_(files.front()), second_(files.back()),
      has_ids_(have([](const Feature& feature) { return !feature.id.empty(); })),
      has_properties_(have([](const Feature& feature) { return !feature.properties.empty(); }))
  {
    out_ << "i,j" << (has_ids_ ? ",id_i,id_j" : "")
         << (has_properties_ ? ",properties_i,properties_j" : "") << '\n';
  }

  void add(std::size_t i, std::size_t j)
  {
    const Feature& a = first_[i];
    const Feature& b = second_[j];
    out_ << i << ',' << j;
    if(has_ids_)
      out_ << ',' << csv_field(a.id) << ',' << csv_field(b.id);
    if(has_properties_)
      out_ << ',' << csv_field(a.properties) << ',' << csv_field(b.properties);
    out_ << '\n';
  }

private:
  template <class Predicate>
  bool have(Predicate has) const
  {
    return std::any_of(first_.begin(), first_.end(), has)
           || std::any_of(second_.begin(), second_.end(), has);
  }

  std::ostream& out_;
  const std::vector<Feature>& first_;
  const std::vector<Feature>& second_;
  bool has_ids_, has_properties_;
};

// Which features are in a pair.
class In_pairs
{
public:
  explicit In_pairs(const Files& files)
  {
    for(const std::vector<Feature>& features : files)
      are_in_.emplace_back(features.size());
  }

  void add(std::size_t i, std::size_t j)
  {
    are_in_.front()[i] = true;
    are_in_.back()[j] = true;
  }

  const std::vector<std::vector<bool>>& operator()() const { return are_in_; }

private:
  std::vector<std::vector<bool>> are_in_;
};

template <class Value>
std::string of_each_file(const Files& files, Value value)
{
  const std::string first = std::to_string(value(0));
  return files.size() == 1 ? first : first + " and " + std::to_string(value(1));
}

void print_summary(std::ostream& out, const Files& files,
                   const std::vector<std::string>& guessed, const Options& options,
                   const In_pairs& in_pairs, std::size_t pairs, double seconds)
{
  const char* const name = options.solids ? "solids" : "features";
  const auto count_if = [&](auto is_meant) {
    return of_each_file(files, [&](std::size_t file) {
      return std::count_if(files[file].begin(), files[file].end(), is_meant);
    });
  };
  print_name(out, name)
    << count_if([](const Feature& feature) { return !feature.is_skipped; }) << '\n';
  if(options.solids)
    print_name(out, "closed")
      << count_if([](const Feature& solid) { return solid.mesh.is_closed; })
      << " of the solids, which are filled\n";
  print_guessed(out, guessed);
  if(options.skip_missing)
    print_name(out, "skipped")
      << count_if([](const Feature& feature) { return feature.is_skipped; }) << " rows\n";
  print_name(out, "pairs") << pairs << '\n';
  const auto count_in_pairs = [&](std::size_t file) {
    return std::count(in_pairs()[file].begin(), in_pairs()[file].end(), true);
  };
  print_name(out, "in pairs") << of_each_file(files, count_in_pairs) << " of the " << name << '\n';
  if(options.overlap)
    print_name(out, "relation") << "overlap\n";
  else
    print_name(out, "distance") << distance_in_words(options, "") << '\n';
  print_kernel(out, options);
  print_costs(out, seconds, ", with its outputs");
}

// Solids of one file or of many are one set, and those of two files are two. What a solid is called
// by depends on how many there are.
void add_solids(Files& sets, std::vector<Feature> solids, const std::string& file,
                std::size_t files)
{
  if(sets.empty() || files == 2)
    sets.emplace_back();
  for(Feature& solid : solids) {
    if(solids.size() == 1)
      solid.id = file;
    else if(files > 1)
      solid.id = file + ':' + solid.id;
    sets.back().push_back(std::move(solid));
  }
}

// The columns of tables that were guessed are told by `guessed`.
Files read_files(const Options& options, std::vector<std::string>& guessed)
{
  Files files;
  std::string system;
  for(std::size_t file = 0; file < options.files.size(); ++file) {
    const Input input(options.files[file], options.progress);
    const Read_options& reading = options.readings[file];
    std::vector<Feature> features = read_features(input, reading, system);
    if(options.solids)
      add_solids(files, std::move(features), input.name(), options.files.size());
    else
      files.push_back(std::move(features));
    if(!has_features(input.name(), reading))
      guessed.push_back(guessed_columns(*open_rows(input, reading)));
  }
  return files;
}

// Throws Error if an --id names what is in no file that it is given for. A table without the column
// was refused; of features, some may have no such property.
void check_id(const Options& options, const Files& files)
{
  const auto has_id = [](const Feature& feature) { return !feature.id.empty(); };
  const auto may_have_ids = [&](std::size_t file) {
    return is_table(options.files[file], options) || files[file].empty()
           || std::any_of(files[file].begin(), files[file].end(), has_id);
  };
  for(const Read_options& reading : options.readings) {
    bool is_found = reading.id.empty();
    for(std::size_t file = 0; !is_found && file < files.size(); ++file)
      is_found = options.readings[file].id == reading.id && may_have_ids(file);
    if(!is_found)
      throw Error("--id: no feature has the property '" + reading.id + "'");
  }
}

// Searches, and writes the pairs into the table if there is one. Returns how many there are.
std::size_t write_pairs(const Files& files, const Options& options, Output_file* table_file,
                        In_pairs& in_pairs)
{
  std::optional<Feature_pair_table> table;
  if(table_file)
    table.emplace(table_file->stream(), files);
  std::size_t pairs = 0;
  search_features(files, options, [&](std::size_t i, std::size_t j) {
    ++pairs;
    in_pairs.add(i, j);
    if(table) {
      table->add(i, j);
      table_file->check(); // a full disk ends the search
    }
  });
  return pairs;
}

// Tells of solids that may be other ones than the user believes.
void print_hints(const Files& files)
{
  const auto print = [&](auto is_meant, const std::string& what) {
    std::size_t count = 0;
    const Feature* first = nullptr;
    for(const std::vector<Feature>& solids : files)
      for(const Feature& solid : solids)
        if(is_meant(solid.mesh) && ++count == 1)
          first = &solid;
    if(count != 0)
      std::cerr << "near_pairs: hint: " << plural(count, "solid") << what << "; the first is "
                << one_line(first->id) << '\n';
  };
  print([](const Mesh& mesh) { return !mesh.is_closed; },
        " with open edges: faces alone, and nothing inside");
  print([](const Mesh& mesh) { return mesh.bent_faces != 0; },
        " with faces whose corners are in no plane, which were cut into triangles");
}

} // namespace

bool have_features(const Options& options)
{
  for(std::size_t file = 0; file < options.files.size(); ++file)
    if(has_features(options.files[file], options.readings[file]))
      return true;
  return false;
}

void run_features(const Options& options)
{
  refuse_options_for_points(options);
  std::vector<std::string> guessed;
  const Files files = read_files(options, guessed);
  check_id(options, files);
  catch_signals();
  const std::unique_ptr<Output_file> table_file = open_output(options.pairs, options.files);
  const std::unique_ptr<Output_file> picture_file = open_output(options.picture, options.files);
  In_pairs in_pairs(files);
  const auto start = std::chrono::steady_clock::now();
  const std::size_t pairs = write_pairs(files, options, table_file.get(), in_pairs);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if(picture_file)
    (options.solids ? draw_solids : draw_features)(picture_file->stream(), files, in_pairs(),
                                                   options, pairs);
  for(Output_file* file : {picture_file.get(), table_file.get()})
    if(file)
      file->commit();
  std::ostream& out = options.pairs == "-" || options.picture == "-" ? std::cerr : std::cout;
  print_summary(out, files, guessed, options, in_pairs, pairs, seconds.count());
  finish(out, "the summary");
  if(options.solids)
    print_hints(files);
  if(has_moved_ties(files, options, pairs))
    std::cerr << "near_pairs: hint: pairs " << (options.open ? "within" : "beyond")
              << " the distance may be at it but for rounding of decimals to doubles; a distance "
                 "that is a little "
              << (options.open ? "shorter leaves them out\n" : "longer finds them\n");
}

} // namespace near_pairs
