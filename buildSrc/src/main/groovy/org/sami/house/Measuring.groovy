package org.sami.house

import org.gradle.api.services.BuildService
import org.gradle.api.services.BuildServiceParameters

/** Held by the one task that measures: it is registered for a single use at a time. */
abstract class Measuring implements BuildService<BuildServiceParameters.None> {}
