#include "dds/node.h"

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

namespace proskill::dds {

namespace rtps = eprosima::fastrtps::rtps;
using namespace eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

namespace {

constexpr const char* kThisMachine = "127.0.0.1";
/// How many participants of this machine, beyond those of multicast, are looked for by number.
constexpr std::uint32_t kPeers = 8;
/// The patience with reliable readers that have not got all messages when a node ends.
const eprosima::fastrtps::Duration_t kLastMessages(0.5);

void keepToLoopback(DomainParticipantQos& qos, std::uint32_t domain) {
  const auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  transport->interfaceWhiteList.emplace_back(kThisMachine);
  qos.transport().user_transports.push_back(transport);
  qos.transport().use_builtin_transports = false;
  auto& builtin = qos.wire_protocol().builtin;
  const rtps::PortParameters ports;
  for (std::uint32_t peer = 0; peer < kPeers; ++peer) {
    rtps::Locator_t locator;
    rtps::IPLocator::setIPv4(locator, kThisMachine);
    locator.port = ports.getUnicastPort(domain, peer);
    builtin.initialPeersList.push_back(locator);
  }
  rtps::Locator_t multicast;
  rtps::IPLocator::setIPv4(multicast, "239.255.0.1");
  multicast.port = ports.getMulticastPort(domain);
  builtin.initialPeersList.push_back(multicast);
}

/// As the RMW of ROS 2 has it: no limit but the depth of the history.
template <typename Qos> void setQuality(Qos& qos, std::uint32_t bits, std::int32_t depth) {
  qos.reliability().kind =
      (bits & DDS_RELIABLE) != 0 ? RELIABLE_RELIABILITY_QOS : BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      (bits & DDS_TRANSIENT_LOCAL) != 0 ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
  qos.history().kind = KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  qos.data_sharing().off();
}

} // namespace

std::unique_ptr<Node> Node::open(const NodeSettings& settings) {
  std::unique_ptr<Node> made(new Node);
  return made->join(settings) ? std::move(made) : nullptr;
}

bool Node::join(const NodeSettings& settings) {
  auto* factory = DomainParticipantFactory::get_instance();
  factory->load_profiles(); // FASTRTPS_DEFAULT_PROFILES_FILE, as nodes of ROS 2 do
  auto qos = factory->get_default_participant_qos();
  qos.name(settings.name);
  const std::string enclave = "enclave=/;"; // nodes of ROS 2 look for it
  qos.user_data().setValue({enclave.begin(), enclave.end()});
  if (settings.loopback) keepToLoopback(qos, settings.domain);
  if (settings.lease > 0) {
    auto& config = qos.wire_protocol().builtin.discovery_config;
    config.leaseDuration = eprosima::fastrtps::Duration_t(settings.lease);
    config.leaseDuration_announcementperiod = eprosima::fastrtps::Duration_t(settings.lease / 4);
  }
  participant = factory->create_participant(settings.domain, qos, this, StatusMask::none());
  if (!participant) return false;
  publisher = participant->create_publisher(PUBLISHER_QOS_DEFAULT);
  subscriber = participant->create_subscriber(SUBSCRIBER_QOS_DEFAULT);
  return publisher && subscriber;
}

Node::~Node() {
  if (!participant) return;
  if (publisher) publisher->wait_for_acknowledgments(kLastMessages);
  participant->delete_contained_entities();
  DomainParticipantFactory::get_instance()->delete_participant(participant);
}

Topic* Node::topicNamed(const std::string& topic, const std::string& type) {
  const std::scoped_lock lock(mutex);
  auto& found = topics[topic];
  if (found) return found->get_type_name() == type ? found : nullptr;
  TypeSupport(new RawType(type)).register_type(participant);
  found = participant->create_topic(topic, type, TOPIC_QOS_DEFAULT);
  return found;
}

Endpoint& Node::newEndpoint() {
  const std::scoped_lock lock(mutex);
  const auto number = static_cast<std::int32_t>(endpoints.size());
  return *endpoints.emplace_back(std::make_unique<Endpoint>(events, number));
}

Endpoint& Node::endpointOf(std::int32_t number) const {
  const std::scoped_lock lock(mutex);
  return *endpoints.at(static_cast<std::size_t>(number));
}

std::int32_t Node::addReader(const std::string& topic, const std::string& type, std::uint32_t qos,
                             std::int32_t depth) {
  auto* const on = topicNamed(topic, type);
  if (!on) return -1;
  auto& endpoint = newEndpoint();
  DataReaderQos quality;
  setQuality(quality, qos, depth);
  auto* const made = subscriber->create_datareader(on, quality, &endpoint);
  if (!made) return -1;
  {
    const std::scoped_lock lock(mutex);
    endpoint.reader = made;
  }
  endpoint.on_data_available(made); // what came before cannot have been taken
  return endpoint.number;
}

std::int32_t Node::addWriter(const std::string& topic, const std::string& type, std::uint32_t qos,
                             std::int32_t depth) {
  auto* const on = topicNamed(topic, type);
  if (!on) return -1;
  auto& endpoint = newEndpoint();
  DataWriterQos quality;
  setQuality(quality, qos, depth);
  endpoint.writer = publisher->create_datawriter(on, quality, &endpoint);
  return endpoint.writer ? endpoint.number : -1;
}

rtps::GUID_t Node::guid(std::int32_t endpoint) const {
  const auto& found = endpointOf(endpoint);
  return found.reader ? found.reader->guid() : found.writer->guid();
}

bool Node::write(std::int32_t writer, Bytes bytes, const DdsSample* related, DdsSample* written) {
  rtps::WriteParams parameters;
  if (related) {
    parameters.related_sample_identity().writer_guid(guidOf(*related));
    if (related->number != 0)
      parameters.related_sample_identity().sequence_number(
          rtps::SequenceNumber_t(static_cast<std::uint64_t>(related->number)));
  }
  if (!endpointOf(writer).writer->write(&bytes, parameters)) return false;
  const auto& identity = parameters.sample_identity();
  if (written)
    *written = sampleOf(identity.writer_guid(),
                        static_cast<std::int64_t>(identity.sequence_number().to64long()));
  return true;
}

void Node::next(std::chrono::milliseconds patience, DdsEvent& event) {
  const auto until = std::chrono::steady_clock::now() + patience;
  event = {};
  while (auto notice = events.next(until)) {
    if (notice->kind == DDS_MESSAGE) {
      if (take(notice->endpoint, event)) return;
      continue;
    }
    message = std::move(notice->text);
    event.kind = notice->kind;
    event.endpoint = notice->endpoint;
    event.sample = notice->who;
    event.message = message.data();
    event.size = message.size();
    return;
  }
}

bool Node::take(std::int32_t endpoint, DdsEvent& event) {
  SampleInfo info;
  auto* reader = endpointOf(endpoint).reader;
  if (!reader || reader->take_next_sample(&message, &info) != ReturnCode_t::RETCODE_OK)
    return false;
  events.add({.kind = DDS_MESSAGE, .endpoint = endpoint}); // perhaps there are more
  if (!info.valid_data) return false;
  const auto identityOf = [](const rtps::SampleIdentity& of) {
    const auto number = of.sequence_number();
    const bool isKnown = number != rtps::SequenceNumber_t::unknown();
    return sampleOf(of.writer_guid(), isKnown ? static_cast<std::int64_t>(number.to64long()) : 0);
  };
  event = {.kind = DDS_MESSAGE,
           .endpoint = endpoint,
           .sample = identityOf(info.sample_identity),
           .related = identityOf(info.related_sample_identity),
           .message = message.data(),
           .size = message.size()};
  return true;
}

void Node::on_participant_discovery(DomainParticipant* /*of*/,
                                    rtps::ParticipantDiscoveryInfo&& found) {
  using Info = rtps::ParticipantDiscoveryInfo;
  if (found.status == Info::CHANGED_QOS_PARTICIPANT) return;
  const std::string name = found.info.m_participantName.to_string();
  events.add({.kind = found.status == Info::DISCOVERED_PARTICIPANT ? DDS_JOINED : DDS_LEFT,
              .who = sampleOf(found.info.m_guid),
              .text = {name.begin(), name.end()}});
}

} // namespace proskill::dds
