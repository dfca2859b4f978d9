// BURNISH_API marks the part of a namespace whose symbols the shared library exports; all others
// are hidden.
#pragma once

#define BURNISH_API [[gnu::visibility("default")]]
