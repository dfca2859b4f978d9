#include "image/codecs/exr_channels.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "burnish/error.hpp"

namespace burnish {
namespace {

// "Layer.pass.R": the last dot parts the layer from the channel.
std::string_view layer_of(std::string_view channel) {
    const std::size_t dot = channel.rfind('.');
    return dot == std::string_view::npos ? std::string_view() : channel.substr(0, dot);
}

bool is_named(std::string_view channel, std::string_view letter, std::string_view word) {
    const std::size_t dot = channel.rfind('.');
    const std::string_view last = dot == std::string_view::npos ? channel : channel.substr(dot + 1);
    return OIIO::Strutil::iequals(last, letter) || OIIO::Strutil::iequals(last, word);
}

// The channels from `at` on if they are R, G, B and maybe A of one layer; else none.
ChannelChoice color_at(const std::vector<std::string>& names, std::size_t at) {
    constexpr std::string_view kLetters[] = {"R", "G", "B", "A"};
    constexpr std::string_view kWords[] = {"red", "green", "blue", "alpha"};
    ChannelChoice choice;
    choice.first = static_cast<int>(at);
    choice.layer = layer_of(names[at]);
    for (std::size_t i = 0; i < 4 && at + i < names.size(); ++i) {
        const std::string& channel = names[at + i];
        if (layer_of(channel) != choice.layer || !is_named(channel, kLetters[i], kWords[i])) break;
        ++choice.count;
    }
    choice.has_alpha = choice.count == 4;
    if (choice.count < 3) choice.count = 0;
    return choice;
}

// The choice among the layers; no channel when none has R, G and B.
ChannelChoice choose_layer(const std::vector<std::string>& names) {
    ChannelChoice chosen;
    std::vector<std::string> layers;
    for (std::size_t i = 0; i < names.size(); ++i) {
        ChannelChoice candidate = color_at(names, i);
        if (candidate.count == 0) continue;
        layers.push_back(candidate.layer);
        if (chosen.count == 0 || (candidate.layer.empty() && !chosen.layer.empty()))
            chosen = std::move(candidate);
    }
    for (std::string& layer : layers)
        if (layer != chosen.layer) chosen.others.push_back(std::move(layer));
    return chosen;
}

}  // namespace

bool has_color(const OIIO::ImageSpec& spec) {
    return choose_layer(spec.channelnames).count > 0;
}

std::string listed_channels(const OIIO::ImageSpec& spec) {
    constexpr std::size_t kMost = 12;
    const std::size_t shown_names = std::min(spec.channelnames.size(), kMost);
    std::string list = one_line(fmt::format(
        "{}",
        fmt::join(spec.channelnames.begin(),
                  spec.channelnames.begin() + static_cast<std::ptrdiff_t>(shown_names), ", ")));
    if (shown_names < spec.channelnames.size())
        list += fmt::format(" and {} more", spec.channelnames.size() - shown_names);
    return list;
}

ChannelChoice choose_channels(const OIIO::ImageSpec& spec, bool has_layers,
                              const std::string& name) {
    ChannelChoice choice;
    if (has_layers) {
        choice = choose_layer(spec.channelnames);
        if (choice.count > 0) return choice;
    }
    if (spec.nchannels <= 4) {
        choice.count = spec.nchannels;
        choice.has_alpha = spec.alpha_channel > 0 && spec.alpha_channel == spec.nchannels - 1;
        return choice;
    }
    choice = color_at(spec.channelnames, 0);
    if (choice.count == 0)
        throw Error(name, "channels", "1 to 4, or R, G and B of one layer", listed_channels(spec));
    return choice;
}

}  // namespace burnish
