// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Parallel.h"

#include "Base/StopSignal.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace recon
{
namespace
{
/// What the threads of one loop share.
struct Loop
{
  std::atomic<int> Next{ 0 };
  std::atomic<int> Done{ 0 };
  std::atomic<bool> Stop{ false };
  std::mutex Mutex;
  std::condition_variable Finished;
  int Running = 0;
  std::exception_ptr Failure;

  void Fail(std::exception_ptr failure)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Failure)
    {
      this->Failure = std::move(failure);
    }
    this->Stop = true;
  }
};

void Work(Loop& loop, int count, const std::function<void(int)>& body)
{
  const StopSignal signal(loop.Stop);
  try
  {
    for (int i = loop.Next++; i < count && !loop.Stop; i = loop.Next++)
    {
      body(i);
      ++loop.Done;
    }
  }
  catch (...)
  {
    loop.Fail(std::current_exception());
  }
  const std::lock_guard<std::mutex> lock(loop.Mutex);
  --loop.Running;
  loop.Finished.notify_all();
}

void Report(Loop& loop, int count, Monitor& monitor, const ProgressRange& range)
{
  const double done = static_cast<double>(loop.Done) / std::max(1, count);
  monitor.Update(range.From + (range.To - range.From) * done, range.Stage);
}
}

void ParallelFor(int count, int threads, const std::function<void(int)>& body, Monitor& monitor,
  const ProgressRange& range)
{
  monitor.Update(range.From, range.Stage);
  const int available = std::max(1u, std::thread::hardware_concurrency());
  const int wanted = std::min(threads > 0 ? threads : available, count);

  // Workers do the pieces while this thread, which alone may talk to the monitor, watches.
  Loop loop;
  loop.Running = wanted;
  std::vector<std::thread> workers;
  for (int w = 0; w < wanted; ++w)
  {
    workers.emplace_back(Work, std::ref(loop), count, std::cref(body));
  }
  for (bool running = wanted > 0; running;)
  {
    {
      std::unique_lock<std::mutex> lock(loop.Mutex);
      running = !loop.Finished.wait_for(
        lock, std::chrono::milliseconds(20), [&] { return loop.Running == 0; });
    }
    try
    {
      Report(loop, count, monitor, range);
    }
    catch (...)
    {
      loop.Fail(std::current_exception());
    }
  }
  for (auto& worker : workers)
  {
    worker.join();
  }
  if (loop.Failure)
  {
    std::rethrow_exception(loop.Failure);
  }
  monitor.Update(range.To, range.Stage);
}
}
