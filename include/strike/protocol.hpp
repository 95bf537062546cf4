#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

#include <strike/cxx20.hpp>

// A protocol lists functions that a model may have. One small type stands for each:
//
//   struct ApplyLoads {
//     struct Decoy {
//       int apply_loads;
//     };
//     template <class Model>
//     using Member = decltype(&Model::apply_loads);
//     static auto call(auto& item, auto& nodes, double time) -> decltype(item.apply_loads(nodes, time)) {
//       return item.apply_loads(nodes, time);
//     }
//   };
//
// `answers` says whether a model has it, `call_if_present` calls it and compiles to nothing where it is absent, and
// `nearly` finds the model that has the name and cannot be called so, which a static_assert then refuses.
namespace strike::detail {

/// A model beside a decoy: a name that both have is ambiguous, so that it can be detected whatever its arguments are.
template <class Model, class Decoy>
struct Disguised : Model, Decoy {};

/// The model has a member of this name, be it a function, a template or a number.
template <class Function, class Model>
concept HasName = std::is_class_v<Model> && !std::is_final_v<Model> &&
                  !requires { typename Function::template Member<Disguised<Model, typename Function::Decoy>>; };

/// The function can be called on the model with such arguments.
template <class Function, class Model, class... Arguments>
inline constexpr bool answers =
    requires(Model& model, Arguments&... arguments) { Function::call(model, arguments...); };

/// The model has a member of the name that cannot be called with such arguments.
template <class Function, class Model, class... Arguments>
inline constexpr bool nearly = HasName<Function, std::remove_cv_t<Model>> && !answers<Function, Model, Arguments...>;

/// The member of the name is a number: a load may have the times `begin` and `end`.
template <class Function, class Model>
inline constexpr bool is_number =
    requires { requires std::is_member_object_pointer_v<typename Function::template Member<Model>>; };

/// The model has a member of the name that cannot be called so, and that is there: a wrapper whose `requires` takes
/// away a function that the wrapped law lacks is sound. Of a template `Function::Specialised` names an instance.
template <class Function, class Model, class... Arguments>
inline constexpr bool misfits = nearly<Function, Model, Arguments...> &&
                                (
                                    requires { typename Function::template Member<std::remove_cv_t<Model>>; } ||
                                    requires { typename Function::template Specialised<std::remove_cv_t<Model>>; });

/// Calls the function if the model has it.
template <class Function, class Model, class... Arguments>
[[gnu::always_inline]] inline void call_if_present(Model& model, Arguments&&... arguments) {
  if constexpr (answers<Function, Model, std::remove_reference_t<Arguments>...>)
    Function::call(model, std::forward<Arguments>(arguments)...);
}

}  // namespace strike::detail
