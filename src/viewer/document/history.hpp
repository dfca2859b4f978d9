// Undo and redo of whole documents.
//
// Threads: one at a time for each object. Lifetime: documents are shared; a pointer that was given
// out stays good.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "viewer/document/document.hpp"

namespace burnish::viewer {

class History {
  public:
    static constexpr std::size_t kMostSteps = 1000;

    // A history without steps, at `first`.
    explicit History(Document first = {});

    const Document& present() const { return *steps_[place_].document; }
    std::shared_ptr<const Document> present_pointer() const { return steps_[place_].document; }

    // Makes `document` the present one. A document that equals the present one makes no step. With a
    // key that is not empty and is that of the last record since close(), undo() or redo(), it
    // replaces that step: a drag is one step. Steps that were undone are forgotten; of more than
    // kMostSteps the oldest go. `name`: what the step changed ("alpha_x"), for menus.
    void record(Document document, std::string_view key = {}, std::string_view name = {});
    void close() { open_key_.clear(); }  // the next record makes a step of its own

    bool can_undo() const { return place_ > 0; }
    bool can_redo() const { return place_ + 1 < steps_.size(); }
    std::size_t undo_count() const { return place_; }
    std::size_t redo_count() const { return steps_.size() - 1 - place_; }
    // Of the step that undo() or redo() would take; "" where there is none.
    std::string_view undo_name() const;
    std::string_view redo_name() const;
    // The document that it would lead to; null where there is none.
    std::shared_ptr<const Document> undo_document() const;
    std::shared_ptr<const Document> redo_document() const;
    bool undo();  // false: there is nothing to undo
    bool redo();

  private:
    struct Step {
        std::shared_ptr<const Document> document;
        std::string name;  // of the change that led to it
    };
    std::deque<Step> steps_;  // never empty
    std::size_t place_ = 0;
    std::string open_key_;
};

}  // namespace burnish::viewer
