package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehicleBattery;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * How far a percent of charge takes a vehicle, as it has driven so far: autopilots do not say it. Counted are the metres between one fall of the charge and
 * the next where the vehicle drove meanwhile. For one thread.
 */
final class VehicleConsumption {
    private static final double LEAST_PERCENT = 5; // so many percent are to be used before it is said
    private static final double REMEMBERED_PERCENT = 100; // older ones count half: batteries age
    private static final int MOST_FALL = 5; // percent; a larger fall is another battery, or another way of measuring
    private static final double LEAST_STEP_M = 2; // less may be the wander of its position
    private static final double MOST_STEP_M = 100; // more is a jump of its position
    private static final double LEAST_MPS = 0.3; // a slower vehicle lay still for most of the time

    private double metres;
    private double percent;
    private Optional<VehiclePosition> last = Optional.empty();
    private Optional<Integer> charge = Optional.empty();
    private double drivenM; // since the charge has fallen
    private long fellMs = -1; // when it has; negative where that is not known

    /**
     * Goes on with what was counted before.
     *
     * @param metres distance driven so far, 0 or more
     * @param percent charge used for it, 0 or more
     */
    VehicleConsumption(double metres, double percent) {
        this.metres = metres;
        this.percent = percent;
    }

    /** The vehicle reports itself. Returns whether more was counted. */
    boolean reported(VehicleSnapshot now) {
        now.position().filter(at -> now.located()).ifPresent(this::moved);
        Optional<Integer> reported = now.battery().flatMap(VehicleBattery::percent);
        boolean changed = reported.isPresent() && !reported.equals(charge);
        boolean counted = changed && charge.isPresent() && fell(charge.get() - reported.get(), now.heardMs());
        if (changed) {
            boolean first = charge.isEmpty();
            charge = reported;
            drivenM = 0;
            fellMs = first ? -1 : now.heardMs(); // at the first report it may have fallen long ago
        }
        return counted;
    }

    private void moved(VehiclePosition at) {
        if (last.isEmpty()) {
            last = Optional.of(at);
            return;
        }
        double stepM = new LocalFrame(last.get().latDeg(), last.get().lonDeg()).distanceM(at.latDeg(), at.lonDeg());
        if (stepM >= LEAST_STEP_M) {
            drivenM += stepM <= MOST_STEP_M ? stepM : 0;
            last = Optional.of(at);
        }
    }

    private boolean fell(int by, long atMs) {
        boolean drove = fellMs >= 0 && drivenM * 1000 >= LEAST_MPS * (atMs - fellMs);
        if (by <= 0 || by > MOST_FALL || !drove) {
            return false;
        }
        metres += drivenM;
        percent += by;
        if (percent > REMEMBERED_PERCENT) {
            metres /= 2;
            percent /= 2;
        }
        return true;
    }

    /** Distance that was counted, in metres. */
    double metres() {
        return metres;
    }

    /** Charge that was used for it, in percent of full. */
    double percent() {
        return percent;
    }

    /** How far a percent takes the vehicle on average; empty before it has used enough for it to be known. */
    OptionalDouble metresPerPercent() {
        return percent >= LEAST_PERCENT && metres > 0 ? OptionalDouble.of(metres / percent) : OptionalDouble.empty();
    }
}
