#include "dds/endpoint.h"

#include <algorithm>

namespace proskill::dds {

namespace rtps = eprosima::fastrtps::rtps;
using namespace eprosima::fastdds::dds;

DdsSample sampleOf(const rtps::GUID_t& guid, std::int64_t number) {
  DdsSample made{};
  auto* end = std::ranges::copy(guid.guidPrefix.value, made.writer).out;
  std::ranges::copy(guid.entityId.value, end);
  made.number = number;
  return made;
}

rtps::GUID_t guidOf(const DdsSample& sample) {
  rtps::GUID_t made;
  std::copy_n(sample.writer, std::size(made.guidPrefix.value), made.guidPrefix.value);
  std::copy_n(sample.writer + std::size(made.guidPrefix.value), std::size(made.entityId.value),
              made.entityId.value);
  return made;
}

void Endpoint::on_data_available(DataReader* /*reader*/) {
  events.add({.kind = DDS_MESSAGE, .endpoint = number});
}

void Endpoint::on_subscription_matched(DataReader* /*reader*/,
                                       const SubscriptionMatchedStatus& status) {
  addMatch(status.current_count_change, status.last_publication_handle);
}

void Endpoint::on_publication_matched(DataWriter* /*writer*/,
                                      const PublicationMatchedStatus& status) {
  addMatch(status.current_count_change, status.last_subscription_handle);
}

void Endpoint::addMatch(int change, const rtps::InstanceHandle_t& other) {
  if (change == 0) return; // the other's quality of service has changed
  events.add({.kind = change > 0 ? DDS_MATCHED : DDS_UNMATCHED,
              .endpoint = number,
              .who = sampleOf(rtps::iHandle2GUID(other))});
}

} // namespace proskill::dds
