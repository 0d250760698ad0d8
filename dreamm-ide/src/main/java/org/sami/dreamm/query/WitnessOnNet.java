package org.sami.dreamm.query;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.dreamm.context.NetOverlay;
import org.sami.dreamm.tryout.TryOutOverlay;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetMarking;
import org.sami.spn.plannet.PlanMarking;
import org.sami.spn.planspace.PlanWitness;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** Shows the run of an answer on the net of the open plan, one marking after another. On the event thread. */
public final class WitnessOnNet {
    private final NetOverlay net;
    private final TryOutOverlay overlay;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private Optional<PlanWitness> shown = Optional.empty();
    private boolean isMarked;
    private int at;

    /** Nothing is shown yet. */
    public WitnessOnNet(NetOverlay net, TryOutOverlay overlay) {
        this.net = Objects.requireNonNull(net, "net");
        this.overlay = Objects.requireNonNull(overlay, "overlay");
    }

    /** Shows a run from its start. */
    void show(PlanWitness witness) {
        shown = Optional.of(witness);
        go(0);
    }

    /**
     * Shows one marking instead of a run.
     *
     * @param fired the transitions that have just led there
     */
    void show(PlanMarking marking, Set<String> fired) {
        shown = Optional.empty();
        isMarked = true;
        overlay.showInstead(
                Optional.of(new NetOverlay.Shown(marking(marking), NetBadges.NONE, id -> Optional.empty())));
        if (!fired.isEmpty()) {
            net.fired(fired);
        }
        listeners.forEach(Runnable::run);
    }

    /** Shows nothing more; the tokens of what is tried are back. */
    void end() {
        if (shown.isPresent() || isMarked) {
            isMarked = false;
            shown = Optional.empty();
            overlay.showInstead(Optional.empty());
            listeners.forEach(Runnable::run);
        }
    }

    Optional<PlanWitness> shown() {
        return shown;
    }

    boolean canGo(int steps) {
        int next = at + steps;
        return shown.filter(run -> next >= 0 && next < run.markings().size()).isPresent();
    }

    /** Goes on or back; where that is beyond the run nothing happens. */
    void step(int steps) {
        if (canGo(steps)) {
            go(at + steps);
            if (steps > 0) {
                String fired = shown.orElseThrow().firings().get(at - 1).transition();
                net.fired(Set.of(fired));
            }
        }
    }

    private void go(int next) {
        at = next;
        NetMarking marking = marking(shown.orElseThrow().markings().get(at));
        overlay.showInstead(Optional.of(new NetOverlay.Shown(marking, NetBadges.NONE, id -> Optional.empty())));
        listeners.forEach(Runnable::run);
    }

    /** Where it is in the run, with names of places and robots; empty text where none is shown. */
    String words() {
        return shown.map(run -> "firing " + at + " of " + run.firings().size()
                        + (at == 0 ? ", the start" : ": " + run.words().get(at - 1)))
                .orElse("");
    }

    private static NetMarking marking(PlanMarking marking) {
        Map<String, List<Token>> tokens = new LinkedHashMap<>();
        marking.tokens().forEach((place, here) -> {
            List<Token> there = new ArrayList<>();
            here.forEach((label, count) -> {
                for (int i = 0; i < count; i++) {
                    there.add(token(label));
                }
            });
            tokens.put(place, there);
        });
        return new NetMarking(tokens, marking.nobody(), Map.of());
    }

    private static Token token(String label) {
        return label.equals("generic")
                ? new Token.Generic()
                : label.startsWith("#")
                        ? new Token.Task(new TaskId(Ids.NONE, label.substring(1)))
                        : new Token.Proxy(label);
    }

    /** Tells somebody when something else is shown. */
    void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }
}
