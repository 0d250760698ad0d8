package org.sami.spn.advice;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.json.ReaderAdvice;
import org.sami.spn.legacy.LegacyAdvice;
import org.sami.spn.planspace.BoundNotes;
import org.sami.spn.statespace.DeepChecks;

/** Why a finding matters and how it is mended, by its code: of readers, checks, deep checks, test cases and imports. */
public final class FindingAdvice {
    private static final Advice TEST_CASE = new Advice(
            "E-TEST-CASE",
            "The plan no longer does what its author saved as right.",
            "Play the test case. Mend the plan where it goes another way, or save the run anew if that way is right.");

    private static final Map<String, Advice> BY_CODE = byCode();

    private FindingAdvice() {}

    private static Map<String, Advice> byCode() {
        Map<String, Advice> all = new LinkedHashMap<>();
        Stream.of(
                        PlanChecks.advice(),
                        DeepChecks.ALL.get(0).advice(),
                        ReaderAdvice.ALL,
                        LegacyAdvice.ALL,
                        BoundNotes.ADVICE,
                        List.of(TEST_CASE))
                .flatMap(List::stream)
                .forEach(advice -> all.putIfAbsent(advice.code(), advice)); // a check knows more than a reader
        return Map.copyOf(all);
    }

    /** What helps with a finding; empty where its code is none of these. */
    public static Optional<Advice> of(Finding finding) {
        return Optional.ofNullable(BY_CODE.get(finding.code()));
    }

    /** One for each code. */
    public static Collection<Advice> all() {
        return BY_CODE.values();
    }
}
