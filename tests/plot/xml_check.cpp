#include "xml_check.hpp"

#include <algorithm>
#include <stdexcept>

namespace burnish::test {
namespace {

class Parser {
  public:
    explicit Parser(const std::string& text) : text_(text) {}

    std::vector<XmlElement> parse() {
        while (at_ < text_.size()) {
            if (text_[at_] == '<') {
                markup();
            } else {
                const std::size_t end = std::min(text_.find('<', at_), text_.size());
                characters(text_.substr(at_, end - at_));
                at_ = end;
            }
        }
        require(open_.empty() && roots_ == 1, "one root, closed");
        return done_;
    }

  private:
    void require(bool good, const char* what) const {
        if (!good)
            throw std::runtime_error("expected " + std::string(what) +
                                     " at: " + text_.substr(std::min(at_, text_.size()), 80));
    }
    bool takes(const std::string& word) {
        if (text_.compare(at_, word.size(), word) != 0) return false;
        at_ += word.size();
        return true;
    }
    std::string until(const std::string& word) {
        const std::size_t end = text_.find(word, at_);
        require(end != std::string::npos, word.c_str());
        const std::string piece = text_.substr(at_, end - at_);
        at_ = end + word.size();
        return piece;
    }
    std::string decoded(const std::string& raw) const {
        std::string plain;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            require(static_cast<unsigned char>(raw[i]) >= 0x20 || raw[i] == '\n', "no control");
            require(raw[i] != '<', "an escaped <");
            if (raw[i] != '&') {
                plain += raw[i];
                continue;
            }
            const std::size_t end = raw.find(';', i);
            require(end != std::string::npos, "an entity");
            const std::string entity = raw.substr(i + 1, end - i - 1);
            const std::map<std::string, char> known = {
                {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
            require(known.contains(entity), "a known entity");
            plain += known.at(entity);
            i = end;
        }
        return plain;
    }
    void characters(const std::string& raw) {
        const std::string plain = decoded(raw);
        if (open_.empty()) require(plain.find_first_not_of(" \n") == std::string::npos, "markup");
        for (XmlElement& element : open_) element.text += plain;
    }
    void markup() {
        if (takes("<?")) {
            until("?>");
        } else if (takes("</")) {
            const std::string name = until(">");
            require(!open_.empty() && open_.back().name == name, "the end of what is open");
            done_.push_back(open_.back());
            open_.pop_back();
        } else {
            require(takes("<"), "<");
            element();
        }
    }
    void element() {
        XmlElement element;
        const std::string kEnds = " \n/>";
        while (at_ < text_.size() && kEnds.find(text_[at_]) == std::string::npos)
            element.name += text_[at_++];
        require(!element.name.empty(), "a name");
        if (open_.empty()) ++roots_;
        while (true) {
            while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
            if (takes("/>")) {
                done_.push_back(element);
                return;
            }
            if (takes(">")) break;
            const std::string name = until("=\"");
            require(element.attributes.emplace(name, decoded(until("\""))).second,
                    "an attribute once");
        }
        open_.push_back(element);
    }

    const std::string& text_;
    std::size_t at_ = 0;
    int roots_ = 0;
    std::vector<XmlElement> open_, done_;
};

}  // namespace

std::vector<XmlElement> parse_xml(const std::string& text) {
    return Parser(text).parse();
}

}  // namespace burnish::test
