package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.task.TaskNews;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/**
 * Refresh Tasks: says once more of each boat's present task that it has been started, if it is one of this mission. Of a task that
 * entered it is the answer, unless its start is just being published; of the others it is news to the mission, where they wait for it.
 */
final class RefreshTasksHandler implements ActivationHandler {
    static final String TYPE = "RefreshTasks";

    private static final String STARTED = TaskNews.Kind.STARTED.event();

    private final TaskQueues queues;

    RefreshTasksHandler(TaskQueues queues) {
        this.queues = queues;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Input> inputs = new ArrayList<>();
        Set<TaskId> underWay = queues.takeStartsUnderWay(activation.id());
        queues.current().forEach((boat, task) -> {
            for (TaskId name : context.query(view -> view.namesOf(task))) {
                boolean entered = activation.tasks().contains(name);
                boolean due = entered ? !underWay.contains(name) : context.query(view -> waits(name, view));
                if (name.mission() == activation.mission() && due) {
                    inputs.add(new Input.Received(new Occurrence(
                            STARTED,
                            activation.mission(),
                            entered ? activation.id() : Ids.NONE,
                            List.of(boat),
                            List.of(name),
                            Map.of())));
                }
            }
        });
        if (!inputs.isEmpty()) {
            context.post(inputs);
        }
    }

    /** Whether a task stands before a transition that goes on with its start. */
    private static boolean waits(TaskId task, EngineView view) {
        Optional<Plan> plan = view.planOf(task.mission());
        Optional<MissionView> mission = view.mission(task.mission());
        return plan.isPresent()
                && mission.isPresent()
                && plan.get().transitions().stream()
                        .filter(transition -> transition.inputs().stream()
                                .anyMatch(input -> input.type().equals(STARTED)))
                        .flatMap(transition -> plan.get().inEdgesOf(transition.id()).stream())
                        .anyMatch(edge -> mission.get()
                                .marking()
                                .getOrDefault(edge.place(), List.of())
                                .contains(new Token.Task(task)));
    }
}
