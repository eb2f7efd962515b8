// What a child process may do, by the request: for the tests of base/child_process.h.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <vector>

#include "base/child_process.h"
#include "base/error.h"

namespace {

std::string repeat(const std::string& request) {
  std::puts("this is printed, and lost");
  std::fflush(stdout);
  return request.substr(request.find(' ') + 1);
}

std::string spin() {
  volatile long turns = 0;
  while (true) turns = turns + 1;
}

std::string eat() {
  std::vector<std::string> all;
  while (true) all.emplace_back(1 << 20, 'x');
}

std::string act(const std::string& request) {
  using namespace advlayers;
  const std::string word = request.substr(0, request.find(' '));
  if (word == "repeat") return repeat(request);
  if (word == "large") return std::string(3'000'000, 'x');
  if (word == "invalid") {
    throw InvalidInput("{}: {}", "a{}.step", Sentence("line {}: {}", 7, Sentence("cut off")));
  }
  if (word == "geometry") throw GeometryError("no face");
  if (word == "raise") std::raise(std::stoi(request.substr(request.find(' '))));
  if (word == "end") _exit(0);
  if (word == "spin") return spin();
  if (word == "eat") return eat();
  if (word == "sleep") {
    while (true) pause();
  }
  throw std::logic_error(request);
}

}  // namespace

int main() { advlayers::answer_parent(&act); }
