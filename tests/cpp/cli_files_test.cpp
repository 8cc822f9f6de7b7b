// SPDX-License-Identifier: GPL-3.0-or-later
// The fate of the files that the program writes, and of files that existed before.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <filesystem>
#include <string>

#include "cli.h"

namespace circle_voronoi {
namespace {

namespace fs = std::filesystem;

class CliFiles : public test::Cli {
 protected:
  const std::string circles_ = "0,0,1\n6,0,1\n0,8,1\n";
  const std::string generated_ = run("generate uniform 3").out;

  std::string folder() const { return fs::path(path("file")).parent_path().string(); }

  /// The number of temporary files that are written beside others.
  int filesBeside() const {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder())) {
      count += entry.path().filename().string().starts_with(".circle-voronoi-") ? 1 : 0;
    }
    return count;
  }

  void expectGenerates(const std::string& file) const {
    const auto [status, out, err] = run("generate uniform 3 -o " + file);
    EXPECT_EQ(status, 0) << err;
    EXPECT_EQ(out + err, "");
    EXPECT_EQ(filesBeside(), 0);
  }
};

TEST_F(CliFiles, AFullDiskLeavesTheOldFile) {
  const std::string file = write("kept.csv", "before");
  // Simulates a disk with room for a few thousand bytes.
  expectFailure(shell("ulimit -f 8; " + program_ + " generate uniform 20000 -o " + file), 1,
                "kept.csv: File too large");
  EXPECT_EQ(readFile(file), "before");
  EXPECT_EQ(filesBeside(), 0);
  expectFailure(shell("ulimit -f 8; " + program_ + " generate uniform 20000 -o " + path("new.csv")), 1, "new.csv");
  EXPECT_FALSE(fs::exists(path("new.csv")));
}

TEST_F(CliFiles, AnInterruptedProgramLeavesTheOldFile) {
  const std::string circles = write("circles.csv", circles_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string file = write("kept.csv", "before");
    // Its script comes while the changes are written, so it waits with that file begun.
    test::WaitingProgram edit({program_, "edit", circles, "--script", "-", "--changes", file, "-o",
                               path("diagram.json"), "--progress", "always"},
                              test::Said::toPipe);
    ASSERT_TRUE(edit.says("compute, [^]*read, "));
    ASSERT_EQ(filesBeside(), 1);
    const int status = edit.kill(signal);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(readFile(file), "before");
    EXPECT_EQ(filesBeside(), 0);
  }
}

TEST_F(CliFiles, AFileThatCannotTakeItsNameIsAnError) {
  const std::string circles = write("circles.csv", circles_);
  const std::string script = path("script.csv");
  const std::string file = path("taken.jsonl");
  // The script comes while the changes are written, and by then a folder has their name.
  const test::Outcome edit =
      shell("mkfifo " + script + "; (exec 3>" + script + "; mkdir " + file + "; echo remove,0 >&3) & " + program_ +
            " edit " + circles + " --script " + script + " --changes " + file + " -o " + path("diagram.json"));
  expectFailure(edit, 1, "Cannot write " + file + ": Is a directory.");
  EXPECT_FALSE(fs::exists(path("diagram.json")));
  EXPECT_EQ(filesBeside(), 0);
}

TEST_F(CliFiles, TheOutputIsNotTheInput) {
  const std::string file = write("circles.csv", circles_);
  fs::create_symlink(file, path("symbolic.csv"));
  fs::create_hard_link(file, path("hard.csv"));
  fs::create_directory(path("sub"));
  for (const char* name : {"circles.csv", "./circles.csv", "sub/../circles.csv", "symbolic.csv", "hard.csv"}) {
    for (const char* command : {"compute ", "convert "}) {
      expectFailure(run(command + file + " -o " + path(name)), 2, "would be overwritten: it is the output as well.");
    }
    expectFailure(run("compute " + path(name) + " -o " + file), 2, "would be overwritten");
  }
  const std::string compute = program_ + " compute ";
  expectFailure(shell(compute + "- <" + file + " -o " + path("hard.csv")), 2, "standard input would be overwritten");
  EXPECT_EQ(shell(compute + file + " >>" + file).status, 2);
  EXPECT_EQ(readFile(file), circles_);
}

TEST_F(CliFiles, AnOutputIsNoOtherOutput) {
  fs::create_directory(path("sub"));
  fs::create_symlink("new.csv", path("dangling.csv"));
  const std::string edit = "edit " + write("circles.csv", circles_) + " --script " + write("edits.csv", "remove,0\n");
  const std::string compute = "compute " + path("circles.csv") + " --format csv";
  const std::string tile = compute + " --known=-9,-9,9,9 --core=-5,-5,8,8.5 --max-radius 0";
  const auto refuses = [&](const std::string& arguments, const std::string& options, const std::string& name) {
    expectFailure(run(arguments), 2, options + " cannot both be " + name + ".");
    EXPECT_FALSE(fs::exists(path("new.csv"))) << arguments;
  };
  for (const char* name : {"new.csv", "./new.csv", "sub/../new.csv", "dangling.csv"}) {
    const std::string file = path(name);
    const std::string output = " -o " + path("new.csv");
    refuses(compute + output + " --trace " + file, "--trace and --output", file);
    refuses(edit + output + " --changes " + file, "--changes and --output", file);
    refuses(edit + output + " --trace " + file, "--trace and --output", file);
    refuses(edit + " --changes " + path("new.csv") + " --trace " + file, "--trace and --changes", file);
    refuses(tile + output + " --open " + file, "--open and --output", file);
  }
  refuses(edit + " --trace -", "--trace and --output", "standard output");
  refuses(edit + " -o " + path("new.csv") + " --changes - --trace -", "--trace and --changes", "standard output");
  refuses(tile + " --open -", "--open and --output", "standard output");
  // Standard output may be a pipe, too.
  const std::string both = shell(program_ + " " + edit + " -o " + path("new.csv") + " --changes - --trace - | cat").err;
  EXPECT_NE(both.find("--trace and --changes cannot both be standard output."), std::string::npos) << both;
  const std::string trace = program_ + " " + compute + " --trace " + path("new.csv") + " >" + path("new.csv");
  EXPECT_EQ(shell(trace).status, 2);
  EXPECT_EQ(readFile(path("new.csv")), "");
  expectFailure(run(tile + " --open " + path("circles.csv")), 2, "circles.csv would be overwritten");
  EXPECT_EQ(readFile(path("circles.csv")), circles_);
  EXPECT_EQ(run(edit + " -o /dev/null --format csv --changes /dev/null --trace /dev/null").status, 0);
}

TEST_F(CliFiles, ALinkIsWrittenThrough) {
  const std::string file = write("target.csv", "before");
  fs::create_directory(path("sub"));
  fs::create_symlink("../target.csv", path("sub/link.csv"));
  fs::create_symlink("sub/link.csv", path("again.csv"));
  expectGenerates(path("again.csv"));
  EXPECT_EQ(readFile(file), generated_);
  EXPECT_TRUE(fs::is_symlink(path("again.csv")) && fs::is_symlink(path("sub/link.csv")));

  fs::create_symlink("missing.csv", path("dangling.csv"));
  expectGenerates(path("dangling.csv"));
  EXPECT_EQ(readFile(path("missing.csv")), generated_);
  EXPECT_TRUE(fs::is_symlink(path("dangling.csv")));
}

TEST_F(CliFiles, PermissionsAreThoseOfTheOldFileOrOfAnyNewOne) {
  const std::string file = write("kept.csv", "before");
  fs::permissions(file, fs::perms{0640});
  expectGenerates(file);
  EXPECT_EQ(fs::status(file).permissions(), fs::perms{0640});
  EXPECT_EQ(readFile(file), generated_);
  EXPECT_EQ(shell("umask 027; " + program_ + " generate uniform 3 -o " + path("new.csv")).status, 0);
  EXPECT_EQ(fs::status(path("new.csv")).permissions(), fs::perms{0640});
}

TEST_F(CliFiles, IrregularFilesAreWrittenDirectly) {
  const std::string generate = program_ + " generate uniform 3 -o ";
  EXPECT_EQ(shell(generate + "/dev/stdout").out, generated_);
  EXPECT_EQ(shell(generate + "/dev/stdout | cat").out, generated_);
  EXPECT_EQ(shell("echo before; " + generate + "/dev/stdout; echo after").out, "before\n" + generated_ + "after\n");
  EXPECT_EQ(shell(generate + "/dev/fd/2").err, generated_);
  EXPECT_EQ(shell(generate + "/dev/null").out, "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const std::string pipe = path("pipe.csv");
  EXPECT_EQ(shell("mkfifo " + pipe + "; cat " + pipe + " & " + generate + pipe + "; wait").out, generated_);
  EXPECT_TRUE(fs::is_fifo(pipe));
  expectFailure(run("generate uniform 3 -o /dev/full"), 1, "Cannot write /dev/full: No space left on device.");
  expectFailure(run("generate uniform 3 -o " + folder()), 1, "Is a directory.");
}

TEST_F(CliFiles, WritingHelpAndListsCanFail) {
  for (const char* arguments : {"--help", "--version", "compute --help", "generate --list"}) {
    const auto [status, out, err] = shell(program_ + " " + arguments + " >/dev/full");
    EXPECT_EQ(status, 1) << arguments;
    EXPECT_EQ(err, "circle-voronoi: Cannot write the standard stream: No space left on device.\n");
  }
}

}  // namespace
}  // namespace circle_voronoi
