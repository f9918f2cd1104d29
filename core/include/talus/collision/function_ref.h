// A view of a callable: two pointers, no allocation, no ownership.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace talus {

// Only FunctionRef<R(Args...)> is defined.
template <class Signature>
class FunctionRef;

// Refers to any callable of that signature. The callable must outlive the call it is passed to, so take a
// FunctionRef as a parameter and never store one. (The shape of C++26's std::function_ref.)
template <class R, class... Args>
class FunctionRef<R(Args...)> {
 public:
  // callable: a function, a lambda or an object with operator() of that signature; not null.
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, FunctionRef> && std::is_invocable_r_v<R, F&, Args...>)
      FunctionRef(F&& callable)  // NOLINT: implicit, so that a lambda can be passed where one is taken
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(callable)))),
        call_([](void* object, Args... args) -> R {
          return (*static_cast<std::remove_reference_t<F>*>(object))(std::forward<Args>(args)...);
        }) {}

  // Calls it. What it throws comes through.
  R operator()(Args... args) const { return call_(object_, std::forward<Args>(args)...); }

 private:
  void* object_;
  R (*call_)(void*, Args...);
};

}  // namespace talus
