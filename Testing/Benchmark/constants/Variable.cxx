// SPDX-License-Identifier: GPL-3.0-or-later
#include "Variable.h"

#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <mutex>
#include <stdexcept>

namespace recon::variables
{
namespace
{
std::mutex Guard;

std::vector<Variable*>& Register()
{
  static std::vector<Variable*> all;
  return all;
}

std::size_t PageSize()
{
  return static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void Allow(const Variable& variable, int access)
{
  if (mprotect(variable.Page, PageSize(), access) != 0)
  {
    throw std::runtime_error("The memory of a variable cannot be guarded.");
  }
}

/// Somebody looks at a page that is guarded: note which, and let them.
void NoteRead(int signal, siginfo_t* info, void*)
{
  auto* at = static_cast<char*>(info->si_addr);
  for (Variable* variable : Register())
  {
    auto* page = static_cast<char*>(variable->Page);
    if (at >= page && at < page + PageSize())
    {
      variable->Read = true;
      mprotect(page, PageSize(), PROT_READ | PROT_WRITE);
      return;
    }
  }
  std::signal(signal, SIG_DFL);
}
}

std::vector<Variable*> All()
{
  const std::lock_guard<std::mutex> lock(Guard);
  return Register();
}

Variable& NewVariable(const char* file, const char* name, std::size_t bytes)
{
  auto* variable = new Variable; // as long as the program
  variable->Name = std::string(file) + ":" + name;
  variable->Original.resize(bytes);
  variable->Page =
    mmap(nullptr, PageSize(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (bytes > PageSize() || variable->Page == MAP_FAILED)
  {
    throw std::runtime_error("There is no page of memory for " + variable->Name + ".");
  }
  return *variable;
}

void Registered(Variable& variable)
{
  std::memcpy(variable.Original.data(), variable.Page, variable.Original.size());
  // Where the program comes by it only now, it is because it is read.
  variable.Read = true;
  const std::lock_guard<std::mutex> lock(Guard);
  Register().push_back(&variable);
}

void Scale(Variable& variable, double factor)
{
  Allow(variable, PROT_READ | PROT_WRITE);
  variable.Scale(variable.Page, variable.Original.data(), factor);
}

void Watch()
{
  struct sigaction action = {};
  action.sa_sigaction = NoteRead;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSEGV, &action, nullptr);
  for (Variable* variable : All())
  {
    variable->Read = false;
    Allow(*variable, PROT_NONE);
  }
}
}
