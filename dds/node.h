#pragma once

#include "dds/dds.h"
#include "dds/endpoint.h"
#include "dds/events.h"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>

#include <deque>
#include <map>
#include <memory>
#include <string>

namespace proskill::dds {

struct NodeSettings {
  std::uint32_t domain = 0;
  std::string name;
  bool loopback = false;
  double lease = 0; ///< seconds; 0: the default
};

/// A participant with its readers and writers.
class Node final : public eprosima::fastdds::dds::DomainParticipantListener {
public:
  /// \return null if DDS refuses
  static std::unique_ptr<Node> open(const NodeSettings& settings);
  ~Node() override;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  /// \return the number of the endpoint, or -1
  std::int32_t addReader(const std::string& topic, const std::string& type, std::uint32_t qos,
                         std::int32_t depth);
  std::int32_t addWriter(const std::string& topic, const std::string& type, std::uint32_t qos,
                         std::int32_t depth);
  [[nodiscard]] eprosima::fastrtps::rtps::GUID_t guid(std::int32_t endpoint) const;

  bool write(std::int32_t writer, Bytes bytes, const DdsSample* related, DdsSample* written);
  void next(std::chrono::milliseconds patience, DdsEvent& event);

  /// In a thread of Fast DDS.
  void
  on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* of,
                           eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& found) override;

private:
  Node() = default;
  bool join(const NodeSettings& settings);
  eprosima::fastdds::dds::Topic* topicNamed(const std::string& topic, const std::string& type);
  Endpoint& newEndpoint();
  [[nodiscard]] Endpoint& endpointOf(std::int32_t number) const;
  bool take(std::int32_t endpoint, DdsEvent& event);

  Events events;
  Bytes message; ///< of the last event
  eprosima::fastdds::dds::DomainParticipant* participant = nullptr;
  eprosima::fastdds::dds::Publisher* publisher = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber = nullptr;
  mutable std::mutex mutex; ///< of what follows
  std::deque<std::unique_ptr<Endpoint>> endpoints;
  std::map<std::string, eprosima::fastdds::dds::Topic*> topics;
};

} // namespace proskill::dds
