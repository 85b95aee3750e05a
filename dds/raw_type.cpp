#include "dds/raw_type.h"

#include <algorithm>
#include <memory>

namespace proskill::dds {

namespace {

/// For the first allocation; longer messages get longer ones.
constexpr std::uint32_t kUsualSize = 1024;

} // namespace

using eprosima::fastrtps::rtps::SerializedPayload_t;

RawType::RawType(const std::string& name) {
  setName(name.c_str());
  m_typeSize = kUsualSize;
  m_isGetKeyDefined = false;
  auto_fill_type_information(false);
  auto_fill_type_object(false);
}

bool RawType::serialize(void* data, SerializedPayload_t* payload) {
  const auto& bytes = *static_cast<const Bytes*>(data);
  if (bytes.size() < 2 || bytes.size() > payload->max_size) return false;
  std::ranges::copy(bytes, payload->data);
  payload->length = static_cast<std::uint32_t>(bytes.size());
  payload->encapsulation = bytes[1] == 0 ? CDR_BE : CDR_LE;
  return true;
}

bool RawType::deserialize(SerializedPayload_t* payload, void* data) {
  static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
  return true;
}

std::function<std::uint32_t()> RawType::getSerializedSizeProvider(void* data) {
  return [data] { return static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size()); };
}

void* RawType::createData() { return std::make_unique<Bytes>().release(); }

void RawType::deleteData(void* data) {
  const std::unique_ptr<Bytes> owned(static_cast<Bytes*>(data));
}

bool RawType::getKey(void* /*data*/, eprosima::fastrtps::rtps::InstanceHandle_t* /*key*/,
                     bool /*force*/) {
  return false; // messages of ROS have no keys
}

} // namespace proskill::dds
