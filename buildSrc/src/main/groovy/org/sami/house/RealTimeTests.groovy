package org.sami.house

import org.gradle.api.services.BuildService
import org.gradle.api.services.BuildServiceParameters

/** Held by each task that tests in real time while it runs: it is registered for few uses at a time. */
abstract class RealTimeTests implements BuildService<BuildServiceParameters.None> {}
