// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Text without control characters, for terminals, charts and tables.
#include "sdk/io/plain_text.h"

#include <gtest/gtest.h>

#include "sdk/cli/record/csv_file.h"
#include "sdk/files/output_file.h"

namespace meniscus::io {
namespace {

TEST(PlainText, KeepsValidTextAndWritesTheRestAsBytes) {
  EXPECT_EQ(plain_text("Wasser – 水 🌊"), "Wasser – 水 🌊");
  EXPECT_EQ(plain_text("a\nb\tc\x7f"), "a\\x0ab\\x09c\\x7f");
  EXPECT_EQ(plain_text("a\nb", "\n"), "a\nb");
  EXPECT_EQ(plain_text(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(plain_text("\xc2\x9b"
                       "1m"),
            "\\xc2\\x9b1m")
      << "a control sequence of C1";
  EXPECT_EQ(plain_text("\xe2\x80\xae"), "\\xe2\\x80\\xae") << "it would turn the line round";
  for (const char* bad : {"\xff", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe6\xb0", "\x80"})
    EXPECT_EQ(plain_text(bad).size(), 4 * std::string(bad).size()) << "not UTF-8";
}

TEST(PlainText, IsWhatXmlHolds) {
  EXPECT_EQ(xml_escaped("<a\x1b & \xff\">"), "&lt;a\\x1b &amp; \\xff&quot;&gt;");
}

TEST(PlainText, OfATableIsNoFormula) {
  EXPECT_EQ(cli::csv_field("crate"), "crate");
  EXPECT_EQ(cli::csv_field("a,\"b\""), "\"a,\"\"b\"\"\"");
  EXPECT_EQ(cli::csv_field("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
  for (const char* start : {"=", "+", "-", "@"})
    EXPECT_EQ(cli::csv_field(std::string(start) + "1"), "'" + std::string(start) + "1");
  EXPECT_EQ(cli::csv_field("a\r\nb"), "a\\x0d\\x0ab");
}

}  // namespace
}  // namespace meniscus::io
