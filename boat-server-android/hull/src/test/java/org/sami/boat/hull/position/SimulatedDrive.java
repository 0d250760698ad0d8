package org.sami.boat.hull.position;

import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * A hull that drives a lawn-mower path at 1.5 m/s in a current, with a receiver whose error is half white and half wandering within 20 s, five fixes a second;
 * with a compass of 5° noise and 8° error, ten headings a second, and a gyro of 1°/s. Equal seeds give equal drives.
 */
final class SimulatedDrive {
    static final LocalFrame FRAME = new LocalFrame(45.4, 10.9);

    private static final double STEP_S = 0.1;

    private final SplittableRandom random;
    private final double whiteM;
    private final double wanderM;
    private double wanderEastM;
    private double wanderNorthM;
    private double eastM;
    private double northM;
    private double headingRad;
    private double turnRate;
    private final double speedMps = 1.5;
    private double seconds;
    private double sumRaw;
    private double sumFiltered;
    private int fixes;
    private int poses;
    private double sumHeading;
    boolean hasCompass = true;
    boolean hasGyro = true;
    boolean givesMotion = true;
    double compassErrorRad = Math.toRadians(8);
    double currentMps = 0.15;
    DoubleUnaryOperator gpsOffEastM = time -> 0;
    DoubleUnaryOperator gpsThere = time -> 1;

    SimulatedDrive(long seed, double whiteM, double wanderM) {
        random = new SplittableRandom(seed);
        this.whiteM = whiteM;
        this.wanderM = wanderM;
        wanderEastM = normal(wanderM);
        wanderNorthM = normal(wanderM);
    }

    private double normal(double deviation) {
        double sum = 0;
        for (int i = 0; i < 12; i++) {
            sum += random.nextDouble();
        }
        return (sum - 6) * deviation;
    }

    double seconds() {
        return seconds;
    }

    long ms() {
        return Math.round(seconds * 1000);
    }

    double offM(Pose pose) {
        return Math.hypot(
                FRAME.eastM(pose.latDeg(), pose.lonDeg()) - eastM, FRAME.northM(pose.latDeg(), pose.lonDeg()) - northM);
    }

    double headingOffRad(Pose pose) {
        return Math.abs(PlaneMath.sameTurn(pose.headingRad() - headingRad));
    }

    /** Drives for a time and tells the filter; errors are counted from the twentieth second on. */
    void drive(PositionFilter filter, double forSeconds) {
        for (double end = seconds + forSeconds; seconds < end - 1e-9; ) {
            step(filter);
        }
    }

    private void step(PositionFilter filter) {
        int tick = (int) Math.round(seconds / STEP_S);
        boolean turns = tick % 400 >= 360; // 36 s straight on, then half a turn in 4 s
        double side = tick / 400 % 2 == 0 ? 1 : -1;
        turnRate = turns ? side * Math.PI / 4 : 0;
        headingRad = PlaneMath.sameTurn(headingRad + turnRate * STEP_S);
        double eastMps = speedMps * Math.sin(headingRad) + currentMps;
        double northMps = speedMps * Math.cos(headingRad);
        eastM += eastMps * STEP_S;
        northM += northMps * STEP_S;
        seconds += STEP_S;
        double keeps = Math.exp(-STEP_S / 20);
        wanderEastM = wanderEastM * keeps + normal(wanderM * Math.sqrt(1 - keeps * keeps));
        wanderNorthM = wanderNorthM * keeps + normal(wanderM * Math.sqrt(1 - keeps * keeps));
        filter.motors(0.5, turnRate, ms());
        if (hasGyro) {
            filter.gyro(turnRate + normal(Math.toRadians(1)), ms());
        }
        if (hasCompass) {
            filter.compass(headingRad + compassErrorRad + normal(Math.toRadians(5)), ms());
        }
        if (tick % 2 == 0 && gpsThere.applyAsDouble(seconds) > 0) {
            fix(filter, eastMps, northMps);
        }
        if (seconds > 20) {
            Pose pose = filter.pose(ms());
            double off = offM(pose);
            sumFiltered += off * off;
            poses++;
            double turn = headingOffRad(pose);
            sumHeading += turn * turn;
        }
    }

    private void fix(PositionFilter filter, double eastMps, double northMps) {
        double shownEastM = eastM + wanderEastM + normal(whiteM) + gpsOffEastM.applyAsDouble(seconds);
        double shownNorthM = northM + wanderNorthM + normal(whiteM);
        double lat = FRAME.latDeg(shownEastM, shownNorthM);
        double lon = FRAME.lonDegOn(lat, shownEastM);
        double east = eastMps + normal(0.15);
        double north = northMps + normal(0.15);
        filter.gps(
                givesMotion
                        ? new GpsFix(lat, lon, 3, Math.hypot(east, north), Math.atan2(east, north))
                        : GpsFix.at(lat, lon),
                ms());
        if (seconds > 20) {
            double off = Math.hypot(shownEastM - eastM, shownNorthM - northM);
            sumRaw += off * off;
            fixes++;
        }
    }

    /** Root of the mean square of the fixes' distance from the truth, in m. */
    double rawErrorM() {
        return Math.sqrt(sumRaw / fixes);
    }

    /** Root of the mean square of the filter's distance from the truth, ten times a second, in m. */
    double filterErrorM() {
        return Math.sqrt(sumFiltered / poses);
    }

    /** Root of the mean square of the filter's error of heading in degrees. */
    double headingErrorDeg() {
        return Math.toDegrees(Math.sqrt(sumHeading / poses));
    }
}
