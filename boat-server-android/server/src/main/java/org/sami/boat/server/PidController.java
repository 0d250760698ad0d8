package org.sami.boat.server;

import org.sami.boat.link.Gains;

/** One PID loop: from an error to an effort of -1 to 1. The integral part alone never exceeds full effort. */
final class PidController {
    private Gains gains;
    private double sum;
    private double lastError;
    private boolean started;

    PidController(Gains gains) {
        this.gains = gains;
    }

    Gains gains() {
        return gains;
    }

    void setGains(Gains newGains) {
        gains = newGains;
        reset();
    }

    /** Resets the loop for another target, or none. */
    void reset() {
        sum = 0;
        started = false;
    }

    /** Clears the integral where it keeps up an error. */
    void forgetWhatKeepsUp(double error) {
        if (sum * error < 0) {
            sum = 0;
        }
    }

    double effort(double error, double seconds) {
        sum = clamp(sum + gains.integral() * error * seconds);
        double change = started && seconds > 0 ? (error - lastError) / seconds : 0;
        lastError = error;
        started = true;
        return clamp(gains.proportional() * error + sum + gains.derivative() * change);
    }

    static double clamp(double effort) {
        return Math.max(-1, Math.min(1, effort));
    }
}
