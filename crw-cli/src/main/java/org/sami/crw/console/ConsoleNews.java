package org.sami.crw.console;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.sim.run.HealthNews;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Ids;

/** The console's news, as they happen: decisions, messages, alarms, missions, links. Printed on the models' thread. */
final class ConsoleNews implements AutoCloseable {
    private final AnswerText answers;
    private final Consumer<String> out;
    private final List<Registration> registrations;
    private final HealthNews health;
    private final Map<String, LinkState> links = new HashMap<>();
    private final Map<Long, Boolean> missions = new HashMap<>(); // whether it has ended
    private final Set<String> alarms = new HashSet<>();
    private long lastMessage;

    ConsoleNews(OperatorModels models, AnswerText answers, Consumer<String> out) {
        this.answers = answers;
        this.out = out;
        health = new HealthNews(models, out);
        registrations = List.of(
                models.decisions().addListener(new DecisionListener() {
                    @Override
                    public void opened(PendingDecision decision) {
                        tell(decision);
                    }

                    @Override
                    public void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by) {
                        settled(decision, answer, by);
                    }

                    @Override
                    public void held(PendingDecision decision) {
                        out.accept("[" + decision.decision().id() + "] waits for you: autonomy does not answer it");
                    }
                }),
                models.messages().addListener(this::messages),
                models.alarms().addListener(this::alarms),
                models.missions().addListener(this::missions),
                models.fleet().addListener(this::boats));
    }

    private void tell(PendingDecision pending) {
        OperatorCommands.describe(pending, pending.openedAtMillis(), answers, out);
    }

    private void settled(PendingDecision pending, Optional<Answer> answer, Optional<Answerer> by) {
        long id = pending.decision().id();
        if (answer.isEmpty()) {
            out.accept("[" + id + "] is asked no longer");
        } else if (by.equals(Optional.of(Answerer.AUTONOMY))) {
            String words = pending.presentation().autonomy().words();
            out.accept("[" + id + "] was answered by autonomy" + (words.isEmpty() ? "" : ": " + words));
        }
    }

    private void messages(List<MessageEntry> entries) {
        long last = lastMessage;
        entries.stream()
                .filter(entry -> entry.number() > last && !entry.muted())
                .sorted((a, b) -> Long.compare(a.number(), b.number()))
                .forEach(entry -> out.accept(
                        "message " + entry.number() + ": " + entry.message().text()));
        lastMessage = entries.stream().mapToLong(MessageEntry::number).max().orElse(last);
        lastMessage = Math.max(last, lastMessage);
    }

    private void alarms(List<Alarm> now) {
        Set<String> active = new HashSet<>();
        for (Alarm alarm : now) {
            String key = alarm.kind() + " " + alarm.boat();
            if (alarm.active()) {
                active.add(key);
                if (alarms.add(key) && !alarm.muted()) {
                    out.accept("ALARM: " + alarm.text());
                }
            }
        }
        alarms.retainAll(active);
    }

    private void missions(MissionsSnapshot snapshot) {
        for (MissionSnapshot mission : snapshot.missions()) {
            boolean ended = mission.hasEnded();
            Boolean before = missions.put(mission.id(), ended);
            if (mission.parent() == Ids.NONE && ended && !Boolean.TRUE.equals(before)) {
                out.accept("mission " + mission.id() + " of " + mission.plan() + ": "
                        + mission.outcome().orElseThrow().name().toLowerCase(Locale.ROOT) + " at "
                        + Numbers.clock(mission.endedAtMillis().orElse(0)));
            }
        }
    }

    private void boats(List<BoatSnapshot> boats) {
        for (BoatSnapshot boat : boats) {
            LinkState before = links.put(boat.boat(), boat.link());
            if (boat.link() == LinkState.LINKED && before != LinkState.LINKED) {
                out.accept(boat.boat() + " is linked");
            } else if (boat.link() == LinkState.LOST && before == LinkState.LINKED) {
                out.accept("the link to " + boat.boat() + " is lost");
            }
        }
    }

    @Override
    public void close() {
        registrations.forEach(Registration::close);
        health.close();
    }
}
