package org.sami.crw.gui.mission;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.session.Session;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** Starts the library's plan of measurements and answers what it asks until each boat has its tasks. */
public final class DividedTasks {
    private DividedTasks() {}

    /** A task at each location, divided among the session's boats. */
    public static void of(Session session, ListValue locations) throws Exception {
        session.start("measure", "measure", Map.of()).toCompletableFuture().get(300, TimeUnit.SECONDS);
        Set<Long> answered = new HashSet<>();
        while (divided(session) < locations.items().size()) {
            Await.until(
                    "something is asked, or all is divided",
                    () -> !session.models().decisions().snapshot().isEmpty()
                            || divided(session) == locations.items().size());
            for (PendingDecision one : session.models().decisions().snapshot()) {
                if (!answered.add(one.decision().id())) {
                    continue; // it is shown for a moment longer
                }
                Answer answer = answer(one.decision().question(), locations);
                session.answer(one.decision().id(), answer, "test")
                        .toCompletableFuture()
                        .get(300, TimeUnit.SECONDS);
            }
        }
    }

    private static int divided(Session session) {
        return session.models().allocation().snapshot().queues().values().stream()
                .mapToInt(List::size)
                .sum();
    }

    private static Answer answer(Question question, ListValue locations) {
        if (question instanceof Question.FillIn asked) {
            Map<String, Value> values = new HashMap<>();
            asked.items()
                    .forEach(item -> values.put(
                            item.key(),
                            item.key().equals("locations")
                                    ? locations
                                    : item.defaultValue().orElseThrow(() -> new AssertionError(item + " is asked"))));
            return new Answer.Fields(values);
        } else if (question instanceof Question.ChooseProxies boats) {
            return new Answer.Proxies(boats.proxies());
        }
        return question instanceof Question.ChooseOption ? new Answer.Option(0) : new Answer.YesNo(true);
    }
}
