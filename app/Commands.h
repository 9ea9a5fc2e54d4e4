// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace brickwall {

/// What a chosen command does; returns the exit code. Bad input is thrown as Error.
using Action = std::function<int()>;

/// Each adds its subcommand, with options bound to state that the action shares, and sets `chosen` when it is parsed.
void addInfoCommand(CLI::App& app, Action& chosen);
void addRenderCommand(CLI::App& app, Action& chosen);
void addViewCommand(CLI::App& app, Action& chosen);
void addConvertCommand(CLI::App& app, Action& chosen);
void addSampleCommand(CLI::App& app, Action& chosen);
void addRigCommand(CLI::App& app, Action& chosen);
void addChartCommand(CLI::App& app, Action& chosen);
void addFlightCommand(CLI::App& app, Action& chosen);
void addVerifyCommand(CLI::App& app, Action& chosen);

} // namespace brickwall
