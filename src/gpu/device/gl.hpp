// The only header that includes the functions of OpenGL. epoxy looks up each function in the
// current context at its first call, so nothing has to be loaded.
#pragma once

#include <epoxy/gl.h>
