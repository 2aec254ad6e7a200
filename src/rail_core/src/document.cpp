#include "rail_core/document.hpp"

#include <algorithm>

#include "document_loader.hpp"
#include "yaml_source.hpp"
#include "yaml_writer.hpp"

namespace rail {

Document& Document::operator=(const Document& other) {
  root_.reset(other.root_);
  file_of_subtree_ = other.file_of_subtree_;
  file_key_ = other.file_key_;
  overridden_ = other.overridden_;
  unreadable_ = other.unreadable_;
  return *this;
}

Document Document::load(const std::string& path, const std::vector<Override>& overrides, Problems& problems) {
  Document document;
  DocumentLoader(document, problems).load(path, overrides);
  return document;
}

Document Document::parse(const std::string& text, const std::string& name, Problems& problems) {
  Document document;
  DocumentLoader(document, problems).parse(text, name);
  return document;
}

std::string Document::text() const { return writeYaml(root_); }

Document::Place Document::place(const std::string& key) const {
  Place place{"", key};
  std::size_t longest = 0;
  for (const auto& [subtree, file] : file_of_subtree_) {
    if (!isWithin(key, subtree) || subtree.size() < longest) continue;
    longest = subtree.size();
    place.file = file;
    place.key = subtree.empty() ? key : key.substr(std::min(key.size(), subtree.size() + 1));
  }
  for (const std::string& path : overridden_) {
    if (isWithin(key, path) && path.size() > longest) return {"--set", key};
  }
  return place;
}

const Document::FileKey* Document::fileKey(const std::string& key) const {
  const auto found = file_key_.find(key);
  return found == file_key_.end() ? nullptr : &found->second;
}

}  // namespace rail
