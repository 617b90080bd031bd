#include "sylph_natnet/client.hpp"

#include "sylph_natnet/frame_codec.hpp"
#include "sylph_natnet/model_codec.hpp"

namespace sylph_natnet {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// The first echoes follow each other fast, to know the clock soon.
constexpr int kFastEchoes = 20;
constexpr milliseconds kFastEchoPeriod{50};
/// As many datagrams are taken at once: more may come faster than they can be read.
constexpr int kLargestBatch = 1000;
constexpr std::uint64_t kOldestEchoNs = 1'000'000'000;

double seconds(steady_clock::time_point time) {
  return duration<double>(time.time_since_epoch()).count();
}

std::uint64_t nanoseconds(steady_clock::time_point time) {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count());
}

/// @return whether `period` has passed since `last`; if so `last` becomes `now`
bool takeTurn(steady_clock::time_point& last, steady_clock::time_point now, milliseconds period) {
  if (now - last < period) {
    return false;
  }
  last = now;
  return true;
}

UdpSocket joinedSocket(const ClientOptions& options) {
  // Bound to the group, not to any address, it gets nothing but what is sent to the group.
  UdpSocket socket({options.multicast_group, options.data_port}, true);
  Ipv4Address interface = options.local_interface;
  if (interface == kAnyAddress) {
    interface = localAddressTowards(options.server).value_or(kAnyAddress);
  }
  socket.joinGroup(options.multicast_group, interface);
  return socket;
}

}  // namespace

Client::Client(const ClientOptions& options)
    : options_(options),
      command_socket_({options.local_interface, 0}),
      last_frame_(steady_clock::now()) {
  if (options_.multicast) {
    data_socket_.emplace(joinedSocket(options_));
  }
}

Client::~Client() {
  // Otherwise the server goes on sending for as long as its timeout is.
  send(makeMessage(MessageId::Disconnect));
}

std::optional<Version> Client::version() const {
  if (options_.bitstream) {
    return options_.bitstream;
  }
  return info_ ? std::optional<Version>(info_->version) : std::nullopt;
}

std::optional<ClockEstimate> Client::clock() const {
  return echo_clock_.estimate(seconds(steady_clock::now()));
}

std::optional<ReceivedFrame> Client::poll(milliseconds timeout) {
  std::vector<ReceivedFrame> frames = pollAll(timeout);
  if (frames.empty()) {
    return std::nullopt;
  }
  // A robot needs to know where it is now: of several frames the newest.
  statistics_.superseded += frames.size() - 1;
  return std::move(frames.back());
}

std::vector<ReceivedFrame> Client::pollAll(milliseconds timeout) {
  sendWhatIsDue(steady_clock::now());
  std::vector<const UdpSocket*> sockets{&command_socket_};
  if (data_socket_) {
    sockets.push_back(&*data_socket_);
  }
  std::vector<ReceivedFrame> frames;
  if (waitForInput(sockets, timeout)) {
    drain(command_socket_, frames);
    if (data_socket_) {
      drain(*data_socket_, frames);
    }
  }
  return frames;
}

void Client::send(const Datagram& datagram) {
  command_socket_.sendTo(datagram, {options_.server, options_.command_port});
}

void Client::sendWhatIsDue(Time now) {
  if ((connect_wanted_ || isSilent(now)) && takeTurn(last_connect_, now, options_.retry_period)) {
    send(makeConnect(options_.name, options_.bitstream.value_or(kNewestVersion)));
    if (options_.bitstream) {
      send(makeRequest("Bitstream," + toString(*options_.bitstream)));
    }
  }
  if (!info_) {
    return;
  }
  // To a group servers send whether anybody listens or not.
  if (!options_.multicast && takeTurn(last_keep_alive_, now, options_.keep_alive_period)) {
    send(makeMessage(MessageId::KeepAlive));
  }
  const milliseconds definitions_period =
      definitions_wanted_ ? options_.retry_period : options_.definitions_period;
  if (takeTurn(last_definitions_request_, now, definitions_period)) {
    // Some servers answer with the mask only, older ones perhaps without it only.
    send(makeModelDefinitionsRequest(unanswered_definitions_requests_ % 2 == 1));
    ++unanswered_definitions_requests_;
    definitions_wanted_ = true;
  }
  const milliseconds echo_period = echoes_ < kFastEchoes ? kFastEchoPeriod : options_.echo_period;
  if (info_->ticks_per_s > 0 && takeTurn(last_echo_, now, echo_period)) {
    ++echoes_;
    send(makeEchoRequest(nanoseconds(steady_clock::now())));
  }
}

void Client::drain(UdpSocket& socket, std::vector<ReceivedFrame>& frames) {
  for (int i = 0; i < kLargestBatch; ++i) {
    const std::optional<Endpoint> sender = socket.receive(buffer_);
    if (!sender) {
      return;
    }
    const Time now = steady_clock::now();
    // Anybody in the network may send to this port, also a second Motive that streams to the same
    // group.
    if (sender->address != options_.server) {
      ++statistics_.foreign;
      statistics_.last_foreign = sender->address;
      continue;
    }
    ++statistics_.datagrams;
    statistics_.bytes += buffer_.size();
    try {
      if (std::optional<Frame> frame = handle(openMessage(buffer_), now)) {
        frames.push_back({std::move(*frame), now});
      }
    } catch (const ParseError& error) {
      ++statistics_.parse_errors;
      statistics_.last_error = error.what();
      connect_wanted_ = true;  // the server may speak another version since
    }
  }
}

std::optional<Frame> Client::handle(const Message& message, Time now) {
  switch (message.id) {
    case MessageId::ServerInfo:
      onServerInfo(parseServerInfo(message.payload), now);
      break;
    case MessageId::ModelDefinitions:
      onDefinitions(message.payload);
      break;
    case MessageId::EchoResponse:
      onEcho(parseEchoResponse(message.payload), now);
      break;
    case MessageId::FrameOfData:
      return onFrame(message.payload, now);
    case MessageId::Disconnect:
    case MessageId::DisconnectByTimeout:
      loseServer();
      break;
    default:
      break;
  }
  return std::nullopt;
}

void Client::onServerInfo(const ServerInfo& info, Time now) {
  connect_wanted_ = false;
  const bool resumes = isSilent(now) && session_has_frames_;
  // A server that was started again may number frames and bodies anew, although it says the same of
  // itself.
  if (!info_ || !(*info_ == info) || resumes) {
    beginSession();
  }
  info_ = info;
}

void Client::beginSession() {
  ++session_;
  sequence_.restart();
  session_has_frames_ = false;
  newest_ticks_ = 0;
  echo_clock_.reset();
  echoes_ = 0;
  definitions_ = {};
  definitions_known_ = false;
  ++definitions_revision_;
  definitions_wanted_ = true;
  last_definitions_request_ = {};
}

void Client::loseServer() {
  info_.reset();
  definitions_ = {};
  definitions_known_ = false;
  ++definitions_revision_;
  connect_wanted_ = true;
}

void Client::onDefinitions(ByteReader payload) {
  if (!version()) {
    return;
  }
  ModelDefinitions definitions = parseModelDefinitions(payload, *version());
  definitions_known_ = true;
  definitions_wanted_ = false;
  unanswered_definitions_requests_ = 0;
  if (!(definitions == definitions_)) {
    definitions_ = std::move(definitions);
    ++definitions_revision_;
  }
}

void Client::onEcho(const EchoResponse& echo, Time now) {
  const std::uint64_t now_ns = nanoseconds(now);
  // An answer to nobody, or to a request of long ago, tells nothing.
  if (!info_ || info_->ticks_per_s == 0 || echo.client_stamp > now_ns ||
      now_ns - echo.client_stamp > kOldestEchoNs) {
    return;
  }
  const double round_trip_s = static_cast<double>(now_ns - echo.client_stamp) * 1e-9;
  echo_clock_.add({seconds(now) - round_trip_s,
                   static_cast<double>(echo.server_ticks) / static_cast<double>(info_->ticks_per_s),
                   seconds(now)});
}

std::optional<Frame> Client::onFrame(ByteReader payload, Time now) {
  ++statistics_.frames;
  if (!version()) {
    return std::nullopt;
  }
  const Frame frame = parseFrame(payload, *version());
  last_frame_ = now;
  session_has_frames_ = true;
  const FrameSequence::Verdict verdict = sequence_.accept(frame.number);
  statistics_.lost = sequence_.lost();
  statistics_.late = sequence_.late();
  if (verdict == FrameSequence::Verdict::Late) {
    return std::nullopt;
  }
  // Its clock began anew as well: what was learnt of it is void.
  if (verdict == FrameSequence::Verdict::Restart || frame.transmit_ticks < newest_ticks_) {
    loseServer();
    return std::nullopt;
  }
  newest_ticks_ = frame.transmit_ticks;
  if (frame.models_changed) {
    definitions_wanted_ = true;
  }
  return frame;
}

}  // namespace sylph_natnet
