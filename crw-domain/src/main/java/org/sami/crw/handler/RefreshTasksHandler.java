package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.crw.task.TaskNews;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;

/**
 * Refresh Tasks: says once more of each boat's present task that it has been started, if it is one of this mission. Of a task that
 * entered it is the answer, of the others news to the mission.
 */
final class RefreshTasksHandler implements ActivationHandler {
    static final String TYPE = "RefreshTasks";

    private final TaskQueues queues;

    RefreshTasksHandler(TaskQueues queues) {
        this.queues = queues;
    }

    @Override
    public void handle(Activation activation, HandlerContext context) {
        List<Input> inputs = new ArrayList<>();
        String started = TaskNews.Kind.STARTED.event();
        queues.current().forEach((boat, task) -> {
            for (TaskId name : context.query(view -> view.namesOf(task))) {
                if (name.mission() == activation.mission()) {
                    long answered = activation.tasks().contains(name) ? activation.id() : Ids.NONE;
                    inputs.add(new Input.Received(new Occurrence(
                            started, activation.mission(), answered, List.of(boat), List.of(name), Map.of())));
                }
            }
        });
        if (!inputs.isEmpty()) {
            context.post(inputs);
        }
    }
}
