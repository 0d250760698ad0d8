package org.sami.crw.sim.run.incident;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.sami.crw.sim.run.incident.IncidentRunInput.ResolutionSpan;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** How long the boats needed from each press of an interrupt until the last of them fired a transition. For the engine's thread. */
final class ResolutionTimes implements HostListener {
    private final ResolutionSpan span;
    private final List<long[]> times = new ArrayList<>(); // press, last firing

    ResolutionTimes(ResolutionSpan span) {
        this.span = span;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        boolean fired = effects.stream().anyMatch(effect -> effect instanceof Effect.Fired);
        if (input instanceof Input.Interrupt press && press.name().equals(span.interrupt()) && fired) {
            times.add(new long[] {atMillis, atMillis});
        }
        boolean ends = effects.stream()
                .anyMatch(effect -> effect instanceof Effect.Fired firing
                        && firing.transition().equals(span.transition()));
        if (ends && !times.isEmpty()) {
            times.get(times.size() - 1)[1] = atMillis;
        }
    }

    /** The mean in seconds; empty where nothing was pressed, or a transition never fired. */
    OptionalDouble meanSeconds() {
        return times.stream()
                .filter(time -> time[1] > time[0])
                .mapToDouble(time -> (time[1] - time[0]) / 1000.0)
                .average();
    }
}
