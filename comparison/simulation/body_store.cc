#include "comparison/simulation/body_store.h"

namespace fretval {

std::shared_ptr<const ContactBody> BodyStore::find_or_make(const BodySpecification& specification,
                                                           const std::function<ContactBody()>& make) {
  std::promise<std::shared_ptr<const ContactBody>> promise;
  Future body;
  bool is_new = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    auto [entry, inserted] = bodies_.try_emplace(specification);
    if (inserted) entry->second = promise.get_future().share();
    body = entry->second;
    is_new = inserted;
  }
  if (!is_new) return body.get();
  try {
    promise.set_value(std::make_shared<const ContactBody>(make()));
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  return body.get();
}

}  // namespace fretval
