package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.CommandInt;
import io.dronefleet.mavlink.common.CommandLong;
import java.util.List;
import java.util.Set;

/**
 * A command as it came, in either form.
 *
 * @param number of the command (MAV_CMD)
 * @param params param1 to param4
 * @param latDeg degrees north; what param5 is where the command has no place
 * @param lonDeg degrees east; the same of param6
 * @param isGlobal whether its place is one on the earth, and not metres from somewhere
 */
record CommandValues(int number, List<Double> params, double latDeg, double lonDeg, boolean isGlobal) {
    private static final Set<Integer> GLOBAL =
            Set.of(0, 3, 5, 6, 10, 11); // of MAV_FRAME: over the sea, home or terrain
    private static final double TO_WHOLE = 1e7;
    private static final double MAX_LAT = 90;
    private static final double MAX_LON = 180;

    static CommandValues of(CommandLong command) {
        return new CommandValues(
                command.command().value(),
                List.of((double) command.param1(), (double) command.param2(), (double) command.param3(), (double)
                        command.param4()),
                command.param5(),
                command.param6(),
                true);
    }

    static CommandValues of(CommandInt command) {
        return new CommandValues(
                command.command().value(),
                List.of((double) command.param1(), (double) command.param2(), (double) command.param3(), (double)
                        command.param4()),
                command.x() / TO_WHOLE,
                command.y() / TO_WHOLE,
                GLOBAL.contains(command.frame().value()));
    }

    /** A parameter by its number from 1 on. */
    double param(int n) {
        return params.get(n - 1);
    }

    /** Whether a parameter is a whole number from 0 on that fits an int. */
    boolean isWhole(int n) {
        double value = param(n);
        return value >= 0 && value <= Integer.MAX_VALUE && value == Math.rint(value);
    }

    /** Whether it has a place on the earth; 0, 0 is none: it is what stations send that know no place. */
    boolean hasPlace() {
        return isPlace(latDeg, lonDeg);
    }

    static boolean isPlace(double latDeg, double lonDeg) {
        boolean earth = Math.abs(latDeg) <= MAX_LAT && Math.abs(lonDeg) <= MAX_LON;
        return earth && (latDeg != 0 || lonDeg != 0);
    }
}
