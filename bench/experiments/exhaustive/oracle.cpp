// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/exhaustive/oracle.hpp"

#include <algorithm>
#include <vector>

namespace machine_code {

std::optional<Oracle> oracle_of(const reference::NamedSubject& named) {
    std::optional<Oracle> found;
    for (const operations::HostSubject& host : operations::host_subjects()) {
        if (host.subject != named.subject) continue;
        if (!found) found = Oracle{named.subject, host.judge, host.judge_all, nullptr};
        if (host.implementation == named.implementation) found->portable = &host;
    }
    return found;
}

void Oracle::compare_all(std::span<const std::int64_t> operands,
                         std::span<const std::int64_t> results, Differences& found) const {
    const reference::OperationShape& shape = reference::shape(subject.operation);
    std::vector<std::int64_t> expected(results.size());
    portable->evaluate(operands, expected);
    for (std::size_t i = 0; i < results.size() / shape.results; ++i) {
        const std::size_t first = i * shape.results;
        if (std::ranges::equal(results.subspan(first, shape.results),
                               std::span(expected).subspan(first, shape.results))) [[likely]]
            continue;
        if (found.count++ == 0)
            found.witness =
                reference::Witness(operands.subspan(i * shape.operands, shape.operands));
    }
}

}  // namespace machine_code
