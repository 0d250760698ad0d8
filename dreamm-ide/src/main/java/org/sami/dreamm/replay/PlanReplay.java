package org.sami.dreamm.replay;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.dreamm.tryout.Breakpoint;
import org.sami.dreamm.tryout.TryOutOverlay;
import org.sami.picture.net.NetMarking;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Effect;
import org.sami.spn.replay.JournalRun;

/**
 * A journal that is looked at on the plans that are written. Goes to a moment on the caller's thread, one at a time, and answers with what is
 * shown then; what it answers is immutable.
 */
public final class PlanReplay {
    private final JournalRun journal;

    /** A mission of a session at a moment. */
    public record ShownMission(long id, String plan, String name, NetMarking marking) {
        public ShownMission {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(marking, "marking");
        }
    }

    /**
     * What stands where at a moment.
     *
     * @param missions those that run then, in order of creation
     * @param fired transitions that fired on the way here, as vertices of their plans, of the last entry only
     * @param stopped the breakpoint that was met on the way, before which nothing of it was shown; empty where none was
     */
    public record Moment(
            long atMillis,
            int entry,
            List<ShownMission> missions,
            Set<Breakpoint> fired,
            Optional<Breakpoint> stopped) {
        public Moment {
            missions = List.copyOf(missions);
            fired = Set.copyOf(fired);
            Objects.requireNonNull(stopped, "stopped");
        }

        /** The newest mission of a plan; empty where none runs. */
        public Optional<ShownMission> mission(String plan) {
            return missions.stream().filter(m -> m.plan().equals(plan)).reduce((older, newer) -> newer);
        }
    }

    /** A replay at its start. */
    public PlanReplay(JournalRun journal) {
        this.journal = Objects.requireNonNull(journal, "journal");
    }

    /** The journal. */
    public JournalRun journal() {
        return journal;
    }

    /** Goes to a moment from any other, without stopping on the way. */
    public Moment goTo(long millis) {
        journal.goTo(millis);
        return shown(Optional.empty());
    }

    /** Goes on to a later moment; stops behind the first entry that enters or fires a breakpoint on the way. */
    public Moment goOn(long millis, Set<Breakpoint> breakpoints) {
        int until = journal.entriesUntil(millis);
        while (journal.taken() < until) {
            journal.goToEntry(journal.taken() + 1);
            Optional<Breakpoint> met =
                    vertices().stream().filter(breakpoints::contains).findFirst();
            if (met.isPresent()) {
                return shown(met);
            }
        }
        return goTo(millis);
    }

    private Moment shown(Optional<Breakpoint> stopped) {
        EngineView view = journal.view();
        List<ShownMission> missions = new ArrayList<>();
        for (MissionView mission : view.missions()) {
            missions.add(new ShownMission(
                    mission.id(), mission.plan(), mission.name(), TryOutOverlay.marking(view, mission.id())));
        }
        Set<Breakpoint> fired = new LinkedHashSet<>();
        for (Effect effect : journal.effects()) {
            if (effect instanceof Effect.Fired e) {
                vertex(view, e.mission(), e.transition()).ifPresent(fired::add);
            }
        }
        return new Moment(journal.atMillis(journal.taken()), journal.taken(), missions, fired, stopped);
    }

    /** What the last entry entered or fired. */
    private List<Breakpoint> vertices() {
        List<Breakpoint> vertices = new ArrayList<>();
        for (Effect effect : journal.effects()) {
            if (effect instanceof Effect.Entered e) {
                vertex(journal.view(), e.mission(), e.place()).ifPresent(vertices::add);
            } else if (effect instanceof Effect.Fired e) {
                vertex(journal.view(), e.mission(), e.transition()).ifPresent(vertices::add);
            }
        }
        return vertices;
    }

    private static Optional<Breakpoint> vertex(EngineView view, long mission, String vertex) {
        return view.mission(mission).map(m -> new Breakpoint(m.plan(), vertex));
    }

    /** What is other in a plan that is written than in the journal's, in one sentence; empty where it runs alike. */
    public Optional<String> difference(Plan written) {
        Optional<Plan> ran = journal.project().plan(written.id());
        if (ran.isEmpty()) {
            return Optional.of("The journal's session has no plan " + written.id());
        }
        Plan then = ran.get();
        List<String> differ = new ArrayList<>();
        add(differ, "places", then.places(), written.places());
        add(differ, "transitions", then.transitions(), written.transitions());
        add(differ, "edges", List.of(then.inEdges(), then.outEdges()), List.of(written.inEdges(), written.outEdges()));
        add(differ, "variables", then.variables(), written.variables());
        add(differ, "tasks", then.tasks(), written.tasks());
        return differ.isEmpty()
                ? Optional.empty()
                : Optional.of("The plan " + written.id() + " is not as it was in the session: its "
                        + String.join(", ", differ) + " differ");
    }

    private static void add(List<String> differ, String what, Object then, Object now) {
        if (!then.equals(now)) {
            differ.add(what);
        }
    }
}
