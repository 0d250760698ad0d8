package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;

/** Makes the net of a plan. For one use. */
final class PlanTranslation {
    private final PlanNetRequest request;
    private final RobotView view;
    private final Plan plan;
    private final PlanNetWork work;
    private final AbstractionList abstractions = new AbstractionList();

    PlanTranslation(PlanNetRequest request, RobotView view) {
        this.request = request;
        this.view = view;
        plan = request.project()
                .plan(request.plan())
                .orElseThrow(() -> new IllegalArgumentException("there is no plan \"" + request.plan() + "\""));
        if (plan.startPlace().isEmpty()) {
            throw new IllegalArgumentException("the plan \"" + plan.title() + "\" has no start place");
        }
        work = new PlanNetWork(request, plan, team(), view);
    }

    private List<PlanToken> team() {
        List<PlanToken> team = new ArrayList<>();
        team.add(PlanToken.GENERIC);
        if (view != RobotView.NAMED) {
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

    /** Whether several of one robot can be in one place: then its places are not where it stands but where it is at least once. */
    boolean losesCount() {
        return robots().anyMatch(work.possible()::isLoose);
    }

    private Stream<PlanToken> robots() {
        return work.team().stream().filter(token -> token.type() == TokenType.PROXY);
    }

    /**
     * Makes the net.
     *
     * @return empty where robots are to be counted that are copied into too many sets of places
     */
    Optional<PlanNet> translate() throws PlanNetTooLargeException {
        new FollowedChildren(work, List.of(plan.id()), view == RobotView.NAMED ? request.depth() : 0, abstractions)
                .make();
        MissionTransitions mission = new MissionTransitions(work, abstractions);
        Map<Transition, TransitionCases> cases = mission.ofPlan();
        Optional<RobotProfiles> profiles = Optional.empty();
        if (view == RobotView.COUNTED && robots().anyMatch(work.possible()::isCopied)) {
            profiles = profiles(cases);
            if (profiles.isEmpty()) {
                return Optional.empty();
            }
        }
        for (TransitionCases each : cases.values()) {
            if (view == RobotView.PRESENT) {
                each.addByPresence();
            } else {
                each.add(profiles);
            }
        }
        mission.addOfChildren();
        return Optional.of(new PlanNet(
                request,
                work.build(),
                work.places().all(),
                work.firings(),
                abstractions.all(),
                work.beyond(),
                work.open(),
                view == RobotView.COUNTED
                        ? Optional.of(new CountedParts(work.counted(), work.possible(), plan))
                        : Optional.empty(),
                view == RobotView.PRESENT ? Optional.of(work.sure()) : Optional.empty()));
    }

    private Optional<RobotProfiles> profiles(Map<Transition, TransitionCases> cases) {
        Map<Transition, List<TokenOption>> options = new LinkedHashMap<>();
        cases.forEach((t, each) -> options.put(t, each.options(PlanToken.ROBOTS)));
        Set<String> start = plan.startPlace()
                .map(Place::id)
                .filter(place -> work.possible().comes(place, PlanToken.ROBOTS))
                .map(Set::of)
                .orElse(Set.of());
        return RobotProfiles.of(start, options, work.possible(), work.places(), work.robots());
    }
}
