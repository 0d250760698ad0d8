package org.sami.dreamm.tryout;

import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.NetOverlay;
import org.sami.dreamm.document.EditorListener;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetMarking;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.testcase.CaseCoverage;

/**
 * Puts the tokens of what is tried, or of the start marking that is put together, over the net of the open plan, with breakpoints and, where
 * requested, the parts that no saved case visits. On the event thread.
 */
public final class TryOutOverlay {
    private final DreammContext context;
    private final TryOut tryOut;
    private final StartMarkingSetup setup;
    private final SavedCases cases;
    private Optional<NetOverlay.Shown> instead = Optional.empty();
    private boolean coverage;
    private int told;

    /** An overlay of a window. */
    public TryOutOverlay(DreammContext context, TryOut tryOut, StartMarkingSetup setup, SavedCases cases) {
        this.context = context;
        this.tryOut = tryOut;
        this.setup = setup;
        this.cases = cases;
        tryOut.addListener(this::stepped);
        setup.addListener(this::show);
        cases.addListener(this::show);
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                show();
            }
        });
    }

    private void stepped() {
        show();
        if (tryOut.steps() > told) {
            context.overlay().fired(fired());
        }
        told = tryOut.steps();
    }

    private Set<String> fired() {
        String open = context.editor().planId().orElse("");
        Optional<Long> mission = tryOut.plan()
                .filter(open::equals)
                .flatMap(plan -> tryOut.stepper().map(Stepper::mission));
        Optional<Long> instance = tryOut.mission(open).map(MissionView::id);
        Set<String> transitions = new LinkedHashSet<>();
        for (Effect effect : tryOut.lastEffects()) {
            if (effect instanceof Effect.Fired e
                    && (mission.equals(Optional.of(e.mission())) || instance.equals(Optional.of(e.mission())))) {
                transitions.add(e.transition());
            }
        }
        return transitions;
    }

    /** Shows something else, such as a moment of a journal, until it is taken away. */
    public void showInstead(Optional<NetOverlay.Shown> other) {
        instead = other;
        show();
    }

    /** Shows what no saved case visits, or shows it no longer. */
    public void setCoverage(boolean on) {
        coverage = on;
        show();
    }

    /** Whether what no saved case visits is shown. */
    public boolean isCoverage() {
        return coverage;
    }

    private void show() {
        context.overlay().show(instead.orElseGet(this::own));
    }

    private NetOverlay.Shown own() {
        String open = context.editor().planId().orElse("");
        Set<String> breakpoints = breakpoints(open);
        Set<String> unvisited =
                coverage ? cases.coverage().map(CaseCoverage::neverVisited).orElse(Set.of()) : Set.of();
        NetMarking marking = tryOut.stepper().isPresent()
                ? tryOut.mission(open).map(this::marking).orElse(NetMarking.EMPTY)
                : setup.marking();
        return new NetOverlay.Shown(marking, new NetBadges(breakpoints, unvisited), id -> tryOut.whyNot(open, id));
    }

    /** Ids of the vertices of a plan at which runs stop. */
    public Set<String> breakpoints(String plan) {
        return tryOut.breakpoints().stream()
                .filter(at -> at.plan().equals(plan))
                .map(Breakpoint::vertex)
                .collect(Collectors.toSet());
    }

    private NetMarking marking(MissionView mission) {
        return marking(tryOut.stepper().orElseThrow().view(), mission.id());
    }

    /** The marking of a mission at a moment. */
    public static NetMarking marking(EngineView view, long mission) {
        FollowedMarking followed = new FollowedMarking();
        view.markingAsEffects().forEach(followed);
        return NetMarking.of(followed, mission, view.allocation());
    }
}
