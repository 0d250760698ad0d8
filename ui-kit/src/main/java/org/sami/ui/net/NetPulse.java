package org.sami.ui.net;

import java.util.HashMap;
import java.util.Map;
import java.util.function.LongSupplier;
import javax.swing.Timer;

/** How strongly each transition shines since it fired: for a quarter of a second, or not at all where the pulse is turned off. */
final class NetPulse {
    private static final long LENGTH_NS = 250_000_000;
    private static final int FRAME_MS = 33;

    private final Map<String, Long> firedNs = new HashMap<>();
    private final LongSupplier clockNs;
    private final Timer frames;
    private boolean on = true;

    /**
     * Makes a pulse that is on.
     *
     * @param clockNs a monotonic clock in nanoseconds
     * @param repaint is run while something shines
     */
    NetPulse(LongSupplier clockNs, Runnable repaint) {
        this.clockNs = clockNs;
        frames = new Timer(FRAME_MS, e -> {
            forget();
            repaint.run();
        });
    }

    void setOn(boolean on) {
        this.on = on;
        if (!on) {
            firedNs.clear();
            frames.stop();
        }
    }

    boolean isOn() {
        return on;
    }

    void fired(String transition) {
        if (on) {
            firedNs.put(transition, clockNs.getAsLong());
            frames.start();
        }
    }

    /** 1 for a transition that fires now, falling to 0. */
    double of(String transition) {
        Long at = firedNs.get(transition);
        return at == null ? 0 : Math.max(0, 1 - (clockNs.getAsLong() - at) / (double) LENGTH_NS);
    }

    private void forget() {
        firedNs.keySet().removeIf(transition -> of(transition) == 0);
        if (firedNs.isEmpty()) {
            frames.stop();
        }
    }
}
