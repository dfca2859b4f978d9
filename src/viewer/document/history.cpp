#include "viewer/document/history.hpp"

#include <utility>

namespace burnish::viewer {

History::History(Document first) {
    steps_.push_back({std::make_shared<const Document>(std::move(first)), ""});
}

void History::record(Document document, std::string_view key, std::string_view name) {
    if (document == present()) return;
    const bool replaces = !key.empty() && key == open_key_ && place_ > 0;
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(place_) + 1, steps_.end());
    auto shared = std::make_shared<const Document>(std::move(document));
    if (replaces) {
        steps_.back().document = std::move(shared);
        return;
    }
    steps_.push_back({std::move(shared), std::string(name)});
    ++place_;
    open_key_ = key;
    // The oldest document is where undo ends; it is no step.
    if (steps_.size() <= kMostSteps + 1) return;
    steps_.pop_front();
    --place_;
}

std::string_view History::undo_name() const {
    return can_undo() ? std::string_view(steps_[place_].name) : std::string_view();
}

std::string_view History::redo_name() const {
    return can_redo() ? std::string_view(steps_[place_ + 1].name) : std::string_view();
}

std::shared_ptr<const Document> History::undo_document() const {
    return can_undo() ? steps_[place_ - 1].document : nullptr;
}

std::shared_ptr<const Document> History::redo_document() const {
    return can_redo() ? steps_[place_ + 1].document : nullptr;
}

bool History::undo() {
    close();
    if (!can_undo()) return false;
    --place_;
    return true;
}

bool History::redo() {
    close();
    if (!can_redo()) return false;
    ++place_;
    return true;
}

}  // namespace burnish::viewer
