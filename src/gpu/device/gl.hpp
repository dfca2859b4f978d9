// The one place that includes the functions of OpenGL. epoxy finds each function in the context
// that is current when it is first called: nothing has to be loaded.
#pragma once

#include <epoxy/gl.h>
