package org.sami.spn.statespace;

import java.util.Objects;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.TestCase;

/**
 * What a deep check found.
 *
 * @param witness a run that ends where the finding is, to be played; empty where the finding is that there is no such run
 */
public record DeepFinding(Finding finding, Optional<TestCase> witness) {
    public DeepFinding {
        Objects.requireNonNull(finding, "finding");
        Objects.requireNonNull(witness, "witness");
    }
}
