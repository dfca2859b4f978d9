// What a measurement has to say about the machine it was made on.
#pragma once

#include <string>

namespace burnish {

std::string processor_name();  // "unknown processor" where the system does not tell
double load_average();         // of the last minute; negative where it is unknown

// Processor time of all threads of this program so far, its own and the system's for it, seconds.
double process_cpu_seconds();

// "2026-11-25T03:50:00Z"
std::string utc_time();

}  // namespace burnish
