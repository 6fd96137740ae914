#pragma once

#include <future>
#include <map>
#include <memory>
#include <mutex>

namespace fretval {

/// Values by key, each made once for all threads, unless it is forgotten.
template <class Key, class Value>
class MadeOnce {
 public:
  /// The value of that key; makes it if nobody has, and waits where another thread is making it. Throws what make
  /// throws, in every call for the key.
  template <class Make>
  std::shared_ptr<const Value> find_or_make(const Key& key, const Make& make) {
    std::promise<std::shared_ptr<const Value>> promise;
    std::shared_future<std::shared_ptr<const Value>> value;
    bool is_new = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto [entry, inserted] = values_.try_emplace(key);
      if (inserted) entry->second = promise.get_future().share();
      value = entry->second;
      is_new = inserted;
    }
    if (!is_new) return value.get();
    try {
      promise.set_value(std::make_shared<const Value>(make()));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
    return value.get();
  }

  /// Forgets a value: it is made again when it is asked for.
  void forget(const Key& key) {
    const std::lock_guard<std::mutex> lock(mutex_);
    values_.erase(key);
  }

 private:
  std::map<Key, std::shared_future<std::shared_ptr<const Value>>> values_;
  std::mutex mutex_;
};

}  // namespace fretval
