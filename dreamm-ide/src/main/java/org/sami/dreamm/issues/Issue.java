package org.sami.dreamm.issues;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.edit.Fix;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.TestCase;

/**
 * One line of the issues view.
 *
 * @param number distinguishes it from others with the same text
 * @param witness a run that leads there, where a deep check found one
 * @param deep whether a deep check found it
 */
public record Issue(int number, Finding finding, Optional<TestCase> witness, boolean deep) {
    public Issue {
        Objects.requireNonNull(finding, "finding");
        Objects.requireNonNull(witness, "witness");
    }

    /** Edits that mend it, the likeliest first. */
    public List<Fix> fixes() {
        return finding.fixes();
    }

    /** The same thing at two moments: what a selection stays with. */
    Object key() {
        return List.of(finding.plan(), finding.code(), finding.elements(), finding.message(), number);
    }
}
