// SPDX-License-Identifier: MIT
// Messages between ranks, by MPI's oldest calls: Isend, Iprobe, Recv. It looks often while messages
// come, and seldom otherwise.
#include "node.h"

#include <mpi.h>

#include <algorithm>
#include <ctime>
#include <list>
#include <utility>

#include "moivre/numeric/bytes.h"

namespace moivre {
namespace {

using Clock = std::chrono::steady_clock;

// A message's tag is what it says.
enum Tag : int {
  kWanted = 1,  // to 0: of which list a piece
  kPiece,       // from 0: the piece
  kTold,        // to 0: outcomes
  kOutcomes,    // down the tree: the rank that told them, and outcomes
  kGivenBack,   // down the tree: a list of which jobs can be drawn again
  kLeft,        // to 0: the exit code of a rank that ends first
  kOver,        // down the tree: rank 0 has ended
  kLast         // to 0: there is no message behind this one
};

// Between two looks a share of the time since the last message, within these bounds.
constexpr int kShareOfSilence = 4;
constexpr std::chrono::microseconds kShortestSleep{100}, kLongestSleep{2000};

void put_key(ByteWriter& bytes, const ListKey& key, std::uint64_t jobs) {
  for (const std::uint64_t word : {key.list.first, key.list.second, key.time, jobs}) {
    bytes.put(word);
  }
}

ListKey get_key(ByteReader& bytes) {
  ListKey key;
  key.list.first = bytes.get<std::uint64_t>();
  key.list.second = bytes.get<std::uint64_t>();
  key.time = bytes.get<std::uint64_t>();
  return key;
}

std::string text_of(int origin, const OutgoingOutcomes& outgoing) {
  ByteWriter bytes;
  bytes.put(origin);
  put_key(bytes, outgoing.key, outgoing.jobs);
  for (const ToldOutcome& outcome : outgoing.outcomes) {
    bytes.put(outcome.job);
    bytes.put(std::string_view(outcome.bytes));
  }
  return bytes.bytes();
}

struct ReadOutcomes {
  int origin = 0;
  OutgoingOutcomes of;
};

ReadOutcomes outcomes_in(std::string_view text) {
  ByteReader bytes(text);
  ReadOutcomes read;
  read.origin = bytes.get<int>();
  read.of.key = get_key(bytes);
  read.of.jobs = bytes.get<std::uint64_t>();
  while (!bytes.is_at_end()) {
    const auto job = bytes.get<std::uint64_t>();
    read.of.outcomes.push_back({job, std::string(bytes.get_text())});
  }
  return read;
}

double cpu_of_thread() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

/// What the thread has in hand while MPI is open.
class MpiRanks::Node::Speaker {
 public:
  explicit Speaker(Node& node) : node_(node), board_(node.ranks_) {}

  void speak() {
    const double begin = cpu_of_thread();
    Clock::time_point last = Clock::now();
    while (!is_done()) {
      const bool has_read = read_all();
      answer_this_rank();
      tell_others();
      leave_or_end();
      forget_sent();
      const Clock::time_point now = Clock::now();
      if (has_read) last = now;
      const auto silence = std::chrono::duration_cast<std::chrono::microseconds>(now - last);
      node_.cpu_ = cpu_of_thread() - begin;
      if (!has_read) {
        node_.lists_.sleep(std::clamp(silence / kShareOfSilence, kShortestSleep, kLongestSleep));
      }
    }
    while (!sent_.empty()) forget_sent();
  }

 private:
  struct Message {
    std::shared_ptr<const std::string> text;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  using Text = std::shared_ptr<const std::string>;

  bool is_first() const { return node_.rank_ == 0; }

  /// Rank 0 hears every other's last word; another rank has said its own.
  bool is_done() const { return is_over_ && (!is_first() || last_words_ + 1 == node_.ranks_); }

  void send(int to, Tag tag, const Text& text) {
    // Nobody receives it, and a long message that is not received is never sent.
    if (is_over_ && tag != kOver && tag != kLast) return;
    Message& message = sent_.emplace_back();
    message.text = text;
    MPI_Isend(text->data(), static_cast<int>(text->size()), MPI_BYTE, to, tag, MPI_COMM_WORLD,
              &message.request);
    ++node_.messages_;
    node_.bytes_ += text->size();
  }
  void send(int to, Tag tag, std::string text) {
    send(to, tag, std::make_shared<const std::string>(std::move(text)));
  }
  void send_down(Tag tag, const Text& text) {
    for (int child = 2 * node_.rank_ + 1; child <= 2 * node_.rank_ + 2; ++child) {
      if (child < node_.ranks_) send(child, tag, text);
    }
  }
  void forget_sent() {
    for (auto place = sent_.begin(); place != sent_.end();) {
      int is_sent = 0;
      MPI_Test(&place->request, &is_sent, MPI_STATUS_IGNORE);
      place = is_sent != 0 ? sent_.erase(place) : std::next(place);
    }
  }

  bool read_all() {
    bool has_read = false;
    while (true) {
      int is_there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
      if (is_there == 0) return has_read;
      int size = 0;
      MPI_Get_count(&status, MPI_BYTE, &size);
      std::string text(static_cast<std::size_t>(size), '\0');
      MPI_Recv(text.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      read(status.MPI_SOURCE, static_cast<Tag>(status.MPI_TAG), std::move(text));
      has_read = true;
    }
  }

  void read(int from, Tag tag, std::string text) {
    ByteReader bytes(text);
    switch (tag) {
      case kWanted: {
        const ListKey key = get_key(bytes);
        const auto jobs = bytes.get<std::uint64_t>();
        const JobPiece piece = board_.take(key, jobs, from);
        ByteWriter answer;
        put_key(answer, key, jobs);
        answer.put(piece.first);
        answer.put(piece.count);
        return send(from, kPiece, answer.bytes());
      }
      case kPiece: {
        const ListKey key = get_key(bytes);
        bytes.get<std::uint64_t>();
        JobPiece piece;
        piece.first = bytes.get<std::uint64_t>();
        piece.count = bytes.get<std::uint64_t>();
        return node_.lists_.take_piece(key, piece);
      }
      case kTold:
      case kOutcomes:
        return take_outcomes(std::move(text));
      case kGivenBack:
        node_.lists_.set_free(get_key(bytes));
        return send_down(kGivenBack, std::make_shared<const std::string>(std::move(text)));
      case kLeft:
        if (bytes.get<int>() != 0) ++node_.failed_;
        return give_back(from);
      case kOver:
        return be_over();
      case kLast:
        ++last_words_;
    }
  }

  void take_outcomes(std::string&& text) {
    ReadOutcomes told = outcomes_in(text);
    if (is_first()) note_done(told.of);
    send_down(kOutcomes, std::make_shared<const std::string>(std::move(text)));
    if (told.origin != node_.rank_ && !has_left_) {
      node_.lists_.take_outcomes(told.of.key, told.of.jobs, std::move(told.of.outcomes));
    }
  }

  void note_done(const OutgoingOutcomes& told) {
    for (const ToldOutcome& outcome : told.outcomes) {
      board_.set_done(told.key, told.jobs, outcome.job);
    }
  }

  void give_back(int rank) {
    for (const ListKey& key : board_.give_back(rank)) {
      ByteWriter bytes;
      put_key(bytes, key, 0);
      node_.lists_.set_free(key);
      send_down(kGivenBack, std::make_shared<const std::string>(bytes.bytes()));
    }
  }

  void answer_this_rank() {
    for (const PieceWanted& wanted : node_.lists_.wanted()) {
      if (is_first()) {
        node_.lists_.take_piece(wanted.key, board_.take(wanted.key, wanted.jobs, 0));
      } else {
        ByteWriter bytes;
        put_key(bytes, wanted.key, wanted.jobs);
        send(0, kWanted, bytes.bytes());
      }
    }
  }

  void tell_others() {
    for (const OutgoingOutcomes& outgoing : node_.lists_.outgoing(Clock::now())) {
      if (is_over_) continue;
      std::string text = text_of(node_.rank_, outgoing);
      if (is_first()) {
        take_outcomes(std::move(text));
      } else {
        send(0, kTold, std::move(text));
      }
    }
  }

  void leave_or_end() {
    if (!node_.is_ending_ || is_over_ || has_left_) return;
    if (is_first()) return be_over();
    has_left_ = true;
    ByteWriter bytes;
    bytes.put(node_.exit_code_.load());
    send(0, kLeft, bytes.bytes());
  }

  /// Behind this nothing but last words is sent: whoever has read it reads no more.
  void be_over() {
    is_over_ = true;
    send_down(kOver, std::make_shared<const std::string>());
    node_.lists_.set_over();
    if (is_first()) return;
    send(0, kLast, std::string());
  }

  Node& node_;
  JobBoard board_;
  std::list<Message> sent_;
  int last_words_ = 0;
  bool is_over_ = false;
  bool has_left_ = false;
};

MpiRanks::Node::Node(int* argc, char*** argv, std::function<void()> when_over)
    : when_over_(std::move(when_over)) {
  std::atomic<bool> has_begun{false};
  thread_ = std::thread([&] { run(argc, argv, has_begun); });
  has_begun.wait(false);
}

MpiRanks::Node::~Node() {
  is_ending_ = true;
  thread_.join();
}

// MPI is begun, used and ended by one thread, so that it needs to know of no others.
void MpiRanks::Node::run(int* argc, char*** argv, std::atomic<bool>& has_begun) {
  int level = MPI_THREAD_SINGLE;
  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
  has_begun = true;
  has_begun.notify_one();
  Speaker(*this).speak();
  MPI_Finalize();
  if (rank_ > 0) when_over_();
}

RankTraffic MpiRanks::Node::traffic() const { return {messages_, bytes_, cpu_}; }

int MpiRanks::Node::end(int exit_code) {
  exit_code_ = exit_code;
  is_ending_ = true;
  thread_.join();
  thread_ = std::thread([] {});
  return failed_;
}

}  // namespace moivre
