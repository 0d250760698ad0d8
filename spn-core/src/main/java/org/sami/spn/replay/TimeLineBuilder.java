package org.sami.spn.replay;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeSet;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.replay.TimeLine.Kind;
import org.sami.spn.replay.TimeLine.Mark;

/** Makes a time line of a journal's entries, in order, and of the domain's own marks. */
public final class TimeLineBuilder {
    private final List<Mark> marks = new ArrayList<>();
    private final NavigableSet<Long> moments = new TreeSet<>();
    private final Map<Long, String> missions = new HashMap<>();
    private long endMillis;

    /** Marks what an entry and its effects tell. */
    public void entry(JournalEntry entry, List<Effect> effects) {
        long at = entry.atMillis();
        until(at);
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

    /** Marks something that the domain knows of. */
    public void mark(Mark mark) {
        marks.add(mark);
    }

    /** The session lasted until then at least. */
    public void until(long millis) {
        endMillis = Math.max(endMillis, millis);
    }

    /** The time line. */
    public TimeLine build() {
        marks.sort(Comparator.comparingLong(Mark::atMillis));
        return new TimeLine(endMillis, marks, moments);
    }
}
