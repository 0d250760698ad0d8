package org.sami.uav.handler;

import java.util.List;
import java.util.Map;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TaskId;

/** Tells the operator of tasks that no aircraft can or may do, and the plan where a transition waits for that. For the fleet's thread. */
final class ImpossibleTasks implements TaskFailures.Impossible {
    private final EngineHost host;
    private final ProxyRegistry robots;
    private final MessageSink messages;

    ImpossibleTasks(EngineHost host, ProxyRegistry robots, MessageSink messages) {
        this.host = host;
        this.robots = robots;
        this.messages = messages;
    }

    @Override
    public List<String> aircraft() {
        return host.ask(view -> List.copyOf(view.proxies())).stream() // not those that the operator has dropped
                .filter(name -> robots.find(name)
                        .filter(one -> one.isFlying() && one.status().pose().isPresent())
                        .isPresent())
                .toList();
    }

    @Override
    public void became(TaskId task) {
        List<String> all = aircraft();
        boolean isTaken = host.ask(view -> view.awaits(UavEvents.TASK_IMPOSSIBLE));
        messages.tell(new OperatorMessage(
                host.nowMillis(),
                task.mission(),
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                words(task, all, isTaken),
                all,
                ""));
        if (isTaken) {
            host.post(List.of(new Input.Received(new Occurrence(
                    UavEvents.TASK_IMPOSSIBLE, task.mission(), Ids.NONE, List.of(), List.of(task), Map.of()))));
        }
    }

    private static String words(TaskId task, List<String> all, boolean isTaken) {
        return String.format(
                "No aircraft can or may do %s: %s failed at it twice. It %s",
                task.name(), String.join(", ", all), isTaken ? "is left out" : "waits for another battery");
    }
}
