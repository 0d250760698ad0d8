package org.sami.crw.sim.run;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Decision;

/**
 * Finds out that nothing can happen any longer: no timer runs, no answer is on its way, no interrupt is to be pressed, no boat moves, and nothing has come
 * in for a while. Without it a mission that is stuck would only end with the run's time.
 */
public final class StallWatch {
    private static final long QUIET_MILLIS = 300_000;
    private static final double STILL_MPS = 0.05;

    private final EngineHost host;
    private final OperatorStation operator;
    private final InterruptStation interrupts;
    private final RunRecorder recorder;

    /** A watch over one run. */
    public StallWatch(EngineHost host, OperatorStation operator, InterruptStation interrupts, RunRecorder recorder) {
        this.host = host;
        this.operator = operator;
        this.interrupts = interrupts;
        this.recorder = recorder;
    }

    /** Why nothing can happen; empty while something can. */
    public Optional<String> look(long nowMillis, List<BoatState> boats) {
        boolean quiet = nowMillis - recorder.lastInputMillis() > QUIET_MILLIS
                && !operator.isThinking()
                && !interrupts.hasPlans()
                && boats.stream().allMatch(boat -> Math.abs(boat.speedMps()) < STILL_MPS)
                && host.ask(EngineView::nextDueMillis).isEmpty();
        return quiet ? Optional.of(reason(boats)) : Optional.empty();
    }

    private String reason(List<BoatState> boats) {
        List<Decision> open = operator.open();
        if (!open.isEmpty()) {
            return "nobody answers: "
                    + open.stream().map(Decision::prompt).collect(Collectors.joining("; "))
                    + operator.troubles().stream().map(t -> " (" + t + ")").collect(Collectors.joining());
        }
        String empty = boats.stream()
                .filter(boat -> boat.batteryPercent() <= 0)
                .map(BoatState::id)
                .collect(Collectors.joining(", "));
        return "nothing can happen in the mission any longer" + (empty.isEmpty() ? "" : "; empty battery: " + empty);
    }
}
