package org.sami.spn.model;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A test case saved with its plan: steps on a fresh mission with the given proxies.
 *
 * @param start where the mission starts if not at the plan's start place
 */
public record TestCase(String name, List<String> proxies, Optional<TestStart> start, List<TestStep> steps) {
    public TestCase {
        Objects.requireNonNull(name, "name");
        proxies = List.copyOf(proxies);
        Objects.requireNonNull(start, "start");
        steps = List.copyOf(steps);
    }

    /** A test case that begins at the plan's start place. */
    public TestCase(String name, List<String> proxies, List<TestStep> steps) {
        this(name, proxies, Optional.empty(), steps);
    }

    /** The same test case with other steps. */
    public TestCase withSteps(List<TestStep> steps) {
        return new TestCase(name, proxies, start, steps);
    }

    /** The same test case from another start. */
    public TestCase withStart(Optional<TestStart> start) {
        return new TestCase(name, proxies, start, steps);
    }

    /** The same test case under another name. */
    public TestCase withName(String name) {
        return new TestCase(name, proxies, start, steps);
    }
}
