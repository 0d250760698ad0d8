package org.sami.uav.handler;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.EventNames;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TaskId;

/**
 * The tasks of aircraft whose batteries are low, as of one whose battery turned low after the allocation was computed, or that is on its way home for another one.
 * Where the plan allocates a task anew that has lost its aircraft, it is given back. Else it waits until an aircraft on the ground is charged, and is flown by one
 * in the air, which nobody calls home. The operator is told of what is given back, and of what waits, once. For the fleet's thread.
 */
final class LowBatteryTasks {
    private final MessageSink messages;
    private final Map<String, Set<TaskId>> told = new HashMap<>(); // by aircraft: those that wait

    LowBatteryTasks(MessageSink messages) {
        this.messages = messages;
    }

    /** A task whose aircraft is to fly to its location. */
    record Task(Activation activation, HandlerContext context, TaskId id) {}

    /** Gives back those of the tasks of an aircraft that the plan allocates anew, and returns them; the others are left. */
    Set<TaskId> giveBack(String aircraft, boolean inTheAir, BatteryState battery, List<Task> tasks) {
        List<Task> returned = tasks.stream()
                .filter(task -> isAllocatedAnew(task, aircraft) && (!inTheAir || isCalledHome(task)))
                .toList();
        if (!returned.isEmpty()) {
            Map<TaskId, Optional<String>> toNobody = new LinkedHashMap<>();
            returned.forEach(task -> toNobody.put(task.id, Optional.empty()));
            returned.get(0).context.post(List.of(new Input.AllocateTasks(toNobody)));
            tell(aircraft, inTheAir, battery, returned, "given back and allocated anew");
        }
        if (!inTheAir) {
            tellOfWaiting(aircraft, battery, tasks, returned);
        }
        return returned.stream().map(Task::id).collect(Collectors.toSet());
    }

    private void tellOfWaiting(String aircraft, BatteryState battery, List<Task> tasks, List<Task> returned) {
        Set<TaskId> known = told.computeIfAbsent(aircraft, name -> new HashSet<>());
        List<Task> news = tasks.stream()
                .filter(task -> !returned.contains(task) && known.add(task.id))
                .toList();
        if (!news.isEmpty()) {
            tell(aircraft, false, battery, news, "kept until it is charged");
        }
    }

    /** An aircraft flies: what it has then waits no longer. */
    void flies(String aircraft) {
        told.remove(aircraft);
    }

    private static boolean isAllocatedAnew(Task task, String aircraft) {
        Activation activation = task.activation;
        return task.id.mission() == activation.mission()
                && task.context.query(view -> aircraft.equals(view.allocation().get(task.id))
                        && planOf(activation, view)
                                .filter(plan -> takesLost(plan, activation.place()))
                                .isPresent());
    }

    /** Else it would hover without a task until its battery is empty. */
    private static boolean isCalledHome(Task task) {
        return task.context.query(view -> planOf(task.activation, view)
                .filter(plan -> plan.transitions().stream()
                        .flatMap(transition -> transition.inputs().stream())
                        .anyMatch(input -> input.type().equals(EventNames.BATTERY_LOW)
                                || input.type().equals(EventNames.BATTERY_CRITICAL)))
                .isPresent());
    }

    private static Optional<Plan> planOf(Activation activation, EngineView view) {
        return view.planOf(activation.mission());
    }

    /** Whether a transition out of a place takes the tasks there that have lost their aircraft. */
    private static boolean takesLost(Plan plan, String place) {
        Set<String> takers = plan.transitions().stream()
                .filter(transition -> transition.inputs().stream()
                        .anyMatch(input -> input.type().equals(UavEvents.AIRCRAFT_LOST)))
                .map(transition -> transition.id())
                .collect(Collectors.toSet());
        return plan.inEdges().stream()
                .anyMatch(edge -> edge.place().equals(place) && takers.contains(edge.transition()));
    }

    private void tell(String aircraft, boolean inTheAir, BatteryState battery, List<Task> tasks, String what) {
        Task first = tasks.get(0);
        String names = tasks.stream().map(task -> task.id.name()).collect(Collectors.joining(", "));
        String text = String.format(
                Locale.ROOT,
                "%s %s, as its battery is %s (%.0f %%): %s %s %s",
                aircraft,
                inTheAir ? "flies to no task any more" : "stays on the ground",
                battery.level().name().toLowerCase(Locale.ROOT),
                battery.percent(),
                names,
                tasks.size() == 1 ? "is" : "are",
                what);
        messages.tell(ActivationMessages.of(first.activation, first.context, Priority.HIGH, text, List.of(aircraft)));
    }
}
