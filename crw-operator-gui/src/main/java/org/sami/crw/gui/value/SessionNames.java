package org.sami.crw.gui.value;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.crw.gui.boat.BoatWords;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.SessionWays;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.AllocationSnapshot;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;
import org.sami.ui.value.ChoiceRow;
import org.sami.ui.value.NamedThings;
import org.sami.ui.value.RobotWays;

/** Boats with their state and mark, tasks, global variables and plans of a session, as editors offer them. On the event thread. */
final class SessionNames implements NamedThings {
    private final OperatorContext context;
    private final SessionWays ways;

    SessionNames(OperatorContext context) {
        this.context = context;
        ways = new SessionWays(context);
    }

    /** Those of the mission that asks with it. */
    @Override
    public RobotWays ways(Value solution) {
        return context.models().decisions().snapshot().stream()
                .map(PendingDecision::decision)
                .filter(decision -> decision.question() instanceof Question.ChooseOption asked
                        && asked.options().contains(solution))
                .map(Decision::mission)
                .findFirst()
                .map(ways::of)
                .orElse(RobotWays.AS_GIVEN);
    }

    @Override
    public List<ChoiceRow> proxies() {
        return context.models().fleet().snapshot().stream().map(this::row).toList();
    }

    private ChoiceRow row(BoatSnapshot boat) {
        String state = BoatWords.battery(boat) + " · " + BoatWords.state(boat);
        return new ChoiceRow(
                new ProxyValue(boat.boat()),
                boat.boat(),
                state,
                Optional.of(context.marks().of(boat.boat())));
    }

    @Override
    public List<ChoiceRow> tasks() {
        AllocationSnapshot allocation = context.models().allocation().snapshot();
        return Stream.concat(
                        allocation.queues().values().stream().flatMap(List::stream), allocation.unallocated().stream())
                .map(task -> new ChoiceRow(task, task.name(), ""))
                .toList();
    }

    @Override
    public List<ChoiceRow> variables() {
        return context.shown().project().globals().stream()
                .map(global ->
                        new ChoiceRow(new VariableReference(global.name()), global.name(), TypeNames.of(global.type())))
                .toList();
    }

    @Override
    public List<ChoiceRow> plans() {
        return context.shown().project().plans().stream()
                .map(plan -> new ChoiceRow(new PlanReference(plan.id()), plan.name(), ""))
                .toList();
    }
}
