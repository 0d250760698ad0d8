package org.sami.crw.handler.boat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.sami.crw.decision.DomainQuestion;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * Asks whether restarted boats may move again: one question for all of them (docs/session.md), in which each can be left out. A boat that restarts
 * while the question waits is added by asking again. For the fleet's thread.
 */
final class RestartQuestion {
    /** After a resume boats answer one after the other: so long they are gathered before they are asked about. */
    private static final long GATHERED_MILLIS = 1000;

    private static final String KIND = DomainQuestion.BOAT_RESTARTED.kind();
    private static final String BETWEEN = "\n"; // boats in the subject of a question

    private final EngineHost host;
    private final Set<String> open = new LinkedHashSet<>(); // subjects of open questions
    private final Set<String> asked = new TreeSet<>(); // boats about which they ask
    private final Set<String> gathered = new TreeSet<>(); // boats about which nobody has asked yet
    private long sinceMillis;
    private boolean lookedUp;

    RestartQuestion(EngineHost host) {
        this.host = host;
    }

    /** A boat's server has restarted. */
    void add(String boat) {
        lookUp();
        if (asked.contains(boat)) {
            return;
        }
        if (gathered.isEmpty()) {
            sinceMillis = host.nowMillis();
        }
        gathered.add(boat);
    }

    /** What an earlier process asked is still asked. */
    private void lookUp() {
        if (!lookedUp) {
            lookedUp = true;
            open.addAll(host.ask(view -> view.decisions().stream()
                    .filter(decision -> decision.type().equals(KIND))
                    .flatMap(decision -> view.subject(decision.id()).stream())
                    .toList()));
            open.forEach(subject -> asked.addAll(boats(subject)));
        }
    }

    private static List<String> boats(String subject) {
        return Arrays.asList(subject.split(BETWEEN));
    }

    /** Asks about those that were gathered, when that has been long enough. To be called again and again. */
    void askIfDue() {
        if (!gathered.isEmpty() && host.nowMillis() - sinceMillis >= GATHERED_MILLIS) {
            asked.addAll(gathered);
            gathered.clear();
            askAgain();
        }
    }

    /** A boat may be moved, or is gone: nobody need be asked about it. */
    void remove(String boat) {
        lookUp();
        gathered.remove(boat);
        if (asked.remove(boat)) {
            askAgain();
        }
    }

    private void askAgain() {
        List<Input> inputs = new ArrayList<>();
        open.forEach(subject -> inputs.add(new Input.WithdrawQuestion(KIND, subject)));
        open.clear();
        if (!asked.isEmpty()) {
            String subject = String.join(BETWEEN, asked);
            open.add(subject);
            inputs.add(
                    asked.size() == 1
                            ? new Input.AskOperator(
                                    KIND,
                                    subject,
                                    subject + " has started anew and does not move. May it move again?",
                                    Priority.CRITICAL)
                            : new Input.AskOperator(
                                    KIND,
                                    subject,
                                    words() + " have started anew and do not move. Which of them may move again?",
                                    Priority.CRITICAL,
                                    List.copyOf(asked)));
        }
        host.post(inputs);
    }

    private String words() {
        List<String> all = List.copyOf(asked);
        return String.join(", ", all.subList(0, all.size() - 1)) + " and " + all.get(all.size() - 1);
    }

    /** The operator has answered; gives the boats that may move. */
    List<String> answered(Effect.QuestionAnswered answer) {
        lookUp();
        List<String> about = boats(answer.about());
        open.remove(answer.about());
        about.forEach(asked::remove);
        boolean chose = about.size() > 1;
        return about.stream()
                .filter(boat -> chose ? answer.proxies().contains(boat) : answer.yes())
                .toList();
    }
}
