// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Functions of Python within a substep, and the class SubstepView that they get.
#include <meniscus/hooks.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include "sdk/python/device_arrays.h"
#include "sdk/python/errors.h"
#include "sdk/python/state/callable.h"

namespace meniscus::python {

namespace {

constexpr const char* hook_names[] = {"predicted", "contacts_found", "iterated", "solved",
                                      "velocities_known"};
static_assert(std::size(hook_names) == hook_count);

Hook hook_named(const std::string& name) {
  std::string allowed;
  for (uint32_t k = 0; k < hook_count; ++k) {
    if (name == hook_names[k]) return static_cast<Hook>(k);
    allowed += (k ? ", '" : "'") + std::string(hook_names[k]) + "'";
  }
  throw nb::value_error(("add_hook(): hook must be one of " + allowed + ", not '" + name + "'").c_str());
}

/// The class SubstepView of Python. Its arrays hold the token, so that one that outlives the call is seen.
struct PySubstepView {
  SubstepView view{};
  std::shared_ptr<const void> token{};
};

/// The memory of the solver, as NumPy's on the CPU and as a DeviceArray on a GPU.
template <class T>
nb::object array_of(const PySubstepView& self, T* data, int64_t count, int64_t width) {
  if (!data) throw nb::attribute_error("the array is not there at this hook");
  using Element = std::remove_const_t<T>;
  if (!self.view.on_cuda) {
    const nb::capsule owner(new std::shared_ptr<const void>(self.token),
                            [](void* at) noexcept { delete static_cast<std::shared_ptr<const void>*>(at); });
    const std::size_t shape[] = {std::size_t(count), std::size_t(width)};
    return nb::cast(nb::ndarray<nb::numpy, T>(data, width > 1 ? 2 : 1, shape, owner));
  }
  PyDeviceArray result{.array = {}, .read_only = std::is_const_v<T>};
  result.array = {.data = const_cast<Element*>(data),
                  .type = std::is_same_v<Element, float> ? ElementType::float32 : ElementType::uint32,
                  .dimensions = width > 1 ? 2 : 1,
                  .shape = {count, width},
                  .strides = {width, 1},
                  .on_cuda = true,
                  .device = self.view.device,
                  .stream = self.view.stream,
                  .memory = std::const_pointer_cast<void>(self.token)};
  return nb::cast(std::move(result));
}

int64_t rows_of(const SubstepView& view) {
  return int64_t{view.particles} + view.vertices;
}

template <class T>
void bind_number(nb::class_<PySubstepView>& type, const char* name, T SubstepView::*member, const char* doc) {
  type.def_prop_ro(
      name, [member](const PySubstepView& self) { return self.view.*member; }, doc);
}

template <class T>
void bind_array(nb::class_<PySubstepView>& type, const char* name, T* SubstepView::*member, int width,
                const char* doc) {
  const std::string getter = "def " + std::string(name) + "(self) -> typing.Any";
  type.def_prop_ro(
      name,
      [member, width](const PySubstepView& self) {
        return array_of(self, self.view.*member, rows_of(self.view), width);
      },
      nb::for_getter(nb::sig(getter.c_str())), doc);
}

void bind_view(nb::module_& module) {
  nb::class_<PySubstepView> type(
      module, "SubstepView",
      "The particles of a substep, and the vertices of cloth and ropes behind them, as add_hook() shows "
      "them. Arrays are NumPy's on the CPU and DeviceArray on a GPU, in the memory of the solver. They must "
      "not be kept.");
  type.def_prop_ro(
      "hook", [](const PySubstepView& s) { return hook_names[uint32_t(s.view.hook)]; },
      "The name of the hook.");
  bind_number(type, "on_cuda", &SubstepView::on_cuda, "Whether the arrays are those of a GPU.");
  bind_number(type, "device", &SubstepView::device, "Ordinal of the GPU; 0 on the CPU.");
  type.def_prop_ro(
      "stream", [](const PySubstepView& s) { return reinterpret_cast<uintptr_t>(s.view.stream); },
      "The cudaStream_t for work on the arrays; 0 on the CPU.");
  bind_number(type, "dt", &SubstepView::dt, "s, of the substep.");
  bind_number(type, "iteration", &SubstepView::iteration, "Of \"iterated\", from 0.");
  bind_number(type, "is_last", &SubstepView::is_last, "Whether it is the last substep of its step.");
  bind_number(type, "particles", &SubstepView::particles, "Of fluids and grains.");
  bind_number(type, "vertices", &SubstepView::vertices, "Of cloth and ropes, behind the particles.");
  bind_array(type, "positions", &SubstepView::positions, 4,
             "m, and the inverse mass in 1/kg, which is 0 of held vertices.");
  bind_array(type, "previous", &SubstepView::previous, 4,
             "m, at the start of the substep; not at \"velocities_known\".");
  bind_array(type, "corrections", &SubstepView::corrections, 4,
             "m: what constraints have moved so far. Who moves a position adds the same here. Not at "
             "\"velocities_known\".");
  bind_array(type, "velocities", &SubstepView::velocities, 4, "m/s, and a word of the solver.");
  bind_array(type, "phases", &SubstepView::phases, 1,
             "Low 16 bits: Fluid.index, or the number of the piece. Bit 16: fluid, 17: vertex, 19: grain.");
  bind_array(type, "slots", &SubstepView::slots, 1,
             "Of particles the place in World.ids, of vertices 2³¹ and the number.");
}

/// A view that shows nothing once this has gone, however the call of the function ends.
class Shown {
 public:
  Shown(const SubstepView& view, const std::shared_ptr<const void>& token)
      : seen_(nb::cast(PySubstepView{view, token})) {}
  ~Shown() { nb::cast<PySubstepView&>(seen_) = {}; }
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  nb::handle get() const { return seen_; }

 private:
  nb::object seen_;
};

/// Drops the local variables of the functions that an exception has left, and of those that the exceptions
/// before it have left.
void clear_frames(nb::handle exception) {
  const nb::object clear = nb::module_::import_("traceback").attr("clear_frames");
  nb::list all;
  all.append(exception);
  for (std::size_t i = 0; i < all.size(); ++i) {
    clear(all[i].attr("__traceback__"));
    for (const char* earlier : {"__cause__", "__context__"}) {
      const nb::object other = all[i].attr(earlier);
      if (!other.is_none() && PySequence_Contains(all.ptr(), other.ptr()) == 0) all.append(other);
    }
  }
}

/// Calls the function. The solver goes on with the memory, so no array may be left afterwards. What is raised
/// keeps the function's variables alive: they are dropped if an array is among them.
void call_with(nb::handle function, const SubstepView& view) {
  if (!function.is_valid()) throw Error(ErrorCode::invalid_argument, "the hook has gone with its World");
  const auto token = std::make_shared<const char>();
  const auto is_kept = [&] { return token.use_count() > 1; };
  const std::string why = "the function of the hook '" + std::string(hook_names[uint32_t(view.hook)]) +
                          "' keeps an array of the view; it must keep a copy instead";
  try {
    function(Shown(view, token).get());
  } catch (nb::python_error& raised) {
    if (is_kept()) clear_frames(raised.value());
    if (is_kept()) nb::raise_from(raised, error_class(ErrorCode::invalid_argument), "%s", why.c_str());
    throw;
  }
  if (is_kept()) throw Error(ErrorCode::invalid_argument, why);
}

}  // namespace

void bind_hooks(nb::module_& module, nb::class_<PyWorld>& world) {
  bind_view(module);
  world.def(
      "add_hook",
      [](const PyWorld& self, const std::string& name, nb::object function) {
        const Hook hook = hook_named(name);
        if (!PyCallable_Check(function.ptr())) throw nb::type_error("add_hook(): function must be callable");
        const Callable kept(std::move(function));
        SubstepCall call = [kept](const SubstepView& view) {
          kept([&](nb::handle f) { call_with(f, view); });
        };
        const HookId id = self.state->change([&](World& w) { return w.add_hook(hook, std::move(call)); });
        self.state->hooks.emplace_back(id, kept);
        return static_cast<uint64_t>(id);
      },
      nb::arg("hook"), nb::arg("function"),
      nb::sig("def add_hook(self, hook: typing.Literal['predicted', 'contacts_found', 'iterated', 'solved', "
              "'velocities_known'], function: collections.abc.Callable[[SubstepView], object]) -> int"),
      "Calls function(view) at this point of each substep, from the next step on, after those that were "
      "added "
      "before. Returns a number for remove_hook(). On a GPU it puts its work on the stream and must not "
      "wait. What it raises ends the step, and the "
      "world is as before. Snapshots do not contain it.");
  world.def(
      "remove_hook",
      [](const PyWorld& self, uint64_t number) {
        const auto id = static_cast<HookId>(number);
        self.state->change([&](World& w) { w.remove_hook(id); });
        std::erase_if(self.state->hooks, [&](const auto& hook) { return hook.first == id; });
      },
      nb::arg("hook"), "Calls the function of this hook no more.");
}

}  // namespace meniscus::python
