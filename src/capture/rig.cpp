#include "capture/rig.hpp"
