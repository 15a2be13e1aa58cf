// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "outputs.h"

#include "measuring/run_facts.h"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace thick_benchmark {

namespace {

const char* const columns[] = {"name", "n", "k", "ms", "quantity", "measured", "target", "good",
                               "verdict", "machine"};
const int widths[] = {50, 9, 10, 8, 28, 8, 8, 5, 7, 7};

std::string number(double value)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals(value)) << value;
  return text.str();
}

std::string number(const std::optional<double>& value) { return value ? number(*value) : ""; }

std::string bound(const Goal& goal, const std::optional<double>& value)
{
  return value ? (goal.sense == Goal::AT_MOST ? "<= " : ">= ") + number(*value) : "";
}

std::string milliseconds(const Row& row)
{
  std::ostringstream text;
  if(row.milliseconds)
    text << std::fixed << std::setprecision(1) << *row.milliseconds;
  return text.str();
}

// The cells of a row, in the order of the columns.
std::vector<std::string> cells(const Row& row)
{
  return {row.name, std::to_string(row.n), std::to_string(row.k), milliseconds(row), row.quantity,
          number(row.measured), bound(row.goal, row.goal.target), number(row.goal.good),
          verdict(row), number(row.machine_speed_up)};
}

bool is_text(std::size_t column) { return column == 0 || column == 4 || column == 8; }

template <class Cells>
void print_cells(std::ostream& out, const Cells& cells)
{
  std::size_t column = 0;
  for(const auto& cell : cells) {
    out << (is_text(column) ? std::left : std::right) << std::setw(widths[column]) << cell << "  ";
    ++column;
  }
  out << std::endl; // at once: the next row takes a while
}

std::ofstream open(const std::string& file)
{
  std::ofstream out(file);
  if(!out)
    throw std::runtime_error("Cannot write " + file + ".");
  return out;
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for(char c : text)
    result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return result + "\"";
}

// A number in full, or `missing`.
std::string in_full(const std::optional<double>& value, const char* missing)
{
  std::ostringstream text;
  text << std::setprecision(10);
  if(value)
    text << *value;
  return value ? text.str() : missing;
}

std::string json(const std::optional<double>& value) { return in_full(value, "null"); }
std::string csv(const std::optional<double>& value) { return in_full(value, ""); }

void write_json_row(std::ostream& out, const Row& row)
{
  out << "    {\"name\": " << quoted(row.name) << ", \"n\": " << row.n << ", \"k\": " << row.k
      << ", \"milliseconds\": " << json(row.milliseconds)
      << ", \"quantity\": " << quoted(row.quantity) << ", \"measured\": " << json(row.measured)
      << ", \"target\": " << json(row.goal.target) << ", \"good\": " << json(row.goal.good)
      << ", \"verdict\": " << quoted(verdict(row))
      << ", \"machine_speed_up\": " << json(row.machine_speed_up) << "}";
}

} // namespace

int decimals(double value) { return value < 10 ? 2 : value < 100 ? 1 : 0; }

std::string verdict(const Row& row)
{
  const double unit = std::pow(0.1, decimals(row.measured));
  const double shown = std::round(row.measured / unit) * unit;
  const auto reaches = [&](double value) {
    return row.goal.sense == Goal::AT_MOST ? shown <= value + unit / 2 : shown >= value - unit / 2;
  };
  if(!row.goal.target)
    return "";
  if(!reaches(*row.goal.target))
    return "missed";
  return row.goal.good && reaches(*row.goal.good) ? "good" : "met";
}

void print_head(std::ostream& out) { print_cells(out, columns); }
void print_row(std::ostream& out, const Row& row) { print_cells(out, cells(row)); }

void write_json(const std::string& file, const Rows& rows)
{
  std::ofstream out = open(file);
  out << "{\n  \"context\": {\n";
  const char* separator = "";
  for(const Run_fact& fact : run_facts()) {
    out << separator << "    " << quoted(fact.name) << ": " << quoted(fact.value);
    separator = ",\n";
  }
  out << "\n  },\n  \"rows\": [\n";
  separator = "";
  for(const Row& row : rows) {
    out << separator;
    write_json_row(out, row);
    separator = ",\n";
  }
  out << "\n  ]\n}\n";
}

void write_csv(const std::string& file, const Rows& rows)
{
  std::ofstream out = open(file);
  for(const Run_fact& fact : run_facts())
    out << "# " << fact.name << ": " << fact.value << '\n';
  out << "name,n,k,milliseconds,quantity,measured,target,good,verdict,machine_speed_up\n";
  for(const Row& row : rows)
    out << quoted(row.name) << ',' << row.n << ',' << row.k << ',' << csv(row.milliseconds) << ','
        << quoted(row.quantity) << ',' << csv(row.measured) << ',' << csv(row.goal.target) << ','
        << csv(row.goal.good) << ',' << verdict(row) << ',' << csv(row.machine_speed_up) << '\n';
}

void write_markdown(const std::string& file, const Rows& rows)
{
  std::ofstream out = open(file);
  print_run_facts(out);
  out << "\n| scene | n | k | ms | quantity | measured | target | good | verdict | machine |\n"
      << "|---|--:|--:|--:|---|--:|--:|--:|---|--:|\n";
  for(const Row& row : rows) {
    for(const std::string& cell : cells(row))
      out << "| " << cell << ' ';
    out << "|\n";
  }
}

} // namespace thick_benchmark
