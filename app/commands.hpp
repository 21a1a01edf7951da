// The commands. Each returns the exit status, or throws before it has done anything.
#pragma once

#include "app/exit_code.hpp"
#include "app/options.hpp"

namespace sphereview {

ExitCode run_view(const ViewOptions& options);  // in app/viewer/
ExitCode run_render(const RenderOptions& options);
ExitCode run_convert(const ConvertOptions& options);
ExitCode run_explain(const ExplainOptions& options);
ExitCode run_doctor(const DoctorOptions& options);

}  // namespace sphereview
