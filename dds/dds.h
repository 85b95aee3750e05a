/* What the adapter to ROS 2 needs of DDS: messages as bytes, and who is there. Python calls it by
 * ctypes (python/proskill/ros2/dds.py). Calls may come from any thread; `dds_next` from one at a
 * time. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A participant with its readers and writers, which are numbered from 0. */
typedef struct DdsNode DdsNode;

/* Which write it was: the writer's GUID, and the number of the write. */
typedef struct DdsSample {
  uint8_t writer[16];
  int64_t number;
} DdsSample;

typedef enum DdsEventKind {
  DDS_NOTHING = 0,   /* the time has passed */
  DDS_MESSAGE = 1,   /* `endpoint` has read a message */
  DDS_MATCHED = 2,   /* `endpoint` and the endpoint `sample.writer` of another participant know each
                        other */
  DDS_UNMATCHED = 3, /* the other endpoint, or its participant, has gone */
  DDS_JOINED = 4,    /* the participant whose GUID is `sample.writer`; its name is the message */
  DDS_LEFT = 5       /* it has said so, or its lease has expired */
} DdsEventKind;

/* What `dds_next` returns. The message is valid until the next call. */
typedef struct DdsEvent {
  int32_t kind;
  int32_t endpoint;
  DdsSample sample;
  DdsSample related; /* of a reply: the request; all zero if there is none */
  const uint8_t* message;
  size_t size;
} DdsEvent;

/* Bits of the quality of service. */
enum { DDS_RELIABLE = 1, DDS_TRANSIENT_LOCAL = 2 };

/* Joins a domain. Without an error it returns a node, which `dds_close` ends.
 * \param loopback not 0: with participants of this machine only, by the loopback interface
 * \param lease seconds of silence after which others consider it gone; 0: the default, 20 */
DdsNode* dds_open(uint32_t domain, const char* name, int loopback, double lease);
void dds_close(DdsNode* node);

/* \param depth how many messages are kept that have not been read
 * \return the number of the endpoint, or -1 */
int32_t dds_reader(DdsNode* node, const char* topic, const char* type, uint32_t qos, int32_t depth);
int32_t dds_writer(DdsNode* node, const char* topic, const char* type, uint32_t qos, int32_t depth);
/* The GUID of an endpoint. \pre it exists */
void dds_guid(const DdsNode* node, int32_t endpoint, uint8_t guid[16]);

/* Writes a message: CDR with its header of 4 bytes.
 * \param related the request that it replies to, or NULL
 * \param written which write it was, or NULL
 * \return whether it was written */
int dds_write(DdsNode* node, int32_t writer, const uint8_t* message, size_t size,
              const DdsSample* related, DdsSample* written);

/* Waits for the next event. */
void dds_next(DdsNode* node, int32_t milliseconds, DdsEvent* event);

#ifdef __cplusplus
}
#endif
