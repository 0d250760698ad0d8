package org.sami.crw.sim.run;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.sami.crw.decision.MixedInitiative;
import org.sami.crw.message.MessageEntry;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.sim.run.operator.SimulatedOperatorDriver;
import org.sami.crw.sim.run.record.FenceNotes;
import org.sami.spn.host.Registration;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;

/**
 * Prints, line by line, what the operator of a run sees: decisions as they open, who answers them and what, messages, alarms
 * that a boat is or is sent where it may not. Shown on
 * the models' thread.
 */
public final class RunNews implements AutoCloseable {
    private static final long REPEATED_MILLIS = 60_000;
    private static final int LONGEST_ANSWER = 100;

    private final RunObserver.News news;
    private final LongSupplier nowMillis;
    private final List<Registration> registrations;
    private final Map<String, Shown> lastShown =
            new HashMap<>(); // by a message's keyword; by its text where it has none
    private long lastMessage;
    private final HealthNews health;
    private long lastAlarm;

    private record Shown(String text, long atMillis) {}

    /**
     * Begins with what is new from now on.
     *
     * @param nowMillis the session's clock
     */
    public RunNews(OperatorModels models, LongSupplier nowMillis, RunObserver.News news) {
        this.news = news;
        this.nowMillis = nowMillis;
        lastMessage = latest(models.messages().snapshot());
        registrations = List.of(
                models.decisions().addListener(new DecisionListener() {
                    @Override
                    public void opened(PendingDecision decision) {
                        asked(decision);
                    }

                    @Override
                    public void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by) {
                        settled(decision, answer, by);
                    }
                }),
                models.messages().addListener(this::messages),
                models.alarms().addListener(this::alarms));
        health = new HealthNews(models, line -> tell(nowMillis.getAsLong(), line));
    }

    private void asked(PendingDecision pending) {
        String where = pending.plan().isEmpty() ? "" : " (" + pending.plan() + ")";
        tell(
                pending.openedAtMillis(),
                "asked [" + pending.decision().id() + "] "
                        + pending.presentation().title() + where + ", "
                        + pending.presentation().priority().name().toLowerCase(Locale.ROOT) + autonomy(pending));
        if (news.isDetailed()) {
            pending.presentation().description().forEach(line -> news.lines().accept("            " + line));
        }
    }

    private static String autonomy(PendingDecision pending) {
        MixedInitiative autonomy = pending.presentation().autonomy();
        if (!autonomy.counts()) {
            return "";
        }
        double seconds = autonomy.remainingMillis(pending.openedAtMillis()).orElse(0) / 1000.0;
        return autonomy.words().isEmpty()
                ? ", autonomy has no answer"
                : String.format(Locale.ROOT, ", autonomy %s in %.0f s", autonomy.phrase(), seconds);
    }

    private void settled(PendingDecision pending, Optional<Answer> answer, Optional<Answerer> by) {
        String decision = "[" + pending.decision().id() + "]";
        if (answer.isEmpty()) {
            tell(nowMillis.getAsLong(), "asked no longer " + decision);
            return;
        }
        boolean byAutonomy = by.equals(Optional.of(Answerer.AUTONOMY));
        String words = EngineText.answer(answer.get());
        tell(
                nowMillis.getAsLong(),
                "answered " + decision + " by " + (byAutonomy ? "autonomy" : "the " + SimulatedOperatorDriver.NAME)
                        + (words.isEmpty() ? "" : ": " + shortened(words)));
    }

    private String shortened(String words) {
        return news.isDetailed() || words.length() <= LONGEST_ANSWER
                ? words
                : words.substring(0, LONGEST_ANSWER) + " ...";
    }

    private void messages(List<MessageEntry> entries) {
        long before = lastMessage;
        lastMessage = Math.max(before, latest(entries));
        entries.stream()
                .filter(entry -> entry.number() > before)
                .sorted((one, other) -> Long.compare(one.number(), other.number()))
                .forEach(this::message);
    }

    /** Leaves out news repeated within the last minute, unless something else was printed about the same subject since: the last line is always the present state. */
    private void message(MessageEntry entry) {
        String text = entry.message().text();
        long atMillis = entry.message().atMillis();
        String keyword = entry.message().keyword();
        String subject = keyword.isEmpty() ? text : keyword;
        Shown before = lastShown.get(subject);
        boolean repeated = before != null && before.text.equals(text) && atMillis - before.atMillis < REPEATED_MILLIS;
        if (news.isDetailed() || !repeated) {
            lastShown.put(subject, new Shown(text, atMillis));
            tell(atMillis, "message: " + text);
        }
    }

    private void alarms(List<Alarm> now) {
        for (Alarm alarm : FenceNotes.raised(now, lastAlarm)) {
            lastAlarm = alarm.number();
            tell(alarm.sinceMillis(), "alarm: " + alarm.text());
        }
    }

    private static long latest(List<MessageEntry> entries) {
        return entries.stream().mapToLong(MessageEntry::number).max().orElse(0);
    }

    private void tell(long atMillis, String text) {
        news.lines().accept(String.format(Locale.ROOT, "%8.1f s  %s", atMillis / 1000.0, text));
    }

    @Override
    public void close() {
        registrations.forEach(Registration::close);
        health.close();
    }
}
