// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "leonhard/app/graphs/partition_request.hpp"
#include "leonhard/app/report/json.hpp"

namespace leonhard::app {

/// What a partition costs in all and part by part, as the report of `leonhard partition`.
[[nodiscard]] Json partition_report(const graph::Partition& partition, const graph::PartitionCost& cost,
                                    const PartitionRequest& request);

/// The same for people: the totals, one a line.
///
/// of  what the graph's vertices are (vertices_are)
[[nodiscard]] std::string partition_report_text(const graph::Partition& partition,
                                                const graph::PartitionCost& cost,
                                                const PartitionRequest& request, std::string_view of);

}  // namespace leonhard::app
