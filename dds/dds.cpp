#include "dds/dds.h"

#include "dds/node.h"

using proskill::dds::Node;

namespace {

Node& nodeOf(DdsNode* node) { return *reinterpret_cast<Node*>(node); }

} // namespace

DdsNode* dds_open(uint32_t domain, const char* name, int loopback, double lease) {
  auto made =
      Node::open({.domain = domain, .name = name, .loopback = loopback != 0, .lease = lease});
  return reinterpret_cast<DdsNode*>(made.release());
}

void dds_close(DdsNode* node) { const std::unique_ptr<Node> owned(&nodeOf(node)); }

int32_t dds_reader(DdsNode* node, const char* topic, const char* type, uint32_t qos,
                   int32_t depth) {
  return nodeOf(node).addReader(topic, type, qos, depth);
}

int32_t dds_writer(DdsNode* node, const char* topic, const char* type, uint32_t qos,
                   int32_t depth) {
  return nodeOf(node).addWriter(topic, type, qos, depth);
}

void dds_guid(const DdsNode* node, int32_t endpoint, uint8_t guid[16]) {
  const auto sample = proskill::dds::sampleOf(reinterpret_cast<const Node*>(node)->guid(endpoint));
  std::copy_n(sample.writer, sizeof sample.writer, guid);
}

int dds_write(DdsNode* node, int32_t writer, const uint8_t* message, size_t size,
              const DdsSample* related, DdsSample* written) {
  return nodeOf(node).write(writer, {message, message + size}, related, written) ? 1 : 0;
}

void dds_next(DdsNode* node, int32_t milliseconds, DdsEvent* event) {
  nodeOf(node).next(std::chrono::milliseconds(milliseconds), *event);
}
