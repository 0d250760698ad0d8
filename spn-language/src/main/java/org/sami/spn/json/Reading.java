package org.sami.spn.json;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.finding.Finding;

/**
 * What came of reading a document: the whole of it or nothing, and every problem that was found.
 *
 * @param result empty where an error kept the document from being understood; nothing is loaded half
 * @param findings in the order of the document
 */
public record Reading<T>(Optional<T> result, List<Finding> findings) {
    public Reading {
        Objects.requireNonNull(result, "result");
        findings = List.copyOf(findings);
    }

    /** Whether a finding is an error. A result may be there even so: it can be shown and edited, but not started. */
    public boolean hasErrors() {
        return findings.stream().anyMatch(Finding::isError);
    }

    /**
     * The same with the places of the findings in the text that was read.
     *
     * @param file the file of the text; empty where the caller knows it
     * @param text in which their pointers, and the lines that a parser named, lie
     */
    public Reading<T> locatedIn(String file, String text) {
        SourceTexts sources = new SourceTexts();
        sources.add("", file, text);
        return new Reading<>(result, sources.locate(findings));
    }

    /**
     * The result of a document that is known to be good, such as one that ships with the program.
     *
     * @throws IllegalStateException naming the findings, where there is none
     */
    public T orThrow() {
        return result.orElseThrow(() -> new IllegalStateException("The document cannot be read: " + findings));
    }

    static <T> Reading<T> of(T value, Problems problems) {
        return new Reading<>(problems.none() ? Optional.of(value) : Optional.empty(), problems.findings());
    }

    static <T> Reading<T> nothing(Problems problems) {
        return new Reading<>(Optional.empty(), problems.findings());
    }
}
