package org.sami.crw.replay;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeSet;
import org.sami.crw.operator.OperatorMessage;
import org.sami.crw.replay.TimeLine.Kind;
import org.sami.crw.replay.TimeLine.Mark;
import org.sami.crw.session.SessionNote;
import org.sami.crw.session.SessionTelemetry;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.TelemetryRow;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;

/** Goes through a journal once and marks what happened. */
final class TimeLineBuilder implements SessionTelemetry.Reader {
    private final List<Mark> marks = new ArrayList<>();
    private final NavigableSet<Long> moments = new TreeSet<>();
    private final Map<Long, String> missions = new HashMap<>();
    private long endMillis;
    private long rowMillis;

    private TimeLineBuilder() {}

    static TimeLine of(Engine engine, List<JournalEntry> entries, List<TelemetryRow> rows) {
        TimeLineBuilder builder = new TimeLineBuilder();
        EngineState state = engine.newState();
        for (JournalEntry entry : entries) {
            List<Effect> effects = engine.step(state, entry.atMillis(), entry.input());
            builder.entry(entry, effects);
        }
        for (TelemetryRow row : rows) {
            builder.rowMillis = row.atMillis();
            builder.endMillis = Math.max(builder.endMillis, row.atMillis());
            SessionTelemetry.read(List.of(row), builder);
        }
        builder.marks.sort(Comparator.comparingLong(Mark::atMillis));
        return new TimeLine(builder.endMillis, builder.marks, builder.moments);
    }

    private void entry(JournalEntry entry, List<Effect> effects) {
        long at = entry.atMillis();
        endMillis = Math.max(endMillis, at);
        moments.add(at);
        Optional<String> done = words(entry.input());
        done.ifPresent(text -> marks.add(new Mark(at, Kind.OPERATOR, Ids.NONE, text)));
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionStarted e && e.parent() == Ids.NONE) {
                missions.put(e.mission(), e.name());
                marks.add(new Mark(at, Kind.MISSION_STARTED, e.mission(), e.name() + " starts"));
            } else if (effect instanceof Effect.MissionEnded e && missions.containsKey(e.mission())) {
                String how = e.outcome().name().toLowerCase(Locale.ROOT);
                marks.add(
                        new Mark(at, Kind.MISSION_ENDED, e.mission(), missions.get(e.mission()) + " is over: " + how));
            } else if (effect instanceof Effect.DecisionOpened e) {
                marks.add(new Mark(
                        at,
                        Kind.DECISION_ASKED,
                        e.decision().id(),
                        "asked: " + e.decision().prompt()));
            } else if (effect instanceof Effect.DecisionClosed e) {
                String by = e.by().map(who -> "answered by " + who.name().toLowerCase(Locale.ROOT))
                        .orElse("withdrawn");
                marks.add(new Mark(at, Kind.DECISION_ANSWERED, e.decision(), "decision " + e.decision() + " " + by));
            }
        }
    }

    private static Optional<String> words(Input input) {
        if (input instanceof Input.Interrupt press) {
            String whom = press.proxies().isEmpty() ? "" : " for " + String.join(", ", press.proxies());
            return Optional.of("pressed " + press.name() + whom);
        } else if (input instanceof Input.AbortMission abort) {
            return Optional.of(abort.mission() == Ids.NONE ? "aborted all" : "aborted mission " + abort.mission());
        } else if (input instanceof Input.CompleteMission complete) {
            return Optional.of("completed mission " + complete.mission());
        } else if (input instanceof Input.SetVariable variable) {
            return Optional.of("set " + variable.variable());
        } else if (input instanceof Input.LoadProject) {
            return Optional.of("loaded a project");
        } else if (input instanceof Input.ProxyDropped dropped) {
            return Optional.of("dropped " + dropped.proxy());
        }
        return Optional.empty();
    }

    @Override
    public void message(OperatorMessage message) {
        marks.add(new Mark(message.atMillis(), Kind.MESSAGE, message.mission(), message.text()));
    }

    @Override
    public void message(SessionNote note) {
        if (note.kind().equals(SessionNote.LINK)) {
            marks.add(new Mark(note.atMillis(), Kind.ALARM, Ids.NONE, note.text()));
        }
    }

    @Override
    public void lost(String boat) {
        marks.add(new Mark(rowMillis, Kind.ALARM, Ids.NONE, "the link to " + boat + " is lost"));
    }
}
