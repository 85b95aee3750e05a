#pragma once

#include "dds/events.h"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

namespace proskill::dds {

/// A reader or a writer. Threads of Fast DDS call it, also before the endpoint is complete.
class Endpoint final : public eprosima::fastdds::dds::DataReaderListener,
                       public eprosima::fastdds::dds::DataWriterListener {
public:
  Endpoint(Events& notices, std::int32_t has) : number(has), events(notices) {}

  void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;
  void
  on_subscription_matched(eprosima::fastdds::dds::DataReader* reader,
                          const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override;
  void
  on_publication_matched(eprosima::fastdds::dds::DataWriter* writer,
                         const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;

  const std::int32_t number;
  // One of the two.
  eprosima::fastdds::dds::DataReader* reader = nullptr;
  eprosima::fastdds::dds::DataWriter* writer = nullptr;

private:
  void addMatch(int change, const eprosima::fastrtps::rtps::InstanceHandle_t& other);

  Events& events;
};

DdsSample sampleOf(const eprosima::fastrtps::rtps::GUID_t& guid, std::int64_t number = 0);
eprosima::fastrtps::rtps::GUID_t guidOf(const DdsSample& sample);

} // namespace proskill::dds
