// Which channels of a picture are its color. Private to the image readers.
#pragma once

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

namespace burnish {

// Consecutive channels, in the order red, green, blue, alpha where there are these.
struct ChannelChoice {
    int first = 0, count = 0;
    bool has_alpha = false;           // the last one
    std::string layer;                // "ViewLayer.Combined"; empty for channels without a layer
    std::vector<std::string> others;  // other layers with red, green and blue
};

// OpenEXR: the channels R, G, B and A without a layer, else those of the first layer that has R, G
// and B. Otherwise all of up to four channels, else the leading R, G, B and A. Throws Error naming
// the channels when there are more than four and no R, G, B.
ChannelChoice choose_channels(const OIIO::ImageSpec& spec, bool has_layers,
                              const std::string& name);

// Whether a layer has R, G and B.
bool has_color(const OIIO::ImageSpec& spec);

// "R, G, B, Depth.Z and 3 more", for messages.
std::string listed_channels(const OIIO::ImageSpec& spec);

}  // namespace burnish
