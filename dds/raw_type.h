#pragma once

#include <fastdds/dds/topic/TopicDataType.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace proskill::dds {

using Bytes = std::vector<std::uint8_t>;

/// Messages of any type, as the bytes that are sent: CDR with its header.
class RawType final : public eprosima::fastdds::dds::TopicDataType {
public:
  explicit RawType(const std::string& name);

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* key, bool force) override;
};

} // namespace proskill::dds
