package org.sami.uav.handler;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TaskId;

/** Tells the operator, once, of a task that is allocated to none, as the charged aircraft have failed at it too often and others are low. For the fleet's thread. */
final class WaitingTasks {
    private final MessageSink messages;
    private final TaskFailures failures;
    private final Map<TaskId, String> told = new HashMap<>(); // what was said of it

    WaitingTasks(MessageSink messages, TaskFailures failures) {
        this.messages = messages;
        this.failures = failures;
    }

    /**
     * A task cannot be allocated now.
     *
     * @param location where it is
     * @param all the aircraft that have said where they are
     * @param charged those of them whose batteries are not low; none of them is to try the task
     */
    void hold(
            Activation activation,
            HandlerContext context,
            TaskId task,
            GeoPoint location,
            Collection<String> all,
            Collection<String> charged) {
        List<String> low = all.stream()
                .filter(one -> !charged.contains(one) && !failures.isOut(task, one))
                .toList();
        if (low.isEmpty() && !told.containsKey(task)) {
            return; // no aircraft can do it, which is told where the last of them has failed
        }
        List<String> out = all.stream().filter(one -> failures.isOut(task, one)).toList();
        String text = words(task, location, out, low);
        if (!text.equals(told.put(task, text))) {
            messages.tell(new OperatorMessage(
                    context.nowMillis(),
                    activation.mission(),
                    OperatorMessage.Source.DOMAIN,
                    Priority.HIGH,
                    text,
                    all.stream().toList(),
                    "waiting-task/" + task.mission() + "/" + task.name()));
        }
    }

    private static String words(TaskId task, GeoPoint location, List<String> out, List<String> low) {
        boolean isOne = low.size() == 1;
        String others = low.isEmpty()
                ? "there is no other"
                : (isOne ? "the battery of " : "the batteries of ")
                        + String.join(", ", low)
                        + (isOne ? " is low" : " are low");
        String charged = low.isEmpty() ? "" : (isOne ? low.get(0) : "one of them") + " is charged, or ";
        return String.format(
                Locale.ROOT,
                "%s at %.5f,%.5f waits: %s failed at it twice, and %s. It is allocated once %s%s has another battery",
                task.name(),
                location.latDeg(),
                location.lonDeg(),
                String.join(", ", out),
                others,
                charged,
                out.size() == 1 ? out.get(0) : "one of " + String.join(", ", out));
    }

    /** Tasks are allocated: where one waits again, the operator is told again. */
    void allocated(Set<TaskId> tasks) {
        told.keySet().removeAll(tasks);
    }

    /** A mission has ended. */
    void forget(long mission) {
        told.keySet().removeIf(task -> task.mission() == mission);
    }
}
