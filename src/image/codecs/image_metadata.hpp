// How text attributes travel in image files. Private to the image readers and writers.
#pragma once

#include <OpenImageIO/imageio.h>

#include <map>
#include <string>

namespace burnish {

using Metadata = std::map<std::string, std::string>;

// Puts `metadata` on what will be written. Formats that keep only names they know (`keeps_names` is
// false) get the names with a colon, "burnish:command", as "name=value" lines of
// "ImageDescription".
void put_metadata(OIIO::ImageSpec& spec, const Metadata& metadata, bool keeps_names);

// All attributes of a file as text of one line each, the lines of put_metadata taken apart again.
Metadata metadata_of(const OIIO::ImageSpec& spec);

}  // namespace burnish
