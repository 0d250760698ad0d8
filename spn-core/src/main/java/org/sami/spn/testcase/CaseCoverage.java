package org.sami.spn.testcase;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * What of a plan some runs of its test cases visited.
 *
 * @param places how many there are
 * @param transitions how many there are
 * @param neverEntered ids of places that no run entered, in the plan's order
 * @param neverFired ids of transitions that no run fired, in the plan's order
 */
public record CaseCoverage(int places, int transitions, Set<String> neverEntered, Set<String> neverFired) {
    public CaseCoverage {
        Objects.requireNonNull(neverEntered, "neverEntered");
        neverEntered = Collections.unmodifiableSet(new LinkedHashSet<>(neverEntered));
        neverFired = Collections.unmodifiableSet(new LinkedHashSet<>(neverFired));
    }

    /** What runs of a plan visited, those that failed included as far as they went. */
    public static CaseCoverage of(Plan plan, List<TestCaseRunner.Trace> runs) {
        Set<String> places =
                new LinkedHashSet<>(plan.places().stream().map(Place::id).toList());
        Set<String> transitions = new LinkedHashSet<>(
                plan.transitions().stream().map(Transition::id).toList());
        runs.forEach(run -> {
            places.removeAll(run.entered());
            transitions.removeAll(run.fired());
        });
        return new CaseCoverage(plan.places().size(), plan.transitions().size(), places, transitions);
    }

    /** All that no run visited. */
    public Set<String> neverVisited() {
        Set<String> all = new LinkedHashSet<>(neverEntered);
        all.addAll(neverFired);
        return all;
    }

    /** In words, such as "7 of 8 places and 9 of 12 transitions visited". */
    public String words() {
        return (places - neverEntered.size()) + " of " + places + " places and " + (transitions - neverFired.size())
                + " of " + transitions + " transitions visited";
    }
}
