#include "worker/worker_job.h"

namespace proskill::worker {

WorkerJob jobFor(const analysis::Program& program) {
  WorkerJob job;
  for (const auto& file : program.files) job.texts.push_back({file.path, file.document.text()});
  return job;
}

std::string encode(const WorkerJob& job, int parentId) {
  Json files = Json::array();
  for (const auto& text : job.texts)
    files.push_back({{"path", text.path.string()}, {"bytes", text.text.size()}});
  Json header{{"parent", parentId},
              {"files", files},
              {"names", job.names},
              {"main", job.mainSkill},
              {"durations", job.durations},
              {"seconds", job.budget.seconds},
              {"megabytes", job.budget.megabytes},
              {"classes", job.budget.classes ? Json(*job.budget.classes) : Json()}};
  auto bytes = header.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  for (const auto& text : job.texts) bytes += text.text;
  return bytes;
}

std::optional<JobHeader> decodeHeader(std::string_view line) {
  auto json = Json::parse(line, nullptr, false);
  try {
    JobHeader header;
    header.parentId = json.at("parent").get<int>();
    for (const auto& file : json.at("files")) {
      header.job.texts.push_back({file.at("path").get<std::string>(), {}});
      header.lengths.push_back(file.at("bytes").get<std::size_t>());
    }
    header.job.names = json.at("names").get<std::vector<std::string>>();
    header.job.mainSkill = json.at("main").get<std::string>();
    header.job.durations = json.at("durations").get<bool>();
    header.job.budget.seconds = json.at("seconds").get<double>();
    header.job.budget.megabytes = json.at("megabytes").get<std::uint64_t>();
    if (const auto& classes = json.at("classes"); !classes.is_null())
      header.job.budget.classes = classes.get<std::uint64_t>();
    if (header.job.texts.empty()) return std::nullopt;
    return header;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

} // namespace proskill::worker
