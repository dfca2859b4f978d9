// The machine that a measurement was made on.
#pragma once

#include <string>

namespace burnish {

std::string processor_name();  // "unknown processor" where the system does not say
double load_average();         // of the last minute; negative where it is unknown

// Processor time of all threads of this program so far, user and system time together, in seconds.
double process_cpu_seconds();

// The time now in UTC, as in "2026-11-25T03:50:00Z".
std::string utc_time();

}  // namespace burnish
