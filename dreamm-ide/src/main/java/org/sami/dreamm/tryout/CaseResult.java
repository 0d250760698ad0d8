package org.sami.dreamm.tryout;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.TestCase;

/**
 * What is known of a saved test case.
 *
 * @param failure why it failed, in one sentence; empty where it passed
 * @param ran whether it was run on the plan as it is now
 */
record CaseResult(TestCase test, boolean ran, Optional<String> failure) {
    CaseResult {
        Objects.requireNonNull(test, "test");
        Objects.requireNonNull(failure, "failure");
    }

    String word() {
        return ran ? (failure.isEmpty() ? "passed" : "FAILED") : "not run";
    }
}
