#pragma once

/// Calls of the global operator new so far in this program.
long countedAllocations();
