// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Molecules in the format mmCIF; see cif_reader.h. The grammar of CIF is that of the library gemmi.
// Its Document holds values as text, as we need them, but not their lines: so the values come to
// the actions below, which keep those of the atoms.

#include "cif_reader.h"

#include "error.h"
#include "text.h"

#include <gemmi/cif.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace near_pairs {
namespace {

namespace cif = gemmi::cif;

// What we want to know of a data block.
enum Field { X, Y, Z, ID, LABEL, MODEL, FRACTION, A, B, C, ALPHA, BETA, GAMMA,
             MATRIX_11, MATRIX_12, MATRIX_13, MATRIX_21, MATRIX_22, MATRIX_23, MATRIX_31, MATRIX_32,
             MATRIX_33, GROUP, OTHER };

const char* const matrix = "_atom_sites_fract_transf_matrix";

// The tags of mmCIF have a point, where those of its older sister have an underscore. They are the
// same in any case.
Field field_of(const std::string& tag)
{
  static const std::map<std::string, Field> fields = {
    {"_atom_site_cartn_x", X}, {"_atom_site_cartn_y", Y}, {"_atom_site_cartn_z", Z},
    {"_atom_site_id", ID}, {"_atom_site_label", LABEL}, {"_atom_site_pdbx_pdb_model_num", MODEL},
    {"_atom_site_fract_x", FRACTION}, {"_cell_length_a", A}, {"_cell_length_b", B},
    {"_cell_length_c", C}, {"_cell_angle_alpha", ALPHA}, {"_cell_angle_beta", BETA},
    {"_cell_angle_gamma", GAMMA},
    {std::string(matrix) + "[1][1]", MATRIX_11}, {std::string(matrix) + "[1][2]", MATRIX_12},
    {std::string(matrix) + "[1][3]", MATRIX_13}, {std::string(matrix) + "[2][1]", MATRIX_21},
    {std::string(matrix) + "[2][2]", MATRIX_22}, {std::string(matrix) + "[2][3]", MATRIX_23},
    {std::string(matrix) + "[3][1]", MATRIX_31}, {std::string(matrix) + "[3][2]", MATRIX_32},
    {std::string(matrix) + "[3][3]", MATRIX_33}, {"_symmetry_space_group_name_h-m", GROUP},
    {"_space_group_name_h-m_alt", GROUP}};
  std::string name = lower_case(tag);
  std::replace(name.begin(), name.end(), '.', '_');
  const auto found = fields.find(name);
  return found == fields.end() ? OTHER : found->second;
}

// A number may have the uncertainty of its last digits behind it, as 1.234(5).
std::string without_uncertainty(const std::string& number)
{
  const std::size_t open = number.find('(');
  const bool has_one = open != std::string::npos && number.back() == ')' && open + 2 < number.size()
    && number.find_first_not_of("0123456789", open + 1) == number.size() - 1;
  return has_one ? number.substr(0, open) : number;
}

// Takes the tags and values of a file in their order. Those of an atom are together, in a row of a
// loop, or on their own if the block has one atom.
class Atom_collector
{
public:
  Atom_collector(const std::string& file, std::size_t frame)
    : file_(file), frame_(frame)
  {}

  void begin_loop()
  {
    columns_.clear();
    has_atoms_ = false;
    count_ = 0;
  }

  void add_column(const std::string& tag, std::size_t line)
  {
    columns_.push_back(told(tag, line));
    has_atoms_ |= columns_.back() <= Z;
  }

  void add_to_loop(const std::string& value, std::size_t line)
  {
    take(columns_[count_ % columns_.size()], value, line);
    if(++count_ % columns_.size() == 0 && has_atoms_)
      end_atom();
  }

  bool is_row_cut() const { return count_ % columns_.size() != 0; }

  void begin_item(const std::string& tag, std::size_t line)
  {
    item_ = told(tag, line);
    is_atom_alone_ |= item_ <= Z;
  }

  void add_item(const std::string& value, std::size_t line) { take(item_, value, line); }

  void end_block()
  {
    if(is_atom_alone_)
      end_atom();
    is_atom_alone_ = false;
    if(first_frame_ <= frame_ && frame_ <= frames)
      take_crystal();
    is_told_.fill(false);
    values_.fill("");
    models_.clear();
    first_frame_ = frames + 1;
  }

  void finish()
  {
    end_block();
    if(frames == 0 && line_of_fraction_ != 0)
      throw Error(file_, line_of_fraction_, "coordinates are fractions of a cell, and not Cartn_x, "
                  "Cartn_y and Cartn_z of mmCIF ('ase convert' makes an .xyz file of this one)");
    if(frames == 0)
      throw Error(file_, "no atoms, which have _atom_site.Cartn_x");
  }

  std::size_t frames = 0;
  std::vector<Row> rows; // of the frame
  std::optional<Crystal> crystal;
  std::size_t line_of_cell = 0;

private:
  Field told(const std::string& tag, std::size_t line)
  {
    const Field field = field_of(tag);
    if(field < GROUP && std::exchange(is_told_[field], true))
      throw Error(file_, line, tag + " is there twice in the block");
    if(field == FRACTION)
      line_of_fraction_ = line;
    return field;
  }

  void take(Field field, const std::string& value, std::size_t line)
  {
    if(field == OTHER)
      return;
    values_[field] = without_uncertainty(cif::is_null(value) ? value : cif::as_string(value));
    if(field <= Z)
      line_ = line;
    if(field == A)
      line_of_cell_in_hand_ = line;
  }

  void end_atom()
  {
    for(Field axis : {X, Y, Z})
      if(!is_told_[axis])
        throw Error(file_, line_, std::string("no _atom_site.Cartn_") + "xyz"[axis]);
    const auto [model, is_new] = models_.emplace(values_[MODEL], frames + 1);
    frames += is_new;
    if(model->second == frame_)
      rows.push_back({line_, {values_[X], values_[Y], values_[Z]},
                      values_[is_told_[ID] ? ID : LABEL]});
  }

  // What nobody knows is told by question marks.
  bool are_known(Field first, Field last) const
  {
    return std::none_of(values_.begin() + first, values_.begin() + last + 1,
      [](const std::string& value) { return value.empty() || cif::is_null(value); });
  }

  void take_crystal()
  {
    if(!are_known(A, GAMMA))
      return;
    crystal = Crystal{{values_[A], values_[B], values_[C]},
                      {values_[ALPHA], values_[BETA], values_[GAMMA]},
                      are_known(GROUP, GROUP) ? values_[GROUP] : "", {}};
    if(are_known(MATRIX_11, MATRIX_33))
      crystal->fractions.assign(values_.begin() + MATRIX_11, values_.begin() + MATRIX_33 + 1);
    line_of_cell = line_of_cell_in_hand_;
  }

  const std::string& file_;
  std::size_t frame_;
  std::array<bool, OTHER> is_told_ = {};     // in the block
  std::array<std::string, OTHER> values_;    // the last ones
  std::map<std::string, std::size_t> models_; // of the block: the frames that they are
  std::size_t first_frame_ = 1;              // of the block, if it has one
  std::vector<Field> columns_;               // of the loop
  bool has_atoms_ = false;                   // the loop
  std::size_t count_ = 0;                    // of its values
  Field item_ = OTHER;
  bool is_atom_alone_ = false;               // in no loop
  std::size_t line_ = 0;                     // of the atom
  std::size_t line_of_cell_in_hand_ = 0, line_of_fraction_ = 0;
};

// What to do where a rule of the grammar is met: to call a function, with the text and its line or
// without, or to refuse the file.
template <class Rule>
struct Action : tao::pegtl::nothing<Rule>
{};

template <void (Atom_collector::*function)()>
struct Call
{
  template <class In>
  static void apply(const In&, Atom_collector& atoms)
  {
    (atoms.*function)();
  }
};

template <void (Atom_collector::*function)(const std::string&, std::size_t)>
struct Call_with_text
{
  template <class In>
  static void apply(const In& in, Atom_collector& atoms)
  {
    (atoms.*function)(in.string(), in.iterator().line);
  }
};

namespace rules = cif::rules;
template <> struct Action<rules::datablockheading> : Call<&Atom_collector::end_block> {};
template <> struct Action<rules::str_loop> : Call<&Atom_collector::begin_loop> {};
template <> struct Action<rules::loop_tag> : Call_with_text<&Atom_collector::add_column> {};
template <> struct Action<rules::loop_value> : Call_with_text<&Atom_collector::add_to_loop> {};
template <> struct Action<rules::item_tag> : Call_with_text<&Atom_collector::begin_item> {};
template <> struct Action<rules::item_value> : Call_with_text<&Atom_collector::add_item> {};

template <>
struct Action<rules::loop_end>
{
  template <class In>
  static void apply(const In& in, Atom_collector& atoms)
  {
    if(atoms.is_row_cut())
      throw tao::pegtl::parse_error("the last row of the loop is not complete", in);
  }
};

template <>
struct Action<rules::missing_value>
{
  template <class In>
  static void apply(const In& in, Atom_collector&)
  {
    throw tao::pegtl::parse_error("a tag has no value", in);
  }
};

std::string all_lines(const Input& input)
{
  Lines lines(input);
  std::string text;
  for(std::string line; lines.next(line); )
    text += line + '\n';
  return text;
}

} // namespace

Cif_reader::Cif_reader(const Input& input, const Read_options& options)
{
  dimension = options.dimension == 0 ? 3 : options.dimension;
  unit = "\u00C5";
  has_ids = true;
  frame.number = options.frame;
  const std::string text = all_lines(input);
  if(text.empty())
    throw Error(input.name(), "is empty");
  Atom_collector atoms(input.name(), frame.number);
  try {
    tao::pegtl::memory_input<> in(text.data(), text.size(), input.name());
    tao::pegtl::parse<rules::file, Action, cif::Errors>(in, atoms);
  }
  catch(const tao::pegtl::parse_error& error) {
    throw Error(error.what()); // with file, line and column
  }
  atoms.finish();
  frame.count = atoms.frames;
  require_frame(input.name());
  rows_ = std::move(atoms.rows);
  crystal_ = atoms.crystal;
  line_of_cell = atoms.line_of_cell;
}

bool Cif_reader::next(Row& row)
{
  if(next_ == rows_.size())
    return false;
  row = rows_[next_++];
  return true;
}

std::optional<Cell> Cif_reader::cell() const
{
  if(!crystal_)
    return std::nullopt;
  return crystal_cell(*crystal_, "_cell");
}

} // namespace near_pairs
