<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- A part of a tag file as doxygen makes them. SPDX-License-Identifier: LGPL-3.0-or-later -->
<tagfile>
  <compound kind="class">
    <name>CGAL::Simple_cartesian</name>
    <filename>structCGAL_1_1Simple__cartesian.html</filename>
  </compound>
  <compound kind="class">
    <name>CGAL::Exact_predicates_exact_constructions_kernel</name>
    <filename>classCGAL_1_1Exact__predicates__exact__constructions__kernel.html</filename>
  </compound>
</tagfile>
