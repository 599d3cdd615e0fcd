#include "verification/suite/shipped.hpp"

#include "core/io/files.hpp"
#include "verification/suite/places.hpp"

namespace talus::verification {

Document shipped(std::string const& study, std::vector<std::string> const& changes) {
  std::string const file = std::string(studies) + "/" + study;
  Document document = parse(io::read_file(file), file);
  for (std::string const& change : changes) set_value(document, change);
  return document;
}

}  // namespace talus::verification
