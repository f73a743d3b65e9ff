// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Monitor.h
 * @brief How the core reports progress, is asked to stop, and says what went wrong.
 */
#ifndef recon_Monitor_h
#define recon_Monitor_h

#include <stdexcept>
#include <string>

namespace recon
{
/**
 * Exceptions are known by their type, and the core is linked into several libraries of one program:
 * those must see one type, though all else of the core is hidden in each of them.
 */
#if defined(__GNUC__)
#define RECON_EXCEPTION __attribute__((visibility("default")))
#else
#define RECON_EXCEPTION
#endif

/// Input that cannot be worked with. what() is one sentence: what, where, what to do.
class RECON_EXCEPTION Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Input with nothing to work on, through no fault of its own: open lines only, as channels and wires
/// are. Among other regions it stops none; what() is one sentence.
class NothingToDo : public Error
{
public:
  using Error::Error;
};

/// Thrown by Monitor::Update where the user asked to stop; carries no message on purpose.
class RECON_EXCEPTION Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "aborted"; }
};

/**
 * Progress and abort, called from the thread that called the core and from no other.
 *
 * Long loops call Update every few milliseconds. The default does nothing.
 */
class Monitor
{
public:
  virtual ~Monitor() = default;

  /// fraction in [0, 1] of the whole call, stage a short present participle ("triangulating
  /// levels").
  /// @throws Aborted where AbortRequested().
  void Update(double fraction, const char* stage)
  {
    this->OnProgress(fraction, stage);
    if (this->AbortRequested())
    {
      throw Aborted();
    }
  }

  virtual bool AbortRequested() { return false; }

protected:
  virtual void OnProgress(double, const char*) {}
};
}

#endif
