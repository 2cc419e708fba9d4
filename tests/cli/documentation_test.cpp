// The man page, the shells' completions and `capcon check`: made from the program's own tables.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "cli/program.h"

namespace capcon::testing {
namespace {

using ::testing::HasSubstr;

/// Words of `--help` that are options or verbs: what CLI11 itself prints.
struct Help {
  std::vector<std::string> options, verbs;
};

Help help_of(const std::string& verb) {
  Help help;
  std::istringstream lines(run(verb + " --help").out);
  std::string part;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Options:" || line == "Subcommands:" || line == "Positionals:") part = line;
    if (line.size() < 3 || line.substr(0, 2) != "  " || line[2] == ' ') continue;
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (part == "Subcommands:") help.verbs.push_back(first);
    if (part != "Options:" || first[0] != '-') continue;
    std::istringstream names(first);
    for (std::string name; std::getline(names, name, ',');) help.options.push_back(name);
  }
  return help;
}

std::string without_escapes(std::string text) {
  std::erase(text, '\\');
  return text;
}

TEST(Documentation, EveryVerbAndOptionIsInTheManPageAndCompleted) {
  const Outcome man = run("man");
  ASSERT_EQ(man.exit_code, 0) << man.err;
  EXPECT_EQ(man.out.rfind(".TH CAPCON 1", 0), 0u);
  const std::string page = without_escapes(man.out);
  const Folder folder;
  const std::string script = folder.write("capcon.bash", run("completion bash").out);
  const auto completed = [&](const std::string& words) {  // the words before the last, which is completed
    const std::string out = folder / "out";
    const std::string command =
        "bash -c 'source " + script + "; COMP_WORDS=(capcon " + words +
        " \"\"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _capcon; echo ${COMPREPLY[@]}' >" + out;
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::istringstream list(contents(out));
    std::set<std::string> replies;
    for (std::string word; list >> word;) replies.insert(word);
    return replies;
  };
  std::vector<std::string> open = {""};
  std::size_t options = 0;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const std::string verb = open[i];
    const Help help = help_of(verb);
    const std::set<std::string> replies = completed(verb);
    const std::size_t at = verb.empty() ? 0 : page.find(".SS capcon" + verb + "\n");
    ASSERT_NE(at, std::string::npos) << verb;
    const std::string section = page.substr(at, page.find("\n.SS", at + 1) - at);
    for (const std::string& option : help.options) {
      EXPECT_NE(section.find("fB" + option + "fR"), std::string::npos) << verb << " " << option;
      EXPECT_TRUE(replies.contains(option)) << verb << " " << option;
      ++options;
    }
    for (const std::string& below : help.verbs) {
      EXPECT_TRUE(replies.contains(below)) << verb << " " << below;
      open.push_back(verb + " " + below);
    }
  }
  EXPECT_GT(open.size(), 15u);
  EXPECT_GT(options, 100u);
}

TEST(Documentation, BashCompletesWhatIsBegun) {
  const Folder folder;
  const std::string script = folder.write("capcon.bash", run("completion bash").out);
  const auto completed = [&](const std::string& words) {
    const std::string out = folder / "out";
    const std::string command = "bash -c 'source " + script + "; COMP_WORDS=(" + words +
                                "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _capcon; echo ${COMPREPLY[@]}' >" +
                                out;
    EXPECT_EQ(std::system(command.c_str()), 0);
    return contents(out);
  };
  EXPECT_EQ(completed("capcon ren"), "render\n");
  EXPECT_EQ(completed("capcon render --sa"), "--sampler --samples\n");
  EXPECT_EQ(completed("capcon render --sampler sobol-"), "sobol-xor sobol-owen sobol-z\n");
  EXPECT_EQ(completed("capcon render scene.pbrt --integrator \"\""), "ao direct igi path\n");
  EXPECT_EQ(completed("capcon study spl"), "splitting\n");
  EXPECT_EQ(completed("capcon study splitting --comb"), "--combined\n");
}

TEST(Documentation, OtherShellsHaveTheVerbsToo) {
  const std::string zsh = run("completion zsh").out, fish = run("completion fish").out;
  EXPECT_EQ(zsh.rfind("#compdef capcon\n", 0), 0u);
  EXPECT_THAT(zsh, HasSubstr("'--sampler:Where sample points come from"));
  EXPECT_THAT(
      fish, HasSubstr("complete -c capcon -n 'test (__capcon_verb) = \"capcon render\"' -l sampler -r -f -a "
                      "'random jittered"));
  EXPECT_EQ(run("completion tcsh").exit_code, 2);
}

TEST(Check, SaysWhatIsThereAndWhatIsNot) {
  const Folder folder;
  const std::string scene = folder.write("s.pbrt",
                                         "Camera \"perspective\"\nWorldBegin\nMaterial \"glass\"\nShape "
                                         "\"sphere\"\nShape \"curve\"\nShape \"curve\"\n");
  const Outcome text = run("check " + scene);
  EXPECT_EQ(text.exit_code, 0) << text.err;
  for (const char* words :
       {"1 sphere", "1 glass", "what it transmits is left out", "2x shape \"curve\" is not supported",
        "s.pbrt:5:1", "ao      yes", "direct  yes, yet it has no light and is black"})
    EXPECT_THAT(text.out, HasSubstr(words));
  const std::string json = run("check --json " + scene).out;
  for (const char* words :
       {"\"what\": \"shape \\\"curve\\\" is not supported and was left out\",\n      \"count\": 2",
        "\"sphere\": 1", "\"shading_errors\": []"})
    EXPECT_THAT(json, HasSubstr(words));
  const Outcome igi = run("check --integrator igi " + scene);
  EXPECT_EQ(igi.exit_code, 2);
  EXPECT_THAT(igi.err, HasSubstr("it has no light that virtual point lights could come from"));
}

TEST(Check, WhatCannotBeRenderedIsOneSentenceOnStderr) {
  const Folder folder;
  const std::string scene =
      folder.write("s.pbrt", "Camera \"realistic\"\nWorldBegin\nVolumeGrid \"x\"\nShape \"sphere\"\n");
  const Outcome check = run("check " + scene), render = run("render " + scene + " -o " + (folder / "a.exr"));
  EXPECT_EQ(check.exit_code, 2);
  EXPECT_THAT(check.out, HasSubstr("s.pbrt:3:1: unknown directive \"VolumeGrid\""));
  EXPECT_EQ(check.err, render.err);
  EXPECT_EQ(run("check " + (folder / "none.pbrt")).exit_code, 2);
}

}  // namespace
}  // namespace capcon::testing
