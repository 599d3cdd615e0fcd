#pragma once
/// The verbs that only look: check, explain, schema, list, describe, cite.

#include <string>
#include <vector>

#include "core/cli/exit_codes.hpp"
#include "core/cli/program.hpp"

namespace talus::cli {

/// A document from a file, with `--set` assignments applied. Throws FileError, InputError.
[[nodiscard]] Document load(std::string const& path, std::vector<std::string> const& assignments);

/// Prints every mistake and warning of the files; input_invalid if there is a mistake.
[[nodiscard]] ExitCode check(std::vector<std::string> const& files, bool json);
/// Prints what would be composed.
void explain(Document const& document, bool json);
/// Prints the kinds of policies, or the policies of one kind. Throws InputError for an unknown kind.
void list(std::string const& kind, bool json);
/// Prints one policy's page, or that of a document ("case", "study"). Throws InputError for an unknown name.
void describe(std::string const& name, bool json);
/// Prints what to cite for a document: its own citations and the sources of its policies.
void cite(Document const& document, bool json);
/// The manual: every policy and document, as Markdown.
[[nodiscard]] std::string manual();

}  // namespace talus::cli
