#pragma once

/// Marks the functions that the shared library exports. All others have hidden visibility.
#define ROCKING_API __attribute__((visibility("default")))
