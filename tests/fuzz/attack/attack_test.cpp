// Tests of the checks that the attack uses.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "fuzz/attack/checks.hpp"
#include "fuzz/attack/run_limited.hpp"

namespace {

using rocking::fuzz::control_character_in;
using rocking::fuzz::damage_of_page;
using rocking::fuzz::Ending;
using rocking::fuzz::run_limited;

Ending shell(const std::string& script, const rocking::fuzz::Limits& limits = {}) {
  return run_limited("/bin/sh", {"-c", script}, std::filesystem::temp_directory_path(), limits);
}

TEST(Attack, SeesWhatATerminalWouldObey) {
  EXPECT_EQ(control_character_in("a line\n\tand Ü 地震\n"), "");
  for (const char* text : {"\x1b[31m", "a\r", "\x07", "\x7f", "\u0085"}) EXPECT_NE(control_character_in(text), "");
  EXPECT_NE(control_character_in(std::string_view("\0", 1)), "");
}

TEST(Attack, SeesWhatIsNoUtf8) {
  EXPECT_TRUE(rocking::fuzz::is_utf8("Ü 地震"));
  for (const char* text : {"\xff", "cut \xc3", "\xc0\x80", "\x80"}) EXPECT_FALSE(rocking::fuzz::is_utf8(text));
}

TEST(Attack, SeesAPageThatIsNotWellFormed) {
  EXPECT_EQ(damage_of_page("<!doctype html><html><p title='<'>1 &lt; 2<br><script>a<b&&c</script></p><svg/></html>"),
            "");
  for (const char* page : {"<p>", "</p>", "<p><b></p></b>", "1 < 2", "a & b", "<p title=\"x>", "<script>", "<!-- "}) {
    EXPECT_NE(damage_of_page(page), "") << page;
  }
}

TEST(Attack, SeesHowAProgramEnds) {
  EXPECT_EQ(shell("exit 65").exit_code, 65);
  EXPECT_EQ(shell("echo out; echo err >&2").output, "out\n");
  EXPECT_EQ(shell("echo out; echo err >&2").errors, "err\n");
  const Ending crashed = shell("kill -SEGV $$");
  EXPECT_FALSE(crashed.exit_code.has_value());
  EXPECT_EQ(crashed.signal, 11);
}

TEST(Attack, EndsAProgramThatDoesNotEnd) {
  EXPECT_TRUE(shell("sleep 1000", {.wall_seconds = 1}).out_of_time);
  EXPECT_TRUE(shell("while :; do :; done", {.processor_seconds = 1}).out_of_time);
  EXPECT_FALSE(shell("true").out_of_time);
}

TEST(Attack, EndsAProgramThatWritesTooMuch) {
  EXPECT_NE(shell("exec dd if=/dev/zero of=rocking-attack-$$ bs=65536 count=2", {.file_bytes = 65536}).exit_code, 0);
}

}  // namespace
