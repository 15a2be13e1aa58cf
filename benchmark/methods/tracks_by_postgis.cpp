// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "track_methods.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace thick_benchmark {

namespace {

// A program that reads what is written to it, and has ended when this object has.
using Program = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

void put_fix(std::FILE* out, const Place_at_time& fix)
{
  const auto& [x, y, z] = fix.place;
  std::fprintf(out, "%.17g %.17g %.17g %.17g", x, y, z, fix.time);
}

// A line with the track and the two ends of each leg, whose measure is the time. In the plane, z is
// 0: without it, the index is slower.
void put_legs(std::FILE* out, const Track_scene& scene)
{
  for(std::size_t i = 0; i < scene.tracks.size(); ++i)
    for(std::size_t k = 1; k < scene.tracks[i].size(); ++k) {
      std::fprintf(out, "%zu\tLINESTRING ZM (", i);
      put_fix(out, scene.tracks[i][k - 1]);
      std::fputs(", ", out);
      put_fix(out, scene.tracks[i][k]);
      std::fputs(")\n", out);
    }
}

// The nanoseconds that the processor has spent on this query's process.
constexpr const char* processor_time
  = "SELECT split_part(pg_read_file('/proc/self/schedstat'), ' ', 1);\n";

void put_search(std::FILE* out, double r)
{
  std::fputs(processor_time, out);
  std::fprintf(out,
               "CREATE TEMP TABLE pairs AS SELECT DISTINCT a.track i, b.track j FROM legs a, legs b"
               " WHERE a.track < b.track AND ST_Expand(a.leg, %.17g, %.17g, %.17g, 0) &&& b.leg"
               " AND ST_CPAWithin(a.leg, b.leg, %.17g);\n",
               r, r, r, r);
  std::fputs(processor_time, out);
  std::fputs("SELECT i, j FROM pairs;\n", out);
}

} // namespace

Timed_pairs tracks_by_postgis(const Track_scene& scene)
{
  char file[] = "/tmp/tracks_by_postgis_XXXXXX";
  close(mkstemp(file));
  {
    const std::string command = "psql -qAtX -F ' ' -v ON_ERROR_STOP=1 > " + std::string(file);
    const Program psql(popen(command.c_str(), "w"), pclose);
    std::fputs("CREATE TEMP TABLE legs (track integer, leg geometry);\nCOPY legs FROM STDIN;\n",
               psql.get());
    put_legs(psql.get(), scene);
    std::fputs("\\.\nCREATE INDEX ON legs USING gist (leg gist_geometry_ops_nd);\nANALYZE legs;\n",
               psql.get());
    put_search(psql.get(), scene.r);
  }
  std::ifstream in(file);
  double begin, end;
  if(!(in >> begin >> end))
    throw std::runtime_error("psql does not answer");
  Timed_pairs result = {{}, 1e-9 * (end - begin)};
  for(std::size_t i, j; in >> i >> j;)
    result.found(i, j);
  unlink(file);
  return result;
}

} // namespace thick_benchmark
