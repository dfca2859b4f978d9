// The figures of the lobe inspector: D over half vectors, the lobe in space, the polar cut, the table of a
// measured material.
//
// Each is drawn into the ImGui window that is begun, at its cursor, as an item of its own.
//
// Threads: the one on which the window's context is current.
#pragma once

#include <cstddef>

#include "viewer/window/app.hpp"

namespace burnish::viewer {

// Of method number `index`, `side` pixels a side (the cut is half as high). `large`: with words beside what is marked.
void disk_figure(const Picked& picked, std::size_t index, float side, bool large);
void lobe_figure(const Picked& picked, std::size_t index, float side, bool large);
void cut_figure(const Picked& picked, std::size_t index, float side, bool large);

// The exemplar's table with its legend and the cell under the mouse. Draws nothing at a point without a table.
void table_figure(const Picked& picked, float side, float scale);

}  // namespace burnish::viewer
