package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/** A test case saved with its plan: steps on a fresh mission with the given proxies. */
public record TestCase(String name, List<String> proxies, List<TestStep> steps) {
    public TestCase {
        Objects.requireNonNull(name, "name");
        proxies = List.copyOf(proxies);
        steps = List.copyOf(steps);
    }

    /** The same test case with other steps. */
    public TestCase withSteps(List<TestStep> steps) {
        return new TestCase(name, proxies, steps);
    }
}
