// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// A folder for exported files, and functions to inspect them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace meniscus::io {

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value{};
  EXPECT_LE(offset + sizeof value, bytes.size());
  if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// The text between the first `before` after `key` and the next quote.
inline std::string attribute(const std::string& xml, const std::string& key, const std::string& before) {
  const std::size_t start = xml.find(before, xml.find(key)) + before.size();
  return xml.substr(start, xml.find('"', start) - start);
}

/// The bytes of an appended array of a VTK file, checked against the length that stands before them.
inline std::string appended(const std::string& file, const std::string& name, std::size_t length) {
  const std::size_t data = file.find("encoding=\"raw\">\n_") + std::strlen("encoding=\"raw\">\n_");
  const std::size_t start = data + std::stoul(attribute(file, "Name=\"" + name + "\"", "offset=\""));
  EXPECT_EQ(value_at<uint64_t>(file, start), length) << name;
  return file.substr(start + sizeof(uint64_t), length);
}

/// Gives each test a folder of its own, and removes it afterwards.
class ExportFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("meniscus_export_" + std::to_string(getpid()) + "_" + test->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

}  // namespace meniscus::io
