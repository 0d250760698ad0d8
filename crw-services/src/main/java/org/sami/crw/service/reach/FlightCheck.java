package org.sami.crw.service.reach;

import java.util.Locale;
import java.util.Optional;

/** Checks before an aircraft flies whether its charge lasts for the flight and the way home; a pure function. */
public final class FlightCheck {
    private static final double MINUTE_S = 60;

    private FlightCheck() {}

    /** What is wrong; empty where nothing is. One that is to land is always to do so. */
    public static Optional<WayDoubt> doubt(Flight flight, Endurance endurance) {
        if (flight.lands()) {
            return Optional.empty();
        }
        double homeS = flight.homeS();
        double neededS = flight.outS() + homeS;
        double lastsS = endurance.seconds();
        return neededS <= lastsS
                ? Optional.empty()
                : Optional.of(new WayDoubt(
                        WayDoubt.Kind.CHARGE,
                        String.format(
                                Locale.ROOT,
                                "%s needs %.0f s of flight, %.0f s of them %s, and its charge of %.0f %% lasts %.0f s"
                                        + " until %.0f %%%s",
                                flight.aircraft(),
                                neededS,
                                homeS,
                                flight.home().isPresent() ? "to come home and land" : "to land where it is then",
                                endurance.percent(),
                                lastsS,
                                Endurance.LANDING_PERCENT,
                                assumed(endurance))));
    }

    /** How much longer a flight with its way home takes than the charge lasts, in seconds; less than 0 where it lasts longer. */
    public static double shortfallS(Flight flight, Endurance endurance) {
        return flight.outS() + flight.homeS() - endurance.seconds();
    }

    /** What is assumed, where nothing was seen of the aircraft's own. */
    private static String assumed(Endurance endurance) {
        return endurance.isSeen()
                ? ""
                : String.format(
                        Locale.ROOT,
                        ", if a full battery lasts %.0f minutes in the air, as nothing else was seen of it yet",
                        Endurance.USUAL_S / MINUTE_S);
    }
}
