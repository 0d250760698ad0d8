package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;

/** Makes the net of a plan. For one use. */
final class PlanTranslation {
    private final PlanNetRequest request;
    private final boolean isCounted;
    private final Plan plan;
    private final PlanNetWork work;
    private final AbstractionList abstractions = new AbstractionList();

    /** @param isCounted whether robots are counted and not named */
    PlanTranslation(PlanNetRequest request, boolean isCounted) {
        this.request = request;
        this.isCounted = isCounted;
        plan = request.project()
                .plan(request.plan())
                .orElseThrow(() -> new IllegalArgumentException("there is no plan \"" + request.plan() + "\""));
        if (plan.startPlace().isEmpty()) {
            throw new IllegalArgumentException("the plan \"" + plan.title() + "\" has no start place");
        }
        work = new PlanNetWork(request, plan, team());
    }

    private List<PlanToken> team() {
        List<PlanToken> team = new ArrayList<>();
        team.add(PlanToken.GENERIC);
        if (isCounted) {
            team.add(PlanToken.ROBOTS);
        } else {
            request.robots().forEach(robot -> team.add(PlanToken.robot(robot)));
        }
        plan.tasks().forEach(task -> team.add(PlanToken.task(task.name(), task.taskClass())));
        if (makesTasks()) {
            for (int i = 1; i <= request.madeTasks(); i++) {
                team.add(PlanToken.madeTask(i, ""));
            }
            abstractions.partial(
                    "", "the mission makes tasks while it runs: " + request.madeTasks() + " of them are followed");
        }
        return team;
    }

    private boolean makesTasks() {
        return plan.transitions().stream().anyMatch(this::waitsForTasks);
    }

    private boolean waitsForTasks(Transition t) {
        return t.inputs().stream()
                .anyMatch(input -> request.vocabulary()
                        .event(input.type())
                        .filter(type -> type.role() == EventRole.TASKS_GENERATED)
                        .isPresent());
    }

    /** Whether there can be several of one robot: then its places are not where it stands but where it is at least once. */
    boolean copiesRobots() {
        return work.team().stream()
                .anyMatch(token ->
                        token.type() == TokenType.PROXY && work.possible().isCopied(token));
    }

    PlanNet translate() throws PlanNetTooLargeException {
        InConditions conditions = new InConditions(work.places(), work.possible(), abstractions);
        Map<Transition, List<CaseArcs>> of = new LinkedHashMap<>();
        for (Transition t : plan.transitions()) {
            of.put(t, conditions.of(t, plan.inEdgesOf(t.id())));
            if (t.inputs().isEmpty() && !TransitionCases.looksAgain(plan, work.possible(), t)) {
                boolean atStart = plan.inEdgesOf(t.id()).stream()
                        .anyMatch(edge ->
                                plan.place(edge.place()).filter(Place::start).isPresent());
                work.places().addOccasion(t.id(), atStart);
            }
        }
        for (Map.Entry<Transition, List<CaseArcs>> entry : of.entrySet()) {
            new TransitionCases(work, entry.getKey(), entry.getValue()).add();
        }
        new AbstractionsOfPlan(work, abstractions).list();
        return new PlanNet(
                request,
                work.build(),
                work.places().all(),
                work.firings(),
                abstractions.all(),
                work.beyond(),
                isCounted ? Optional.of(new CountedParts(work.counted(), work.possible(), plan)) : Optional.empty());
    }
}
