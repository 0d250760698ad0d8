package org.sami.spn.legacy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Which copies of plans are replaced by a reference to the plan they were copied from. */
final class Copies {
    private final LegacyProject project;
    private final Map<String, Fold> folds = new LinkedHashMap<>();

    /**
     * A copy that is replaced.
     *
     * @param plan id of the plan that runs instead
     * @param variables the copy's variable for the plan's, where they differ
     */
    record Fold(String plan, Map<String, String> variables) {}

    Copies(LegacyProject project, Findings findings, Counts.Tally explained) {
        this.project = project;
        Set<String> globals =
                project.globals().stream().map(LegacyProject.Global::name).collect(Collectors.toSet());
        for (LegacyPlan copy : project.plans()) {
            if (copy.role() == LegacyPlan.Role.INSTANCE) {
                look(copy, globals, findings, explained);
            }
        }
    }

    Optional<Fold> of(String planId) {
        return Optional.ofNullable(folds.get(planId));
    }

    /** The plan that runs here where the export names one; empty where the export has no such plan. */
    Optional<String> running(String planId) {
        return project.plans().stream()
                .map(LegacyPlan::id)
                .filter(planId::equals)
                .findFirst()
                .map(id -> of(id).map(Fold::plan).orElse(id));
    }

    private void look(LegacyPlan copy, Set<String> globals, Findings findings, Counts.Tally explained) {
        List<LegacyPlan> originals = project.plans().stream()
                .filter(p -> p.role() != LegacyPlan.Role.INSTANCE && isNamedAfter(copy, p))
                .toList();
        boolean used = project.plans().stream()
                .flatMap(p -> p.vertices().stream())
                .flatMap(v -> v.subMissions().stream())
                .anyMatch(s -> s.plan().equals(copy.id()));
        String name = "The plan " + copy.id() + " (" + copy.name() + ")";
        String difference = "";
        for (LegacyPlan original : originals) {
            CopyCheck.Result result = CopyCheck.compare(copy, original, globals);
            Map<String, String> variables = result.variables();
            difference = difference.isEmpty() ? result.difference() : difference;
            if (used && result.isTrue()) {
                folds.put(copy.id(), new Fold(original.id(), variables));
                findings.note(
                        LegacyCodes.COPY_FOLDED,
                        copy.pointer(),
                        name + " is a true copy of " + original.id() + " (" + original.name()
                                + "): its place runs that plan"
                                + (variables.isEmpty() ? "" : ", with the variables " + variables)
                                + ", and the copy is not imported",
                        copy.id());
                explained(copy, explained);
                return;
            }
        }
        String why = originals.isEmpty()
                ? "no plan of its name is in the project"
                : used ? "it differs from " + originals.get(0).id() + ": " + difference : "no place runs it";
        findings.note(
                originals.isEmpty() ? LegacyCodes.NOT_A_COPY : LegacyCodes.COPY_KEPT,
                copy.pointer(),
                name + " stays a plan of its own: " + why,
                copy.id());
    }

    private static boolean isNamedAfter(LegacyPlan copy, LegacyPlan original) {
        return !original.name().isEmpty() && copy.name().endsWith("." + original.name());
    }

    /** The copy's elements are in the export and not in the project. */
    private static void explained(LegacyPlan copy, Counts.Tally explained) {
        explained.add(CountedKind.PLANS, 1);
        explained.add(CountedKind.TASKS, copy.tasks().size());
        explained.add(CountedKind.PLACES, copy.places().size());
        explained.add(CountedKind.TRANSITIONS, copy.transitions().size());
        for (LegacyPlan.Edge e : copy.edges()) {
            explained.add(e.in() ? CountedKind.IN_EDGES : CountedKind.OUT_EDGES, 1);
            explained.add(
                    e.in() ? CountedKind.IN_REQUIREMENTS : CountedKind.OUT_REQUIREMENTS,
                    e.requirements().size());
        }
        for (LegacyPlan.Vertex v : copy.vertices()) {
            explained.add(CountedKind.SUB_MISSIONS, v.subMissions().size());
            explained.add(
                    v.place() ? CountedKind.PLACE_EVENTS : CountedKind.TRANSITION_EVENTS,
                    v.events().size());
            v.events()
                    .forEach(e -> explained.add(CountedKind.MARKUPS, e.markups().size()));
        }
        explained.add(CountedKind.VARIABLES, (int) variables(copy).distinct().count());
    }

    private static Stream<String> variables(LegacyPlan plan) {
        return plan.vertices().stream()
                .flatMap(v -> v.events().stream())
                .flatMap(e -> Stream.of(
                                e.reads().values().stream(),
                                e.writes().values().stream(),
                                e.values().values().stream()
                                        .filter(v -> v.type().equals("variable-name"))
                                        .map(v -> v.node().path("name").asText()))
                        .flatMap(s -> s));
    }
}
