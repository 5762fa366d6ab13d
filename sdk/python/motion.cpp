// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Keyframes of bodies from files.
#include "sdk/python/motion.h"

#include <meniscus/motion.h>

#include "sdk/python/lent.h"
#include "sdk/python/values/from_python.h"

namespace meniscus::python {

namespace {

nb::object read_motion(nb::dict given) {
  const FileReader reader =
      reader_of(function_of(taken(given, "read_file"), {"read_keyframes", "read_file"}));
  MotionFile motion;
  read_members(motion, given, "read_keyframes");
  std::vector<Keyframe> keyframes;
  {
    const nb::gil_scoped_release released;
    keyframes = read_keyframes(motion, reader);
  }
  return to_python(keyframes);
}

/// Of a function, which has no self.
Description describe() {
  Description text = describe_call<MotionFile>(
      "read_keyframes", "list[Keyframe]",
      "The keyframes of a body from a file, for add_body(). Raises FileError, and SceneError with the line.");
  text.signature.replace(text.signature.find("self, "), std::string("self, ").size(), "");
  text.signature.insert(text.signature.rfind(") -> "),
                        ", read_file: collections.abc.Callable[[str], bytes | None] | None = None");
  text.doc +=
      "\n    read_file: a function of the name that returns its bytes, or None if there is no such file; "
      "default None, the file system";
  return text;
}

}  // namespace

void bind_motion(nb::module_& module) {
  const Description text = describe();
  module.def(
      "read_keyframes", [](const nb::kwargs& given) { return read_motion(given); },
      nb::sig(text.signature.c_str()), text.doc.c_str());
}

}  // namespace meniscus::python
