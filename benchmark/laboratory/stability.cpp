// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Whether an answer depends on what must not matter: the order of the two points, the order of the
// axes, the rounding mode, and, comparing two builds of this program, fused multiplication.
//
//   stability <folder>                  writes stability.csv, and all answers to answers.txt
//   stability <folder> <answers.txt>    compares with the answers of another build: fused.csv

#include "measuring/Csv_file.h"
#include "methods/distance_forms.h"

#include "support/kernels.h"
#include "support/point_generators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <cfenv>

namespace {

using namespace test_support;
using thick_benchmark::Csv_file;
using Form = thick_benchmark::Named_form<3>;
using Array = Form::Point;
using Answers = std::string; // a character '0' or '1' per question

struct Question
{
  Array p, q;
  double r;
};

// A product that is rounded in both builds, so that they ask the same questions.
double product(double x, double y)
{
  const volatile double rounded = x * y;
  return rounded;
}

// Points at a distance of r up to rounding, for many radii.
std::vector<Question> questions()
{
  Random random(1);
  std::vector<Question> result;
  for(int i = 0; i < 20000; ++i) {
    Question question{{}, {}, 0.5 + random.uniform()};
    Array direction;
    double length = 0;
    for(double& x : direction) {
      x = random.uniform() - 0.5;
      length += product(x, x);
    }
    for(int axis = 0; axis < 3; ++axis) {
      question.p[axis] = random.uniform();
      question.q[axis]
        = question.p[axis] + product(question.r, direction[axis] / std::sqrt(length));
    }
    result.push_back(question);
  }
  return result;
}

bool ask_epick(const Array& p, const Array& q, double r)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  return CGAL::compare_squared_distance(Point(p[0], p[1], p[2]), Point(q[0], q[1], q[2]), r * r)
         != CGAL::LARGER;
}

// By the public function, on the two points.
bool ask_package(const Array& p, const Array& q, double r)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const std::vector<Point> points = {{p[0], p[1], p[2]}, {q[0], q[1], q[2]}};
  return !near_pairs(points, CGAL::within_distance(r)).empty();
}

std::vector<Form> forms()
{
  std::vector<Form> forms = thick_benchmark::common_forms<3>();
  forms.push_back({"EPICK, r * r", ask_epick});
  forms.push_back({"ours", ask_package});
  return forms;
}

template <class Change>
Answers answers(const Form& form, const std::vector<Question>& questions, const Change& change)
{
  Answers result;
  for(const Question& question : questions) {
    const Question changed = change(question);
    result += form.is_near(changed.p, changed.q, changed.r) ? '1' : '0';
  }
  return result;
}

std::size_t count_differences(const Answers& a, const Answers& b)
{
  std::size_t count = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    count += a[i] != b[i];
  return count;
}

Question as_it_is(const Question& question) { return question; }

Question with_points_swapped(const Question& question)
{
  return {question.q, question.p, question.r};
}

Question with_axes_reversed(const Question& question)
{
  return {{question.p[2], question.p[1], question.p[0]},
          {question.q[2], question.q[1], question.q[0]},
          question.r};
}

const char* const truth = "none needed: answers of one method are compared with each other";

void write_changes(const std::string& folder)
{
  Csv_file csv(folder, "stability.csv", truth, "method,change,questions,changed");
  std::ofstream all_answers(folder + "/answers.txt");
  const std::vector<Question> all = questions();
  for(const Form& form : forms()) {
    const Answers base = answers(form, all, as_it_is);
    all_answers << base << '\n';
    const auto write = [&](const char* change, const Answers& other) {
      csv.row(form.name, change, all.size(), count_differences(base, other));
    };
    write("p and q swapped", answers(form, all, with_points_swapped));
    write("axes reversed", answers(form, all, with_axes_reversed));
    const auto write_mode = [&](const char* name, int mode) {
      std::fesetround(mode);
      const Answers other = answers(form, all, as_it_is);
      std::fesetround(FE_TONEAREST);
      write(name, other);
    };
    write_mode("rounding up", FE_UPWARD);
    write_mode("rounding down", FE_DOWNWARD);
    write_mode("rounding to zero", FE_TOWARDZERO);
  }
}

void write_differences_of_builds(const std::string& folder, const std::string& answers_of_other)
{
  Csv_file csv(folder, "fused.csv", truth, "method,change,questions,changed");
  std::ifstream other(answers_of_other);
  const std::vector<Question> all = questions();
  for(const Form& form : forms()) {
    Answers base;
    std::getline(other, base);
    csv.row(form.name, "fused multiplication", all.size(),
            count_differences(base, answers(form, all, as_it_is)));
  }
}

} // namespace

int main(int count, char** arguments)
{
  if(count == 2)
    write_changes(arguments[1]);
  else
    write_differences_of_builds(arguments[1], arguments[2]);
}
