#include "serve/hub.h"

namespace capcon::serve {

Hub::Hub(std::chrono::milliseconds patience)
    : patience_(patience), thread_([this](const std::stop_token& stop) { work(stop); }) {}

Hub::~Hub() {
  {
    const std::lock_guard lock(mutex_);
    for (Entry& entry : entries_) entry.comparison->cancel();
  }
  thread_.request_stop();
  changed_.notify_all();
}

std::shared_ptr<Comparison> Hub::start(const std::string& client, const std::string& key,
                                       const Settings& settings) {
  leave(client);
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  std::size_t clients = 0;
  for (Entry& entry : entries_) clients += entry.clients.size();
  if (clients >= kMostClients) throw Busy("too many pages are open; close one of them");
  for (Entry& entry : entries_) {
    if (entry.key != key) continue;
    entry.clients[client] = now;
    return entry.comparison;
  }
  if (entries_.size() >= kMostComparisons)
    throw Busy("four other comparisons are under way; close a page that shows one, or choose its settings");
  entries_.push_back(
      {key, std::make_shared<Comparison>(std::to_string(++started_), settings), {{client, now}}});
  changed_.notify_all();
  return entries_.back().comparison;
}

std::shared_ptr<Comparison> Hub::find(const std::string& id, const std::string& client) {
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_) {
    if (entry.comparison->id() != id) continue;
    const auto found = entry.clients.find(client);
    if (found != entry.clients.end()) found->second = Clock::now();
    return entry.comparison;
  }
  return nullptr;
}

void Hub::leave(const std::string& client) {
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_) entry.clients.erase(client);
  drop_abandoned();
}

std::size_t Hub::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

void Hub::drop_abandoned() {
  const auto now = Clock::now();
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    std::erase_if(entry->clients, [&](const auto& client) { return now - client.second > patience_; });
    if (entry->clients.empty()) {
      entry->comparison->cancel();
      entry = entries_.erase(entry);
    } else {
      ++entry;
    }
  }
}

void Hub::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    drop_abandoned();
    std::shared_ptr<Comparison> next;
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (entry->idle) continue;
      next = entry->comparison;
      entries_.splice(entries_.end(), entries_, entry);  // the next turn is another's
      break;
    }
    if (!next) {
      changed_.wait_for(lock, stop, std::chrono::milliseconds(250), [] { return false; });
      continue;
    }
    lock.unlock();
    const bool more = next->step();
    lock.lock();
    if (more) continue;
    for (Entry& entry : entries_)
      if (entry.comparison == next) entry.idle = true;
  }
}

}  // namespace capcon::serve
