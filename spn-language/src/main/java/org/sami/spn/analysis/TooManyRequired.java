package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.EventRole;

/** A transition asks for more tokens than there can be: of the robots that are listed, of the plan's tasks, of its generic tokens. */
final class TooManyRequired implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-TOO-MANY-WANTED",
                "There are never so many: the transition never fires.",
                "Ask for fewer, or give the mission more robots or tasks."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (InEdge edge : plan.plan().inEdges()) {
            for (InRequirement r : edge.requirements()) {
                if (isTooMany(plan, r)) {
                    int most = most(plan, r).orElseThrow();
                    report.accept(Finding.warning(
                            "W-TOO-MANY-WANTED",
                            plan.at(edge),
                            plan.transitionName(edge.transition()) + " waits for " + r.n() + " "
                                    + things(r.kind(), r.n()) + " in the " + plan.placeName(edge.place())
                                    + ", but there " + (most == 1 ? "is " : "are ") + (most == 0 ? "none" : most)
                                    + ": it never fires. Ask for fewer" + more(r.kind()),
                            edge.id(),
                            edge.transition()));
                }
            }
        }
    }

    private static String things(TokenKind kind, int n) {
        String one = switch (kind) {
            case GENERIC -> "generic token";
            case ANY_TASK, TASK -> "task";
            default -> "robot";
        };
        return n == 1 ? one : one + "s";
    }

    private static String more(TokenKind kind) {
        return switch (kind) {
            case GENERIC -> ", or add them with a transition before";
            case ANY_TASK, TASK -> ", or give the plan more tasks";
            default -> ", or list more robots";
        };
    }

    /** Whether a requirement can never be met, by what is known of the number of tokens. */
    static boolean isTooMany(PlanContext plan, InRequirement r) {
        return (r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY)
                && most(plan, r).filter(most -> r.n() > most).isPresent();
    }

    /** How many tokens of its kind there are at most, where that is known. */
    private static Optional<Integer> most(PlanContext plan, InRequirement r) {
        return switch (r.kind()) {
            case GENERIC -> r.n() > 1 && onlyOneGeneric(plan) ? Optional.of(1) : Optional.empty();
            case ANY_PROXY -> r.n() > 1 ? UnknownRobots.number(plan) : Optional.empty();
            case ANY_TASK -> ownTasks(plan).map(Set::size);
            case TASK -> ownTasks(plan).filter(own -> own.contains(r.task())).map(own -> 1);
            default -> Optional.empty();
        };
    }

    private static Optional<Set<String>> ownTasks(PlanContext plan) {
        boolean all = plan.parents().isEmpty()
                && plan.outputs().stream().noneMatch(o -> o.type().role() == EventRole.GENERATE_TASKS);
        return all
                ? Optional.of(plan.plan().tasks().stream().map(TaskSpec::name).collect(Collectors.toSet()))
                : Optional.empty();
    }

    /** Whether the start's generic token is the only one there is: none is made, and none leads two ways. */
    private static boolean onlyOneGeneric(PlanContext plan) {
        return plan.parents().isEmpty()
                && plan.plan().transitions().stream().allMatch(t -> {
                    long ways = plan.outEdges(t).stream()
                            .filter(e -> plan.flow().along(e).contains(TokenType.GENERIC))
                            .count();
                    boolean makes = plan.outEdges(t).stream()
                            .flatMap(e -> e.requirements().stream())
                            .anyMatch(o -> o.action() == Action.ADD
                                    && TokenType.of(o.kind()).contains(TokenType.GENERIC));
                    return ways <= 1 && !makes;
                });
    }
}
