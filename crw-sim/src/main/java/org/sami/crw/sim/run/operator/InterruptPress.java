package org.sami.crw.sim.run.operator;

import java.util.List;
import java.util.OptionalLong;
import org.sami.crw.report.InterruptResult;
import org.sami.crw.sim.run.settings.PlannedInterrupt;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;

/** One interrupt that is pressed until a transition takes it, and its state. */
final class InterruptPress {
    /** The state of a press. */
    enum State {
        /** Not due yet. */
        AHEAD,
        /** Posted; the engine has not processed it. */
        POSTED,
        /** The operator is asked for which boats it is. */
        ASKED,
        /** No transition took it; it is pressed again after something has changed. */
        REFUSED,
        /** Due to be pressed again. */
        DUE_AGAIN,
        /** A transition fired with it. */
        TAKEN,
        /** Not needed any longer: the boat's battery has recovered. */
        GIVEN_UP
    }

    final PlannedInterrupt plan;
    State state = State.AHEAD;
    long decision;
    private List<String> boats;
    private int presses;
    private OptionalLong firstMillis = OptionalLong.empty();
    private OptionalLong takenMillis = OptionalLong.empty();
    private long lastMillis;

    InterruptPress(PlannedInterrupt plan, List<String> boats) {
        this.plan = plan;
        this.boats = boats;
    }

    /** The input to post; without a robot where the operator chooses it, at each press. */
    Input.Interrupt input() {
        return new Input.Interrupt(
                Ids.NONE, plan.name(), plan.boat().isPresent() || plan.isForBattery() ? boats : List.of());
    }

    void pressed(long atMillis) {
        presses++;
        lastMillis = atMillis;
        if (firstMillis.isEmpty()) {
            firstMillis = OptionalLong.of(atMillis);
        }
    }

    void taken(long atMillis) {
        state = State.TAKEN;
        takenMillis = OptionalLong.of(atMillis);
    }

    void chosen(List<String> proxies) {
        boats = proxies;
    }

    long lastMillis() {
        return lastMillis;
    }

    /** Whether it is for this boat and not pending. */
    boolean isWaitingFor(String boat) {
        return boats.contains(boat) && (state == State.AHEAD || state == State.REFUSED || state == State.DUE_AGAIN);
    }

    InterruptResult result() {
        return new InterruptResult(
                plan.name(),
                String.join(" ", boats),
                plan.isForBattery() ? InterruptResult.BATTERY : InterruptResult.TIME,
                firstMillis,
                takenMillis,
                presses);
    }
}
