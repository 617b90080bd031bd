#include "sylph_natnet/server.hpp"

#include <algorithm>

#include "sylph_natnet/byte_writer.hpp"
#include "sylph_natnet/frame_codec.hpp"
#include "sylph_natnet/model_codec.hpp"

namespace sylph_natnet {

Server::Server(const ServerOptions& options)
    : options_(options),
      command_socket_({options.address, options.command_port}),
      data_socket_({options.address, options.data_port}) {
  if (options_.multicast) {
    data_socket_.sendGroupsThrough(options_.address);
  }
}

std::size_t Server::serve(std::uint64_t now_ticks) {
  std::size_t commands = 0;
  Datagram datagram;
  while (const std::optional<Endpoint> sender = command_socket_.receive(datagram)) {
    ++commands;
    try {
      answer(openMessage(datagram), *sender, now_ticks);
    } catch (const ParseError&) {
      command_socket_.sendTo(makeMessage(MessageId::UnrecognizedRequest), *sender);
    }
  }
  dropSilentClients();
  return commands;
}

bool Server::waitForCommand(std::chrono::milliseconds timeout) const {
  return waitForInput({&command_socket_}, timeout);
}

void Server::answer(const Message& message, const Endpoint& sender, std::uint64_t now_ticks) {
  switch (message.id) {
    case MessageId::Connect:
      remember(sender);
      command_socket_.sendTo(makeServerInfo(info()), sender);
      break;
    case MessageId::Discovery:
      command_socket_.sendTo(makeServerInfo(info()), sender);
      break;
    case MessageId::KeepAlive:
      refresh(sender);
      break;
    case MessageId::Disconnect:
      forget(sender);
      break;
    case MessageId::RequestModelDefinitions:
      command_socket_.sendTo(makeModelDefinitions(definitions_, options_.version), sender);
      break;
    case MessageId::EchoRequest:
      command_socket_.sendTo(makeEchoResponse({parseEchoRequest(message.payload), now_ticks}),
                             sender);
      break;
    case MessageId::Request:
      answerRequest(message.payload, sender);
      break;
    default:
      command_socket_.sendTo(makeMessage(MessageId::UnrecognizedRequest), sender);
  }
}

void Server::answerRequest(ByteReader payload, const Endpoint& sender) {
  if (payload.readString("request") != "FrameRate") {
    command_socket_.sendTo(makeMessage(MessageId::UnrecognizedRequest), sender);
    return;
  }
  ByteWriter response;
  response.writeFloat(options_.frame_rate_hz);
  command_socket_.sendTo(makeMessage(MessageId::Response, response.bytes()), sender);
}

std::size_t Server::send(const Frame& frame) {
  const Datagram datagram = makeFrame(frame, options_.version);
  if (options_.multicast) {
    return data_socket_.sendTo(datagram, {options_.multicast_group, dataPort()}) ? 1 : 0;
  }
  std::size_t receivers = 0;
  for (const Client& client : clients_) {
    receivers += data_socket_.sendTo(datagram, client.endpoint) ? 1 : 0;
  }
  return receivers;
}

void Server::remember(const Endpoint& sender) {
  if (options_.multicast) {
    return;
  }
  forget(sender);
  // Who connects again is still one client.
  clients_.push_back({sender, std::chrono::steady_clock::now()});
}

void Server::refresh(const Endpoint& sender) {
  for (Client& client : clients_) {
    if (client.endpoint == sender) {
      client.last_heard = std::chrono::steady_clock::now();
    }
  }
}

void Server::forget(const Endpoint& sender) {
  clients_.erase(
      std::remove_if(clients_.begin(), clients_.end(),
                     [&sender](const Client& client) { return client.endpoint == sender; }),
      clients_.end());
}

void Server::dropSilentClients() {
  const SteadyTime oldest = std::chrono::steady_clock::now() - options_.client_timeout;
  clients_.erase(
      std::remove_if(clients_.begin(), clients_.end(),
                     [oldest](const Client& client) { return client.last_heard < oldest; }),
      clients_.end());
}

ServerInfo Server::info() const {
  ServerInfo info;
  info.name = options_.name;
  info.app_version = {1, 0, 0, 0};
  info.version = options_.version;
  if (options_.version >= Version{3, 0}) {
    info.ticks_per_s = options_.ticks_per_s;
    info.data_port = dataPort();
    info.is_multicast = options_.multicast;
    info.multicast_group = options_.multicast_group;
  }
  return info;
}

}  // namespace sylph_natnet
